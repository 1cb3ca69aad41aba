//! Goal motions: against an independent reference, and by the properties each interpolation has.

#![allow(clippy::float_cmp, reason = "key frames are met exactly")]

use nalgebra::{Matrix3, Quaternion, Rotation3, Translation3, UnitQuaternion, Vector3};
use synthetica::math::pose::{
    DualQuaternion, FrameCoordinates, Pose, dual_quaternion, gaps, nearer_sign,
};
use synthetica::motion::goal::{
    Curve, DoubleQuaternions, Goal, Interpolation, MAX_FRAMES, default_radius, goal_motion,
};
use synthetica::motion::key_frames::{KeyFrame, KeyFrameFault, MAX_KEY_FRAMES};

const ALL: [Interpolation; 3] = [
    Interpolation::Bezier,
    Interpolation::Sclerp,
    Interpolation::Straight,
];

/// Knuth's MMIX generator: the same numbers on every platform.
struct Random(u64);

impl Random {
    /// Uniform in ±1.
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> Vector3<f64> {
        Vector3::new(self.next(), self.next(), self.next())
    }

    /// Origin in ±1, any rotation.
    fn pose(&mut self) -> Pose {
        let q = Quaternion::from_parts(self.next(), self.vector());
        Pose::from_parts(
            Translation3::from(self.vector()),
            UnitQuaternion::new_normalize(q),
        )
    }

    /// Up to seven key frames, each turned against the one before by less than `turn` (rad).
    fn keys(&mut self, turn: f64) -> Vec<KeyFrame> {
        let count = 2 + usize::from(self.next() > -0.5) + usize::from(self.next() > 0.0) * 3;
        let mut pose = self.pose();
        let mut keys = Vec::new();
        for _ in 0..count {
            keys.push(key(pose));
            let axis =
                UnitQuaternion::from_scaled_axis(self.vector().normalize() * (turn * self.next()));
            pose = Pose::from_parts(Translation3::from(self.vector()), pose.rotation * axis);
        }
        keys
    }
}

fn key(pose: Pose) -> KeyFrame {
    KeyFrame {
        name: String::new(),
        pose,
        time: None,
    }
}

/// Times with intervals from 0.2 to 2.2.
fn timed(mut keys: Vec<KeyFrame>, random: &mut Random) -> Vec<KeyFrame> {
    let mut time = -1.0;
    for k in &mut keys {
        k.time = Some(time);
        time += 1.2 + random.next();
    }
    keys
}

fn curve(keys: &[KeyFrame], how: Interpolation, radius: Option<f64>) -> Curve {
    Curve::new(keys, how, radius).expect("fit key frames")
}

/// The largest difference of two poses as 4×4 matrices.
fn apart(a: &Pose, b: &Pose) -> f64 {
    (a.to_homogeneous() - b.to_homogeneous()).abs().max()
}

fn roll(degrees: f64) -> Pose {
    FrameCoordinates {
        roll: degrees.to_radians(),
        ..FrameCoordinates::default()
    }
    .pose()
}

fn numbers(list: &serde_json::Value) -> Vec<f64> {
    list.as_array()
        .expect("list")
        .iter()
        .map(|x| x.as_f64().expect("number"))
        .collect()
}

/// The key frames of a task of the golden file, 4×4 matrices.
fn golden_keys(task: &serde_json::Value) -> Vec<KeyFrame> {
    let pose = |matrix: &serde_json::Value| {
        let rows: Vec<_> = matrix
            .as_array()
            .expect("rows")
            .iter()
            .map(numbers)
            .collect();
        let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_fn(|i, j| rows[i][j]));
        let d = Translation3::new(rows[0][3], rows[1][3], rows[2][3]);
        Pose::from_parts(d, UnitQuaternion::from_rotation_matrix(&rotation))
    };
    task["keys"]
        .as_array()
        .expect("keys")
        .iter()
        .map(|m| key(pose(m)))
        .collect()
}

/// Golden numbers of an independent program (tests/golden/README.md): its goals were made from its
/// key frames with R = 20.
#[test]
fn bezier_meets_the_golden_goals() {
    let text = include_str!("golden/closest-motion.json");
    let tasks: serde_json::Value = serde_json::from_str(text).expect("golden file");
    let mut worst: f64 = 0.0;
    for task in tasks.as_array().expect("tasks") {
        let goals = task["goals"].as_array().expect("goals");
        let keys = golden_keys(task);
        let motion =
            goal_motion(&keys, Interpolation::Bezier, goals.len(), Some(20.0)).expect("fit");
        for (ours, golden) in motion.iter().zip(goals) {
            let golden = DualQuaternion::from_vec(numbers(golden));
            let ours = nearer_sign(&golden, dual_quaternion(&ours.pose, 1.0));
            worst = worst.max((ours - golden).abs().max());
        }
    }
    assert!(worst < 1e-14, "{worst:e}");
}

