//! A planned motion as a table: CSV, and JSON with its document beside it. Frames count from 0.

use crate::document::fault::{Fault, FaultCode, Place, excerpt};
use crate::document::report::Report;
use crate::document::schema::Document;
use crate::model::mechanism::Mechanism;
use crate::motion::columns::{COLUMNS, Kind};
use crate::motion::trajectory::{Status, Trajectory};
use serde::Deserialize;
use std::fmt::Write;

/// Version of the JSON of a motion: in 1 its column `frame` counted from 1.
pub const VERSION: u32 = 2;

/// Where a table in CSV has the units of its columns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Headings {
    /// Behind the names: `x[mm]`.
    #[default]
    Units,
    /// Nowhere: `x`.
    Plain,
    /// In a row of their own below the names.
    TwoRows,
}

impl Headings {
    /// All.
    pub const ALL: [Self; 3] = [Self::Units, Self::Plain, Self::TwoRows];

    /// The word by which it is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Units => "units",
            Self::Plain => "plain",
            Self::TwoRows => "two-rows",
        }
    }

    /// Those of this word.
    ///
    /// # Errors
    /// Where there are none.
    pub fn named(word: &str) -> Result<Self, Fault> {
        let found = Self::ALL.into_iter().find(|one| one.name() == word);
        found.ok_or_else(|| {
            let what = format!("\u{201c}{}\u{201d} is unknown", excerpt(word));
            let accepted = Self::ALL.map(Self::name).join(", ");
            let place = Place::WHOLE.field("headings");
            Fault::new(FaultCode::UnknownValue, &place, &what, &accepted)
        })
    }
}

/// What fills a column.
pub(crate) enum Values {
    Numbers(Vec<f64>),
    Statuses(Vec<Status>),
}

/// A column: a name in ASCII, its unit (empty for a pure number), an entry a frame.
pub(crate) struct Column {
    name: String,
    unit: String,
    values: Values,
}

impl Column {
    /// Of pure numbers.
    #[cfg(feature = "study")]
    pub(crate) fn number(name: &str, values: Values) -> Self {
        Self {
            name: name.to_owned(),
            unit: String::new(),
            values,
        }
    }

    /// As a spreadsheet takes it: `theta1[deg]`.
    fn heading(&self) -> String {
        if self.unit.is_empty() {
            self.name.clone()
        } else {
            format!("{}[{}]", self.name, self.unit)
        }
    }

    /// The entry of a frame; `missing` for what is no number.
    fn entry(&self, frame: usize, missing: &str) -> String {
        match &self.values {
            Values::Statuses(statuses) => statuses[frame].name().to_owned(),
            Values::Numbers(numbers) if numbers[frame].is_finite() => number(numbers[frame]),
            Values::Numbers(_) => missing.to_owned(),
        }
    }
}

/// The shortest text that reads back as the same double.
pub(crate) fn number(x: f64) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let (plain, scientific) = (format!("{x}"), format!("{x:e}"));
    if scientific.len() < plain.len() {
        scientific
    } else {
        plain
    }
}

/// The name of a joint variable in ASCII: `chain2_theta1` for θ1 of the second chain.
pub(crate) fn variable_name(chain: usize, label: &str) -> String {
    format!("chain{}_{}", chain + 1, label.replace('θ', "theta"))
}

/// The columns of a motion, that of its frames' numbers first.
pub(crate) fn columns(document: &Document, report: &Report, t: &Trajectory) -> Vec<Column> {
    let length = match document.length_unit.as_str() {
        "" => "length",
        unit => unit,
    };
    let mut list = Vec::new();
    let mut add = |name: &str, unit: &str, values: Values| {
        list.push(Column {
            name: name.to_owned(),
            unit: unit.to_owned(),
            values,
        });
    };
    let numbers = |values: &[f64]| Values::Numbers(values.to_vec());
    let degrees =
        |angles: &[f64]| Values::Numbers(angles.iter().map(|angle| angle.to_degrees()).collect());
    let counted = (0..t.frames()).map(|i| i as f64).collect();
    add("frame", "", Values::Numbers(counted));
    for column in &COLUMNS {
        let (name, values) = (column.name, (column.values)(t));
        match column.kind {
            Kind::Time | Kind::Number | Kind::Count => add(name, "", numbers(&values)),
            Kind::Status => add(name, "", Values::Statuses(t.status.clone())),
            Kind::Length => add(name, length, numbers(&values)),
            Kind::Angle => add(name, "deg", degrees(&values)),
            Kind::Pose => {
                for (i, part) in ["x", "y", "z", "qx", "qy", "qz", "qw"]
                    .into_iter()
                    .enumerate()
                {
                    let own = values.iter().skip(i).step_by(7).copied().collect();
                    add(
                        &format!("{}{part}", column.prefix),
                        if i < 3 { length } else { "" },
                        Values::Numbers(own),
                    );
                }
            }
            Kind::Joints => {
                let mut k = 0;
                for (i, chain) in report.chains.iter().enumerate() {
                    for variable in &chain.variables {
                        let own: Vec<f64> = values
                            .iter()
                            .skip(k)
                            .step_by(t.variables)
                            .copied()
                            .collect();
                        let name = variable_name(i, &variable.label);
                        if variable.unit == "rad" {
                            add(&name, "deg", degrees(&own));
                        } else {
                            add(&name, length, Values::Numbers(own));
                        }
                        k += 1;
                    }
                }
            }
        }
    }
    list
}

