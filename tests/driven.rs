//! Motions with driven joints: against closed forms, through change points, up to dead points and limits; and every fault.

use serde_json::{Value, json};
use std::f64::consts::PI;
use synthetica::document::report::Report;
use synthetica::export::{Format, Options, write};
use synthetica::math::pose::FrameCoordinates;
use synthetica::motion::trajectory::DriveEnd;
use synthetica::{Session, Status, Trajectory, Warning};

/// Where the plane of a linkage lies: origin, and longitude, latitude, roll.
type Place = [f64; 6];
const FLAT: Place = [0.0; 6];
/// Tilted, with three decimals, and far from the origin of the fixed frame.
const FAR: Place = [5123.457, -803.211, 922.106, 37.123, -21.456, 64.789];

/// The frame at (x, y) of that plane, turned in it by `turn` degrees; lengths in it are multiplied by `scale`.
fn frame(place: &Place, scale: f64, x: f64, y: f64) -> Value {
    let [ox, oy, oz, longitude, latitude, roll] = *place;
    let pose = FrameCoordinates {
        x: ox * scale,
        y: oy * scale,
        z: oz * scale,
        longitude: longitude.to_radians(),
        latitude: latitude.to_radians(),
        roll: roll.to_radians(),
    }
    .pose();
    let at = pose * nalgebra::Point3::new(scale * x, scale * y, 0.0);
    json!({"x": at.x, "y": at.y, "z": at.z, "longitude": longitude, "latitude": latitude, "roll": roll})
}

fn revolute(a: f64) -> Value {
    json!({"type": "R", "rows": [{"a": a}]})
}

/// A planar linkage of revolute joints: its workpiece is the coupler from the crank's pin to the rocker's.
/// Joint variables: crank angle, coupler against it, rocker angle, coupler against it.
struct FourBar {
    ground: f64,
    crank: f64,
    coupler: f64,
    rocker: f64,
}

impl FourBar {
    /// The angles of rocker and coupler at a crank angle; `side` chooses the branch. Freudenstein's equation
    /// A cos φ + B sin φ = C.
    fn closed_form(&self, crank: f64, side: f64) -> Option<(f64, f64)> {
        let Self {
            ground: g,
            crank: a,
            coupler: c,
            rocker: b,
        } = *self;
        let (sin, cos) = libm::sincos(crank);
        let (p, q) = (2.0 * b * (g - a * cos), -2.0 * a * b * sin);
        let r = c * c - g * g - a * a - b * b + 2.0 * g * a * cos;
        let h = libm::hypot(p, q);
        if r.abs() > h {
            return None;
        }
        let rocker = libm::atan2(q, p) + side * libm::acos(r / h);
        let at = libm::atan2;
        let coupler = at(
            b * libm::sin(rocker) - a * sin,
            g + b * libm::cos(rocker) - a * cos,
        );
        Some((rocker, coupler))
    }

    /// The start in degrees at a crank angle in degrees.
    fn start(&self, crank: f64, side: f64) -> [Vec<f64>; 2] {
        let (rocker, coupler) = self
            .closed_form(crank.to_radians(), side)
            .expect("it closes");
        let (rocker, coupler) = (rocker.to_degrees(), coupler.to_degrees());
        [vec![crank, coupler - crank], vec![rocker, coupler - rocker]]
    }

    fn document(&self, place: &Place, scale: f64, start: Option<&[Vec<f64>; 2]>) -> Value {
        let mut document = json!({
            "version": 1, "name": "four-bar", "length_unit": "mm",
            "chains": [
                {"name": "crank", "base": frame(place, scale, 0.0, 0.0),
                 "joints": [revolute(0.0), revolute(scale * self.crank)]},
                {"name": "rocker", "base": frame(place, scale, self.ground, 0.0),
                 "joints": [revolute(0.0), revolute(scale * self.rocker)],
                 "gripper": {"x": -scale * self.coupler}},
            ],
            "motion": {"drivers": []},
        });
        if let Some(start) = start {
            for (i, own) in start.iter().enumerate() {
                document["chains"][i]["start"] = json!(own);
            }
        }
        document
    }
}

fn driver(chain: usize, joint: usize, values: &[(f64, f64)]) -> Value {
    let values: Vec<Value> = values
        .iter()
        .map(|(time, value)| json!({"time": time, "value": value}))
        .collect();
    json!({"chain": chain, "joint": joint, "values": values})
}

fn drive(mut document: Value, frames: usize, drivers: impl Into<Value>) -> Value {
    document["motion"] = json!({"frames": frames, "drivers": drivers.into()});
    document
}

fn open(document: &Value) -> Session {
    Session::open(&document.to_string()).unwrap_or_else(|fault| panic!("{fault}"))
}

fn plan(document: &Value) -> Trajectory {
    open(document).plan()
}

/// All frames reached, loops closed, no goal.
fn all_reached(t: &Trajectory) {
    assert!(
        t.status.iter().all(|s| *s == Status::Reached),
        "{:?} {:?}",
        t.status,
        t.warnings
    );
    for frame in 0..t.frames() {
        assert!(t.closure[frame] <= t.bounds.closure, "frame {frame}");
        assert!(t.metric[frame].is_nan() && t.translation_gap[frame].is_nan());
        assert!(t.goals[frame].translation.x.is_nan());
    }
}

