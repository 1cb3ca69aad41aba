//! Documents: what is read, what is refused with which words, and what is written.

#![allow(
    clippy::float_cmp,
    reason = "numbers read from a text are the ones that stand there"
)]

use nalgebra::Vector3;
use serde_json::{Value, json};
use std::fs;
use std::time::Instant;
use synthetica::document::defaults::defaults;
use synthetica::document::fault::{Fault, FaultCode};
use synthetica::document::problem::{Problem, start_values};
use synthetica::document::schema::Document;
use synthetica::document::text::{MAX_TEXT, parse};
use synthetica::math::metric::MetricKind;
use synthetica::model::chain::Chain;
use synthetica::model::joint::JointKind;
use synthetica::plan::settings::Settings;

/// A document with every field: two chains, every kind of joint, times, limits, starts.
const WHOLE: &str = r#"{
  "$schema": "../document.schema.json", "version": 1, "name": "all", "about": "one of each", "length_unit": "m",
  "chains": [
    {
      "name": "left leg", "base": {"x": 1, "longitude": 30},
      "joints": [
        {"type": "R", "rows": [{"alpha": 10, "a": 1, "theta": 20, "d": 0.5}], "limits": [{"min": -90, "max": 90}]},
        {"type": "P", "rows": [{}], "limits": [{"max": 2}]},
        {"type": "T", "rows": [{}, {"alpha": -90, "theta": 5, "d": 0.25}], "limits": [null, {"min": -10}]}
      ],
      "gripper": {"z": 1}, "start": [45, 0.9, -30, 0]
    },
    {"joints": [{"type": "C", "rows": [{}]}, {"type": "S", "rows": [{}, {"alpha": 90}, {"alpha": -90, "d": 1}]}]},
    {"joints": [{"type": "E", "rows": [{"a": 1}, {"alpha": 90, "theta": 90}, {"alpha": 90}]}], "start": [1, 2, 90]}
  ],
  "motion": {
    "key_frames": [{"name": "rest", "x": 1, "time": 0}, {"x": 1.5, "roll": 20, "time": 2}, {"name": "lift", "y": 1, "time": 3}],
    "interpolation": "sclerp", "frames": 9, "reference": [0.5, 0, 0.25], "radius": 40
  },
  "planner": {
    "method": "gradient", "metric": "dual-quaternion", "metric_length": 2, "metric_origin": [1, 2, 3],
    "dimension_tolerance": 0.001, "max_iterations": 100
  }
}"#;

fn read(text: &str) -> Result<Problem, Fault> {
    Problem::new(&parse(text)?)
}

/// The whole document with one value replaced, or put there if the last step is a new field.
fn with(pointer: &str, value: Value) -> String {
    let mut document: Value = serde_json::from_str(WHOLE).expect("JSON");
    let (parent, last) = pointer.rsplit_once('/').expect("a pointer");
    match document.pointer_mut(parent).expect("a place") {
        Value::Object(fields) => drop(fields.insert(last.into(), value)),
        Value::Array(entries) => entries[last.parse::<usize>().expect("an index")] = value,
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {
            panic!("{pointer} leads nowhere")
        }
    }
    document.to_string()
}

fn without(pointer: &str) -> String {
    let mut document: Value = serde_json::from_str(WHOLE).expect("JSON");
    let (parent, last) = pointer.rsplit_once('/').expect("a pointer");
    let parent = document
        .pointer_mut(parent)
        .and_then(Value::as_object_mut)
        .expect("an object");
    parent.remove(last).expect("a field");
    document.to_string()
}

fn samples() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/www/mechanisms");
    let index = fs::read_to_string(format!("{folder}/index.json")).expect("the samples' index");
    let index: Vec<Value> = serde_json::from_str(&index).expect("a list");
    let file = |entry: &Value| entry["file"].as_str().expect("a file's name").to_owned();
    let text = |name: &String| fs::read_to_string(format!("{folder}/{name}")).expect("a sample");
    // Those of makers are typed documents, which are read in another room.
    let is_plain = |(_, text): &(String, String)| !text.contains("\"parameters\"");
    index
        .iter()
        .map(file)
        .map(|name| (name.clone(), text(&name)))
        .filter(is_plain)
        .collect()
}

#[test]
fn a_whole_document_becomes_a_problem() {
    let problem = read(WHOLE).expect("a document");
    let chains = problem.mechanism.chains();
    assert_eq!(
        chains.iter().map(Chain::type_name).collect::<Vec<_>>(),
        ["RPT", "CS", "E"]
    );
    assert_eq!(
        chains.iter().map(Chain::name).collect::<Vec<_>>(),
        ["left leg", "chain 2", "chain 3"]
    );
    assert_eq!(problem.start.len(), 3);
    assert_eq!(
        problem.start[0],
        Some(vec![45_f64.to_radians(), 0.9, -30_f64.to_radians(), 0.0])
    );
    assert_eq!(problem.start[1], None);
    assert_eq!(problem.start[2], Some(vec![1.0, 2.0, 90_f64.to_radians()]));
    let limits: Vec<_> = chains[0].limits().map(|l| [l.min, l.max]).collect();
    let (right, open) = (90_f64.to_radians(), f64::INFINITY);
    assert_eq!(
        limits,
        [
            [-right, right],
            [-open, 2.0],
            [-open, open],
            [-10_f64.to_radians(), open]
        ]
    );
    assert_eq!(problem.goals.len(), 9);
    assert_eq!(problem.goals[8].time, 3.0);
    assert_eq!(problem.settings.metric_length, Some(2.0));
    assert_eq!(problem.settings.metric, MetricKind::DualQuaternion);
    assert_eq!(
        problem.settings.metric_origin,
        Some(Vector3::new(1.0, 2.0, 3.0))
    );
    assert_eq!(problem.settings.dimension_tolerance, 0.001);
    assert_eq!(problem.settings.max_iterations, Some(100));
    assert!((chains[0].base().rotation.angle().to_degrees() - 30.0).abs() < 1e-12);
}