/// Headings, then a line a frame. Angles in degrees, lengths in the document's unit; every number with all its digits,
/// empty where there is none.
pub fn csv(
    document: &Document,
    mechanism: &Mechanism,
    t: &Trajectory,
    headings: Headings,
) -> String {
    let report = Report::new(mechanism, &document.length_unit, t);
    columns_in_csv(&columns(document, &report, t), t.frames(), headings)
}

/// Headings, then a line a row.
pub(crate) fn columns_in_csv(columns: &[Column], rows: usize, headings: Headings) -> String {
    let line = |fields: Vec<String>| fields.join(",") + "\n";
    let row = |field: fn(&Column) -> String| {
        line(
            columns
                .iter()
                .map(|column| quoted(&field(column)))
                .collect(),
        )
    };
    let mut text = match headings {
        Headings::Units => row(Column::heading),
        Headings::Plain => row(|column| column.name.clone()),
        Headings::TwoRows => row(|column| column.name.clone()) + &row(|column| column.unit.clone()),
    };
    for frame in 0..rows {
        let entries = columns.iter().map(|column| column.entry(frame, ""));
        text += &line(entries.collect());
    }
    text
}

/// The motion as one JSON object: its units, its columns as lists, what is said about it, and the
/// document that it answers.
///
/// # Panics
/// Never: texts and plain data become JSON.
pub fn json(document: &Document, mechanism: &Mechanism, t: &Trajectory) -> String {
    let report = Report::new(mechanism, &document.length_unit, t);
    let columns = columns_in_json(&columns(document, &report, t), t.frames());
    let counts = [("frames", t.frames().to_string())];
    object(
        "synthetica motion",
        VERSION,
        document,
        &counts,
        &columns,
        &report,
    )
}

/// A list of columns, each with its name, its unit and its values.
pub(crate) fn columns_in_json(columns: &[Column], rows: usize) -> String {
    let list: Vec<String> = columns
        .iter()
        .map(|column| {
            let values: Vec<String> = (0..rows)
                .map(|row| match column.values {
                    Values::Numbers(_) => column.entry(row, "null"),
                    Values::Statuses(_) => text_in_json(&column.entry(row, "")),
                })
                .collect();
            format!(
                "    {{\"name\": {}, \"unit\": {}, \"values\": [{}]}}",
                text_in_json(&column.name),
                text_in_json(&column.unit),
                values.join(", ")
            )
        })
        .collect();
    format!("[\n{}\n  ]", list.join(",\n"))
}

/// The object around columns. `own` are its own fields, their values being JSON.
pub(crate) fn object(
    format: &str,
    version: u32,
    document: &Document,
    own: &[(&str, String)],
    columns: &str,
    report: &Report,
) -> String {
    let mut text = String::from("{\n");
    let mut field = |name: &str, value: &str| {
        let _ = writeln!(text, "  \"{name}\": {value},");
    };
    field("format", &text_in_json(format));
    field("version", &version.to_string());
    field("name", &text_in_json(&document.name));
    field("length_unit", &text_in_json(&document.length_unit));
    field("angle_unit", "\"deg\"");
    for (name, value) in own {
        field(name, value);
    }
    field("columns", columns);
    let said = serde_json::to_string(report).expect("plain data becomes JSON");
    field("report", &said);
    let document = document.text();
    text + "  \"document\": " + &document.trim_end().replace('\n', "\n  ") + "\n}\n"
}

fn text_in_json(text: &str) -> String {
    serde_json::to_string(text).expect("a text becomes JSON")
}

/// A field of CSV: in quotation marks where it holds what would end it (RFC 4180).
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}