/// Smallest difference of two angles.
fn apart(a: f64, b: f64) -> f64 {
    let turns = ((a - b) / (2.0 * PI)).round();
    (a - b - 2.0 * PI * turns).abs()
}

const CRANK_ROCKER: FourBar = FourBar {
    ground: 400.0,
    crank: 100.0,
    coupler: 350.0,
    rocker: 250.0,
};

#[test]
fn a_crank_goes_round_and_the_rocker_comes_back() {
    for side in [1.0, -1.0] {
        for (place, scale) in [(FLAT, 1.0), (FLAT, 1e-3), (FAR, 1.0), (FAR, 1e-3)] {
            let bar = CRANK_ROCKER;
            let document = bar.document(&place, scale, Some(&bar.start(0.0, side)));
            let turn = driver(1, 1, &[(0.0, 0.0), (2.0, 360.0)]);
            let t = plan(&drive(document, 49, vec![turn]));
            all_reached(&t);
            assert_eq!(t.frames(), 49);
            for frame in 0..49 {
                let joints = t.joints_at(frame);
                let crank = 2.0 * PI * frame as f64 / 48.0;
                assert!((joints[0] - crank).abs() < 1e-12, "{}", joints[0] - crank);
                let (rocker, coupler) = bar.closed_form(crank, side).expect("a crank");
                assert!(
                    apart(joints[2], rocker) < 1e-9,
                    "{frame}: {}",
                    apart(joints[2], rocker)
                );
                assert!(apart(joints[0] + joints[1], coupler) < 1e-9);
            }
            let last = t.joints_at(48);
            assert_eq!(last[0].to_bits(), 360_f64.to_radians().to_bits());
            assert!((last[2] - t.joints_at(0)[2]).abs() < 1e-9);
        }
    }
}

/// Three turns, forth and back, with few frames: no value is wound back, and the branch is kept.
#[test]
fn many_turns_are_one_motion() {
    let bar = CRANK_ROCKER;
    let document = bar.document(&FLAT, 1.0, Some(&bar.start(30.0, 1.0)));
    let turns = driver(1, 1, &[(0.0, 30.0), (3.0, 1110.0), (4.0, -330.0)]);
    let t = plan(&drive(document, 9, vec![turns]));
    all_reached(&t);
    for frame in 0..9 {
        let joints = t.joints_at(frame);
        let (rocker, _) = bar.closed_form(joints[0], 1.0).expect("a crank");
        assert!((joints[2] - rocker).abs() < 1e-9, "{frame}");
    }
    assert!((t.joints_at(6)[0].to_degrees() - 1110.0).abs() < 1e-9);
    assert!((t.joints_at(8)[0].to_degrees() + 330.0).abs() < 1e-9);
}

/// Without a start an assembly with the driver's first value is looked for.
#[test]
fn a_start_is_found_at_the_first_value() {
    let bar = CRANK_ROCKER;
    let document = bar.document(&FLAT, 1.0, None);
    let t = plan(&drive(
        document,
        13,
        vec![driver(1, 1, &[(0.0, 75.0), (1.0, 435.0)])],
    ));
    all_reached(&t);
    assert!(
        (t.start[0].to_degrees() - 75.0).abs() < 1e-3,
        "{}",
        t.start[0].to_degrees()
    );
}

/// Crank and rod in a plane, the slider along x. The workpiece is the rod. Joint variables: crank, rod against it;
/// slider, rod against the x axis.
fn slider_crank(place: &Place, scale: f64, crank: f64, rod: f64, start: f64) -> Value {
    let phi = libm::asin(-crank * libm::sin(start.to_radians()) / rod).to_degrees();
    let x = crank * libm::cos(start.to_radians()) + rod * libm::cos(phi.to_radians());
    let base = frame(place, scale, 0.0, 0.0);
    // Turned in its plane by 90°, so that X(90°) turns z into the plane's x.
    let mut turned = base.clone();
    turned["roll"] = json!(place[5] + 90.0);
    json!({
        "version": 1, "name": "slider-crank", "length_unit": "mm",
        "chains": [
            {"name": "crank", "base": base,
             "joints": [revolute(0.0), revolute(scale * crank)], "start": [start, phi - start]},
            {"name": "slider", "base": turned,
             "joints": [
                {"type": "P", "rows": [{"alpha": 90.0}]},
                {"type": "R", "rows": [{"alpha": -90.0, "theta": -90.0}]}],
             "gripper": {"x": -scale * rod}, "start": [scale * x, phi]},
        ],
        "motion": {"drivers": []},
    })
}

#[test]
fn a_slider_crank_is_its_closed_form() {
    let (crank, rod) = (80.0, 230.0);
    for (place, scale) in [(FLAT, 1.0), (FAR, 1.0), (FAR, 1e-3)] {
        let document = slider_crank(&place, scale, crank, rod, 20.0);
        let turn = driver(1, 1, &[(0.0, 20.0), (1.0, 740.0)]);
        let t = plan(&drive(document, 61, vec![turn]));
        all_reached(&t);
        for frame in 0..61 {
            let joints = t.joints_at(frame);
            let angle = (20.0 + 12.0 * frame as f64).to_radians();
            let (sin, cos) = libm::sincos(angle);
            let x = crank * cos + (rod * rod - crank * crank * sin * sin).sqrt();
            assert!((joints[2] / scale - x).abs() < 1e-9 * rod, "{frame}");
        }
    }
}