#[test]
fn fields_that_may_be_left_out_have_defaults() {
    let text = r#"{"version": 1, "chains": [{"joints": [{"type": "R", "rows": [{}]}]}],
                   "motion": {"key_frames": [{}, {"roll": 90}]}}"#;
    let problem = read(text).expect("a document");
    assert_eq!(problem.goals.len(), 33);
    assert_eq!(problem.settings, Settings::default());
    assert_eq!(problem.start, [None]);
    // null stands for an optional field that is not given; a byte-order mark is no fault.
    let nulls = text
        .replace(r#""joints""#, r#""start": null, "joints""#)
        .replace("[{}]", r#"[{}], "limits": null"#);
    assert!(read(&format!("\u{feff}{nulls}")).is_ok());
}

#[test]
fn the_default_document_plans_and_every_default_joint_fits() {
    let defaults = defaults();
    assert!(read(&defaults.document).is_ok());
    assert_eq!(
        parse(&defaults.document).expect("a document").text(),
        defaults.document
    );
    for kind in JointKind::ALL {
        let joint = serde_json::to_value(&defaults.joints[&kind.letter()]).expect("JSON");
        assert_eq!(joint["type"], kind.letter().to_string());
        let text = without("/chains/0/start");
        let mut document: Value = serde_json::from_str(&text).expect("JSON");
        document["chains"][0]["joints"] = json!([joint]);
        assert!(read(&document.to_string()).is_ok(), "{kind:?}");
    }
}

#[test]
fn samples_are_read_and_stay_as_they_are() {
    let samples = samples();
    assert!(!samples.is_empty());
    for (name, text) in samples {
        let document = parse(&text).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        Problem::new(&document).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        let normal = document.text();
        assert_eq!(
            parse(&normal).expect("a normalised document").text(),
            normal,
            "{name}"
        );
    }
}

/// Editors write the schema's address into a document.
#[test]
fn the_address_of_a_schema_is_kept() {
    let document = parse(WHOLE).expect("a document");
    let first = "{\n  \"$schema\": \"../document.schema.json\",\n  \"version\": 1,";
    assert!(document.text().starts_with(first), "{}", document.text());
    let without = parse(&without("/$schema")).expect("a document");
    assert!(!without.text().contains("$schema"));
}

#[test]
fn writing_keeps_fifteen_digits_and_wastes_none() {
    let written = |x: f64| {
        let mut document = parse(WHOLE).expect("a document");
        document.chains[0].base.y = x;
        let text = document.text();
        let again = parse(&text).expect("a document");
        assert!(
            (again.chains[0].base.y - x).abs() <= 5.1e-15 * x.abs(),
            "{x:e}"
        );
        assert_eq!(again.text(), text);
        text.split_once("\"y\": ")
            .and_then(|(_, rest)| rest.split_once(','))
            .expect("y")
            .0
            .to_owned()
    };
    // One case a line.
    #[rustfmt::skip]
    let cases = [
        (1.0, "1"), (-1.0, "-1"), (0.0, "0"), (-0.0, "0"), (0.1 + 0.2, "0.3"), (1.0 / 3.0, "0.333333333333333"),
        (-44.999_999_999_999_99, "-45"), (123_456.789, "123456.789"), (999_999.999_999_999_9, "1000000"),
        (1e-6, "0.000001"), (1.5e-9, "1.5e-9"), (1e14, "100000000000000"), (1.25e300, "1.25e300"), (5e-324, "4.94065645841247e-324"),
    ];
    for (x, text) in cases {
        assert_eq!(written(x), text);
    }
    let mut state = 15_u64;
    for _ in 0..3_000 {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let x = f64::from_bits(state);
        if x.is_normal() && x.abs() < 1e300 {
            written(x);
        }
        // And of the sizes that documents have.
        written((state >> 11) as f64 / (1_u64 << (40 + state % 20)) as f64);
    }
}

#[test]
fn writing_breaks_lines_where_they_get_long() {
    let normal = parse(WHOLE).expect("a document").text();
    assert!(
        normal.contains(r#"{"x": 1, "y": 0, "z": 0, "longitude": 30, "latitude": 0, "roll": 0}"#),
        "{normal}"
    );
    assert!(normal.contains("\n  \"chains\": [\n"), "{normal}");
    assert!(normal.lines().all(|line| line.len() <= 140), "{normal}");
    let quoted = with("/name", json!("a \"b\" \\ {[,:]} \u{e4}\n-0.0"));
    assert_eq!(
        parse(&parse(&quoted).expect("a document").text())
            .expect("again")
            .name,
        "a \"b\" \\ {[,:]} \u{e4}\n-0.0"
    );
}

#[test]
fn a_found_start_is_written_in_the_documents_units() {
    let mut document = parse(WHOLE).expect("a document");
    let mechanism = Problem::new(&document).expect("a problem").mechanism;
    let degrees = [[45.0, 0.9, -30.0, 0.0], [12.345_678_901, 2.0, 30.0, 60.0]];
    let joints = [
        45_f64.to_radians(),
        0.9,
        -30_f64.to_radians(),
        0.0,
        12.345_678_901_f64.to_radians(),
        2.0,
        30_f64.to_radians(),
        60_f64.to_radians(),
        90_f64.to_radians(),
        1.0,
        2.0,
        180_f64.to_radians(),
    ];
    document.set_start(&mechanism, &joints);
    assert_eq!(document.chains[0].start.as_deref(), Some(&degrees[0][..]));
    assert_eq!(
        document.chains[1].start,
        Some([&degrees[1][..], &[90.0]].concat())
    );
    assert_eq!(document.chains[2].start, Some(vec![1.0, 2.0, 180.0]));
    let again = read(&document.text()).expect("a document");
    let values: Vec<f64> = again.start.iter().flatten().flatten().copied().collect();
    assert!(
        values
            .iter()
            .zip(joints)
            .all(|(a, b)| (a - b).abs() < 1e-14)
    );
    assert_eq!(
        start_values(&mechanism, &values),
        document
            .chains
            .iter()
            .map(|c| c.start.clone().expect("set"))
            .collect::<Vec<_>>()
    );
}

/// A bad document: its text, the fault's code and path, words of the message, words of `accepted`.
type Case = (String, FaultCode, &'static str, &'static str, &'static str);

fn check((text, code, place, words, accepted): Case) {
    let shown: String = text.chars().take(200).collect();
    let fault = read(&text)
        .err()
        .unwrap_or_else(|| panic!("{place} was accepted: {shown}"));
    assert_eq!(
        (fault.code, fault.place.as_str()),
        (code, place),
        "{fault:?} for {shown}"
    );
    assert!(
        fault.message.contains(words),
        "“{}” has no “{words}”",
        fault.message
    );
    let null = if fault.optional { ", or null" } else { "" };
    let all = format!("{}{null}", fault.accepted);
    assert!(all.contains(accepted), "“{all}” has no “{accepted}”");
    let told = format!("{}. Accepted: {all}.", fault.what);
    assert!(fault.message.ends_with(&told), "{}", fault.message);
    assert!(fault.message.len() < 600, "{}", fault.message);
}

#[test]
fn texts_that_are_no_document_are_refused() {
    use FaultCode::{EmptyText, MissingField, Syntax, TextTooLong, UnknownVersion, WrongType};
    let deep = |open: &str| format!(r#"{{"version": 1, "x": {}"#, open.repeat(100_000));
    // One case a line.
    #[rustfmt::skip]
    let cases: Vec<Case> = vec![
        (String::new(), EmptyText, "", "The document", "JSON"),
        (" \n\u{feff}".into(), Syntax, "", "Line 2, column 1. The document", "JSON"),
        ("\u{feff} \n".into(), EmptyText, "", "The document", "JSON"),
        (" ".repeat(MAX_TEXT + 1), TextTooLong, "", "32000001 bytes", "32,000,000"),
        ("nonsense".into(), Syntax, "", "not JSON", "JSON"),
        ("<html>".into(), Syntax, "", "Line 1, column 1", "JSON"),
        ("null".into(), WrongType, "", "null", "object"),
        ("[]".into(), WrongType, "", "a list", "object"),
        ("3".into(), WrongType, "", "the number 3", "object"),
        ("{}".into(), MissingField, "version", "Version", "1"),
        (WHOLE[..WHOLE.len() - 40].into(), Syntax, "", "Line 22, column 21. The document: this is not JSON, EOF", "JSON"),
        (format!("{WHOLE} {{}}"), Syntax, "", "trailing", "JSON"),
        (format!("{WHOLE}\0"), Syntax, "", "trailing", "JSON"),
        (WHOLE.replacen("\"x\": 1,", "\"x\": NaN,", 1), Syntax, "", "Line 5, column", "JSON"),
        (WHOLE.replacen("\"x\": 1,", "\"x\": Infinity,", 1), Syntax, "", "Line 5, column", "JSON"),
        (WHOLE.replacen("\"x\": 1,", "\"x\": -Infinity,", 1), Syntax, "", "Line 5, column", "JSON"),
        (WHOLE.replacen("\"x\": 1,", "\"x\": 1e999,", 1), Syntax, "", "Line 5, column 45. The document: this is not JSON, number out of range", "JSON"),
        (WHOLE.replacen("\"x\": 1,", "\"x\": 01,", 1), Syntax, "", "Line 5, column", "JSON"),
        (WHOLE.replacen("\"x\": 1,", "\"x\": 1,,", 1), Syntax, "", "Line 5", "JSON"),
        (WHOLE.replacen("\"m\"", "'m'", 1), Syntax, "", "Line 2", "JSON"),
        (deep("["), Syntax, "", "recursion limit", "JSON"),
        (deep("{\"x\":"), Syntax, "", "recursion limit", "JSON"),
        ("[".repeat(500_000), Syntax, "", "recursion limit", "JSON"),
        (with("/version", json!(2)), UnknownVersion, "version", "version 2", "1"),
        (r#"{"version": 7, "linkage": {"new": true}}"#.into(), UnknownVersion, "version", "version 7", "1"),
        (with("/version", json!("1")), WrongType, "version", "the text \u{201c}1\u{201d}", "whole number"),
        (with("/version", json!(-1)), UnknownVersion, "version", "version -1", "1"),
    ];
    cases.into_iter().for_each(check);
}

#[test]
fn fields_that_are_wrong_are_refused() {
    use FaultCode::{
        DuplicateField, MissingField, OutOfRange, UnknownField, UnknownValue, WrongType,
    };
    let long = "x".repeat(100_000);
    // One case a line.
    #[rustfmt::skip]
    let cases: Vec<Case> = vec![
        (with("/\u{e4}", json!("red")), UnknownField, "\u{e4}", "\u{e4}: there is no field", "planner"),
        (with("/planner/metric_length", json!("1")), WrongType, "planner.metric_length", "the text \u{201c}1\u{201d}", "a number, or null"),
        (with("/motion/reference", json!([0, 0, "a"])), WrongType, "motion.reference[2]", "Motion, reference, entry 3", "a number"),
        (with("/colour", json!("red")), UnknownField, "colour", "there is no field", "chains"),
        (with("/chains/1/color", json!(1)), UnknownField, "chains[1].color", "Chain 2, color", "gripper"),
        (with("/chains/0/base/X", json!(1)), UnknownField, "chains[0].base.X", "base frame", "longitude"),
        (with("/chains/0/joints/2/kind", json!(1)), UnknownField, "chains[0].joints[2].kind", "Chain 1, joint 3, kind", "type"),
        (with("/chains/0/joints/2/rows/1/r", json!(1)), UnknownField, "chains[0].joints[2].rows[1].r", "row 2", "alpha, a, theta, d"),
        (with("/chains/0/joints/2/limits/1/low", json!(1)), UnknownField, "chains[0].joints[2].limits[1].low", "limits of freedom 2", "min, max"),
        (with("/motion/key_frames/2/pitch", json!(1)), UnknownField, "motion.key_frames[2].pitch", "Key frame 3", "latitude"),
        (with("/motion/steps", json!(1)), UnknownField, "motion.steps", "Motion, steps", "frames"),
        (with("/planner/tolerance", json!(1)), UnknownField, "planner.tolerance", "Planner", "metric_length"),
        (with("/a, expected `b", json!(1)), UnknownField, "a, expected `b", "there is no field", "chains"),
        (with(&format!("/{long}"), json!(1)), UnknownField, &*format!("{}…", "x".repeat(80)).leak(), "there is no field", "chains"),
        (without("/chains"), MissingField, "chains", "Chains", "list of chains"),
        (without("/motion"), MissingField, "motion", "Motion", "key_frames"),
        (without("/motion/key_frames"), MissingField, "motion.key_frames", "key frames", "two or more"),
        (without("/chains/1/joints"), MissingField, "chains[1].joints", "Chain 2, joints", "list of joints"),
        (without("/chains/1/joints/0/type"), MissingField, "chains[1].joints[0].type", "Chain 2, joint 1, type", "R, P, C, T, S, E"),
        (without("/chains/1/joints/0/rows"), MissingField, "chains[1].joints[0].rows", "joint 1, rows", "rows"),
        (WHOLE.replacen("\"x\": 1,", "\"x\": 1, \"x\": 2,", 1), DuplicateField, "chains[0].base", "\u{201c}x\u{201d}", "x once"),
        (WHOLE.replacen("\"version\": 1,", "\"version\": 1, \"version\": 1,", 1), DuplicateField, "", "version", "version once"),
        (with("/chains/0/base/x", json!("1")), WrongType, "chains[0].base.x", "the text \u{201c}1\u{201d}", "a number"),
        (with("/chains/0/base/x", json!(null)), WrongType, "chains[0].base.x", "null", "a number"),
        (with("/chains/0/base/x", json!(true)), WrongType, "chains[0].base.x", "true", "a number"),
        (with("/chains/0/base/x", json!({})), WrongType, "chains[0].base.x", "an object", "a number"),
        (with("/chains/0/base/x", json!([1])), WrongType, "chains[0].base.x", "a list", "a number"),
        (with("/chains/0/base/x", json!(long)), WrongType, "chains[0].base.x", "the text \u{201c}xxx", "a number"),
        (with("/chains/0/base", json!(3)), WrongType, "chains[0].base", "the number 3", "object"),
        // A list of the fields' values in order is not a frame, though serde would take it.
        (with("/chains/0/base", json!([0, 0, 0, 0, 0, 0])), WrongType, "chains[0].base", "a list", "object"),
        (with("/chains/0/joints/0/rows/0", json!([0, 0, 0, 0])), WrongType, "chains[0].joints[0].rows[0]", "a list", "object"),
        (with("/planner", json!(["newton", 1, 1])), WrongType, "planner", "a list", "object"),
        (with("/chains/0/name", json!(5)), WrongType, "chains[0].name", "the number 5", "text in quotes"),
        (with("/chains/0/joints", json!({})), WrongType, "chains[0].joints", "an object", "a list"),
        (with("/chains/0/joints/1", json!("P")), WrongType, "chains[0].joints[1]", "the text \u{201c}P\u{201d}", "object"),
        (with("/chains/0/start/1", json!("0.9")), WrongType, "chains[0].start[1]", "Chain 1, start value 2", "a number"),
        (with("/chains", json!(5)), WrongType, "chains", "the number 5", "a list"),
        (with("/motion/frames", json!(9.5)), WrongType, "motion.frames", "the number 9.5", "whole number"),
        (with("/motion/frames", json!(-9)), OutOfRange, "motion.frames", "-9", "whole number"),
        (with("/motion/frames", json!(10_000_000_000_u64)), OutOfRange, "motion.frames", "10000000000", "whole number"),
        (with("/motion/frames", json!("many")), WrongType, "motion.frames", "many", "whole number"),
        (with("/chains/0/joints/0/type", json!("U")), UnknownValue, "chains[0].joints[0].type", "\u{201c}U\u{201d}", "R, P, C, T, S, E"),
        (with("/chains/0/joints/0/type", json!(1)), WrongType, "chains[0].joints[0].type", "the number 1", "one of R, P, C, T, S, E"),
        (with("/chains/0/joints/0/type", json!({"R": null})), WrongType, "chains[0].joints[0].type", "an object", "one of R, P, C, T, S, E"),
        (with("/motion/interpolation", json!("linear")), UnknownValue, "motion.interpolation", "linear", "bezier, sclerp, straight"),
        (with("/planner/method", json!("magic")), UnknownValue, "planner.method", "magic", "newton, gradient"),
        (with("/planner/metric", json!("paper")), UnknownValue, "planner.metric", "paper", "pose, dual-quaternion"),
        (with("/planner/metric_origin", json!(0)), WrongType, "planner.metric_origin", "the number 0", "a list"),
    ];
    cases.into_iter().for_each(check);
}

#[test]
fn numbers_out_of_bounds_are_refused() {
    use FaultCode::OutOfRange;
    let huge = json!(1e308);
    // One case a line.
    #[rustfmt::skip]
    let cases: Vec<Case> = vec![
        (with("/chains/0/base/x", huge.clone()), OutOfRange, "chains[0].base.x", "Chain 1 \u{201c}left leg\u{201d}, base frame, x: 1e308", "from -1e12 to 1e12"),
        (with("/chains/1/gripper", json!({"roll": -1e7})), OutOfRange, "chains[1].gripper.roll", "Chain 2, gripper frame, roll", "degrees"),
        (with("/chains/0/joints/2/rows/1/d", huge.clone()), OutOfRange, "chains[0].joints[2].rows[1].d", "joint 3, row 2, d", "length"),
        (with("/chains/0/joints/2/rows/1/theta", huge.clone()), OutOfRange, "chains[0].joints[2].rows[1].theta", "row 2, theta", "degrees"),
        (with("/chains/0/joints/0/limits/0/max", huge.clone()), OutOfRange, "chains[0].joints[0].limits[0].max", "limits of freedom 1, max", "degrees"),
        (with("/chains/0/joints/1/limits/0/max", huge.clone()), OutOfRange, "chains[0].joints[1].limits[0].max", "joint 2, limits of freedom 1, max", "a length"),
        (with("/chains/0/start/0", huge.clone()), OutOfRange, "chains[0].start[0]", "start value 1", "degrees"),
        (with("/chains/0/start/1", huge.clone()), OutOfRange, "chains[0].start[1]", "start value 2", "a length"),
        (with("/motion/key_frames/2/y", huge.clone()), OutOfRange, "motion.key_frames[2].y", "Key frame 3 \u{201c}lift\u{201d}, y", "from -1e12 to 1e12"),
        (with("/motion/key_frames/2/time", huge.clone()), OutOfRange, "motion.key_frames[2].time", "Key frame 3 \u{201c}lift\u{201d}, time", "a time"),
        (with("/motion/frames", json!(0)), OutOfRange, "motion.frames", "Motion, frames: 0", "2 to 100001"),
        (with("/motion/frames", json!(1)), OutOfRange, "motion.frames", "Motion, frames: 1", "2 to 100001"),
        (with("/motion/frames", json!(1_000_000_000)), OutOfRange, "motion.frames", "1000000000", "2 to 100001"),
        (with("/motion/radius", json!(0)), OutOfRange, "motion.radius", "Motion, radius: 0", "null"),
        (with("/motion/radius", json!(-20)), OutOfRange, "motion.radius", "-20", "positive length"),
        (with("/motion/radius", json!(0.5)), OutOfRange, "motion.radius", "0.5 is", "not below 0.5731, half"),
        (with("/motion/radius", huge.clone()), OutOfRange, "motion.radius", "1e308", "a length"),
        (with("/planner/metric_length", json!(0)), OutOfRange, "planner.metric_length", "Planner, metric length: 0", "from 1e-12 to 1e12, or null"),
        (with("/planner/metric_length", json!(-1)), OutOfRange, "planner.metric_length", "-1", "length"),
        (with("/planner/metric_length", huge.clone()), OutOfRange, "planner.metric_length", "Planner", "length"),
        (with("/planner/metric_origin", json!([0, 1e13, 0])), OutOfRange, "planner.metric_origin[1]", "Planner", "a length"),
        (with("/planner/dimension_tolerance", json!(-1e-9)), OutOfRange, "planner.dimension_tolerance", "-1e-9", "from 0 to 0.01"),
        (with("/planner/dimension_tolerance", huge), OutOfRange, "planner.dimension_tolerance", "1e308", "from 0 to 0.01"),
        (with("/planner/max_iterations", json!(0)), OutOfRange, "planner.max_iterations", "max iterations: 0", "from 1"),
        (with("/planner/max_iterations", json!(1_000_000)), OutOfRange, "planner.max_iterations", "1000000", "100000"),
    ];
    cases.into_iter().for_each(check);
    // Each bound itself is accepted.
    for (pointer, value) in [
        ("/chains/0/base/x", json!(-1e12)),
        ("/chains/0/base/roll", json!(1e6)),
        ("/motion/radius", json!(1e12)),
        ("/planner/metric_length", json!(1e-12)),
        ("/planner/metric_length", json!(1e12)),
        ("/planner/metric_origin", json!([1e12, -1e12, 0])),
        ("/planner/dimension_tolerance", json!(0)),
        ("/planner/dimension_tolerance", json!(0.01)),
        ("/planner/max_iterations", json!(100_000)),
        ("/motion/frames", json!(10_000)),
        ("/motion/frames", json!(2)),
    ] {
        let mut text = with(pointer, value);
        if pointer == "/chains/0/base/x" {
            text = text.replace("\"radius\":40", "\"radius\":null");
        }
        assert!(
            read(&text).is_ok(),
            "{pointer}: {}",
            read(&text).expect_err("a fault")
        );
    }
}

#[test]
fn what_the_model_refuses_is_told_with_its_place() {
    use FaultCode::{
        InnerRow, LimitOrder, NameTooLong, OutOfRange, TimeMissing, TimeOrder, WrongCount,
    };
    let rows = |n: usize| Value::Array(vec![json!({}); n]);
    let t = "/chains/0/joints/2/rows";
    let s = "/chains/1/joints/1/rows";
    let e = "/chains/2/joints/0/rows";
    let at = |list: &str, place: &str| format!("{list}/{place}");
    let many_chains = Value::Array(vec![json!({"joints": [{"type": "R", "rows": [{}]}]}); 25]);
    let big_chains = Value::Array(vec![
        json!({"joints": vec![json!({"type": "R", "rows": [{}]}); 5]});
        24
    ]);
    let r = json!({"type": "R", "rows": [{}]});
    let key_frames =
        |n: usize| Value::Array((0..n).map(|i| json!({"x": i as f64 * 1e-3})).collect());
    let mut crowd: Value = serde_json::from_str(&with("/chains", big_chains)).expect("JSON");
    crowd["motion"]["frames"] = json!(20_000);
    // One case a line.
    #[rustfmt::skip]
    let cases: Vec<Case> = vec![
        (with("/chains", json!([])), WrongCount, "chains", "Chains: there are none", "1 to 24"),
        (with("/chains", many_chains), WrongCount, "chains", "there are 25", "1 to 24"),
        (with("/chains/1/joints", json!([])), WrongCount, "chains[1].joints", "Chain 2, joints: there are none", "1 to 5 freedoms"),
        (with("/chains/1/joints", json!([r, r, r, r, r, r])), WrongCount, "chains[1].joints", "Chain 2, joints: the joints have 6 freedoms", "1 to 5 freedoms"),
        (with("/chains/1/joints", Value::Array(vec![r.clone(); 500])), WrongCount, "chains[1].joints", "500 freedoms", "1 to 5 freedoms"),
        (with(t, rows(1)), WrongCount, "chains[0].joints[2].rows", "Chain 1 \u{201c}left leg\u{201d}, joint 3, rows: there is only one", "2 for a joint of type T"),
        (with(t, rows(3)), WrongCount, "chains[0].joints[2].rows", "there are 3", "2 for a joint of type T"),
        (with(s, rows(2)), WrongCount, "chains[1].joints[1].rows", "Chain 2, joint 2, rows: there are 2", "3 for a joint of type S"),
        (with(e, rows(0)), WrongCount, "chains[2].joints[0].rows", "there are none", "3 for a joint of type E"),
        (with("/chains/0/joints/0/rows", rows(0)), WrongCount, "chains[0].joints[0].rows", "there are none", "1 for a joint of type R"),
        (with(&at(t, "1/alpha"), json!(89.999)), InnerRow, "chains[0].joints[2].rows[1].alpha", "joint 3, row 2, alpha", "90 or -90"),
        (with(&at(t, "1/a"), json!(0.5)), InnerRow, "chains[0].joints[2].rows[1].a", "joint 3, row 2, a: the axes inside a joint of type T meet, here they are 0.5 apart", "0"),
        (with(&at(s, "2/alpha"), json!(0)), InnerRow, "chains[1].joints[1].rows[2].alpha", "joint 2, row 3, alpha", "90 or -90"),
        (with(&at(s, "1/a"), json!(1)), InnerRow, "chains[1].joints[1].rows[1].a", "type S", "0"),
        (with(&at(s, "1/d"), json!(1)), InnerRow, "chains[1].joints[1].rows[1].d", "one point", "0"),
        (with(&at(e, "1/theta"), json!(0)), InnerRow, "chains[2].joints[0].rows[1].theta", "both sliders", "90 or -90"),
        (with(&at(e, "2/a"), json!(-1)), InnerRow, "chains[2].joints[0].rows[2].a", "type E", "0"),
        (with("/chains/0/joints/0/limits", json!([null, null])), WrongCount, "chains[0].joints[0].limits", "there are 2", "1 for a joint of type R"),
        (with("/chains/0/joints/2/limits", json!([null])), WrongCount, "chains[0].joints[2].limits", "there is only one", "2 for a joint of type T"),
        (with("/chains/0/joints/2/limits/1", json!({"min": 1, "max": 0})), LimitOrder, "chains[0].joints[2].limits[1]", "limits of freedom 2", "min up to max"),
        (with("/chains/0/start", json!([1, 2, 3])), WrongCount, "chains[0].start", "start: there are 3", "4, one for each freedom of RPT"),
        (with("/chains/0/start", json!([])), WrongCount, "chains[0].start", "there are none", "4"),
        (with("/motion/key_frames", json!([])), WrongCount, "motion.key_frames", "key frames: there are none", "2 to 100000"),
        (with("/motion/key_frames", key_frames(1)), WrongCount, "motion.key_frames", "there is only one", "2 to 100000"),
        (with("/motion/key_frames", key_frames(100_001)), WrongCount, "motion.key_frames", "there are 100001", "2 to 100000"),
        (without("/motion/key_frames/1/time"), TimeMissing, "motion.key_frames[1].time", "Key frame 2, time", "every key frame"),
        (without("/motion/key_frames/0/time"), TimeMissing, "motion.key_frames[0].time", "Key frame 1 \u{201c}rest\u{201d}", "for none"),
        (with("/motion/key_frames/2/time", json!(2)), TimeOrder, "motion.key_frames[2].time", "Key frame 3 \u{201c}lift\u{201d}, time: 2", "later than 2"),
        (with("/motion/key_frames/1/time", json!(-1)), TimeOrder, "motion.key_frames[1].time", "Key frame 2, time: -1", "later than 0"),
        (with("/name", json!("n".repeat(101))), NameTooLong, "name", "Name: 101 characters", "100"),
        (with("/about", json!("n".repeat(2001))), NameTooLong, "about", "About", "2000"),
        (with("/$schema", json!("n".repeat(2001))), NameTooLong, "$schema", "$schema: 2001", "2000"),
        (with("/length_unit", json!("n".repeat(17))), NameTooLong, "length_unit", "Length unit", "16"),
        (with("/chains/1/name", json!("\u{e4}".repeat(101))), NameTooLong, "chains[1].name", "Chain 2", "100"),
        (with("/motion/key_frames/1/name", json!("k".repeat(101))), NameTooLong, "motion.key_frames[1].name", "Key frame 2", "100"),
        (crowd.to_string(), OutOfRange, "motion.frames", "20000", "16666 frames"),
    ];
    cases.into_iter().for_each(check);
}

#[test]
fn a_hundred_megabytes_are_refused_at_once() {
    let text = WHOLE.repeat(100_000_000 / WHOLE.len() + 1);
    let started = Instant::now();
    assert_eq!(
        parse(&text).expect_err("too long").code,
        FaultCode::TextTooLong
    );
    assert!(started.elapsed().as_millis() < 100);
}

#[test]
fn a_fault_is_a_plain_object() {
    let fault = read("{").expect_err("no document");
    let value = serde_json::to_value(&fault).expect("JSON");
    assert_eq!(value["code"], "syntax");
    assert_eq!(value["where"], "");
    assert_eq!((&value["line"], &value["column"]), (&json!(1), &json!(1)));
    let fault = read(&with("/chains/1/joints", json!([]))).expect_err("no joints");
    let value = serde_json::to_value(&fault).expect("JSON");
    assert_eq!(value["code"], "wrong-count");
    assert_eq!(value["where"], "chains[1].joints");
    assert_eq!(
        value.as_object().map(serde_json::Map::len),
        Some(5),
        "{value}"
    );
    let text = with("/planner/metric_length", json!("1"));
    let value = serde_json::to_value(read(&text).expect_err("a text")).expect("JSON");
    let parts = (&value["what"], &value["accepted"], &value["optional"]);
    let what = json!("Planner, metric length: this is the text \u{201c}1\u{201d}");
    assert_eq!(parts, (&what, &json!("a number"), &json!(true)));
}

/// Mutilated documents, by a generator with a fixed seed: an answer or a fault, never a panic, and
/// what is read can be written and read again.
#[test]
fn mutilated_documents_never_panic() {
    let mut texts: Vec<String> = samples().into_iter().map(|(_, text)| text).collect();
    texts.push(WHOLE.into());
    let pieces = [
        "{",
        "}",
        "[",
        "]",
        ",",
        ":",
        "\"",
        "null",
        "true",
        "-",
        "0",
        "9",
        "1e308",
        "1e999",
        "-1e-320",
        "NaN",
        ".",
        "\\",
        "\\ud800",
        "\u{e4}",
        "\0",
        "\n",
        "\"type\"",
        "\"rows\"",
        "\"E\"",
        "\"S\"",
        "{}",
        "[]",
        "180",
        "-90",
        "1000000001",
    ];
    let mut state = 7_u64;
    let mut random = |below: usize| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        usize::try_from((state >> 33) % below as u64).expect("below")
    };
    let mut accepted = 0;
    for round in 0..6_000 {
        let mut bytes: Vec<char> = texts[round % texts.len()].chars().collect();
        for _ in 0..=random(3) {
            let start = random(bytes.len());
            let piece: Vec<char> = pieces[random(pieces.len())].chars().collect();
            match random(4) {
                // Replace a few characters, cut a stretch out, double it, swap a whole number.
                0 => drop(bytes.splice(start..(start + random(4)).min(bytes.len()), piece)),
                1 => drop(bytes.drain(start..(start + random(60)).min(bytes.len()))),
                2 => {
                    let part = bytes[start..(start + random(60)).min(bytes.len())].to_vec();
                    drop(bytes.splice(start..start, part));
                }
                _ => {
                    if let Some(digit) = bytes[start..].iter().position(char::is_ascii_digit) {
                        drop(bytes.splice(start + digit..=start + digit, piece));
                    }
                }
            }
            if bytes.is_empty() {
                bytes.push(' ');
            }
        }
        let text: String = bytes.into_iter().collect();
        match parse(&text) {
            Ok(document) => {
                let normal = document.text();
                let again: Document = parse(&normal).expect("what was written can be read");
                assert_eq!(again.text(), normal);
                match Problem::new(&document) {
                    Ok(problem) => {
                        accepted += 1;
                        assert!(
                            problem.goals.iter().all(|g| g
                                .pose
                                .to_homogeneous()
                                .iter()
                                .all(|x| x.is_finite()))
                        );
                    }
                    Err(fault) => assert!(!fault.accepted.is_empty()),
                }
            }
            Err(fault) => assert!(!fault.accepted.is_empty() && fault.message.len() < 1_000),
        }
    }
    // The mutations are mild enough to get past the reader.
    assert!(accepted > 100, "{accepted}");
}

/// The published schema is the one of the types.
#[cfg(feature = "schema")]
#[test]
fn the_schema_is_up_to_date() {
    use synthetica::document::schema::SCHEMA;
    use synthetica::source::schema::schema;
    assert_eq!(
        SCHEMA,
        schema(),
        "write it anew: cargo run --features cli,schema -- schema > src/document/schema.json"
    );
}

/// The schema names every field that a whole document has, those of typed documents, and no other.
#[test]
fn the_schema_knows_the_fields() {
    let schema: Value = serde_json::from_str(synthetica::document::schema::SCHEMA).expect("JSON");
    assert_eq!(
        schema["$schema"],
        "https://json-schema.org/draft/2020-12/schema"
    );
    assert_eq!(schema["$id"], synthetica::document::schema::SCHEMA_ID);
    assert_eq!(schema["additionalProperties"], false);
    let fields = |object: &Value| {
        object
            .as_object()
            .expect("an object")
            .keys()
            .cloned()
            .collect::<Vec<_>>()
    };
    let document: Value =
        serde_json::from_str(&parse(WHOLE).expect("a document").text()).expect("JSON");
    let rotations = [
        "matrix",
        "order",
        "quaternion_wxyz",
        "quaternion_xyzw",
        "roll_pitch_yaw",
    ];
    let with = |mut plain: Vec<String>, typed: &[&str]| {
        plain.extend(typed.iter().map(ToString::to_string));
        plain.sort();
        plain
    };
    let typed = ["angles", "home", "parameters"];
    assert_eq!(
        fields(&schema["properties"]),
        with(fields(&document), &typed)
    );
    let mut driven = document.clone();
    driven["motion"] = serde_json::json!({"drivers": [
        {"chain": 1, "joint": 1, "values": [{"time": 0, "value": 0}, {"time": 1, "value": 1}]}
    ]});
    let driven: Value =
        serde_json::from_str(&parse(&driven.to_string()).expect("a document").text())
            .expect("JSON");
    for (part, pointer) in [
        ("DriverEntry", "/motion/drivers/0"),
        ("DriverValueEntry", "/motion/drivers/0/values/0"),
    ] {
        assert_eq!(
            fields(&schema["$defs"][part]["properties"]),
            fields(driven.pointer(pointer).expect(pointer))
        );
    }
    // A motion has key frames or drivers.
    let (mut document, drivers) = (document, driven["motion"]["drivers"].clone());
    document["motion"]["drivers"] = drivers;
    for (part, pointer, typed) in [
        ("ChainEntry", "/chains/0", &["convention"] as &[&str]),
        (
            "JointEntry",
            "/chains/0/joints/0",
            &["axis", "point", "second"] as &[&str],
        ),
        ("RowEntry", "/chains/0/joints/0/rows/0", &[] as &[&str]),
        ("FrameEntry", "/chains/0/base", &rotations as &[&str]),
        ("LimitsEntry", "/chains/0/joints/0/limits/0", &[] as &[&str]),
        ("MotionEntry", "/motion", &[] as &[&str]),
        (
            "KeyFrameEntry",
            "/motion/key_frames/0",
            &rotations as &[&str],
        ),
        ("PlannerEntry", "/planner", &[] as &[&str]),
    ] {
        assert_eq!(
            fields(&schema["$defs"][part]["properties"]),
            with(fields(document.pointer(pointer).expect(pointer)), typed)
        );
    }
}
