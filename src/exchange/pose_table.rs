//! Key frames from a table: CSV, or cells copied from a spreadsheet. What cannot be taken over is listed by its row, and the
//! rest is read.

pub use crate::source::expression::AngleUnit;

use crate::document::fault::{Fault, FaultCode, Place, excerpt};
use crate::document::number::typed;
use crate::document::reader::Node;
use crate::document::schema::KeyFrameEntry;
use crate::document::text::{MAX_TEXT, not_json};
use crate::exchange::delimited::{Separator, fields, number, rows, separator};
use crate::exchange::pose_columns::{Convention, Layout, by_headings, by_number, heading};
use crate::exchange::pose_rows::{Reader, SkippedRow};
use crate::math::orientation::from_angles;
use serde::{Deserialize, Serialize};

/// Rows at the beginning from which separator and columns are told.
const SAMPLE: usize = 20;
/// Deviation of a quaternion or matrix from a rotation that is rounding of all its digits.
const ROUNDING: f64 = 1e-9;
/// Most fields of a row that are looked at.
const MAX_COLUMNS: usize = 1_000;

/// What is known of a table beside its text; what is not said is told from its headings, or from the number of its columns.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct PoseTableRequest {
    /// How rotations are given.
    pub convention: Option<Convention>,
    /// The order of three angles, as [`from_angles`] has it; "xyz" without.
    pub order: Option<String>,
    /// The unit of angles; degrees without, and where no heading says otherwise.
    pub angles: Option<AngleUnit>,
    /// Whether the table has times; without headings in its first column with numbers.
    pub time: Option<bool>,
    /// Factor of lengths, from the table's unit to the document's; 1 without.
    pub scale: Option<f64>,
}

impl PoseTableRequest {
    /// From JSON; empty text asks for nothing.
    ///
    /// # Errors
    /// Where that is no request.
    pub fn read(json: &str) -> Result<Self, Fault> {
        if json.trim().is_empty() {
            return Ok(Self::default());
        }
        let node: Node = serde_json::from_str(json).map_err(|error| not_json(&error))?;
        let request = Self::deserialize(&node).map_err(|refusal| refusal.fault(&Place::WHOLE))?;
        check_request(&request)?;
        Ok(request)
    }
}

/// What was read.
#[derive(Clone, Debug, Serialize)]
pub struct PoseTable {
    /// In the order of the rows, angles in degrees.
    pub key_frames: Vec<KeyFrameEntry>,
    /// What the table was taken for.
    pub understood: Understood,
    /// The first rows that could not be taken over, up to [`MAX_SKIPPED`](crate::exchange::pose_rows::MAX_SKIPPED).
    pub skipped: Vec<SkippedRow>,
    /// All of them.
    pub skipped_count: usize,
}

/// What a table was taken for.
#[derive(Clone, Debug, Serialize)]
pub struct Understood {
    /// What stands between fields.
    pub separator: Separator,
    /// Whether the first row has headings.
    pub header: bool,
    /// How rotations are given.
    pub convention: Convention,
    /// The order of angles; none where there are no angles in an order.
    pub order: Option<String>,
    /// The unit of angles.
    pub angles: AngleUnit,
    /// Whether there are times.
    pub time: bool,
    /// The factor of lengths.
    pub scale: f64,
    /// The columns from left to right.
    pub columns: Vec<ColumnRead>,
    /// What could have been understood otherwise, in sentences.
    pub assumed: Vec<String>,
}

/// A column of the table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ColumnRead {
    /// As it stands there, with its unit where a row below has one; empty without headings.
    pub heading: String,
    /// What it was taken for, such as x, qw, time or name; empty where it is not read.
    pub role: String,
}

/// [`read_pose_table`] with the request in JSON.
///
/// # Errors
/// Where the request is none, or [`read_pose_table`] has an error.
pub fn read_pose_table_asked(text: &str, request: &str) -> Result<PoseTable, Fault> {
    read_pose_table(text, &PoseTableRequest::read(request)?)
}

