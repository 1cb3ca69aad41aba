//! Parallel robots that makers make, each against the closed form of its paper: joints that the planner found, held against
//! formulas of the workpiece's pose.
#![cfg(not(target_arch = "wasm32"))]

use nalgebra::{Rotation3, Vector3};
use serde_json::Value;
use synthetica::Session;
use synthetica::makers::list::named;
use synthetica::makers::make::make;
use synthetica::math::pose::Pose;
use synthetica::motion::trajectory::{Status, Trajectory};

/// A maker's mechanism with these inputs, in mm.
fn made(name: &str, given: &[(&str, &str)]) -> Session {
    let owned = |&(name, value): &(&str, &str)| (name.to_owned(), value.to_owned());
    let given: Vec<(String, String)> = given.iter().map(owned).collect();
    let maker = named(name).unwrap_or_else(|| panic!("no maker {name}"));
    let text = make(maker, &given, Some("mm")).unwrap_or_else(|fault| panic!("{fault}"));
    Session::open(&text).unwrap_or_else(|fault| panic!("{fault}"))
}

/// A maker's mechanism with its defaults, planned; every frame is an answer.
fn planned(name: &str, given: &[(&str, &str)]) -> (Session, Trajectory) {
    let session = made(name, given);
    let t = session.plan();
    assert!(
        t.status.iter().all(|s| s.is_certified()),
        "{name}: {:?}",
        t.status
    );
    (session, t)
}

fn near(what: &str, got: f64, wanted: f64, within: f64) {
    assert!((got - wanted).abs() <= within, "{what}: {got} for {wanted}");
}

/// A radial unit vector, at so many thirds of a turn.
fn radial(third: usize) -> Vector3<f64> {
    let angle = (third as f64) * 120.0_f64.to_radians();
    Vector3::new(libm::cos(angle), libm::sin(angle), 0.0)
}

/// The point of the workpiece that is at `point` in its frame.
fn moved(pose: &Pose, point: &Vector3<f64>) -> Vector3<f64> {
    pose.rotation * point + pose.translation.vector
}

/// Azimuth and angle of the tilt and the torsion of an orientation Rz(azimuth) Ry(tilt) Rz(torsion - azimuth).
fn tilt_and_torsion(pose: &Pose) -> (f64, f64, f64) {
    let r = pose.rotation.to_rotation_matrix();
    let azimuth = libm::atan2(r[(1, 2)], r[(0, 2)]);
    let tilt = libm::atan2(libm::hypot(r[(0, 2)], r[(1, 2)]), r[(2, 2)]);
    let level = Rotation3::from_axis_angle(
        &nalgebra::Unit::new_normalize(Vector3::new(-libm::sin(azimuth), libm::cos(azimuth), 0.0)),
        tilt,
    );
    let rest = level.inverse() * r;
    (azimuth, tilt, libm::atan2(rest[(1, 0)], rest[(0, 0)]))
}

/// I. A. Bonev, Direct kinematics of zero-torsion parallel mechanisms (2008): the platform has no torsion, and its middle is
/// moved aside by h/2 (1 - cos tilt) at minus twice the azimuth, where h is the platform's radius.
fn has_parasitic_motion(name: &str, t: &Trajectory, radius: f64) {
    let mut most = 0.0_f64;
    for (frame, pose) in t.poses.iter().enumerate() {
        let (azimuth, tilt, torsion) = tilt_and_torsion(pose);
        let aside = radius / 2.0 * (1.0 - libm::cos(tilt));
        let what = |which: &str| format!("{name}, frame {frame}, {which}");
        near(&what("torsion"), torsion, 0.0, 1e-9);
        near(
            &what("x"),
            pose.translation.x,
            -aside * libm::cos(2.0 * azimuth),
            1e-7,
        );
        near(
            &what("y"),
            pose.translation.y,
            aside * libm::sin(2.0 * azimuth),
            1e-7,
        );
        most = most.max(tilt);
    }
    assert!(
        most > 10.0_f64.to_radians(),
        "{name} tilts by {most} rad only"
    );
}

/// The key frames of a motion with `count` of them at equal times are reached.
fn key_frames_are_reached(name: &str, t: &Trajectory, count: usize) {
    for key in 0..count {
        let frame = key * (t.frames() - 1) / (count - 1);
        assert_eq!(t.status[frame], Status::Reached, "{name}, key frame {key}");
    }
}