#[test]
fn every_interpolation_meets_the_key_frames() {
    let mut random = Random(1);
    for round in 0..200 {
        let mut keys = random.keys(3.1);
        if round % 2 == 1 {
            keys = timed(keys, &mut random);
        }
        for how in ALL {
            let curve = curve(&keys, how, None);
            let (first, last) = curve.interval();
            for (i, k) in keys.iter().enumerate() {
                let time = k.time.unwrap_or(i as f64 / (keys.len() - 1) as f64);
                assert_eq!(apart(&curve.pose(time), &k.pose), 0.0);
                // And continuously: a little before and after it is nearly there.
                for side in [-1e-9, 1e-9] {
                    let near = curve.pose((time + side).clamp(first, last));
                    assert!(
                        apart(&near, &k.pose) < 1e-6,
                        "{how:?} {}",
                        apart(&near, &k.pose)
                    );
                }
            }
        }
    }
}

/// Four key frames and 31 frames: every key frame falls on a frame.
#[test]
fn frames_are_equally_spaced_and_end_on_the_key_frames() {
    let mut random = Random(2);
    let keys: Vec<_> = (0..4).map(|_| key(random.pose())).collect();
    for how in ALL {
        let motion = goal_motion(&keys, how, 31, None).expect("fit");
        assert_eq!(motion.len(), 31);
        for (i, goal) in motion.iter().enumerate() {
            assert!((goal.time - i as f64 / 30.0).abs() < 1e-15);
            if i % 10 == 0 {
                assert_eq!(apart(&goal.pose, &keys[i / 10].pose), 0.0);
            }
        }
        // The sign of the quaternion is continuous.
        for pair in motion.windows(2) {
            assert!(
                pair[0]
                    .pose
                    .rotation
                    .coords
                    .dot(&pair[1].pose.rotation.coords)
                    > 0.0
            );
        }
        let mut keys = keys.clone();
        for (k, time) in keys.iter_mut().zip([-2.0, 0.1, 0.7, 1e3]) {
            k.time = Some(time);
        }
        let motion = goal_motion(&keys, how, 2, None).expect("fit");
        assert_eq!([motion[0].time, motion[1].time], [-2.0, 1e3]);
        assert_eq!(apart(&motion[1].pose, &keys[3].pose), 0.0);
    }
}

/// One-sided differences of second order, at every inner key frame, with equal and unequal times.
#[test]
fn bezier_has_a_continuous_velocity() {
    let mut random = Random(3);
    let mut worst: f64 = 0.0;
    for round in 0..300 {
        let mut keys = random.keys(2.0);
        if round % 2 == 1 {
            keys = timed(keys, &mut random);
        }
        let curve = curve(&keys, Interpolation::Bezier, None);
        for i in 1..keys.len() - 1 {
            let time = keys[i].time.unwrap_or(i as f64 / (keys.len() - 1) as f64);
            let velocity = |h: f64| {
                let at = |t: f64| curve.pose(t).to_homogeneous();
                (at(time + h) * 4.0 - at(time) * 3.0 - at(time + 2.0 * h)) / (2.0 * h)
            };
            let (behind, before) = (velocity(1e-5), velocity(-1e-5));
            worst = worst.max((behind - before).abs().max() / (1.0 + behind.abs().max()));
        }
    }
    // The curvature's jump times h, and rounding over h.
    assert!(worst < 1e-6, "{worst}");
}

/// Nothing blows up: the velocity stays within a small multiple of the fastest chord's.
#[test]
fn velocities_are_finite_everywhere() {
    let mut random = Random(4);
    for round in 0..200 {
        // Up to a half turn from key frame to key frame, and identical neighbours.
        let mut keys = random.keys(if round % 3 == 0 {
            std::f64::consts::PI
        } else {
            1e-9
        });
        if round % 5 == 0 {
            keys.push(keys[keys.len() - 1].clone());
        }
        let chord = keys
            .windows(2)
            .map(|k| {
                let (d, angle) = gaps(&k[0].pose, &k[1].pose);
                d + angle
            })
            .fold(0.0, f64::max);
        let bound = 1e-6 + 12.0 * chord * (keys.len() - 1) as f64;
        for how in ALL {
            let curve = curve(&keys, how, None);
            for i in 0..500 {
                let t = f64::from(i) / 500.0;
                let (d, angle) = gaps(&curve.pose(t), &curve.pose(t + 1e-4));
                assert!(
                    (d + angle) / 1e-4 < bound,
                    "{how:?} {} {bound}",
                    (d + angle) / 1e-4
                );
            }
        }
    }
}