/// Reads a table of poses, a row each.
///
/// Fields are parted by tabs, semicolons, commas or blanks, and may stand in quotation marks; where the comma does not part
/// them, it may be the decimal sign. Lines that begin with # are comments. Columns are told by their headings, which a row
/// of units may follow, or else by their number.
///
/// ```
/// use synthetica::exchange::pose_table::{PoseTableRequest, read_pose_table};
///
/// let table = read_pose_table("x;y;z\n1,5;2;3\n4;5;what\n", &PoseTableRequest::default())?;
/// assert_eq!(table.key_frames[0].x, 1.5);
/// assert_eq!((table.skipped[0].row, table.skipped_count), (3, 1));
/// # Ok::<(), synthetica::Fault>(())
/// ```
///
/// # Errors
/// When there is no row that could be taken over, the columns cannot be told, or the request does not fit.
pub fn read_pose_table(text: &str, request: &PoseTableRequest) -> Result<PoseTable, Fault> {
    if text.len() > MAX_TEXT {
        let what = format!("{} bytes of text are too many", text.len());
        let accepted = format!("up to {MAX_TEXT} bytes");
        return Err(Fault::new(FaultCode::TextTooLong, &TABLE, &what, &accepted));
    }
    check_request(request)?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let separator = separator(rows(text).take(SAMPLE));
    let sample: Vec<Vec<String>> = rows(text)
        .take(SAMPLE)
        .filter_map(|row| fields(row.text, separator))
        .collect();
    let Some(first) = sample.first() else {
        return Err(Fault::new(
            FaultCode::EmptyText,
            &TABLE,
            "there are no rows",
            LAYOUTS,
        ));
    };
    let header = is_header(first, &sample, separator);
    let mut headings = if header { first.clone() } else { Vec::new() };
    let units = sample
        .get(1)
        .filter(|row| is_units(&headings, row, separator));
    let above = usize::from(header) + usize::from(units.is_some());
    for (heading, unit) in headings.iter_mut().zip(units.into_iter().flatten()) {
        if !unit.is_empty() {
            *heading = format!("{heading}[{unit}]");
        }
    }
    let body = &sample[above..];
    let (layout, assumed) = layout(&headings, body, separator, request)?;
    let (angles, angles_said) = angle_unit(&layout, &headings, request);
    let reader = Reader {
        columns: columns_of(&headings, body),
        layout,
        separator,
        in_degrees: angles == AngleUnit::Degrees,
        order: request.order.clone().unwrap_or_else(|| "xyz".to_owned()),
        scale: request.scale.unwrap_or(1.0),
    };
    let taken = reader.read(rows(text).skip(above));
    let mut understood = understood(&reader, header, &headings, angles);
    understood.assumed = [assumed, angles_said].concat();
    if taken.error > ROUNDING {
        let off = taken.error;
        understood.assumed.push(format!(
            "The rotations are off by up to {off:.1e}: the nearest ones are taken."
        ));
    }
    let table = PoseTable {
        key_frames: taken.key_frames,
        understood,
        skipped: taken.skipped,
        skipped_count: taken.skipped_count,
    };
    if table.key_frames.is_empty() {
        let (what, accepted) = match table.skipped.first() {
            Some(SkippedRow {
                row,
                what,
                accepted,
            }) => (
                format!("no row can be taken over; row {row}: {what}"),
                accepted.as_str(),
            ),
            None => ("there are headings and no rows".to_owned(), LAYOUTS),
        };
        return Err(Fault::new(FaultCode::WrongType, &TABLE, &what, accepted));
    }
    Ok(table)
}

const TABLE: Place<'static> = Place::WHOLE.field("table");

const LAYOUTS: &str = "a row for each pose: x y z alone, or with longitude latitude roll, with qw qx qy qz, with nine numbers of a matrix, or with roll pitch yaw; a time before them, a name, and headings are optional";

fn check_request(request: &PoseTableRequest) -> Result<(), Fault> {
    if let Some(order) = &request.order {
        from_angles([0.0; 3], order).map_err(|refusal| {
            let place = Place::WHOLE.field("order");
            Fault::new(
                FaultCode::UnknownValue,
                &place,
                &refusal.what(),
                &refusal.accepted(),
            )
        })?;
    }
    /// Ångström to a thousand kilometres, and more.
    const FACTORS: std::ops::RangeInclusive<f64> = 1e-18..=1e18;
    if let Some(scale) = request.scale.filter(|scale| !FACTORS.contains(scale)) {
        let what = format!("{} is out of range", typed(scale));
        let place = Place::WHOLE.field("scale");
        let accepted = "a factor of lengths from 1e-18 to 1e18";
        return Err(Fault::new(FaultCode::OutOfRange, &place, &what, accepted));
    }
    Ok(())
}

/// The first row has headings where fewer of its fields are numbers than of the rows behind it, and not half of them.
fn is_header(first: &[String], sample: &[Vec<String>], separator: Separator) -> bool {
    let numbers = |row: &[String]| {
        row.iter()
            .filter(|f| number(f, separator).is_some())
            .count()
    };
    let own = numbers(first);
    let behind = sample[1..].iter().map(|row| numbers(row)).max();
    2 * own < first.len() && behind.is_none_or(|most| own < most || most == 0) && own < 3
}

/// The row below headings without units has the units where none of its fields is a number and x, y and z have the same.
fn is_units(headings: &[String], row: &[String], separator: Separator) -> bool {
    let Some(Layout { position, .. }) = by_headings(headings, None) else {
        return false;
    };
    let unit = |column: usize| row.get(column).map_or("", String::as_str);
    let [x, y, z] = position.map(unit);
    let is_name = |text: &String| heading(text).1.is_empty();
    !x.is_empty()
        && x == y
        && y == z
        && headings.iter().all(is_name)
        && row.iter().all(|field| number(field, separator).is_none())
}

