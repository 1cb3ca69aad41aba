//! The same linkage in another unit, and elsewhere in the fixed frame, moves the same.

#[path = "common/fixtures.rs"]
mod fixtures;

use fixtures::{SAMPLES, document, lines, moved, problem, sample, scaled};
use nalgebra::{Translation3, Unit, UnitQuaternion, Vector3};
use std::collections::BTreeSet;
use synthetica::document::problem::Problem;
use synthetica::document::report::Report;
use synthetica::document::schema::Document;
use synthetica::math::pose::Pose;
use synthetica::math::random::Random;
use synthetica::motion::trajectory::{LengthSource, Trajectory};
use synthetica::source::typed::Typed;
use synthetica::study::why::explain;

/// Samples, and every `step`th random assembly.
fn documents(step: usize) -> Vec<(String, Document)> {
    let samples = SAMPLES.iter().map(|text| {
        let document = synthetica::document::text::parse(text).expect("a sample");
        (document.name.clone(), document)
    });
    let random = sample(lines("assemblies"), step);
    let random = random
        .iter()
        .map(|line| (line["case"].to_string(), document(line)));
    samples.chain(random).collect()
}

fn codes(problem: &Problem, t: &Trajectory) -> BTreeSet<&'static str> {
    let report = Report::new(&problem.mechanism, "", t);
    report.warnings.iter().map(|w| w.code).collect()
}

/// Sliders and angles of the joint values of one frame or of many, in a unit `s` times smaller, in the original's.
fn in_original(problem: &Problem, joints: &[f64], s: f64) -> Vec<f64> {
    let turns: Vec<bool> = problem
        .mechanism
        .chains()
        .iter()
        .flat_map(|c| c.turns().collect::<Vec<_>>())
        .collect();
    joints
        .iter()
        .zip(turns.iter().cycle())
        .map(|(x, turns)| if *turns { *x } else { x / s })
        .collect()
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|x| x.to_bits()).collect()
}

/// Is the answer of a frame well determined: singular values and curvature above 1e-3?
fn well_determined(problem: &Problem, t: &Trajectory, frame: usize) -> bool {
    if t.sigma_min[frame] <= 1e-3 {
        return false;
    }
    let mut solver = problem
        .settings
        .solver(&problem.mechanism, problem.extent());
    let mut joints = t.joints_at(frame).to_vec();
    if !solver
        .close_start(&mut joints, problem.settings.dimension_tolerance)
        .is_closed()
    {
        return false;
    }
    let insight = explain(&mut solver, &joints, &t.goals[frame]);
    insight.least_curvature.is_none_or(|least| least > 1e-3)
}

fn any_unit(step: usize) {
    let mut failures = Vec::new();
    for (case, document) in documents(step) {
        let own = problem(&document);
        let t = own.plan();
        for power in [-10_i32, 7, 13] {
            let s = power_of_two(power);
            let other = problem(&scaled(&document, s));
            let u = other.plan();
            let joints = in_original(&own, &u.joints, s);
            assert_eq!(joints.len(), t.joints.len(), "{case}");
            let same = bits(&t.metric) == bits(&u.metric)
                && bits(&t.rotation_gap) == bits(&u.rotation_gap)
                && bits(&t.closure) == bits(&u.closure)
                && bits(&t.misfit) == bits(&u.misfit)
                && bits(&t.sigma_min) == bits(&u.sigma_min)
                && bits(&t.projected_gradient) == bits(&u.projected_gradient)
                && t.iterations == u.iterations
                && t.status == u.status
                && bits(&joints) == bits(&t.joints);
            if !same || codes(&own, &t) != codes(&other, &u) || t.mobility_rank != u.mobility_rank {
                let frame = (0..t.frames())
                    .find(|&f| t.joints_at(f) != &joints[f * t.variables..(f + 1) * t.variables]);
                failures.push(format!(
                    "{case} times 2^{power}: other bits from frame {frame:?} of {}",
                    t.frames()
                ));
            }
        }
        for s in [1e-3, 25.4, 1e4] {
            let other = problem(&scaled(&document, s));
            let u = other.plan();
            if t.mobility_rank != u.mobility_rank {
                failures.push(format!(
                    "{case} times {s}: mobility {} and {}",
                    t.mobility_rank, u.mobility_rank
                ));
            }
            let mut lost = false;
            for frame in 0..t.frames() {
                let joints = in_original(&own, u.joints_at(frame), s);
                let size = own.mechanism.size_or(own.extent());
                let turns = own
                    .mechanism
                    .chains()
                    .iter()
                    .flat_map(|c| c.turns().collect::<Vec<_>>());
                let apart = joints
                    .iter()
                    .zip(t.joints_at(frame))
                    .zip(turns)
                    .map(|((a, b), turns)| (a - b).abs() / if turns { 1.0 } else { size })
                    .fold(0.0, f64::max);
                if apart <= 1e-9 && t.status[frame] == u.status[frame] {
                    continue;
                }
                if well_determined(&own, &t, frame) {
                    failures.push(format!(
                        "{case} times {s}, frame {frame}: joints {apart:.1e} apart, {:?} and {:?}",
                        t.status[frame], u.status[frame]
                    ));
                }
                // Where the answer is not determined so well the motions may part.
                lost = true;
                break;
            }
            if !lost && codes(&own, &t) != codes(&other, &u) {
                failures.push(format!(
                    "{case} times {s}: warnings {:?} and {:?}",
                    codes(&own, &t),
                    codes(&other, &u)
                ));
            }
        }
    }
    assert!(
        failures.is_empty(),
        "{} failures\n{}",
        failures.len(),
        failures.join("\n")
    );
}