/// A screw motion has no favourite frame, fixed or moving.
#[test]
fn sclerp_is_bi_invariant() {
    let mut random = Random(5);
    for _ in 0..200 {
        let (a, b) = (random.pose(), random.pose());
        let keys = random.keys(3.0);
        let moved: Vec<_> = keys.iter().map(|k| key(a * k.pose * b)).collect();
        let (own, other) = (
            curve(&keys, Interpolation::Sclerp, None),
            curve(&moved, Interpolation::Sclerp, None),
        );
        for i in 0..=40 {
            let t = f64::from(i) / 40.0;
            assert!(apart(&(a * own.pose(t) * b), &other.pose(t)) < 1e-12);
        }
    }
}

/// Equal steps in time are equal displacements in the moving frame.
#[test]
fn sclerp_is_steady() {
    let mut random = Random(6);
    for turn in [3.0, 1e-3, 1e-8, 1e-12, 0.0] {
        let keys = random.keys(turn);
        let curve = curve(&keys[..2], Interpolation::Sclerp, None);
        let step = curve.pose(0.0).inv_mul(&curve.pose(0.1));
        for i in 0..10 {
            let at = curve.pose(f64::from(i) / 10.0);
            assert!(
                apart(&(at * step), &curve.pose((f64::from(i) + 1.0) / 10.0)) < 1e-13,
                "{turn}"
            );
        }
    }
}

#[test]
fn straight_is_straight_and_turns_about_one_axis() {
    let mut random = Random(7);
    for _ in 0..100 {
        let (a, b) = (random.pose(), random.pose());
        let curve = curve(&[key(a), key(b)], Interpolation::Straight, None);
        let whole = (a.rotation.inverse() * b.rotation).scaled_axis();
        for i in 0..=10 {
            let u = f64::from(i) / 10.0;
            let pose = curve.pose(u);
            let d = a.translation.vector * (1.0 - u) + b.translation.vector * u;
            assert!((pose.translation.vector - d).norm() < 1e-14);
            let turned = (a.rotation.inverse() * pose.rotation).scaled_axis();
            assert!((turned - whole * u).norm() < 1e-12);
        }
    }
}

/// The spline does not know which way time runs, nor in which unit.
#[test]
fn bezier_is_reversible_and_free_of_the_unit_of_time() {
    let mut random = Random(8);
    for _ in 0..50 {
        let keys = random.keys(1.5);
        let keys = timed(keys, &mut random);
        let rate = |k: &KeyFrame, rate: f64| KeyFrame {
            time: k.time.map(|t| rate * t),
            ..k.clone()
        };
        let reversed: Vec<_> = keys.iter().rev().map(|k| rate(k, -1.0)).collect();
        let slow: Vec<_> = keys.iter().map(|k| rate(k, 60.0)).collect();
        let [own, reversed, slow] =
            [&keys, &reversed, &slow].map(|k| curve(k, Interpolation::Bezier, None));
        let (first, last) = own.interval();
        for i in 0..=20 {
            let t = first + (last - first) * f64::from(i) / 20.0;
            assert!(apart(&own.pose(t), &reversed.pose(-t)) < 1e-12);
            assert!(apart(&own.pose(t), &slow.pose(60.0 * t)) < 1e-12);
        }
    }
}

/// What the documentation of `default_radius` claims, in units of the farthest key frame's distance.
#[test]
fn the_chosen_radius_bends_little_and_keeps_the_digits() {
    let text = include_str!("golden/closest-motion.json");
    let tasks: serde_json::Value = serde_json::from_str(text).expect("golden file");
    let motions: Vec<_> = tasks
        .as_array()
        .expect("tasks")
        .iter()
        .map(golden_keys)
        .collect();
    // The distortion falls with the square of R, so this R stands for the limit.
    let away_from_limit = |times: f64| {
        let mut worst: f64 = 0.0;
        for keys in &motions {
            let farthest = keys
                .iter()
                .map(|k| k.pose.translation.vector.norm())
                .fold(0.0, f64::max);
            let [own, limit] =
                [times, 2e4].map(|r| curve(keys, Interpolation::Bezier, Some(r * farthest)));
            for i in 0..=64 {
                let t = f64::from(i) / 64.0;
                worst = worst.max(gaps(&own.pose(t), &limit.pose(t)).0 / farthest);
            }
        }
        worst
    };
    assert_eq!(default_radius(3.0), 60.0);
    let [twice, chosen, ten_times_that, huge] = [2.0, 20.0, 200.0, 1e8].map(away_from_limit);
    assert!((2e-3..5e-3).contains(&twice), "{twice:e}");
    assert!((2e-5..5e-5).contains(&chosen), "{chosen:e}");
    assert!(
        (90.0..110.0).contains(&(chosen / ten_times_that)),
        "{ten_times_that:e}"
    );
    assert!((1e-9..1e-7).contains(&huge), "{huge:e}");
}

