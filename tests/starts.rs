//! The start that is found where none is given, and a given one outside its limits.

use nalgebra::Vector3;
use serde_json::Value;
use synthetica::document::chain_report::chain;
use synthetica::document::problem::Problem;
use synthetica::document::report::Report;
use synthetica::document::schema::Document;
use synthetica::model::scaled::{CLOSED, Scaled};
use synthetica::motion::trajectory::{Status, Warning};
use synthetica::plan::given::{OutsideLimit, outside_limits};

/// tests/fixtures/README.md says what they are.
const FAR: &str = include_str!("fixtures/starts.jsonl");
const NEAREST: &str = include_str!("fixtures/starts-nearest.json");
const TRIPOD: &str = include_str!("field/3rps-closed-form-mm-L250.json");
const EXECHON: &str = include_str!("field/exechon-nostart.json");
const DELTA: &str = include_str!("field/delta-mm-nostart.json");
const CRANK: &str = include_str!("field/slider-crank-40-nostart.json");
const OPEN: &str = include_str!("field/start-open.json");
const KNOWN: &str = include_str!("field/start-open-known.json");

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

fn problem(document: &Value) -> Problem {
    // Not by way of text, whose numbers are read with another last digit.
    let document: Document = serde_json::from_value(document.clone()).expect("a document");
    Problem::new(&document).expect("a document without faults")
}

fn documents() -> impl Iterator<Item = (String, Value)> {
    FAR.lines().map(json).map(|mut line| {
        let case = line["case"].as_str().expect("a name").to_owned();
        (case, line["document"].take())
    })
}

/// How far from closed the joints are, in units of what is published as closed.
fn openness(problem: &Problem, joints: &[f64]) -> f64 {
    let scaled = Scaled::new(&problem.mechanism, 1.0);
    scaled.closure_error(&scaled.entered(joints)) / CLOSED
}

fn size(problem: &Problem) -> f64 {
    problem.mechanism.size().expect("a linkage with lengths")
}

/// Joint values with lengths in multiples of `unit`.
fn in_lengths(problem: &Problem, joints: &[f64], unit: f64) -> Vec<f64> {
    Scaled::about(&problem.mechanism, unit, &Vector3::zeros()).entered(joints)
}

/// The lengths of the sliders: the joint values with what their rows add.
fn lengths(problem: &Problem, document: &Value, joints: &[f64]) -> Vec<f64> {
    let mut values = joints.iter();
    let mut list = Vec::new();
    let chains = problem.mechanism.chains().iter().map(chain);
    for (i, chain) in chains.enumerate() {
        let rows: Vec<&Value> = (document["chains"][i]["joints"].as_array().expect("joints"))
            .iter()
            .flat_map(|joint| joint["rows"].as_array().expect("rows"))
            .collect();
        for variable in &chain.variables {
            let value = values.next().expect("one value a variable");
            if variable.unit == "length" {
                list.push(value + rows[variable.row]["d"].as_f64().unwrap_or(0.0));
            }
        }
    }
    list
}

/// Every length of a document without starts and limits times `factor`.
fn in_unit(value: &mut Value, factor: f64) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(|item| in_unit(item, factor)),
        Value::Object(fields) => {
            for (name, field) in fields {
                match field.as_f64() {
                    Some(x) if ["x", "y", "z", "a", "d", "metric_length"].contains(&&name[..]) => {
                        *field = (x * factor).into();
                    }
                    _ => in_unit(field, factor),
                }
            }
        }
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

