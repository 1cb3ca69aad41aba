//! Goal motions: against an independent reference, and by the properties each interpolation has.

#![allow(clippy::float_cmp, reason = "key frames are met exactly")]

use nalgebra::{Matrix3, Quaternion, Rotation3, Translation3, UnitQuaternion, Vector3};
use synthetica::document::problem::Problem;
use synthetica::document::report::Report;
use synthetica::document::text::parse;
use synthetica::document::warnings::WarningReport;
use synthetica::math::pose::{DualQuaternion, FrameCoordinates, Pose, dual_quaternion, gaps};
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

/// About the default point of reference, with the default radius.
fn curve(keys: &[KeyFrame], how: Interpolation) -> Curve {
    curve_about(keys, how, &DoubleQuaternions::default())
}

fn curve_about(keys: &[KeyFrame], how: Interpolation, about: &DoubleQuaternions) -> Curve {
    Curve::new(keys, how, about).expect("usable key frames")
}

/// About the origin of the fixed frame, as the paper has it.
fn about_origin(radius: f64) -> DoubleQuaternions {
    DoubleQuaternions {
        reference: Some(Vector3::zeros()),
        radius: Some(radius),
    }
}

fn goals(keys: &[KeyFrame], how: Interpolation, frames: usize) -> Vec<Goal> {
    let motion = goal_motion(keys, how, frames, &DoubleQuaternions::default());
    motion.expect("usable key frames").goals
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
        let motion = goal_motion(
            &keys,
            Interpolation::Bezier,
            goals.len(),
            &about_origin(20.0),
        );
        let motion = motion.expect("usable key frames").goals;
        for (ours, golden) in motion.iter().zip(goals) {
            let golden = DualQuaternion::from_vec(numbers(golden));
            let ours = dual_quaternion(&ours.pose, 1.0);
            // Both signs are the same pose.
            let ours = if ours.dot(&golden) < 0.0 { -ours } else { ours };
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
            let curve = curve(&keys, how);
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
        let motion = goals(&keys, how, 31);
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
        let motion = goals(&keys, how, 2);
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
        let curve = curve(&keys, Interpolation::Bezier);
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
            let curve = curve(&keys, how);
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
            curve(&keys, Interpolation::Sclerp),
            curve(&moved, Interpolation::Sclerp),
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
        let curve = curve(&keys[..2], Interpolation::Sclerp);
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
        let curve = curve(&[key(a), key(b)], Interpolation::Straight);
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
            [&keys, &reversed, &slow].map(|k| curve(k, Interpolation::Bezier));
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
            let [own, limit] = [times, 2e4]
                .map(|r| curve_about(keys, Interpolation::Bezier, &about_origin(r * farthest)));
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
            let quarter = curve(&[key(roll(0.0)), key(roll(turn))], how).pose(0.5);
            assert!(
                apart(&quarter, &roll(90.0 * sign)) < 1e-12,
                "{how:?} {turn}"
            );
        }
        // There and back, where the spline's mirror image lies opposite the next point.
        let keys = [0.0, 180.0, 0.0, 180.0].map(|turn| key(roll(turn)));
        let there_and_back = curve(&keys, how);
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
        let still = curve(&vec![key(pose); 5], how);
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
        let curve = curve(&keys, how);
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
        let about = DoubleQuaternions {
            reference: None,
            radius,
        };
        goal_motion(keys, Interpolation::Bezier, frames, &about).expect_err("unusable")
    };
    assert_eq!(fault(&[], 33, None), KeyFrameFault::TooFew { found: 0 });
    assert_eq!(
        fault(&two[..1], 33, None),
        KeyFrameFault::TooFew { found: 1 }
    );
    let many = vec![two[0].clone(); MAX_KEY_FRAMES + 1];
    assert_eq!(
        fault(&many, 33, None),
        KeyFrameFault::TooMany {
            found: MAX_KEY_FRAMES + 1
        }
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

/// The motion of key frames that were moved together is the moved motion: with the default reference
/// and radius, and with a point of reference that is moved too.
#[test]
fn the_motion_does_not_depend_on_the_fixed_frame() {
    let mut random = Random(12);
    for size in [1.0, 1e3, 1e5] {
        let mut worst: f64 = 0.0;
        for round in 0..60 {
            let mut keys = random.keys(3.0);
            if round % 2 == 1 {
                keys = timed(keys, &mut random);
            }
            let mut by = random.pose();
            by.translation.vector *= size;
            let moved: Vec<_> = keys
                .iter()
                .map(|k| KeyFrame {
                    pose: by * k.pose,
                    ..k.clone()
                })
                .collect();
            let point = random.vector();
            let given = |point| DoubleQuaternions {
                reference: Some(point),
                radius: Some(9.0),
            };
            let default = DoubleQuaternions::default();
            let shifted = by.rotation * point + by.translation.vector;
            for (own, other) in [(default, default), (given(point), given(shifted))] {
                for how in ALL {
                    let own = curve_about(&keys, how, &own);
                    let other = curve_about(&moved, how, &other);
                    let (first, last) = own.interval();
                    for i in 0..=40 {
                        let t = first + (last - first) * f64::from(i) / 40.0;
                        worst = worst.max(apart(&(by * own.pose(t)), &other.pose(t)));
                    }
                }
            }
        }
        // The moved key frames themselves are rounded, by 1e-16 of the distance, and so is the result.
        assert!(worst < 5e-14 + 5e-16 * size, "{size:e}: {worst:e}");
    }
}

/// Where the shift itself rounds nothing, all that is left is the rounding of the published positions.
#[test]
fn far_from_the_origin_no_digits_are_lost() {
    let mut random = Random(13);
    let coarse = |x: f64| (x * 1024.0).round() / 1024.0;
    let shift = Vector3::new(131_072.0, -65_536.0, 98_304.0);
    let last_digit = 131_072.0 * f64::EPSILON;
    for _ in 0..60 {
        let mut keys = random.keys(3.0);
        for k in &mut keys {
            k.pose.translation.vector.apply(|x| *x = coarse(*x));
        }
        let mut moved = keys.clone();
        for k in &mut moved {
            k.pose.translation.vector += shift;
        }
        for how in ALL {
            let (own, other) = (curve(&keys, how), curve(&moved, how));
            for i in 0..=64 {
                let t = f64::from(i) / 64.0;
                let (own, other) = (own.pose(t), other.pose(t));
                let d = other.translation.vector - shift - own.translation.vector;
                let turned = (own.rotation.coords - other.rotation.coords).norm();
                assert!(d.amax() <= last_digit, "{how:?} {:e}", d.amax());
                assert!(turned < 1e-13, "{how:?} {turned:e}");
            }
        }
    }
}

/// The same key frames in another unit of length: to the last bit where the factor is a power of two.
#[test]
fn the_unit_of_length_does_not_matter() {
    let mut random = Random(14);
    for _ in 0..60 {
        let keys = random.keys(3.0);
        let about = DoubleQuaternions {
            reference: Some(random.vector()),
            radius: Some(7.0),
        };
        for (factor, bound) in [(1024.0, 0.0), (0.125, 0.0), (1000.0, 1e-13), (0.001, 1e-13)] {
            let mut scaled = keys.clone();
            for k in &mut scaled {
                k.pose.translation.vector *= factor;
            }
            let scaled_about = DoubleQuaternions {
                reference: about.reference.map(|point| point * factor),
                radius: about.radius.map(|radius| radius * factor),
            };
            let default = DoubleQuaternions::default();
            for (own, other) in [(default, default), (about, scaled_about)] {
                for how in ALL {
                    let own = curve_about(&keys, how, &own);
                    let other = curve_about(&scaled, how, &other);
                    for i in 0..=40 {
                        let t = f64::from(i) / 40.0;
                        let mut back = other.pose(t);
                        back.translation.vector /= factor;
                        let off = apart(&own.pose(t), &back);
                        assert!(off <= bound, "{how:?} {factor} {off:e}");
                    }
                }
            }
        }
    }
}

#[test]
fn turning_on_the_spot_stays_on_the_spot() {
    for place in [0.0, 1.0 / 3.0, 1e5 / 3.0] {
        let spot = Vector3::new(place, -place, 7.0 * place);
        let keys = [0.0, 100.0, 170.0].map(|turn| {
            let mut pose = roll(turn);
            pose.translation.vector = spot;
            key(pose)
        });
        for how in ALL {
            let curve = curve(&keys, how);
            for i in 0..=50 {
                let off = curve.pose(f64::from(i) / 50.0).translation.vector - spot;
                assert!(off.amax() <= 2.0 * f64::EPSILON * spot.amax(), "{off:e}");
            }
        }
    }
}

/// A radius that is no shorter than the key frames' distances from the fixed frame is accepted wherever
/// their mean lies: here one is 1.9 away from it.
#[test]
fn the_radius_may_be_the_distance_from_the_fixed_frame() {
    let mut keys: Vec<_> = (0..40)
        .map(|_| key(Pose::translation(1.0, 0.0, 0.0)))
        .collect();
    keys[20] = key(Pose::translation(-1.0, 0.0, 0.0));
    let about = |radius| DoubleQuaternions {
        reference: None,
        radius: Some(radius),
    };
    let curve = curve_about(&keys, Interpolation::Bezier, &about(1.0));
    for i in 0..=400 {
        let x = curve.pose(f64::from(i) / 400.0).translation.x;
        assert!((-1.0 - 1e-12..1.0 + 1e-12).contains(&x), "{x}");
    }
    let fault = Curve::new(&keys, Interpolation::Bezier, &about(0.9)).expect_err("too short");
    assert!(
        matches!(fault, KeyFrameFault::Radius { least, .. } if (least - 0.975).abs() < 1e-12),
        "{fault:?}"
    );
}

/// Between equal neighbours nothing moves, and the motion arrives and leaves with no velocity.
#[test]
fn equal_neighbours_rest() {
    let mut random = Random(15);
    for round in 0..200 {
        let mut keys = random.keys(3.0);
        let at = round % keys.len();
        keys.insert(at, keys[at].clone());
        if round % 4 == 3 {
            keys.insert(at, keys[at].clone());
        }
        // Equal up to the sign of the quaternion, and to the rounding of an angle.
        let q = keys[at].pose.rotation.into_inner();
        if round % 3 == 1 {
            keys[at].pose.rotation = UnitQuaternion::new_unchecked(-q);
        }
        if round % 3 == 2 {
            keys[at].pose.rotation =
                UnitQuaternion::new_normalize(q + q * random.pose().rotation.into_inner() * 1e-14);
        }
        if round % 2 == 1 {
            keys = timed(keys, &mut random);
        }
        let time = |i: usize| keys[i].time.unwrap_or(i as f64 / (keys.len() - 1) as f64);
        let (from, to) = (time(at), time(at + 1));
        for how in ALL {
            let curve = curve(&keys, how);
            for i in 0..=50 {
                let t = from + (to - from) * f64::from(i) / 50.0;
                let off = apart(&curve.pose(t), &keys[at].pose);
                assert!(off < 1e-12, "{how:?} {off:e}");
            }
        }
        let curve = curve(&keys, Interpolation::Bezier);
        for (end, side) in [(from, -1e-5), (to, 1e-5)] {
            // A steady velocity would carry it 1e-5 times a velocity of about 1.
            let off = apart(&curve.pose(end + side), &keys[at].pose);
            assert!(off < 1e-7, "{off:e}");
        }
    }
}

/// Turned to 90°, held, and turned back: never beyond.
#[test]
fn a_held_pose_is_not_overshot() {
    for turns in [
        vec![0.0, 90.0, 90.0, 0.0],
        vec![0.0, 0.0, 90.0, 90.0],
        vec![0.0, 90.0, 90.0, 90.0, 20.0],
        vec![0.0, 90.0, 450.0, 0.0],
    ] {
        let keys: Vec<_> = turns
            .iter()
            .map(|&turn: &f64| {
                key(Pose::translation(libm::sin(turn.to_radians()), 0.0, 0.0) * roll(turn))
            })
            .collect();
        let curve = curve(&keys, Interpolation::Bezier);
        for i in 0..=600 {
            let pose = curve.pose(f64::from(i) / 600.0);
            let turned = FrameCoordinates::from_pose(&pose).roll.to_degrees();
            assert!((-1e-9..90.0 + 1e-9).contains(&turned), "{turns:?} {turned}");
            assert!(
                (-1e-12..1.0 + 1e-12).contains(&pose.translation.x),
                "{turns:?}"
            );
        }
    }
}

#[test]
fn half_turns_are_listed_with_their_axis() {
    let axes = |turns: &[f64]| -> Vec<(usize, f64)> {
        let keys: Vec<_> = turns.iter().map(|&turn| key(roll(turn))).collect();
        let lists = ALL.map(|how| {
            let motion = goal_motion(&keys, how, 9, &DoubleQuaternions::default());
            motion.expect("usable key frames").half_turns
        });
        assert!(lists[0] == lists[1] && lists[1] == lists[2]);
        lists[0]
            .iter()
            .map(|half| (half.key, half.axis.z))
            .collect()
    };
    let rounded = |turns: &[f64]| -> Vec<(usize, i32)> {
        let axes = axes(turns);
        assert!(axes.iter().all(|(_, z)| (z.abs() - 1.0).abs() < 1e-12));
        axes.iter()
            .map(|&(key, z)| (key, if z > 0.0 { 1 } else { -1 }))
            .collect()
    };
    assert_eq!(rounded(&[0.0, 180.0]), [(1, 1)]);
    assert_eq!(rounded(&[0.0, -180.0]), [(1, -1)]);
    assert_eq!(
        rounded(&[10.0, 190.0, 370.0, 190.0]),
        [(1, 1), (2, 1), (3, -1)]
    );
    assert_eq!(rounded(&[0.0, 179.999_999, -179.999_999]), []);
    // From 350°, which is met as −10°, on to 530°, as typed.
    assert_eq!(rounded(&[0.0, 350.0, 530.0]), [(2, 1)]);
    let keys = [0.0, 350.0, 530.0].map(|turn| key(roll(turn)));
    for how in [Interpolation::Sclerp, Interpolation::Straight] {
        let halfway = curve(&keys, how).pose(0.75);
        assert!(apart(&halfway, &roll(440.0)) < 1e-12, "{how:?}");
    }
    // The axis is in the fixed frame.
    let tilted = FrameCoordinates {
        longitude: 0.7,
        latitude: 0.4,
        ..FrameCoordinates::default()
    }
    .pose();
    let keys = [key(tilted), key(tilted * roll(180.0))];
    let motion = goal_motion(
        &keys,
        Interpolation::Bezier,
        2,
        &DoubleQuaternions::default(),
    );
    let axis = motion.expect("a motion").half_turns[0].axis;
    assert!((axis - tilted.rotation * Vector3::z()).norm() < 1e-12);
}

/// The document of a turntable with these key frames, as JSON.
fn turntable(key_frames: &str) -> String {
    format!(
        r#"{{"version": 1, "chains": [{{"joints": [{{"type": "R", "rows": [{{}}]}}], "start": [0]}}],
            "motion": {{"key_frames": {key_frames}, "frames": 37}}}}"#
    )
}