/// Driven by its slider, it stops where crank and rod are in line, and comes back.
#[test]
fn a_driven_slider_stops_at_the_dead_point() {
    let (crank, rod) = (80.0, 230.0);
    for scale in [1.0, 1e-3] {
        let document = slider_crank(&FAR, scale, crank, rod, 60.0);
        let x = 80.0 * 0.5 + (rod * rod - 80.0 * 80.0 * 0.75_f64).sqrt();
        let push = driver(
            2,
            1,
            &[(0.0, scale * x), (1.0, scale * 330.0), (2.0, scale * x)],
        );
        let t = plan(&drive(document, 41, vec![push]));
        let (driven, first, last) = dead_point(&t, 2);
        assert!((driven / scale - (crank + rod)).abs() < 1e-6, "{driven}");
        for frame in 0..41 {
            let stopped = (first..=last).contains(&frame);
            let expected = if stopped {
                Status::Stalled
            } else {
                Status::Reached
            };
            assert_eq!(t.status[frame], expected, "frame {frame}");
            assert!(t.closure[frame] <= t.bounds.closure);
        }
        assert!(first > 0 && last < 40);
        // On the side that it came from, as it was.
        for frame in 0..first {
            let (there, back) = (t.joints_at(frame), t.joints_at(40 - frame));
            assert!((there[0] - back[0]).abs() < 1e-8, "frame {frame}");
        }
    }
}

/// The driven value at the only dead point, and the frames that stay there.
fn dead_point(t: &Trajectory, driven: usize) -> (f64, usize, usize) {
    let mut found = None;
    for warning in &t.warnings {
        if let Warning::DriveEnds {
            first,
            last,
            why,
            driven: values,
            ..
        } = warning
        {
            assert_eq!(*why, DriveEnd::DeadPoint);
            assert!(found.is_none(), "{:?}", t.warnings);
            assert_eq!(values[0].0, driven);
            found = Some((values[0].1, *first, *last));
        }
    }
    found.unwrap_or_else(|| panic!("no dead point: {:?} {:?}", t.status, t.warnings))
}

fn sentences(session: &Session, t: &Trajectory) -> Vec<(&'static str, String)> {
    let problem = session.problem();
    let report = Report::new(&problem.mechanism, &problem.length_unit, t);
    report
        .warnings
        .into_iter()
        .map(|w| (w.code, w.message))
        .collect()
}

/// A double rocker's input turns as far as coupler and output are in line: cos θ from the triangle.
#[test]
fn a_double_rocker_tells_its_dead_point() {
    let bar = FourBar {
        ground: 300.0,
        crank: 250.0,
        coupler: 100.0,
        rocker: 280.0,
    };
    let (g, a, reach) = (bar.ground, bar.crank, bar.coupler + bar.rocker);
    let dead = libm::acos((g * g + a * a - reach * reach) / (2.0 * g * a));
    for (place, scale) in [(FLAT, 1.0), (FAR, 1e-3)] {
        for side in [1.0, -1.0] {
            let document = bar.document(&place, scale, Some(&bar.start(70.0, side)));
            let swing = driver(1, 1, &[(0.0, 70.0), (1.0, 130.0), (2.0, 70.0)]);
            let session = open(&drive(document, 31, vec![swing]));
            let t = session.plan();
            let (driven, first, last) = dead_point(&t, 0);
            assert!((driven - dead).abs() < 1e-6, "{:e}", driven - dead);
            assert!(first > 2 && last < 28, "{first} {last}");
            let there = t.joints_at(3);
            let back = t.joints_at(27);
            assert!((there[2] - back[2]).abs() < 1e-8, "the branch is kept");
            let said = sentences(&session, &t);
            let (_, message) = said
                .iter()
                .find(|(code, _)| *code == "drive-ends")
                .expect("told");
            assert!(
                message.contains("dead point") && message.contains("θ₁ of crank at "),
                "{message}"
            );
            let digits = format!("{:.4}", dead.to_degrees());
            assert!(
                message.contains(&digits[..digits.len() - 1]),
                "{message} {digits}"
            );
        }
    }
}

/// At 0° and 180° a parallelogram is flat, and could go on as an antiparallelogram.
#[test]
fn a_parallelogram_keeps_its_branch() {
    let bar = FourBar {
        ground: 250.0,
        crank: 90.0,
        coupler: 250.0,
        rocker: 90.0,
    };
    for (place, scale) in [(FLAT, 1.0), (FAR, 1.0), (FAR, 1e-3)] {
        for frames in [9, 25, 62, 73, 361] {
            // From 90°: frames of the first kind stand exactly in the flat positions.
            let start = [vec![90.0, -90.0], vec![90.0, -90.0]];
            let document = bar.document(&place, scale, Some(&start));
            let turn = driver(1, 1, &[(0.0, 90.0), (1.0, 810.0)]);
            let t = plan(&drive(document, frames, vec![turn]));
            all_reached(&t);
            for frame in 0..frames {
                let joints = t.joints_at(frame);
                assert!(
                    (joints[0] - joints[2]).abs() < 1e-5,
                    "frame {frame} of {frames}: {joints:?}"
                );
            }
            let chosen = t
                .warnings
                .iter()
                .any(|w| matches!(w, Warning::BranchChosen { .. }));
            assert!(!chosen, "{:?}", t.warnings);
        }
    }
}