/// A power of two from its exponent, exactly.
fn power_of_two(power: i32) -> f64 {
    (0..power.unsigned_abs()).fold(1.0, |s, _| if power > 0 { s * 2.0 } else { s * 0.5 })
}

#[test]
fn any_unit_moves_the_same() {
    any_unit(15);
}

#[test]
#[ignore = "minutes in release: cargo test --release --test any_unit_any_place -- --ignored"]
fn any_unit_moves_the_same_in_all_assemblies() {
    any_unit(1);
}

fn any_place(step: usize) {
    let mut failures = Vec::new();
    let mut random = Random::new(0x91ACE);
    for (case, mut document) in documents(step) {
        document.planner.metric = synthetica::math::metric::MetricKind::Pose;
        document.motion.reference = None;
        let own = problem(&document);
        let t = own.plan();
        let size = own.mechanism.size_or(own.extent());
        for far in [10.0, 1e3, 1e5] {
            let mut direction = || {
                Vector3::new(
                    random.between(-1.0, 1.0),
                    random.between(-1.0, 1.0),
                    random.between(-1.0, 1.0),
                )
            };
            let (shift, axis) = (
                direction().normalize() * (far * size),
                Unit::new_normalize(direction()),
            );
            let turn = UnitQuaternion::from_axis_angle(&axis, 2.0);
            let motion = Pose::from_parts(Translation3::from(shift), turn);
            let other = problem(&moved(&document, &motion));
            let u = other.plan();
            if far > 1e4 {
                let worse = (0..t.frames())
                    .find(|&f| t.status[f].is_certified() && !u.status[f].is_certified());
                if let Some(frame) = worse {
                    failures.push(format!(
                        "{case} at {far} sizes, frame {frame}: {:?}",
                        u.status[frame]
                    ));
                }
                let new: Vec<_> = codes(&other, &u)
                    .difference(&codes(&own, &t))
                    .copied()
                    .collect();
                if !new.is_empty() {
                    failures.push(format!("{case} at {far} sizes warns of {new:?}"));
                }
                continue;
            }
            for frame in 0..t.frames() {
                let back = motion.inverse() * u.poses[frame];
                let apart =
                    (back.translation.vector - t.poses[frame].translation.vector).norm() / size;
                if apart > 1e-8 && t.sigma_min[frame] > 1e-2 {
                    if well_determined(&own, &t, frame) {
                        failures.push(format!("{case} at {far} sizes, frame {frame}: {apart:.1e} sizes apart, {:?} and {:?}", t.status[frame], u.status[frame]));
                    }
                    break;
                }
            }
        }
    }
    assert!(
        failures.is_empty(),
        "{} failures\n{}",
        failures.len(),
        failures.join("\n")
    );
}

#[test]
fn any_place_moves_the_same() {
    any_place(15);
}

#[test]
#[ignore = "minutes in release: cargo test --release --test any_unit_any_place -- --ignored"]
fn any_place_moves_the_same_in_all_assemblies() {
    any_place(1);
}

/// A linkage whose axes meet in one point has no lengths, and no motion about that point has any: what rounding leaves of one
/// is no length to measure by. All places of the point, and of what the rows have as points along their axes, give one answer.
#[test]
fn rounding_is_no_length_to_measure_by() {
    let axes = [
        [
            [1.0, 0.0, 0.0],
            [0.7544065067354889, 0.133022221559489, 0.6427876096865393],
        ],
        [
            [0.25881904510252074, 0.9659258262890683, 0.0],
            [0.21984631039295427, 0.6040227735550536, 0.766044443118978],
        ],
    ];
    let planned = |centre: [f64; 3], radius: f64| {
        let joint = |axis: [f64; 3]| {
            let point: Vec<f64> = (0..3).map(|i| centre[i] + radius * axis[i]).collect();
            serde_json::json!({"type": "R", "point": point, "axis": axis})
        };
        let chain = |axes: [[f64; 3]; 2]| serde_json::json!({"joints": axes.map(joint)});
        let [x, y, z] = centre;
        let document = serde_json::json!({
            "version": 1, "length_unit": "mm", "home": {"x": x, "y": y, "z": z}, "chains": axes.map(chain),
            "motion": {"frames": 33, "key_frames": [
                {"x": x, "y": y, "z": z, "roll_pitch_yaw": [0, 0, 0]},
                {"x": x, "y": y, "z": z, "roll_pitch_yaw": [10, 25, -40]},
            ]},
        });
        let typed = Typed::read(&document.to_string()).expect("a document");
        Problem::new(&typed.document).expect("a problem").plan()
    };
    let with_lengths = planned([0.0; 3], 100.0);
    assert_eq!(with_lengths.length_source, LengthSource::Mechanism);
    for centre in [[0.0; 3], [1000.0, -300.0, 0.1], [-0.7, 1e5, 3e4]] {
        let motion = planned(centre, 0.0);
        assert_eq!(
            (motion.length_source, motion.metric_used.length),
            (LengthSource::None, 1.0),
            "{centre:?}"
        );
        for (found, expected) in motion.metric.iter().zip(&with_lengths.metric) {
            assert!(
                (found - expected).abs() < 1e-9,
                "{centre:?}: {found} for {expected}"
            );
        }
    }
}