fn warnings(document: &str) -> Vec<WarningReport> {
    let document = parse(document).expect("a document");
    let problem = Problem::new(&document).expect("a problem");
    Report::new(&problem.mechanism, &problem.length_unit, &problem.plan()).warnings
}

/// From the field: a full turn, typed as 0 and 360, in which nothing turned and nothing was told.
#[test]
fn a_full_turn_typed_as_0_and_360_is_told_to_stand_still() {
    let document = r#"{"version": 1, "name": "a full turn typed as 0 and 360", "about": "", "length_unit": "m",
        "chains": [{"name": "turntable", "joints": [{"type": "R", "rows": [{}]}], "start": [0]}],
        "motion": {"key_frames": [{"roll": 0}, {"roll": 360}], "interpolation": "bezier", "frames": 37, "radius": null},
        "planner": {"method": "newton", "metric_length": 1.0}}"#;
    let [warning] = &warnings(document)[..] else {
        panic!("one warning");
    };
    assert_eq!(
        (warning.code, warning.first, warning.last),
        ("full-turn", None, None)
    );
    assert_eq!(
        warning.message,
        "From key frame 1 to key frame 2 the roll differs by 360°, which is the same rotation: the workpiece stands \
         still between them. To turn it all the way, add key frames between them, each less than 180° from the one \
         before."
    );
}