/// The platform does not turn, and does not stand still.
fn only_translates(name: &str, t: &Trajectory, far: f64) {
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, f64::max);
    let turned = largest(&mut t.poses.iter().map(|pose| pose.rotation.angle()));
    assert!(turned < 1e-9, "{name} turns by {turned}");
    let home = t.poses[0].translation.vector;
    let shifted = largest(
        &mut t
            .poses
            .iter()
            .map(|pose| (pose.translation.vector - home).norm()),
    );
    assert!(shifted > far, "{name} moves by {shifted} only");
}

#[test]
fn the_3_rps_has_its_parasitic_motion_and_leg_lengths() {
    for radius in ["250", "400"] {
        let (_, t) = planned("3-rps", &[("platform", radius)]);
        let h: f64 = radius.parse().expect("a number");
        assert_eq!(t.mobility_rank, 3);
        key_frames_are_reached("3-rps", &t, 5);
        has_parasitic_motion("3-rps", &t, h);
        let length =
            |pose: &Pose, leg| (moved(pose, &(radial(leg) * h)) - radial(leg) * 350.0).norm();
        let home = libm::hypot(h - 350.0, 600.0);
        for (frame, pose) in t.poses.iter().enumerate() {
            for leg in 0..3 {
                near(
                    "leg",
                    t.joints_at(frame)[5 * leg + 1],
                    length(pose, leg) - home,
                    1e-7,
                );
            }
        }
    }
}

#[test]
fn the_3_rps_agrees_with_the_document_by_rows() {
    let rows = include_str!("field/3rps-closed-form-mm-L250.json");
    let rows = Session::open(rows).expect("a document").plan();
    // Its key frames are those of a platform of radius 250, with the numbers of the maker's defaults.
    let (session, _) = planned("3-rps", &[]);
    let mut document: Value = serde_json::from_str(&session.text()).expect("its text");
    let given: Value = serde_json::from_str(include_str!("field/3rps-closed-form-mm-L250.json"))
        .expect("a document");
    document["motion"] = given["motion"].clone();
    document["planner"] = given["planner"].clone();
    let made = Session::open(&document.to_string())
        .expect("a document")
        .plan();
    assert_eq!(made.frames(), rows.frames());
    for frame in 0..made.frames() {
        let apart =
            (made.poses[frame].to_homogeneous() - rows.poses[frame].to_homogeneous()).norm();
        assert!(apart < 1e-5, "frame {frame}: {apart}");
    }
    key_frames_are_reached("3-rps by rows", &made, 3);
}

#[test]
fn the_3_prs_has_its_parasitic_motion_and_carriages() {
    let (_, t) = planned("3-prs", &[]);
    assert_eq!(t.mobility_rank, 3);
    key_frames_are_reached("3-prs", &t, 5);
    has_parasitic_motion("3-prs", &t, 250.0);
    for (frame, pose) in t.poses.iter().enumerate() {
        for leg in 0..3 {
            let ball = moved(pose, &(radial(leg) * 250.0));
            let across = (radial(leg) * 350.0 - ball).xy().norm();
            let carriage = ball.z - (500.0_f64 * 500.0 - across * across).sqrt();
            near("carriage", t.joints_at(frame)[5 * leg], carriage, 1e-7);
        }
    }
}

#[test]
fn the_3_upu_of_tsai_only_translates() {
    let (_, t) = planned("3-upu-tsai", &[]);
    assert_eq!(t.mobility_rank, 3);
    key_frames_are_reached("3-upu-tsai", &t, 5);
    only_translates("3-upu-tsai", &t, 100.0);
    // L.-W. Tsai: each leg is the vector from its base joint to its platform joint.
    for (frame, pose) in t.poses.iter().enumerate() {
        for leg in 0..3 {
            let length = (pose.translation.vector + radial(leg) * (120.0 - 300.0)).norm();
            let home = libm::hypot(180.0, 400.0);
            near("leg", t.joints_at(frame)[5 * leg + 2], length - home, 1e-7);
        }
    }
}

#[test]
fn the_3_upu_of_tsai_is_loose_on_a_cylinder() {
    // With outer axes t and legs l the forbidden turns are l - (l t) t; they are in one plane where the middle is aside by
    // twice the difference of the radii.
    let mut document: Value =
        serde_json::from_str(&made("3-upu-tsai", &[]).text()).expect("its text");
    document["motion"] = serde_json::json!({"frames": 61, "key_frames": [{"z": "height"}, {"x": 350, "y": 410, "z": "height"}]});
    let t = Session::open(&document.to_string())
        .expect("a document")
        .plan();
    let aside = |frame: usize| t.poses[frame].translation.vector.xy().norm() / 180.0;
    let loosest = (0..t.frames())
        .min_by(|&a, &b| t.sigma_min[a].total_cmp(&t.sigma_min[b]))
        .expect("frames");
    assert!(aside(0) < 1e-9 && aside(t.frames() - 1) > 2.9);
    near("loose at", aside(loosest), 2.0, 0.06);
}

