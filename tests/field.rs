//! Mechanisms from papers, bug reports, textbooks and machines, with what is right about each: tests/field/README.md.

use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use synthetica::Session;
use synthetica::document::problem::Problem;
use synthetica::document::report::Report;
use synthetica::model::scaled::{LIMIT, Scaled, larger};
use synthetica::motion::trajectory::{Status, Trajectory};
use synthetica::source::typed::Typed;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/field")
}

fn read(file: &str) -> String {
    fs::read_to_string(folder().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// What is wrong with a motion, held against what is right; empty where nothing is.
fn faults(right: &Map<String, Value>, problem: &Problem, t: &Trajectory) -> Vec<String> {
    let report = Report::new(&problem.mechanism, &problem.length_unit, t);
    let codes: BTreeSet<&str> = report.warnings.iter().map(|w| w.code).collect();
    let mut found = Vec::new();
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, larger);
    let number = |value: &Value| value.as_f64().expect("a number");
    let texts = |value: &Value| -> Vec<String> {
        let list = value.as_array().expect("a list");
        list.iter()
            .map(|text| text.as_str().expect("a text").to_owned())
            .collect()
    };
    for (key, value) in right {
        let mut expect = |holds: bool, what: String| {
            if !holds {
                found.push(what);
            }
        };
        match key.as_str() {
            "note" => {}
            "ok" => {
                let lost = t
                    .status
                    .iter()
                    .filter(|s| **s == Status::ClosureLost)
                    .count();
                expect(t.frames() > 0, "no frames".into());
                expect(lost == 0, format!("{lost} {}", Status::ClosureLost.name()));
            }
            "no" => {
                for name in texts(value) {
                    let count = t.status.iter().filter(|s| s.name() == name).count();
                    expect(count == 0, format!("{count} {name}"));
                }
            }
            "rank" => expect(
                t.mobility_rank as u64 == value.as_u64().expect("a count"),
                format!("rank {}", t.mobility_rank),
            ),
            "reached" => {
                for frame in value.as_array().expect("frames") {
                    let frame =
                        usize::try_from(frame.as_u64().expect("a frame")).expect("an index");
                    expect(
                        t.status[frame] == Status::Reached,
                        format!("frame {frame}: {:?}", t.status[frame]),
                    );
                }
            }
            "gap" => expect(
                largest(&t.translation_gap) <= number(value),
                format!("gap {}", largest(&t.translation_gap)),
            ),
            "last" => {
                let last = t.translation_gap[t.frames() - 1];
                expect(last <= number(value), format!("last gap {last}"));
            }
            "rot" => {
                let turned =
                    |pose: &synthetica::math::pose::Pose| pose.rotation.angle().to_degrees();
                let most = t.poses.iter().map(turned).fold(0.0, larger);
                expect(most <= number(value), format!("turned by {most} degrees"));
            }
            "joints" => {
                let turns: Vec<bool> = problem
                    .mechanism
                    .chains()
                    .iter()
                    .flat_map(|c| c.turns().collect::<Vec<_>>())
                    .collect();
                for (frame, joints) in value.as_object().expect("frames") {
                    let at = t.joints_at(frame.parse().expect("a frame"));
                    for (joint, wanted) in joints.as_object().expect("joints") {
                        let joint: usize = joint.parse().expect("a joint");
                        let got = if turns[joint] {
                            at[joint].to_degrees()
                        } else {
                            at[joint]
                        };
                        let near =
                            (got - number(wanted)).abs() <= 1e-6 * number(wanted).abs().max(1.0);
                        expect(
                            near,
                            format!("frame {frame}, joint {joint}: {got} for {wanted}"),
                        );
                    }
                }
            }
            "positive" => {
                let turns = problem
                    .mechanism
                    .chains()
                    .iter()
                    .flat_map(|c| c.turns().collect::<Vec<_>>());
                let least = t
                    .start
                    .iter()
                    .zip(turns)
                    .filter(|(_, turns)| !turns)
                    .map(|(x, _)| *x)
                    .fold(0.0, f64::min);
                expect(least > -1e-9, format!("a slider of {least}"));
            }
            "nowarn" => {
                for code in texts(value) {
                    expect(!codes.contains(code.as_str()), format!("warns of {code}"));
                }
            }
            "warn" => {
                for code in texts(value) {
                    expect(
                        codes.contains(code.as_str()),
                        format!("does not warn of {code}: {codes:?}"),
                    );
                }
            }
            "f_at" => {
                for (frame, most) in value.as_object().expect("frames") {
                    let f = t.metric[frame.parse::<usize>().expect("a frame")];
                    expect(f <= number(most), format!("frame {frame}: f {f}"));
                }
            }
            other => panic!("no such key: {other}"),
        }
    }
    found
}

#[test]
fn what_is_right_holds() {
    let index: Vec<Value> = serde_json::from_str(&read("index.json")).expect("a list");
    let mut failures = Vec::new();
    let mut listed = BTreeSet::from(["index.json".to_owned(), "README.md".to_owned()]);
    for entry in &index {
        let file = entry["file"].as_str().expect("a file");
        listed.insert(file.to_owned());
        let session = Session::open(&read(file)).unwrap_or_else(|fault| panic!("{file}: {fault}"));
        let t = session.plan();
        for fault in faults(
            entry["right"].as_object().expect("what is right"),
            session.problem(),
            &t,
        ) {
            failures.push(format!("{file}: {fault}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    let there: BTreeSet<String> = fs::read_dir(folder())
        .expect("the folder")
        .map(|file| {
            file.expect("a file")
                .file_name()
                .into_string()
                .expect("a name")
        })
        .collect();
    assert_eq!(there, listed, "every document is held against something");
}

/// The same steel without a metric length: nothing in it may depend on the unit.
#[test]
fn millimetres_without_a_metric_length() {
    let index: Vec<Value> = serde_json::from_str(&read("index.json")).expect("a list");
    let mut planned = 0;
    for entry in &index {
        let file = entry["file"].as_str().expect("a file");
        let typed = Typed::read(&read(file)).expect("a document");
        let mut document = typed.document;
        if document.length_unit != "mm" {
            continue;
        }
        planned += 1;
        document.planner.metric_length = None;
        let problem = Problem::new(&document).expect("a problem");
        let t = problem.plan();
        let report = Report::new(&problem.mechanism, &problem.length_unit, &t);
        let wrong = |code: &str| report.warnings.iter().any(|w| w.code == code);
        assert!(!wrong("metric-length"), "{file}");
        assert!(!t.status.contains(&Status::ClosureLost), "{file}");
        assert!(!t.status.contains(&Status::Stalled), "{file}");
    }
    assert!(planned >= 10, "{planned} documents in millimetres");
}

/// Every frame called closest or reached keeps the bounds that are published with it, and its joints their limits. Where
/// the dimensions agree, its closure error is computed anew from its joint values.
#[test]
fn certified_frames_keep_the_published_bounds() {
    let index: Vec<Value> = serde_json::from_str(&read("index.json")).expect("a list");
    let (mut certified, mut recomputed) = (0, 0);
    for entry in &index {
        let file = entry["file"].as_str().expect("a file");
        let session = Session::open(&read(file)).expect("a document");
        let problem = session.problem();
        let t = problem.plan();
        let report = Report::new(&problem.mechanism, &problem.length_unit, &t);
        let bounds = &report.bounds;
        let scaled = Scaled::new(&problem.mechanism, problem.extent());
        for frame in 0..t.frames() {
            if t.status[frame].is_certified() {
                certified += 1;
                let theta = scaled.entered(t.joints_at(frame));
                if t.misfit[frame] == 0.0 {
                    recomputed += 1;
                    let open = scaled.closure_error(&theta);
                    assert!(
                        open <= bounds.closure,
                        "{file}, frame {frame}: open by {open:e}"
                    );
                }
                for (joint, (x, l)) in theta.iter().zip(scaled.limits()).enumerate() {
                    assert!(
                        l.min - LIMIT <= *x && *x <= l.max + LIMIT,
                        "{file}, frame {frame}: joint {joint} at {x}"
                    );
                }
                assert!(
                    t.projected_gradient[frame] <= bounds.projected_gradient,
                    "{file}, frame {frame}"
                );
                assert!(t.closure[frame] <= bounds.closure, "{file}, frame {frame}");
                assert!(t.misfit[frame] <= bounds.misfit, "{file}, frame {frame}");
            }
            if t.status[frame] == Status::Reached {
                assert!(
                    t.metric[frame] <= bounds.reached * (1.0 + 1e-6),
                    "{file}, frame {frame}"
                );
            }
        }
    }
    assert!(
        recomputed > certified / 2,
        "{recomputed} of {certified} frames"
    );
}