/// The antiparallelogram through its flat positions too, with a dwell in one, and back.
#[test]
fn an_antiparallelogram_keeps_its_branch() {
    let bar = FourBar {
        ground: 250.0,
        crank: 90.0,
        coupler: 250.0,
        rocker: 90.0,
    };
    let sides = [1.0, -1.0].map(|side| bar.start(60.0, side));
    let anti = sides
        .iter()
        .find(|start| apart(start[1][0].to_radians(), 60_f64.to_radians()) > 0.1);
    let document = bar.document(&FAR, 1.0, Some(anti.expect("the other branch")));
    let turn = driver(
        1,
        1,
        &[
            (0.0, 60.0),
            (1.0, 180.0),
            (1.5, 180.0),
            (2.0, 300.0),
            (3.0, 60.0),
        ],
    );
    let t = plan(&drive(document, 61, vec![turn]));
    all_reached(&t);
    for frame in 0..61 {
        let joints = t.joints_at(frame);
        // The diagonals of an antiparallelogram are parallel: its coupler never is.
        let off = apart(joints[0], joints[2]);
        let flat = libm::sin(joints[0]).abs() < 0.05;
        assert!(flat || off > 0.02, "frame {frame}: {joints:?}");
    }
    let (first, last) = (t.joints_at(0), t.joints_at(60));
    assert!(
        (first[2] - last[2]).abs() < 1e-6,
        "{} {}",
        first[2],
        last[2]
    );
}

/// From a flat position there are two ways: one is taken, and the warning says so.
#[test]
fn a_start_at_a_change_point_is_told() {
    let bar = FourBar {
        ground: 250.0,
        crank: 90.0,
        coupler: 250.0,
        rocker: 90.0,
    };
    let start = [vec![0.0, 0.0], vec![0.0, 0.0]];
    for scale in [1.0, 1e-3] {
        let document = bar.document(&FLAT, scale, Some(&start));
        let session = open(&drive(
            document,
            37,
            vec![driver(1, 1, &[(0.0, 0.0), (1.0, 360.0)])],
        ));
        let t = session.plan();
        all_reached(&t);
        let said = sentences(&session, &t);
        assert_eq!(
            said.iter()
                .filter(|(code, _)| *code == "branch-chosen")
                .count(),
            1,
            "{said:?}"
        );
        assert!(
            said.iter().all(|(code, _)| *code != "undriven-freedoms"),
            "{said:?}"
        );
        let kept = (2..36).all(|f| apart(t.joints_at(f)[0], t.joints_at(f)[2]) < 1e-5);
        let other = (2..36)
            .filter(|f| *f != 18)
            .all(|f| apart(t.joints_at(f)[0], t.joints_at(f)[2]) > 1e-3);
        assert!(kept || other, "one of the two, all the way");
    }
}

/// A five-bar with two drivers. Joint variables: left crank, left rod; right crank, right rod.
fn five_bar(place: &Place, scale: f64, left: f64, right: f64) -> (Value, impl Fn(f64, f64) -> f64) {
    const GROUND: f64 = 120.0;
    const CRANK: f64 = 100.0;
    const ROD: f64 = 160.0;
    // The angle of the left rod: the rods' pin is above.
    let rod = |left: f64, right: f64| {
        let a = (CRANK * libm::cos(left), CRANK * libm::sin(left));
        let b = (GROUND + CRANK * libm::cos(right), CRANK * libm::sin(right));
        let d = (b.0 - a.0, b.1 - a.1);
        libm::atan2(d.1, d.0) + libm::acos(0.5 * libm::hypot(d.0, d.1) / ROD)
    };
    let (l, r) = (left.to_radians(), right.to_radians());
    let angle = rod(l, r);
    let pin = (
        CRANK * libm::cos(l) + ROD * libm::cos(angle),
        CRANK * libm::sin(l) + ROD * libm::sin(angle),
    );
    let other = libm::atan2(
        pin.1 - CRANK * libm::sin(r),
        pin.0 - GROUND - CRANK * libm::cos(r),
    );
    let (angle, other) = (angle.to_degrees(), other.to_degrees());
    let document = json!({
        "version": 1, "name": "five-bar", "length_unit": "mm",
        "chains": [
            {"name": "left", "base": frame(place, scale, 0.0, 0.0),
             "joints": [revolute(0.0), revolute(scale * CRANK)],
             "gripper": {"x": scale * ROD}, "start": [left, angle - left]},
            {"name": "right", "base": frame(place, scale, GROUND, 0.0),
             "joints": [revolute(0.0), revolute(scale * CRANK), revolute(scale * ROD)],
             "start": [right, other - right, angle - other]},
        ],
        "motion": {"drivers": []},
    });
    (document, rod)
}

