//! The columns of a motion are in the types of the JavaScript package and in the tables as the one list has them; and the
//! objects that go out as JSON have the fields that their types name.
#![cfg(not(target_arch = "wasm32"))]

use std::collections::BTreeSet;
use synthetica::Session;
use synthetica::document::report::Report;
use synthetica::exchange::table;
use synthetica::motion::columns::{COLUMNS, Column, Kind};

const TYPES: &str = include_str!("../src/bind/wasm.d.ts");
const SAMPLE: &str = include_str!("../www/mechanisms/3rps.json");

/// What the numbers of a column are, behind its meaning; the list says it by its kinds.
fn layout(kind: Kind) -> &'static str {
    match kind {
        Kind::Pose => " Seven numbers: x y z, then the rotation's quaternion x y z w.",
        Kind::Joints => " In rad or lengths.",
        Kind::Angle => " In rad.",
        Kind::Time | Kind::Length | Kind::Number | Kind::Count | Kind::Status => "",
    }
}

/// The fields of an interface as it declares them, with the comments above them.
fn written(fields: &[(&Column, &str)]) -> String {
    let field = |(column, kind): &(&Column, &str)| {
        let (comment, name) = (
            format!("{}{}", column.meaning, layout(column.kind)),
            column.name,
        );
        format!("  /** {comment} */\n  {name}: {kind};\n")
    };
    fields.iter().map(field).collect()
}

/// What stands between the braces of an interface.
fn interface(name: &str) -> &'static str {
    let head = format!("export interface {name} {{\n");
    let body = TYPES.split(head.as_str()).nth(1);
    let body = body.unwrap_or_else(|| panic!("wasm.d.ts has no interface {name}"));
    body.split("\n}").next().unwrap_or_default()
}

/// The names of its fields.
fn fields(name: &str) -> BTreeSet<&'static str> {
    let lines = interface(name)
        .lines()
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    let names = lines
        .filter_map(|line| line.trim().split_once(':'))
        .map(|(name, _)| name.trim_end_matches('?'));
    names.filter(|name| !name.contains([' ', '*'])).collect()
}

fn holds(name: &str, expected: &str, others: &[&str]) {
    assert!(
        interface(name).contains(expected.trim_end()),
        "the columns of {name} in src/bind/wasm.d.ts are not those of src/motion/columns.rs, which are\n\n{expected}"
    );
    let columns = COLUMNS.iter().map(|column| column.name);
    let all: BTreeSet<&str> = columns
        .filter(|column| expected.contains(&format!("  {column}: ")))
        .collect();
    let all: BTreeSet<&str> = all.into_iter().chain(others.iter().copied()).collect();
    assert_eq!(fields(name), all);
}

#[test]
fn the_type_of_a_motion_is_that_of_the_list() {
    let columns: Vec<(&Column, &str)> = (COLUMNS.iter())
        .map(|column| {
            let kind = match column.kind {
                Kind::Status => "Uint8Array",
                Kind::Count => "Uint32Array",
                Kind::Time
                | Kind::Length
                | Kind::Angle
                | Kind::Number
                | Kind::Pose
                | Kind::Joints => "Float64Array",
            };
            (column, kind)
        })
        .collect();
    let others = [
        "frames",
        "partial",
        "goal_frames",
        "report",
        "milliseconds",
        "rows",
        // Of typed documents.
        "plain",
        "parameters",
        "expressions",
    ];
    holds("Motion", &written(&columns), &others);
}

/// A posture has one frame, and so numbers where a motion has columns of them.
#[test]
fn the_type_of_a_posture_is_that_of_the_list() {
    let columns: Vec<(&Column, &str)> = (COLUMNS.iter())
        .filter(|column| !matches!(column.kind, Kind::Time | Kind::Status))
        .map(|column| {
            let kind = match column.kind {
                Kind::Pose | Kind::Joints => "Float64Array",
                Kind::Time
                | Kind::Length
                | Kind::Angle
                | Kind::Number
                | Kind::Count
                | Kind::Status => "number",
            };
            (column, kind)
        })
        .collect();
    holds(
        "Posture",
        &written(&columns),
        &["rows", "status", "value", "obstacle"],
    );
}

#[test]
fn a_table_has_the_columns_of_the_list() {
    let session = Session::open(SAMPLE).expect("a sample");
    let motion = session.plan();
    let mechanism = &session.problem().mechanism;
    let report = Report::new(mechanism, "m", &motion);
    let mut expected = vec!["frame".to_owned()];
    for column in &COLUMNS {
        let name = column.name;
        match column.kind {
            Kind::Time | Kind::Number | Kind::Count | Kind::Status => {
                expected.push(name.to_owned());
            }
            Kind::Length => expected.push(format!("{name}[m]")),
            Kind::Angle => expected.push(format!("{name}[deg]")),
            Kind::Pose => {
                let prefix = if name == "pose" {
                    String::new()
                } else {
                    format!("{name}_")
                };
                expected.extend(
                    ["x[m]", "y[m]", "z[m]", "qx", "qy", "qz", "qw"]
                        .map(|part| format!("{prefix}{part}")),
                );
            }
            Kind::Joints => {
                expected.extend(report.chains.iter().enumerate().flat_map(|(i, chain)| {
                    chain.variables.iter().map(move |variable| {
                        let unit = if variable.unit == "rad" { "deg" } else { "m" };
                        format!(
                            "chain{}_{}[{unit}]",
                            i + 1,
                            variable.label.replace('θ', "theta")
                        )
                    })
                }));
            }
        }
    }
    let text = table::csv(
        session.document(),
        mechanism,
        &motion,
        table::Headings::Units,
    );
    let found: Vec<&str> = text.lines().next().expect("a heading").split(',').collect();
    assert_eq!(found, expected);
}

/// The objects that go out as they are: every field has its type, and every type its field.
#[test]
fn the_types_of_reports_name_their_fields() {
    let session = Session::open(SAMPLE).expect("a sample");
    let motion = session.plan();
    let frame = motion.frames() / 2;
    let placed = |pose: &synthetica::math::pose::Pose| synthetica::motion::columns::placed([pose]);
    let insight = session
        .explain(motion.joints_at(frame), &placed(&motion.goals[frame]))
        .expect("closed loops");
    let report = serde_json::to_value(Report::new(&session.problem().mechanism, "m", &motion))
        .expect("plain data");
    let gaps = serde_json::to_value(session.problem().compare_metrics()).expect("plain data");
    let insight = serde_json::to_value(insight).expect("plain data");
    for (name, value) in [
        ("Report", &report),
        ("MetricReport", &report["metric"]),
        ("BoundsReport", &report["bounds"]),
        ("ChainReport", &report["chains"][0]),
        ("Insight", &insight),
        ("Screw", &insight["freedoms"][0]),
        ("MetricGaps", &gaps[0]),
    ] {
        let value = value
            .as_object()
            .unwrap_or_else(|| panic!("{name} is no object"));
        assert_eq!(
            value.keys().map(String::as_str).collect::<BTreeSet<_>>(),
            fields(name),
            "{name}"
        );
    }
}