fn columns_of(headings: &[String], body: &[Vec<String>]) -> usize {
    if !headings.is_empty() {
        return headings.len().min(MAX_COLUMNS);
    }
    // Of rows without headings the number that most of them have, the first of equals.
    let alike = |row: &&Vec<String>| body.iter().filter(|other| other.len() == row.len()).count();
    let most = body.iter().rev().max_by_key(alike);
    most.map_or(0, Vec::len).min(MAX_COLUMNS)
}

/// By the headings, else by the number of columns with numbers.
fn layout(
    headings: &[String],
    body: &[Vec<String>],
    separator: Separator,
    request: &PoseTableRequest,
) -> Result<(Layout, Vec<String>), Fault> {
    if let Some(mut layout) = by_headings(headings, request.convention)
        && (request.time != Some(true) || layout.time.is_some())
    {
        if request.time == Some(false) {
            layout.time = None;
        }
        let said = "No headings of rotations: they stay 0.".to_owned();
        let is_left = layout.convention == Convention::Positions && request.convention.is_none();
        return Ok((layout, if is_left { vec![said] } else { Vec::new() }));
    }
    let is_number = |row: &Vec<String>, column: usize| {
        row.get(column)
            .is_some_and(|field| number(field, separator).is_some())
    };
    let (mut columns, mut name) = (Vec::new(), None);
    for column in 0..columns_of(headings, body) {
        let filled = |row: &&Vec<String>| row.get(column).is_some_and(|field| !field.is_empty());
        if body.iter().any(|row| is_number(row, column)) {
            columns.push(column);
        } else if body.iter().any(|row| filled(&row)) {
            name = name.or(Some(column));
        }
    }
    let numbers = |row: &Vec<String>| {
        let own = columns
            .iter()
            .map(|&c| row.get(c).and_then(|f| number(f, separator)));
        own.collect::<Option<Vec<f64>>>()
    };
    let sample: Vec<Vec<f64>> = body.iter().filter_map(numbers).collect();
    if let Some(guess) = by_number(&columns, name, &sample, request.convention, request.time) {
        let mut assumed = guess.assumed;
        if !headings.is_empty() {
            assumed.insert(
                0,
                "The headings do not say what the columns are: they are taken in their order."
                    .to_owned(),
            );
        }
        return Ok((guess.layout, assumed));
    }
    let count = columns.len();
    let what = if headings.is_empty() {
        format!("what {count} columns with numbers are cannot be told")
    } else {
        let list = excerpt(&headings.join(", "));
        format!("what the columns {list} are cannot be told")
    };
    Err(Fault::new(FaultCode::WrongCount, &TABLE, &what, LAYOUTS))
}

/// The request's unit of angles, else that of the headings, else degrees.
fn angle_unit(
    layout: &Layout,
    headings: &[String],
    request: &PoseTableRequest,
) -> (AngleUnit, Vec<String>) {
    let has_angles = matches!(
        layout.convention,
        Convention::LongitudeLatitudeRoll | Convention::RollPitchYaw
    );
    if let Some(unit) = request.angles {
        return (unit, Vec::new());
    }
    if !has_angles {
        return (AngleUnit::Degrees, Vec::new());
    }
    let units = layout
        .rotation
        .iter()
        .filter_map(|&column| headings.get(column));
    let units: Vec<String> = units.map(|text| heading(text).1).collect();
    let is =
        |words: &[&str]| !units.is_empty() && units.iter().all(|u| words.contains(&u.as_str()));
    if is(&["rad", "radian", "radians"]) {
        return (AngleUnit::Radians, Vec::new());
    }
    let said = "Angles are taken for degrees.".to_owned();
    let known = is(&["deg", "degree", "degrees", "\u{b0}"]);
    (
        AngleUnit::Degrees,
        if known { Vec::new() } else { vec![said] },
    )
}

fn understood(reader: &Reader, header: bool, headings: &[String], angles: AngleUnit) -> Understood {
    let column = |i: usize| ColumnRead {
        heading: headings
            .get(i)
            .map_or_else(String::new, |text| excerpt(text)),
        role: reader.layout.role(i),
    };
    Understood {
        separator: reader.separator,
        header,
        convention: reader.layout.convention,
        order: (reader.layout.convention == Convention::RollPitchYaw).then(|| reader.order.clone()),
        angles,
        time: reader.layout.time.is_some(),
        scale: reader.scale,
        columns: (0..reader.columns).map(column).collect(),
        assumed: Vec::new(),
    }
}