/// All are found, and nearly all of them nearest: f, in the default metric with a length of 1, is compared with the
/// least that 1,400 seeds a case found (from ourselves: the same search, 800 and 600 other seeds). A dozen seeds miss a
/// quarter of them.
#[test]
fn two_hundred_assemblies_are_found_from_afar() {
    let least: Vec<f64> = serde_json::from_str(NEAREST).expect("numbers");
    assert_eq!(least.len(), 200);
    let (mut open, mut farther) = (Vec::new(), Vec::new());
    for ((case, document), least) in documents().zip(least) {
        let problem = problem(&document);
        let joints = problem.find_start();
        if !(openness(&problem, &joints) <= 1.0) {
            let error = openness(&problem, &joints) * CLOSED;
            open.push(format!("{case}: open by {error:e}"));
            continue;
        }
        let pose = problem.mechanism.chains()[0].pose(&joints);
        let f = problem
            .settings
            .metric_for(&problem.mechanism, 1.0)
            .value(&pose, &problem.goals[0].pose);
        if f > least + 1e-6 {
            farther.push(format!("{case}: {f} in place of {least}"));
        }
    }
    assert!(open.is_empty(), "not found: {open:#?}");
    println!("{} are farther", farther.len());
    assert!(farther.len() <= 6, "{farther:#?}");
}

#[test]
fn sliders_have_positive_lengths() {
    for (name, text) in [("3RPS", TRIPOD), ("Exechon", EXECHON)] {
        let mut document = json(text);
        let given = problem(&document);
        let rounding = -1e-9 * size(&given);
        let joints = given.find_start();
        assert!(joints.iter().all(|x| *x > -1e-6), "{name}: {joints:?}");
        for length in lengths(&given, &document, &joints) {
            assert!(length > rounding, "{name}: {length}");
        }
        // The same legs with joint values that count from elsewhere: with all at 0 the legs would now point away
        // from the platform, and small values would keep them so.
        for chain in document["chains"].as_array_mut().expect("chains") {
            for joint in chain["joints"].as_array_mut().expect("joints") {
                if joint["type"] == "P" {
                    joint["rows"][0]["d"] = 0.0.into();
                }
            }
            let first = &mut chain["joints"][0]["rows"][0]["theta"];
            *first = (first.as_f64().expect("an angle") + 180.0).into();
        }
        let turned = problem(&document);
        let joints = turned.find_start();
        assert!(openness(&turned, &joints) <= 1.0, "{name}, turned");
        for length in lengths(&turned, &document, &joints) {
            assert!(length > rounding, "{name}, turned: {length}");
        }
    }
}

#[test]
fn field_documents_without_a_start_are_planned() {
    for (name, text) in [
        ("delta", DELTA),
        ("crank", CRANK),
        ("open", OPEN),
        ("known", KNOWN),
    ] {
        let problem = problem(&json(text));
        let motion = problem.plan();
        let bad = [Status::ClosureLost, Status::Stalled];
        assert!(
            !motion.status.iter().any(|s| bad.contains(s)),
            "{name}: {:?}",
            motion.status
        );
        match name {
            "delta" => assert!(motion.translation_gap.iter().all(|gap| *gap <= 1e-6)),
            "crank" => {
                assert_eq!(motion.mobility_rank, 1);
                for frame in (0..=96).step_by(8) {
                    assert_eq!(motion.status[frame], Status::Reached, "frame {frame}");
                }
            }
            _ => {}
        }
    }
}

#[test]
fn the_start_is_the_same_in_every_unit() {
    let field = [TRIPOD, EXECHON, DELTA, CRANK].map(|text| ("field".to_owned(), json(text)));
    for (case, document) in field.into_iter().chain(documents().take(12)) {
        let given = problem(&document);
        let size = size(&given);
        let start = in_lengths(&given, &given.find_start(), size);
        for (factor, exact) in [
            (1e3, false),
            (1e-3, false),
            (1024.0, true),
            (1.0 / 1024.0, true),
        ] {
            let mut other = document.clone();
            in_unit(&mut other, factor);
            let other = problem(&other);
            let found = other.find_start();
            if exact {
                let back = in_lengths(&other, &found, factor);
                assert_eq!(back, given.find_start(), "{case}, times {factor}");
            }
            let found = in_lengths(&other, &found, factor * size);
            for (a, b) in start.iter().zip(&found) {
                assert!((a - b).abs() <= 1e-9, "{case}, times {factor}: {a} and {b}");
            }
        }
    }
}