#[test]
fn the_3_upu_of_snu_has_five_freedoms_at_home_and_three_beside_it() {
    let (session, t) = planned("3-upu-snu", &[]);
    let rank = |frame: usize| {
        let pose = t.poses[frame];
        let (d, r) = (pose.translation, pose.rotation);
        let goal = [d.x, d.y, d.z, r.i, r.j, r.k, r.w];
        session
            .explain(t.joints_at(frame), &goal)
            .expect("closed loops")
            .mobility_rank
    };
    assert_eq!((t.mobility_rank, rank(0)), (5, 5));
    for frame in [8, t.frames() - 1] {
        assert!(t.poses[frame].translation.vector.xy().norm() > 5.0);
        assert_eq!(rank(frame), 3, "frame {frame}");
    }
    // It is loose for any sizes: the three legs forbid one turn only.
    assert_eq!(
        planned("3-upu-snu", &[("platform", "170")]).1.mobility_rank,
        5
    );
    // The same legs with tangential outer axes, as Tsai's, hold it.
    let tsai = [("base", "300"), ("platform", "170"), ("height", "600")];
    assert_eq!(planned("3-upu-tsai", &tsai).1.mobility_rank, 3);
}

#[test]
fn the_linear_delta_has_its_carriages_where_the_rods_reach() {
    let (_, t) = planned("linear-delta", &[]);
    assert_eq!(t.mobility_rank, 3);
    key_frames_are_reached("linear-delta", &t, 5);
    only_translates("linear-delta", &t, 50.0);
    for (frame, pose) in t.poses.iter().enumerate() {
        let at = pose.translation.vector;
        for column in 0..3 {
            let across = (at + radial(column) * (60.0 - 195.0)).xy().norm();
            let carriage = at.z + (241.0_f64 * 241.0 - across * across).sqrt();
            near("carriage", t.joints_at(frame)[5 * column], carriage, 1e-7);
        }
    }
}

#[test]
fn the_linear_delta_agrees_with_the_document_by_rows() {
    let given: Value =
        serde_json::from_str(include_str!("field/linear-delta-mm-L200.json")).expect("a document");
    let mut document: Value =
        serde_json::from_str(&made("linear-delta", &[]).text()).expect("its text");
    document["motion"] = given["motion"].clone();
    let t = Session::open(&document.to_string())
        .expect("a document")
        .plan();
    // Of tests/field/index.json, by an independent computation.
    for (column, carriage) in [-9.058625, -36.941629, -62.967954].iter().enumerate() {
        near("carriage", t.joints_at(32)[5 * column], *carriage, 1e-5);
    }
}

#[test]
fn the_tripterons_carriages_are_the_coordinates() {
    for given in [&[][..], &[("arms", "300,200")]] {
        let (_, t) = planned("tripteron", given);
        assert_eq!(t.mobility_rank, 3);
        key_frames_are_reached("tripteron", &t, 5);
        only_translates("tripteron", &t, 50.0);
        for (frame, pose) in t.poses.iter().enumerate() {
            for axis in 0..3 {
                near(
                    "carriage",
                    t.joints_at(frame)[4 * axis],
                    pose.translation.vector[axis],
                    1e-7,
                );
            }
        }
    }
}

#[test]
fn the_orthoglides_carriages_follow_from_its_rods() {
    let (_, t) = planned("orthoglide", &[]);
    assert_eq!(t.mobility_rank, 3);
    key_frames_are_reached("orthoglide", &t, 5);
    only_translates("orthoglide", &t, 90.0);
    // (x - carriage)² + y² + z² = rod², with the carriage at -rod at home; likewise the others.
    for (frame, pose) in t.poses.iter().enumerate() {
        let at = pose.translation.vector;
        for axis in 0..3 {
            let across = at.norm_squared() - at[axis] * at[axis];
            let carriage = at[axis] - (300.0_f64 * 300.0 - across).sqrt() + 300.0;
            near("carriage", t.joints_at(frame)[5 * axis], carriage, 1e-7);
        }
    }
}