#[test]
fn two_drivers_of_a_five_bar() {
    for (place, scale) in [(FLAT, 1.0), (FAR, 1e-3)] {
        let (document, rod) = five_bar(&place, scale, 110.0, 60.0);
        let left = driver(1, 1, &[(0.0, 110.0), (1.0, 140.0), (3.0, 95.0)]);
        let mut right = driver(2, 1, &[(0.5, 60.0), (2.0, 20.0), (2.5, 20.0), (3.0, 45.0)]);
        right["ramp"] = json!("smooth");
        let session = open(&drive(document, 31, vec![left, right]));
        let t = session.plan();
        all_reached(&t);
        for frame in 0..31 {
            let joints = t.joints_at(frame);
            let expected = rod(joints[0], joints[2]);
            assert!(
                apart(joints[0] + joints[1], expected) < 1e-9,
                "frame {frame}"
            );
        }
        let at = |frame: usize, v: usize| t.joints_at(frame)[v].to_degrees();
        assert!((at(10, 0) - 140.0).abs() < 1e-9 && (at(20, 0) - 117.5).abs() < 1e-9);
        assert!((at(5, 2) - 60.0).abs() < 1e-9 && (at(20, 2) - 20.0).abs() < 1e-9);
        assert!(
            sentences(&session, &t)
                .iter()
                .all(|(code, _)| *code == "mobility-differs")
        );
    }
}

/// A dwell stands still, all joints; a smooth ramp comes to rest at each value.
#[test]
fn dwell_and_ramps() {
    let bar = CRANK_ROCKER;
    let document = bar.document(&FLAT, 1.0, Some(&bar.start(0.0, 1.0)));
    let values = [(0.0, 0.0), (1.0, 90.0), (2.0, 90.0), (3.0, 200.0)];
    for ramp in ["linear", "smooth"] {
        let mut turn = driver(1, 1, &values);
        turn["ramp"] = json!(ramp);
        let t = plan(&drive(document.clone(), 301, vec![turn]));
        all_reached(&t);
        for frame in 100..=200 {
            let (dwell, joints) = (t.joints_at(100), t.joints_at(frame));
            assert!(
                joints.iter().zip(dwell).all(|(a, b)| (a - b).abs() < 1e-9),
                "{frame}"
            );
        }
        let step = |frame: usize| (t.joints_at(frame + 1)[2] - t.joints_at(frame)[2]).abs();
        // The rocker's steps beside a value against one in the middle of a ramp.
        let ratio = step(0).max(step(99)).max(step(200)).max(step(299)) / step(50);
        if ramp == "smooth" {
            assert!(ratio < 1e-2, "{ratio}");
        } else {
            assert!(ratio > 0.1, "{ratio}");
        }
    }
}

#[test]
fn limits_stop_drivers_and_are_told() {
    let bar = CRANK_ROCKER;
    let mut document = bar.document(&FAR, 1.0, Some(&bar.start(0.0, 1.0)));
    let swing = driver(1, 1, &[(0.0, 0.0), (1.0, 120.0), (2.0, 0.0)]);
    document["chains"][0]["joints"][0]["limits"] = json!([{"min": -10.0, "max": 80.0}]);
    let session = open(&drive(document, 25, vec![swing.clone()]));
    let t = session.plan();
    for frame in 0..25 {
        let asked = 10.0 * frame.min(24 - frame) as f64;
        let got = t.joints_at(frame)[0].to_degrees();
        assert!((got - asked.min(80.0)).abs() < 1e-9, "{frame}: {got}");
        let expected = if asked > 80.0 + 1e-6 {
            Status::AtLimit
        } else {
            Status::Reached
        };
        assert_eq!(t.status[frame], expected, "frame {frame}");
    }
    let said = sentences(&session, &t);
    let (_, message) = said
        .iter()
        .find(|(code, _)| *code == "drive-ends")
        .expect("told");
    assert!(
        message.contains("limit of θ₁ of crank itself") && message.contains("80°"),
        "{message}"
    );

    // Another joint's limit: the rocker may go half of its way only.
    let mut document = bar.document(&FAR, 1.0, Some(&bar.start(0.0, 1.0)));
    let rocker = |crank: f64| bar.closed_form(crank.to_radians(), 1.0).expect("a crank").0;
    let (from, half) = (rocker(0.0), rocker(75.0));
    let range = if half > from {
        json!([{"max": half.to_degrees()}])
    } else {
        json!([{"min": half.to_degrees()}])
    };
    document["chains"][1]["joints"][0]["limits"] = range;
    let session = open(&drive(document, 25, vec![swing]));
    let t = session.plan();
    let stopped: Vec<usize> = (0..25)
        .filter(|f| t.status[*f] == Status::AtLimit)
        .collect();
    assert!(!stopped.is_empty(), "{:?} {:?}", t.status, t.warnings);
    for &frame in &stopped {
        assert!(
            (t.joints_at(frame)[2] - half).abs() < 1e-9,
            "at the limit itself"
        );
    }
    for frame in (0..25).filter(|f| !stopped.contains(f)) {
        assert_eq!(t.status[frame], Status::Reached, "frame {frame}");
    }
    assert!(t.warnings.iter().any(
        |w| matches!(w, Warning::DriveEnds { why: DriveEnd::Limits(held), .. } if held == &[2])
    ));
    let said = sentences(&session, &t);
    let (_, message) = said
        .iter()
        .find(|(code, _)| *code == "drive-ends")
        .expect("told");
    assert!(message.contains("θ₁ of rocker is at a limit"), "{message}");
}