#[test]
fn angles_are_small_where_the_limits_allow_it() {
    // An arm of one joint, whose key frame is at 30 degrees.
    let arm = |limits: &str| {
        problem(&json(&format!(
            r#"{{"version": 1, "chains": [{{"joints": [{{"type": "R", "rows": [{{}}]{limits}}}], "gripper": {{"x": 1}}}}],
            "motion": {{"key_frames": [{{"x": 0.8660254037844387, "y": 0.5, "roll": 30}}, {{"x": 1}}], "frames": 2}}}}"#
        )))
        .find_start()[0]
            .to_degrees()
    };
    assert!((arm("") - 30.0).abs() < 1e-6, "{}", arm(""));
    let turned = arm(r#", "limits": [{"min": 200, "max": 500}]"#);
    assert!((turned - 390.0).abs() < 1e-6, "{turned}");
    for (case, document) in documents().take(30) {
        let problem = problem(&document);
        let joints = problem.find_start();
        let kinds = problem
            .mechanism
            .chains()
            .iter()
            .flat_map(|c| c.turns().collect::<Vec<_>>());
        for (x, turns) in joints.iter().zip(kinds) {
            assert!(
                !turns || x.abs() <= std::f64::consts::PI + 1e-9,
                "{case}: {x}"
            );
        }
    }
}

#[test]
fn a_given_chain_stays_where_it_is() {
    let mut document = json(CRANK);
    document["chains"][0]["start"] = serde_json::json!([25, -30]);
    let problem = problem(&document);
    let joints = problem.find_start();
    // The crank turned by 25°; the piston's slider follows, and the coupler with it.
    assert!(
        openness(&problem, &joints) <= 1.0,
        "{joints:?} {}",
        openness(&problem, &joints)
    );
    assert!((joints[0].to_degrees() - 25.0).abs() < 3.0, "{joints:?}");
}

#[test]
fn a_start_outside_its_limits_is_told() {
    let mut document = json(KNOWN);
    let whole = problem(&document);
    let home = whole
        .start
        .iter()
        .flatten()
        .flatten()
        .copied()
        .collect::<Vec<f64>>();
    assert_eq!(outside_limits(&whole.mechanism, &home, 1.0), []);
    // The cylinder's slider of the first chain at 0.0555, and its first angle at −67.97°.
    document["chains"][0]["joints"][3]["limits"] = json(r#"[{}, {"min": 0.1, "max": 0.5}]"#);
    document["chains"][0]["joints"][0]["limits"] = json(r#"[{"min": -170, "max": -68.5}]"#);
    let limited = problem(&document);
    let outside = outside_limits(&limited.mechanism, &home, 1.0);
    let slider = OutsideLimit {
        variable: 4,
        value: home[4],
        limit: 0.1,
    };
    assert_eq!(outside.len(), 2, "{outside:?}");
    assert_eq!((outside[0].variable, outside[1]), (0, slider));
    let motion = limited.plan();
    let told = |w: &&Warning| matches!(w, Warning::StartOutsideLimits { .. });
    assert_eq!(motion.warnings.iter().filter(told).count(), 2);
    let report = Report::new(&limited.mechanism, "m", &motion);
    let messages: Vec<&str> = (report.warnings.iter())
        .filter(|w| w.code == "start-outside-limits")
        .map(|w| &w.message[..])
        .collect();
    assert_eq!(
        messages,
        [
            "The start of θ₁ of RRRC, −67.97°, is above its largest value, −68.5°: it is moved there.",
            "The start of d₄ of RRRC, 0.0555 m, is below its smallest value, 0.1 m: it is moved there.",
        ]
    );
    // Also where the start of another chain is to be found.
    document["chains"][1]
        .as_object_mut()
        .expect("a chain")
        .remove("start");
    let motion = problem(&document).plan();
    assert_eq!(motion.warnings.iter().filter(told).count(), 2);
    // A found one never is.
    for chain in document["chains"].as_array_mut().expect("chains") {
        chain.as_object_mut().expect("a chain").remove("start");
    }
    let found = problem(&document);
    let joints = found.find_start();
    assert!(openness(&found, &joints) <= 1.0);
    assert_eq!(outside_limits(&found.mechanism, &joints, 1.0), []);
}