#[test]
fn the_exechon_has_its_leg_lengths_and_leans_as_its_third_leg_says() {
    let (_, t) = planned("exechon", &[]);
    let (side, front, tips, nose, height) = (50.0, 180.0, 50.0, 86.0, 350.0);
    assert_eq!(t.mobility_rank, 3);
    key_frames_are_reached("exechon", &t, 4);
    let legs = [
        (
            Vector3::new(-side, 0.0, 0.0),
            Vector3::new(-tips, 0.0, 0.0),
            2,
        ),
        (
            Vector3::new(side, 0.0, 0.0),
            Vector3::new(tips, 0.0, 0.0),
            6,
        ),
        (
            Vector3::new(0.0, front, 0.0),
            Vector3::new(0.0, nose, 0.0),
            11,
        ),
    ];
    let home = Pose::translation(0.0, 0.0, height);
    let mut leaned = 0.0_f64;
    for (frame, pose) in t.poses.iter().enumerate() {
        for (base, tip, variable) in legs {
            let length = |pose: &Pose| (moved(pose, &tip) - base).norm();
            near(
                "leg",
                t.joints_at(frame)[variable],
                length(pose) - length(&home),
                1e-7,
            );
        }
        // Rx(swing) Ry(lean): in the plane of legs A and C, which holds their common axis, the platform is at x and at the
        // distance `up` of it; leg B is at right angles to its hinge, which is the platform's x axis.
        let r = pose.rotation.to_rotation_matrix();
        let swing = libm::atan2(r[(2, 1)], r[(1, 1)]);
        let at = pose.translation.vector;
        let up = at.z * libm::cos(swing) - at.y * libm::sin(swing);
        let lean = libm::atan2(at.x, up + front * libm::sin(swing));
        let swung = Rotation3::from_axis_angle(&Vector3::x_axis(), swing);
        let wanted = swung * Rotation3::from_axis_angle(&Vector3::y_axis(), lean);
        near(
            "in the plane",
            at.y * libm::cos(swing) + at.z * libm::sin(swing),
            0.0,
            1e-7,
        );
        near("lean", (wanted.matrix() - r.matrix()).norm(), 0.0, 1e-9);
        leaned = leaned.max(lean.abs());
    }
    assert!(
        leaned > 5.0_f64.to_radians(),
        "it leans by {leaned} rad only"
    );
}

#[test]
fn each_locked_leg_of_the_hexapod_takes_one_freedom_and_keeps_its_length() {
    for locked in ["1", "4,6", "1,3,5", "2,3,5,6", "1,2,3,4,5", "1,2,3,4,5,6"] {
        let legs: Vec<usize> = locked
            .split(',')
            .map(|leg| leg.parse().expect("a leg"))
            .collect();
        let (_, t) = planned("hexapod", &[("locked", locked)]);
        assert_eq!(t.mobility_rank, 6 - legs.len(), "{locked}");
        let point = |radius: f64, angle: f64, z: f64| {
            let angle = angle.to_radians();
            Vector3::new(radius * libm::cos(angle), radius * libm::sin(angle), z)
        };
        // Pairs at 0°, 120° and 240° on the base, and at 60°, 180° and 300° on the platform; each leg goes to the nearer one.
        let base = [-20.0, 20.0, 100.0, 140.0, 220.0, 260.0];
        let platform = [-40.0, 40.0, 80.0, 160.0, 200.0, 280.0];
        // 90/60/125: every leg of tests/field/hexapod-6-locked-L60.json has this length.
        let length = 131.058459076521;
        let mut moves = 0.0_f64;
        for pose in &t.poses {
            moves = moves.max((pose.to_homogeneous() - t.poses[0].to_homogeneous()).norm());
            for &leg in &legs {
                let (from, to) = (
                    point(90.0, base[leg - 1], 0.0),
                    point(60.0, platform[leg - 1], 0.0),
                );
                near("leg", (moved(pose, &to) - from).norm(), length, 1e-8);
            }
        }
        assert_eq!(moves > 1.0, legs.len() < 6, "{locked}: {moves}");
    }
}

#[test]
fn a_hexapod_locks_legs_that_it_has_each_once_and_at_least_one() {
    let hexapod = named("hexapod").expect("the maker");
    for (locked, part) in [
        ("7", "7 is out of range"),
        ("2,2", "2 is out of range"),
        ("1.5", "1.5 is out of range"),
        ("", "is no number"),
    ] {
        let given = ("locked".to_owned(), locked.to_owned());
        let fault = make(hexapod, &[given], None).expect_err(locked);
        assert!(fault.message.contains(part), "{locked}: {fault}");
    }
}