/// An open chain has no loops: all joints go as they are told, and the workpiece's path is the result.
#[test]
fn an_open_chain_by_all_its_joints() {
    let text = include_str!("../www/mechanisms/scara.json");
    let mut document: Value = serde_json::from_str(text).expect("JSON");
    let start = Session::open(text).expect("a sample").plan();
    let from: Vec<f64> = start.joints_at(0).to_vec();
    let mut drivers = Vec::new();
    for (i, joint) in document["chains"][0]["joints"]
        .as_array()
        .expect("joints")
        .iter()
        .enumerate()
    {
        // The turn of a C comes before its shift.
        let freedoms: &[bool] = match joint["type"].as_str() {
            Some("R") => &[true],
            Some("P") => &[false],
            Some("C") => &[true, false],
            other => panic!("a SCARA has no {other:?}"),
        };
        for (freedom, &turns) in freedoms.iter().enumerate() {
            let from = from[drivers.len()];
            let (value, way) = if turns {
                (from.to_degrees(), 5.0)
            } else {
                (from, 0.01)
            };
            let mut own = driver(1, i + 1, &[(0.0, value), (1.0, value + way)]);
            own["freedom"] = json!(freedom + 1);
            drivers.push(own);
        }
    }
    assert_eq!(drivers.len(), 4);
    document = drive(document, 11, drivers);
    let session = open(&document);
    let t = session.plan();
    all_reached(&t);
    let chain = &session.problem().mechanism.chains()[0];
    for frame in 0..11 {
        let pose = chain.pose(t.joints_at(frame));
        assert!((pose.translation.vector - t.poses[frame].translation.vector).norm() < 1e-12);
    }
    assert!(t.warnings.is_empty(), "{:?}", t.warnings);
    assert!((t.poses[10].translation.vector - t.poses[0].translation.vector).norm() > 1e-3);
}

/// With one driver of two freedoms the rest moves as little as it can, and the warning counts it.
#[test]
fn fewer_drivers_than_freedoms() {
    let (document, rod) = five_bar(&FLAT, 1.0, 110.0, 60.0);
    let left = driver(1, 1, &[(0.0, 110.0), (1.0, 125.0), (2.0, 110.0)]);
    let session = open(&drive(document, 21, vec![left]));
    let t = session.plan();
    all_reached(&t);
    assert!(
        t.warnings.contains(&Warning::UndrivenFreedoms { count: 1 }),
        "{:?}",
        t.warnings
    );
    for frame in 0..21 {
        let joints = t.joints_at(frame);
        assert!(apart(joints[0] + joints[1], rod(joints[0], joints[2])) < 1e-9);
        assert!((joints[2] - 60_f64.to_radians()).abs() < 0.2);
    }
}

/// A second driver of a linkage with one freedom: not driven, told, and no frame is called reached against it.
#[test]
fn more_drivers_than_freedoms() {
    let bar = CRANK_ROCKER;
    let start = bar.start(0.0, 1.0);
    let document = bar.document(&FLAT, 1.0, Some(&start));
    let rocker = start[1][0];
    let drivers = vec![
        driver(1, 1, &[(0.0, 0.0), (1.0, 90.0)]),
        driver(2, 1, &[(0.0, rocker), (1.0, rocker)]),
    ];
    let session = open(&drive(document, 11, drivers));
    let t = session.plan();
    assert!(
        t.warnings
            .contains(&Warning::DriverDependent { variable: 2 }),
        "{:?}",
        t.warnings
    );
    assert!((t.joints_at(10)[0].to_degrees() - 90.0).abs() < 1e-9);
    assert_eq!(t.status[0], Status::Reached);
    assert!(t.status[1..].iter().all(|s| *s == Status::Stalled));
    let said = sentences(&session, &t);
    assert!(
        said.iter()
            .any(|(code, m)| *code == "driver-dependent" && m.contains("θ₁ of rocker"))
    );
}

/// Lengths with three decimals in a tilted plane: the axes are parallel only to rounding.
#[test]
fn rounded_dimensions_turn_too() {
    let bar = CRANK_ROCKER;
    let mut document = bar.document(&FAR, 1e-3, Some(&bar.start(0.0, 1.0)));
    for chain in 0..2 {
        for field in ["x", "y", "z"] {
            let value = document["chains"][chain]["base"][field]
                .as_f64()
                .expect("a number");
            document["chains"][chain]["base"][field] = json!((value * 1e5).round() / 1e5);
        }
    }
    let turn = driver(1, 1, &[(0.0, 0.0), (1.0, 360.0)]);
    let t = plan(&drive(document, 37, vec![turn]));
    assert!(
        t.status.iter().all(|s| *s == Status::Reached),
        "{:?} {:?}",
        t.status,
        t.warnings
    );
    assert!(
        t.warnings
            .iter()
            .any(|w| matches!(w, Warning::RoundedDimensions { .. }))
    );
    assert!(t.misfit.iter().any(|m| *m > 1e-9));
    for frame in 0..37 {
        let joints = t.joints_at(frame);
        let (rocker, _) = bar.closed_form(joints[0], 1.0).expect("a crank");
        assert!(apart(joints[2], rocker) < 1e-3, "frame {frame}");
    }
}

