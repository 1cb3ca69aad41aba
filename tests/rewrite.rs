//! A chain given by rows becomes one by axes: the same linkage, the same motion, its joints counted from the start.

use serde_json::{Value, json};
use synthetica::Session;
use synthetica::motion::trajectory::Trajectory;

fn open(document: &Value) -> Session {
    let text = document.to_string();
    Session::open(&text).unwrap_or_else(|fault| panic!("{fault}\n{text}"))
}

/// The document with chain `index` by its axes, and the metric's length kept.
fn rewritten(document: &Value, index: usize, length: f64) -> Value {
    let session = open(document);
    let made = session.by_axes(index as f64).expect("by axes").text();
    let made: Value = serde_json::from_str(&made).expect("JSON");
    let mut document = document.clone();
    document["home"] = made["home"].clone();
    document["chains"][index] = made["chain"].clone();
    document["planner"]["metric_length"] = json!(length);
    document
}

/// Farthest of the poses apart, in shares of `size` and in rad.
fn apart(a: &Trajectory, b: &Trajectory, size: f64) -> f64 {
    assert_eq!(a.frames(), b.frames());
    let far = a.poses.iter().zip(&b.poses).map(|(a, b)| {
        let shift = (a.translation.vector - b.translation.vector).norm() / size;
        shift.max(a.rotation.angle_to(&b.rotation))
    });
    far.fold(0.0, f64::max)
}

fn sample(name: &str) -> Value {
    let text = std::fs::read_to_string(format!("www/mechanisms/{name}.json")).expect(name);
    serde_json::from_str(&text).expect(name)
}

#[test]
fn the_motion_stays_when_one_chain_after_the_other_is_given_by_its_axes() {
    for name in ["2tpr", "3rps", "bennett", "four-bar", "scara", "spacecraft"] {
        let rows = sample(name);
        let session = open(&rows);
        let size = session.problem().mechanism.size().expect("a size");
        let plan = session.plan();
        let length = plan.metric_used.length;
        let mut axes = rows.clone();
        for chain in 0..rows["chains"].as_array().expect("chains").len() {
            // A sample's S that has limits would have other axes.
            axes = rewritten(&axes, chain, length);
            let planned = open(&axes).plan();
            let far = apart(&plan, &planned, size);
            assert!(far < 1e-6, "{name}, chain {chain}: {far:e}\n{axes}");
        }
        assert!(!axes.to_string().contains("rows"), "{axes}");
        let planned = open(&axes).plan();
        assert!(
            planned.start.iter().all(|&value| value.abs() < 1e-12),
            "{name}"
        );
    }
}

#[test]
fn limits_and_start_count_from_home() {
    let document = json!({"version": 1, "angles": "radians", "chains": [{
        "joints": [{"type": "R", "rows": [{}], "limits": [{"min": -0.5, "max": 1.5}]}, {"type": "P", "rows": [{"alpha": 1}], "limits": [{"max": 3}]}],
        "start": [0.25, 2]}], "motion": {"key_frames": [{}, {"x": 1}]}});
    let made = open(&document).by_axes(0.0).expect("by axes").text();
    let made: Value = serde_json::from_str(&made).expect("JSON");
    let limit = |joint: usize, name: &str| {
        made["chain"]["joints"][joint]["limits"][0][name]
            .as_f64()
            .expect("a number")
    };
    assert!((limit(0, "min") + 0.75).abs() < 1e-12, "{made}");
    assert!((limit(0, "max") - 1.25).abs() < 1e-12, "{made}");
    assert!((limit(1, "max") - 1.0).abs() < 1e-12, "{made}");
    assert!(made["chain"].get("start").is_none(), "{made}");
    // Turned by 0.25 rad about z, then by 1 about x: the slider's axis.
    let axis = &made["chain"]["joints"][1]["axis"];
    assert!((axis[0].as_f64().expect("x") - libm::sin(1.0) * libm::sin(0.25)).abs() < 1e-12);
}

#[test]
fn another_chain_comes_to_the_home_that_there_is() {
    // A crank by its axes whose start is a quarter turn from home, and one by rows.
    let document = json!({"version": 1, "home": {"x": 1}, "chains": [
        {"joints": [{"type": "R", "point": [0, 0, 0], "axis": [0, 0, 1]}], "start": [90]},
        {"joints": [{"type": "R", "rows": [{}], "limits": [{"min": 0, "max": 200}]}], "gripper": {"x": 1}, "start": [90]}],
        "motion": {"key_frames": [{"y": 1, "roll": 90}, {"x": -1, "roll": 180}]}});
    let made = open(&document).by_axes(1.0).expect("by axes").text();
    let made: Value = serde_json::from_str(&made).expect("JSON");
    let start = made["chain"]["start"][0].as_f64().expect("a start");
    assert!((start - 90.0).abs() < 1e-5, "{made}");
    let limits = &made["chain"]["joints"][0]["limits"][0];
    assert!(limits["min"].as_f64().expect("min").abs() < 1e-5, "{made}");
    assert!((made["home"]["x"].as_f64().expect("x") - 1.0).abs() < 1e-12);
    let mut axes = document.clone();
    axes["chains"][1] = made["chain"].clone();
    let far = apart(&open(&document).plan(), &open(&axes).plan(), 1.0);
    assert!(far < 1e-6, "{far:e}");
}

#[test]
fn what_cannot_be_given_by_axes_is_refused() {
    let limited = json!({"version": 1, "chains": [{
        "joints": [{"type": "S", "rows": [{}, {"alpha": 90}, {"alpha": -90}], "limits": [{"max": 100}, {}, {}]}],
        "gripper": {"x": 1}, "start": [10, 20, 30]}], "motion": {"key_frames": [{"x": 1}, {"y": 1}]}});
    let session = open(&limited);
    let fault = session.by_axes(0.0).expect_err("limits of other axes");
    assert_eq!(fault.place, "chains[0].joints[0].limits");
    for index in [-1.0, 0.5, 1.0, f64::NAN] {
        assert_eq!(
            session.by_axes(index).expect_err("no chain").place,
            "chains"
        );
    }
}