#[test]
fn half_turns_go_the_way_they_are_typed() {
    for how in ALL {
        for (turn, sign) in [(180.0, 1.0), (-180.0, -1.0)] {
            let quarter = curve(&[key(roll(0.0)), key(roll(turn))], how, None).pose(0.5);
            assert!(
                apart(&quarter, &roll(90.0 * sign)) < 1e-12,
                "{how:?} {turn}"
            );
        }
        // There and back, where the spline's mirror image lies opposite the next point.
        let keys = [0.0, 180.0, 0.0, 180.0].map(|turn| key(roll(turn)));
        let there_and_back = curve(&keys, how, None);
        for i in 0..=300 {
            let coords = there_and_back.pose(f64::from(i) / 300.0).rotation.coords;
            assert!((coords.norm() - 1.0).abs() < 1e-12 && coords.x.abs() + coords.y.abs() < 1e-12);
        }
    }
}

#[test]
fn identical_key_frames_stand_still() {
    let pose = Random(9).pose();
    for how in ALL {
        let still = curve(&vec![key(pose); 5], how, None);
        for i in 0..=50 {
            assert!(apart(&still.pose(f64::from(i) / 50.0), &pose) < 1e-13);
        }
    }
}

#[test]
fn outside_of_the_interval_the_motion_waits() {
    let mut random = Random(10);
    let keys = [key(random.pose()), key(random.pose())];
    for how in ALL {
        let curve = curve(&keys, how, None);
        assert_eq!(curve.pose(-1.0), curve.pose(0.0));
        assert_eq!(curve.pose(f64::INFINITY), curve.pose(1.0));
        assert_eq!(curve.pose(f64::NEG_INFINITY), curve.pose(0.0));
    }
}

#[test]
fn unfit_key_frames_are_refused() {
    let mut random = Random(11);
    let two = [key(random.pose()), key(random.pose())];
    let fault = |keys: &[KeyFrame], frames, radius| {
        goal_motion(keys, Interpolation::Bezier, frames, radius).expect_err("unfit")
    };
    assert_eq!(fault(&[], 33, None), KeyFrameFault::TooFew { found: 0 });
    assert_eq!(
        fault(&two[..1], 33, None),
        KeyFrameFault::TooFew { found: 1 }
    );
    let many = vec![two[0].clone(); MAX_KEY_FRAMES + 1];
    assert_eq!(
        fault(&many, 33, None),
        KeyFrameFault::TooMany { found: 1001 }
    );
    for found in [0, 1, MAX_FRAMES + 1, usize::MAX] {
        assert_eq!(
            fault(&two, found, None),
            KeyFrameFault::FrameCount { found }
        );
    }
    for radius in [0.0, -1.0, 1e-3, f64::INFINITY, f64::NAN] {
        assert!(matches!(
            fault(&two, 33, Some(radius)),
            KeyFrameFault::Radius { .. }
        ));
    }
    for bad in [f64::NAN, f64::INFINITY, 1e300] {
        let mut keys = two.clone();
        keys[1].pose.translation.x = bad;
        assert_eq!(fault(&keys, 33, None), KeyFrameFault::NotFinite { key: 1 });
    }
    let times = |times: [Option<f64>; 2]| {
        let mut keys = two.clone();
        keys[0].time = times[0];
        keys[1].time = times[1];
        fault(&keys, 33, None)
    };
    assert_eq!(
        times([Some(0.0), None]),
        KeyFrameFault::TimeMissing { key: 1 }
    );
    assert_eq!(
        times([None, Some(0.0)]),
        KeyFrameFault::TimeMissing { key: 0 }
    );
    assert_eq!(
        times([Some(1.0), Some(1.0)]),
        KeyFrameFault::TimeOrder {
            key: 1,
            previous: 1.0,
            time: 1.0
        }
    );
    assert!(matches!(
        times([Some(f64::NAN), Some(1.0)]),
        KeyFrameFault::TimeOrder { key: 0, .. }
    ));
    assert!(matches!(
        times([Some(-1e308), Some(1e308)]),
        KeyFrameFault::TimeOrder { key: 1, .. }
    ));
}