/// A motion planned towards goals, given again by its independent joints, is the same motion.
#[test]
fn driven_as_it_was_planned() {
    let samples = [
        // The three sliders of the legs; later they would come to a dead point, from which they could go either way.
        (
            include_str!("../www/mechanisms/3rps.json"),
            &[(1, 2), (2, 2), (3, 2)][..],
        ),
        (include_str!("../www/mechanisms/four-bar.json"), &[(1, 1)]),
        (include_str!("../www/mechanisms/bennett.json"), &[(1, 1)]),
        (include_str!("../www/mechanisms/five-link.json"), &[(1, 1)]),
    ];
    for (text, joints) in samples {
        let session = Session::open(text).expect("a sample");
        let planned = session.plan();
        let mut document: Value = serde_json::from_str(&session.text()).expect("JSON");
        let mechanism = &session.problem().mechanism;
        for (i, (_, values)) in mechanism.split(planned.joints_at(0)).enumerate() {
            let turns = mechanism.chains()[i].turns();
            let start: Vec<f64> = turns
                .zip(values)
                .map(|(turns, v)| if turns { v.to_degrees() } else { *v })
                .collect();
            document["chains"][i]["start"] = json!(start);
        }
        let frames = planned.frames().min(120);
        let mut drivers = Vec::new();
        for &(chain, joint) in joints {
            let before: usize = mechanism.chains()[..chain - 1]
                .iter()
                .map(synthetica::model::chain::Chain::freedoms)
                .sum();
            let own = &mechanism.chains()[chain - 1];
            let inside: usize = own.joints()[..joint - 1]
                .iter()
                .map(|j| j.kind().freedoms())
                .sum();
            let turns = own.turns().nth(inside).expect("a joint");
            let values: Vec<(f64, f64)> = (0..frames)
                .map(|frame| {
                    let value = planned.joints_at(frame)[before + inside];
                    (frame as f64, if turns { value.to_degrees() } else { value })
                })
                .collect();
            drivers.push(driver(chain, joint, &values));
        }
        let session = open(&drive(document, frames, drivers));
        let t = session.plan();
        let name = &session.document().name;
        all_reached(&t);
        let size = session.problem().mechanism.size_or(1.0);
        for frame in 0..t.frames() {
            // The closest motion may hold the driven joint still at its turning points, where a position is only
            // known to the root of the closure.
            let off = (t.poses[frame].translation.vector - planned.poses[frame].translation.vector)
                .norm();
            assert!(
                off < 1e-5 * size,
                "{name}, frame {frame}: {off:e} {:?}",
                t.warnings
            );
        }
    }
}

#[test]
fn portions_are_the_same_motion() {
    let bar = CRANK_ROCKER;
    let document = bar.document(&FLAT, 1.0, Some(&bar.start(0.0, 1.0)));
    let session = open(&drive(
        document,
        20,
        vec![driver(1, 1, &[(0.0, 0.0), (1.0, 360.0)])],
    ));
    let whole = session.plan();
    let mut planning = session.planning();
    assert_eq!((planning.done(), planning.frames()), (0, 20));
    while planning.done() < 7 && planning.advance() {}
    let some = planning.so_far();
    assert_eq!((some.frames(), some.sigma_min.len()), (7, 7));
    assert_eq!(some.joints[..], whole.joints[..some.joints.len()]);
    assert_eq!(format!("{:?}", planning.finish()), format!("{whole:?}"));
}

/// Who asks for goals gets none, and nothing breaks.
#[test]
fn readers_of_goals_find_none() {
    let bar = CRANK_ROCKER;
    let document = bar.document(&FLAT, 1.0, Some(&bar.start(0.0, 1.0)));
    let session = open(&drive(
        document,
        5,
        vec![driver(1, 1, &[(0.0, 0.0), (1.0, 90.0)])],
    ));
    let t = session.plan();
    let problem = session.problem();
    assert_eq!(problem.frames(), 5);
    assert_eq!(
        (session.frame(4.0), session.frame(5.0).is_err()),
        (Ok(4), true)
    );
    let fault = problem.trace(0, &[]).expect_err("no goal");
    assert!(
        fault.message.contains("driven") && fault.place == "motion",
        "{fault}"
    );
    assert!(
        problem
            .pull(t.joints_at(1), &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0])
            .is_ok()
    );
    assert!(session.drive(t.joints_at(1), 0, 0.3).is_ok());
    let gaps = problem.compare_metrics_of(&t);
    assert!(
        gaps.iter()
            .all(|g| g.translation_gap.is_nan() && g.rotation_gap.is_nan())
    );
    assert!(
        session
            .comparison()
            .finish()
            .iter()
            .all(|g| g.translation_gap.is_nan())
    );
    let report = Report::new(&problem.mechanism, "mm", &t);
    assert_eq!(report.drivers, [0]);

    let text = |format| {
        let (document, mechanism) = (session.document(), &problem.mechanism);
        write(format, Options::default(), document, mechanism, &t).expect("a text")
    };
    let csv = text(Format::Csv);
    let mut lines = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let headings = lines.next().expect("headings");
    for line in lines {
        for (heading, entry) in headings.iter().zip(&line) {
            let none = heading.starts_with("goal_")
                || heading.contains("_gap")
                || ["metric", "projected_gradient"].contains(heading);
            assert_eq!(entry.is_empty(), none, "{heading}");
        }
    }
    let exported: Value = serde_json::from_str(&text(Format::Json)).expect("JSON");
    assert_eq!(exported["report"]["drivers"], json!([0]));
    let column = |name: &str| {
        let columns = exported["columns"].as_array().expect("columns");
        columns
            .iter()
            .find(|c| c["name"] == name)
            .expect("a column")["values"]
            .clone()
    };
    assert_eq!(column("metric"), json!([null, null, null, null, null]));
    assert!(column("x")[0].is_number());
    let mjcf = text(Format::Mjcf);
    assert_eq!(mjcf.matches("<key ").count(), 5);
    assert_eq!(mjcf.matches("<position ").count(), 1);
    assert!(mjcf.contains("<position name=\"chain1_theta1_drive\" joint=\"chain1_theta1\""));
    assert!(!mjcf.contains("NaN"));
    // The text comes back as it is, and with its start.
    assert_eq!(
        Session::open(&session.text()).expect("its own text").text(),
        session.text()
    );
    assert!(session.text_with_start().contains("drivers"));
}