#[test]
fn what_angles_leave_open_is_told() {
    for (key_frames, expected) in [
        (
            r#"[{}, {"roll": 120}, {"roll": 240}, {"roll": 360}]"#,
            vec![],
        ),
        (r#"[{"roll": 170}, {"roll": -170}]"#, vec![]),
        (r#"[{"roll": -135}, {"roll": 135}]"#, vec![]),
        (r#"[{}, {"roll": 179.99}, {"roll": 10}]"#, vec![]),
        (r#"[{"roll": 300}, {"roll": 400}]"#, vec![]),
        ("[{}, {}]", vec![]),
        (r#"[{"roll": -180}, {"roll": 180}]"#, vec!["full-turn"]),
        (
            r#"[{"longitude": 20}, {"longitude": 740}]"#,
            vec!["full-turn"],
        ),
        (r#"[{}, {"roll": 360, "z": 1}]"#, vec!["full-turn"]),
        (r#"[{}, {"roll": 270}]"#, vec!["short-way"]),
        (r#"[{}, {"roll": 359.9}]"#, vec!["short-way"]),
        (r#"[{}, {"roll": 180}]"#, vec!["half-turn"]),
        (
            r#"[{"latitude": 90}, {"latitude": -90}]"#,
            vec!["half-turn"],
        ),
        (r#"[{}, {"roll": 540}]"#, vec!["short-way", "half-turn"]),
        (
            r#"[{}, {"roll": 270}, {"roll": 630}, {"roll": 450}]"#,
            vec!["short-way", "full-turn", "half-turn"],
        ),
    ] {
        let document = parse(&turntable(key_frames)).expect("a document");
        let problem = Problem::new(&document).expect("a problem");
        let mut trajectory = problem.plan();
        // In front of what the plan itself gives reason to warn of.
        assert!(trajectory.warnings.starts_with(&problem.notes));
        trajectory.warnings = problem.notes;
        let report = Report::new(&problem.mechanism, &problem.length_unit, &trajectory);
        let codes: Vec<_> = report.warnings.iter().map(|w| w.code).collect();
        assert_eq!(codes, expected, "{key_frames}");
    }
}

#[test]
fn warnings_name_key_frames_angles_and_the_axis() {
    let message = |key_frames: &str| warnings(&turntable(key_frames))[0].message.clone();
    assert_eq!(
        message(r#"[{"name": "rest"}, {"name": "lift", "roll": 360, "z": 1}]"#),
        "From key frame 1 “rest” to key frame 2 “lift” the roll differs by 360°, which is the same rotation: the \
         workpiece does not turn between them. To turn it all the way, add key frames between them, each less than \
         180° from the one before."
    );
    assert_eq!(
        message(r#"[{}, {"longitude": 10}, {"name": "end", "longitude": -260}]"#),
        "From key frame 2 to key frame 3 “end” the longitude differs by 270°, and the workpiece turns the short way, \
         by 90°. To turn it all the way, add key frames between them, each less than 180° from the one before."
    );
    assert_eq!(
        message(r#"[{}, {"roll": -180}]"#),
        "From key frame 1 to key frame 2 the workpiece turns by 180°, and both ways are equally long. It turns about \
         the direction (0, 0, -1) of the fixed frame, by the right-hand rule. A key frame between the two chooses the \
         other way."
    );
}

#[test]
fn the_reference_point_of_a_document() {
    let text = |reference: &str| {
        turntable(r#"[{"x": 1}, {"x": 2, "y": 1, "roll": 90}]"#).replace(
            r#""frames""#,
            &format!(r#""reference": {reference}, "frames""#),
        )
    };
    let problem = |reference: &str| parse(&text(reference)).and_then(|d| Problem::new(&d));
    let middle = |reference: &str| problem(reference).expect("a problem").goals[18].pose;
    assert_eq!(middle("null"), middle("[1.5, 0.5, 0]"));
    let off = apart(&middle("null"), &middle("[0, 0, 0]"));
    assert!((1e-6..1e-2).contains(&off), "{off:e}");
    for (reference, place, code) in [
        ("[0, 0]", "motion.reference", "WrongCount"),
        ("[0, 0, 0, 0]", "motion.reference", "WrongCount"),
        ("[0, 0, 1e13]", "motion.reference[2]", "OutOfRange"),
        (r#"[0, "0", 0]"#, "motion.reference[1]", "WrongType"),
        ("0", "motion.reference", "WrongType"),
    ] {
        let fault = problem(reference).expect_err(reference);
        assert_eq!(fault.place, place);
        assert_eq!(format!("{:?}", fault.code), code);
    }
}

/// The paper's samples name the origin: their goals are those of the key frames in the golden file's
/// interpolation, and another point would change them.
#[test]
fn the_papers_samples_interpolate_about_the_origin() {
    for text in [
        include_str!("../www/mechanisms/2tpr.json"),
        include_str!("../www/mechanisms/3rps.json"),
    ] {
        let document = parse(text).expect("a document");
        let problem = Problem::new(&document).expect("a problem");
        let keys: Vec<_> = document
            .motion
            .key_frames
            .iter()
            .map(|k| {
                let coordinates = FrameCoordinates {
                    x: k.x,
                    y: k.y,
                    z: k.z,
                    longitude: k.longitude.to_radians(),
                    latitude: k.latitude.to_radians(),
                    roll: k.roll.to_radians(),
                };
                key(coordinates.pose())
            })
            .collect();
        let motion = |about: &DoubleQuaternions| {
            let motion = goal_motion(&keys, Interpolation::Bezier, problem.goals.len(), about);
            motion.expect("usable key frames").goals
        };
        let worst = |goals: &[Goal]| {
            let pairs = goals.iter().zip(&problem.goals);
            pairs
                .map(|(a, b)| apart(&a.pose, &b.pose))
                .fold(0.0, f64::max)
        };
        let printed = worst(&motion(&about_origin(20.0)));
        assert!(printed < 1e-13, "{printed:e}");
        let elsewhere = worst(&motion(&DoubleQuaternions::default()));
        assert!(elsewhere > 1e-6, "{elsewhere:e}");
    }
}