#[test]
fn every_fault_has_its_place() {
    let bar = CRANK_ROCKER;
    let document = bar.document(&FLAT, 1.0, Some(&bar.start(0.0, 1.0)));
    let good = driver(1, 1, &[(0.0, 0.0), (1.0, 90.0)]);
    let with = |field: &str, value: Value| {
        let mut changed = good.clone();
        changed[field] = value;
        changed
    };
    let value = |time: Value, value: Value| json!([{"time": 0, "value": 0}, {"time": time, "value": value}]);
    let cases = [
        (
            vec![with("chain", json!(3))],
            "motion.drivers[0].chain",
            "the linkage has 2 chains",
        ),
        (
            vec![with("chain", json!(0))],
            "motion.drivers[0].chain",
            "from 1 to 2",
        ),
        (
            vec![with("joint", json!(3))],
            "motion.drivers[0].joint",
            "crank has 2 joints",
        ),
        (
            vec![with("freedom", json!(2))],
            "motion.drivers[0].freedom",
            "a joint of type R has 1 freedom",
        ),
        (
            vec![with("freedom", json!(1.5))],
            "motion.drivers[0].freedom",
            "a whole number",
        ),
        (
            vec![good.clone(), good.clone()],
            "motion.drivers[1]",
            "θ₁ of crank is driven by driver 1 already",
        ),
        (
            vec![with("values", json!([]))],
            "motion.drivers[0].values",
            "2 to 1000",
        ),
        (
            vec![with("values", json!([{"time": 0, "value": 0}]))],
            "motion.drivers[0].values",
            "there is only one",
        ),
        (
            vec![with("values", value(json!(0), json!(1)))],
            "motion.drivers[0].values[1].time",
            "later than 0",
        ),
        (
            vec![with("values", value(json!(1e10), json!(1)))],
            "motion.drivers[0].values[1].time",
            "a time from",
        ),
        (
            vec![with("values", value(json!(1), json!(1e7)))],
            "motion.drivers[0].values[1].value",
            "an angle in degrees",
        ),
        (
            vec![with("values", value(json!(1), json!("x")))],
            "motion.drivers[0].values[1].value",
            "a number",
        ),
        (
            vec![with("ramp", json!("slow"))],
            "motion.drivers[0].ramp",
            "one of linear, smooth",
        ),
        (
            vec![with("speed", json!(1))],
            "motion.drivers[0].speed",
            "one of",
        ),
        (
            vec![json!({"joint": 1, "values": []})],
            "motion.drivers[0].chain",
            "counted from 1",
        ),
        (
            vec![json!({"chain": 1, "joint": 1})],
            "motion.drivers[0].values",
            "times and values",
        ),
    ];
    for (drivers, place, part) in cases {
        let text = drive(document.clone(), 5, drivers).to_string();
        let fault = Session::open(&text).expect_err(place);
        assert_eq!(fault.place, place, "{fault}");
        assert!(fault.message.contains(part), "{fault}");
    }
    let motions = [
        (json!({}), "motion.key_frames", "or drivers in their place"),
        (
            json!({"drivers": []}),
            "motion.key_frames",
            "or drivers in their place",
        ),
        (
            json!({"drivers": [good], "key_frames": [{}, {"x": 1}]}),
            "motion.drivers",
            "key frames, or drivers",
        ),
        (
            json!({"drivers": [good], "frames": 1}),
            "motion.frames",
            "from 2 to 10000",
        ),
        (
            json!({"key_frames": []}),
            "motion.key_frames",
            "2 to 100000 key frames",
        ),
    ];
    for (motion, place, part) in motions {
        let mut document = document.clone();
        document["motion"] = motion;
        let fault = Session::open(&document.to_string()).expect_err(place);
        assert_eq!(fault.place, place, "{fault}");
        assert!(fault.message.contains(part), "{fault}");
    }
    // Key frames may be an empty list where there are drivers.
    let mut document = document.clone();
    document["motion"] = json!({"drivers": [good], "key_frames": []});
    assert!(Session::open(&document.to_string()).is_ok());
}
