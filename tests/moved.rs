//! The linkage moved by hand: pulled by its workpiece, driven by one joint, and explained where it stands.

#[allow(dead_code, reason = "each test file wants some of it")]
#[path = "common/checks.rs"]
mod checks;
mod common;

use checks::open;
use common::{Linkage, Random, assemblies, goals, linkage};
use nalgebra::{Quaternion, Translation3, UnitQuaternion, Vector3, Vector6};
use std::fs;
use synthetica::document::problem::Problem;
use synthetica::document::questions::Posture;
use synthetica::document::text;
use synthetica::math::metric::Metric;
use synthetica::math::pose::Pose;
use synthetica::model::chain::Chain;
use synthetica::model::joint::Limits;
use synthetica::model::mechanism::Mechanism;
use synthetica::model::scaled::{CLOSED, Scaled};
use synthetica::motion::trajectory::{Status, Trajectory};
use synthetica::plan::follow::plan;
use synthetica::plan::settings::{Settings, extent};
use synthetica::solve::close_start::Start;
use synthetica::solve::drive::{self, Driven, Obstacle};
use synthetica::solve::objective::objective;
use synthetica::source::session::Session;
use synthetica::study::why::{Held, Insight, explain};

/// The plain documents of www/mechanisms, by name; those of makers have other units and motions, and tests of their own.
fn documents() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/www/mechanisms");
    let mut all = Vec::new();
    for file in fs::read_dir(folder).expect("the samples") {
        let path = file.expect("a file").path();
        let name = path
            .file_name()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        if name != "index.json" {
            all.push((name, fs::read_to_string(&path).expect("text")));
        }
    }
    all.retain(|(_, text)| !text.contains("\"parameters\""));
    all.sort();
    assert!(all.len() >= 8, "{}", all.len());
    all
}

fn samples() -> impl Iterator<Item = (String, Problem, Trajectory)> {
    documents().into_iter().map(|(name, text)| {
        let session = Session::open(&text).unwrap_or_else(|fault| panic!("{name}: {fault}"));
        let problem = Problem::new(session.document()).expect("a document that is read");
        let motion = problem.plan();
        (name, problem, motion)
    })
}

fn sample(wanted: &str) -> (Problem, Trajectory) {
    let (_, problem, motion) = samples()
        .find(|(name, ..)| name == wanted)
        .expect("a sample of that name");
    (problem, motion)
}

fn numbers(pose: &Pose) -> Vec<f64> {
    let mut numbers = pose.translation.vector.as_slice().to_vec();
    numbers.extend(pose.rotation.coords.as_slice());
    numbers
}

/// Drives one joint of a linkage that is closed at `joints`.
fn drive(m: &Mechanism, joints: &mut [f64], variable: usize, value: f64) -> Driven {
    let mut solver = Settings::PAPER.solver(m, 1.0);
    assert_eq!(solver.close_start(joints, 0.0), Start::Closed);
    let (scaled, closer, _) = solver.parts();
    drive::drive(scaled, closer, joints, variable, value)
}

/// The length that stands for 1 rad of a turning joint.
fn size(m: &Mechanism) -> f64 {
    m.size().expect("a linkage with lengths")
}

/// Joint values with lengths as shares of the size.
fn in_sizes(m: &Mechanism, joints: &[f64]) -> Vec<f64> {
    Scaled::new(m, 1.0).entered(joints)
}

fn limits_kept(mechanism: &Mechanism, joints: &[f64]) -> bool {
    let limits = mechanism.chains().iter().flat_map(Chain::limits);
    limits
        .zip(joints)
        .all(|(l, x)| *x >= l.min - 1e-9 && *x <= l.max + 1e-9)
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}

#[test]
fn pulled_along_the_goals_the_linkage_makes_the_planned_motion() {
    for (name, problem, motion) in samples() {
        let mut joints = motion.joints_at(0).to_vec();
        for frame in 0..motion.frames() {
            let goal = numbers(&motion.goals[frame]);
            let posture = problem.pull(&joints, &goal).expect("a posture");
            let t = &posture.frame;
            assert!(t.closure[0] <= CLOSED, "{name}, frame {frame}");
            assert_eq!(t.status[0], motion.status[frame], "{name}, frame {frame}");
            assert!(
                (t.metric[0] - motion.metric[frame]).abs() <= 1e-9,
                "{name}, frame {frame}: f {} pulled, {} planned",
                t.metric[0],
                motion.metric[frame]
            );
            assert!(
                (t.sigma_min[0] - motion.sigma_min[frame]).abs() < 1e-3,
                "{name}"
            );
            joints.clone_from(&t.joints);
        }
    }
}

/// The lengths of a mechanism's joint values in its size, angles as they are.
fn distance(mechanism: &Mechanism, a: &[f64], b: &[f64]) -> f64 {
    largest_difference(&in_sizes(mechanism, a), &in_sizes(mechanism, b))
}

#[test]
fn a_joint_driven_to_a_planned_value_gets_it_and_the_loops_stay_closed() {
    for (name, problem, motion) in samples() {
        let m = &problem.mechanism;
        for variable in 0..motion.variables {
            for (from, to) in [(0, motion.frames() - 1), (motion.frames() / 2, 0)] {
                let value = motion.joints_at(to)[variable];
                let posture = problem
                    .drive(motion.joints_at(from), variable, value)
                    .expect("a posture");
                let t = &posture.frame;
                let case = format!("{name}, variable {variable}, frame {from} to {to}");
                assert!(t.closure[0] <= CLOSED, "{case}: open by {:e}", t.closure[0]);
                assert!(limits_kept(m, &t.joints), "{case}: {:?}", t.joints);
                assert_eq!(posture.obstacle, None, "{case}");
                assert_eq!(posture.value, Some(value), "{case}");
            }
        }
    }
}

#[test]
fn a_linkage_of_one_freedom_goes_the_same_way_by_whichever_joint_it_is_driven() {
    for name in ["four-bar.json", "bennett.json", "five-link.json"] {
        let (problem, motion) = sample(name);
        let m = &problem.mechanism;
        for variable in 0..motion.variables {
            let at = |frame: usize| motion.joints_at(frame)[variable];
            // At a turning point of its own a joint does not say which way.
            if (at(3) - at(2)) * (at(4) - at(3)) <= 0.0 || (at(4) - at(3)) * (at(5) - at(4)) <= 0.0
            {
                continue;
            }
            let (from, to) = (motion.joints_at(3), motion.joints_at(4));
            let mut joints = from.to_vec();
            let driven = drive(m, &mut joints, variable, to[variable]);
            assert_eq!(driven.obstacle, None);
            let off = distance(m, &joints, to);
            assert!(off < 1e-6, "{name}, variable {variable}: {off:e}");
        }
    }
}

#[test]
fn what_stops_a_joint_is_a_fact() {
    let mut stopped = 0;
    for (name, problem, motion) in samples() {
        let m = &problem.mechanism;
        let turns: Vec<bool> = m.chains().iter().flat_map(Chain::turns).collect();
        for variable in 0..motion.variables {
            for side in [-1.0, 1.0] {
                let from = motion.joints_at(motion.frames() / 3);
                let far = if turns[variable] { 3.5 } else { 3.0 * size(m) };
                let mut joints = from.to_vec();
                let value = from[variable] + side * far;
                let driven = drive(m, &mut joints, variable, value);
                let case = format!("{name}, variable {variable} by {}", side * far);
                assert!(open(m, &joints) <= CLOSED, "{case}");
                assert!(limits_kept(m, &joints), "{case}: {joints:?}");
                let Some(obstacle) = driven.obstacle else {
                    assert_eq!(joints[variable].to_bits(), value.to_bits(), "{case}");
                    continue;
                };
                stopped += 1;
                let got = joints[variable];
                assert!(
                    (got - from[variable]) * side >= -1e-12,
                    "{case}: {obstacle:?} at {got}"
                );
                // Just before, it still goes.
                let before = got - side * 1e-4 * if turns[variable] { 1.0 } else { size(m) };
                if (before - from[variable]) * side > 0.0 {
                    let mut again = from.to_vec();
                    let short = drive(m, &mut again, variable, before);
                    assert_eq!(short.obstacle, None, "{case}: {obstacle:?} at {got}");
                }
                // There, and on from there, it does not.
                let mut again = joints.clone();
                let on = drive(m, &mut again, variable, value);
                assert!(
                    on.obstacle.is_some() && (again[variable] - got).abs() < 1e-6,
                    "{case}: {obstacle:?} at {got}, then {:?} at {}",
                    on.obstacle,
                    again[variable]
                );
                // And it comes back.
                let mut back = joints.clone();
                let home = drive(m, &mut back, variable, from[variable]);
                assert_eq!(
                    home.obstacle, None,
                    "{case}: back from {obstacle:?} at {got}"
                );
                match obstacle {
                    Obstacle::OwnLimit => {
                        let l = m.chains().iter().flat_map(Chain::limits).nth(variable);
                        let l = l.expect("limits");
                        assert!((got - l.min).abs() < 1e-12 || (got - l.max).abs() < 1e-12);
                    }
                    Obstacle::Limits(held) => {
                        let limits: Vec<_> = m.chains().iter().flat_map(Chain::limits).collect();
                        for joint in held {
                            let (l, x) = (limits[joint], joints[joint]);
                            if l == Limits::NONE {
                                assert!(x.abs() > 19.0 * size(m), "{case}: {x}");
                                continue;
                            }
                            assert!(
                                (x - l.min).abs() < 1e-9 || (x - l.max).abs() < 1e-9,
                                "{case}"
                            );
                        }
                    }
                    Obstacle::DeadPoint => {
                        // The joint is stationary there: no free motion moves it to first order.
                        let rate = largest_rate(m, &joints, variable);
                        assert!(rate < 1e-3, "{case}: dead at {got}, rate {rate}");
                    }
                    other @ (Obstacle::Immobile | Obstacle::TooFar | Obstacle::Open) => {
                        panic!("{case}: {other:?}")
                    }
                }
            }
        }
    }
    assert!(stopped > 20, "{stopped}");
}

/// The largest rate of a joint variable over the unit motions of all joints that keep the loops closed,
/// from the paper's [A] and its singular vectors.
fn largest_rate(mechanism: &Mechanism, joints: &[f64], variable: usize) -> f64 {
    let rates = null_space(mechanism, joints);
    rates
        .iter()
        .map(|r| r[variable] * r[variable])
        .sum::<f64>()
        .sqrt()
}

/// Orthonormal joint rates that keep the loops closed, lengths in units of the size: the null space
/// of the differences of the chains' Jacobians.
fn null_space(mechanism: &Mechanism, joints: &[f64]) -> Vec<Vec<f64>> {
    let scaled = Scaled::new(mechanism, 1.0);
    let theta = scaled.entered(joints);
    let n = theta.len();
    let mut columns: Vec<Vec<f64>> = Vec::new();
    for (i, chain) in scaled.chains().iter().enumerate() {
        let mut state = synthetica::model::chain::ChainState::default();
        chain.evaluate(&theta[columns.len()..], &mut state);
        for column in &state.jacobian[..chain.freedoms()] {
            let mut c = vec![0.0; 6 * scaled.chains().len()];
            for (j, part) in c.chunks_exact_mut(6).enumerate() {
                // Loop j closes the first chain with chain j.
                if j > 0 && i == 0 {
                    part.copy_from_slice(column.as_slice());
                } else if j > 0 && i == j {
                    part.iter_mut()
                        .zip(column.iter())
                        .for_each(|(p, x)| *p = -x);
                }
            }
            columns.push(c);
        }
    }
    let svd = synthetica::math::linalg::svd(columns);
    (0..n)
        .filter(|&k| svd.sigma[k] < 1e-7)
        .map(|k| svd.v[k].clone())
        .collect()
}

#[test]
fn the_other_joints_follow_at_the_least_rates() {
    const STEP: f64 = 1e-4;
    for (name, problem, motion) in samples() {
        let m = &problem.mechanism;
        let from = motion.joints_at(motion.frames() / 2);
        let rates = null_space(m, from);
        let here = in_sizes(m, from);
        for variable in 0..motion.variables {
            let speed: f64 = rates.iter().map(|r| r[variable] * r[variable]).sum();
            if speed < 1e-2 {
                continue;
            }
            let turns = m.chains().iter().flat_map(Chain::turns).nth(variable);
            let unit = if turns == Some(true) { 1.0 } else { size(m) };
            let mut joints = from.to_vec();
            let driven = drive(m, &mut joints, variable, from[variable] + STEP * unit);
            if driven.obstacle.is_some() {
                continue;
            }
            let there = in_sizes(m, &joints);
            for k in 0..motion.variables {
                let least: f64 = rates.iter().map(|r| r[k] * r[variable]).sum::<f64>() / speed;
                let moved = (there[k] - here[k]) / STEP;
                assert!(
                    (moved - least).abs() < 1e-2 * (1.0 + least.abs()),
                    "{name}, variable {variable}: {k} follows by {moved}, least {least}"
                );
            }
        }
    }
}

#[test]
fn a_four_bar_stops_at_its_dead_points_and_says_so() {
    let (problem, motion) = sample("four-bar.json");
    let mut seen = 0;
    for variable in 0..4 {
        for value in [-9.0, 9.0] {
            let posture = problem
                .drive(motion.joints_at(0), variable, value)
                .expect("a posture");
            if let Some(obstacle) = posture.obstacle {
                assert!(
                    obstacle.starts_with("The loops cannot close with θ"),
                    "{obstacle}"
                );
                assert!(
                    obstacle.contains(" of ") && obstacle.ends_with("°."),
                    "{obstacle}"
                );
                seen += 1;
            }
        }
    }
    assert!(seen >= 2);
}

#[test]
fn limits_are_named() {
    let (problem, motion) = sample("scara.json");
    let posture = problem
        .drive(motion.joints_at(0), 1, 3.0)
        .expect("a posture");
    let sentence = posture.obstacle.expect("its limit is 140°");
    assert!(
        sentence.contains("θ₂ of ") && sentence.ends_with("ends at its own limit of 140°."),
        "{sentence}"
    );
    // Another joint's limit: the first slider of the 3RPS with a limit on the second, close by.
    let (_, text) = documents()
        .into_iter()
        .find(|(name, _)| name == "four-bar.json")
        .expect("there");
    let mut document: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let start = problem_of(&text).plan();
    let other = start.joints_at(0)[2].to_degrees();
    document["chains"][1]["joints"][0]["limits"] =
        serde_json::json!([{ "min": other - 5.0, "max": other + 5.0 }]);
    let limited = problem_of(&document.to_string());
    let sentences: Vec<String> = [-9.0, 9.0]
        .iter()
        .filter_map(|&value| {
            limited
                .drive(start.joints_at(0), 0, value)
                .expect("a posture")
                .obstacle
        })
        .collect();
    assert_eq!(sentences.len(), 2);
    assert!(
        sentences.iter().all(|s| s.contains("θ₁ of ")
            && s.contains(" stops at ")
            && s.contains(" is at its limit of ")),
        "{sentences:?}"
    );
}

fn problem_of(text: &str) -> Problem {
    Problem::new(&text::parse(text).expect("a document")).expect("a problem")
}

#[test]
fn random_linkages_are_driven_closed() {
    let mut random = Random(77);
    let (mut driven, mut met) = (0, 0);
    for kinds in assemblies(&mut random).iter().step_by(3) {
        let Linkage { mechanism: m, home } = linkage(kinds, &mut random);
        for variable in 0..home.len() {
            let mut joints = home.clone();
            let value = home[variable] + random.between(-0.8, 0.8);
            let end = drive(&m, &mut joints, variable, value);
            let open = open(&m, &joints);
            let case = format!("{kinds:?}, variable {variable}: {end:?}");
            assert!(open <= CLOSED, "{case}: open by {open:e}");
            assert!(end.obstacle != Some(Obstacle::TooFar), "{case}");
            driven += 1;
            met += usize::from(end.obstacle.is_none());
        }
    }
    assert!(10 * met > 5 * driven, "{met} of {driven}");
}

fn metric_of(problem: &Problem) -> Metric {
    problem
        .settings
        .metric_for(&problem.mechanism, problem.extent())
}

fn moved(pose: &Pose, twist: &Vector6<f64>, share: f64) -> Pose {
    let v = Vector3::new(twist[0], twist[1], twist[2]) * share;
    let w = Vector3::new(twist[3], twist[4], twist[5]) * share;
    let turn = UnitQuaternion::from_scaled_axis(w);
    Pose::from_parts(
        Translation3::from(pose.translation.vector + v),
        turn * pose.rotation,
    )
}

/// What holds of any insight.
fn is_consistent(
    case: &str,
    m: &Mechanism,
    joints: &[f64],
    goal: &Pose,
    metric: &Metric,
    insight: &Insight,
) {
    let reached = m.chains()[0].pose(joints);
    for k in 0..6 {
        let sum = insight.free_part[k] + insight.blocked_part[k];
        assert!(
            (sum - insight.gap[k]).abs() <= 1e-12 * (1.0 + size(m)),
            "{case}"
        );
    }
    // The chains' wrenches are the gradient but for the projected one.
    let target = metric.target(goal, &reached.rotation);
    let gradient = objective(&reached, &target).gradient;
    let mut sum = Vector6::zeros();
    for hold in &insight.chains {
        sum += Vector6::from_column_slice(&hold.wrench);
    }
    let mut rest = gradient - sum;
    rest.fixed_rows_mut::<3>(0).scale_mut(size(m));
    assert!(
        rest.norm() <= insight.projected_gradient + 1e-8 * (1.0 + gradient.norm()),
        "{case}: {rest} left, {:e} projected",
        insight.projected_gradient
    );
    let shares: f64 = insight.chains.iter().map(|h| h.share).sum();
    assert!(
        shares.abs() < 1e-12 || (shares - 1.0).abs() < 1e-12,
        "{case}: {shares}"
    );
    assert!(insight.freedoms.len() <= insight.mobility_rank, "{case}");
    let variables = joints.len() + 8;
    let rank = insight
        .singular_values
        .iter()
        .filter(|s| **s > 1e-6)
        .count();
    assert!(variables - rank >= insight.mobility_rank, "{case}");
}

/// A slider that may not lengthen as far as the motion asks.
#[test]
fn joints_at_limits_are_told() {
    let text = include_str!("../www/mechanisms/3rps.json");
    let mut document: serde_json::Value = serde_json::from_str(text).expect("JSON");
    document["chains"][0]["joints"][1]["limits"] = serde_json::json!([{ "max": 1.3 }]);
    let problem = problem_of(&document.to_string());
    let motion = problem.plan();
    let mut seen = 0;
    for frame in 0..motion.frames() {
        let (joints, goal) = (motion.joints_at(frame), &motion.goals[frame]);
        let held = problem
            .explain(joints, &numbers(goal))
            .expect("an insight")
            .held;
        let pressed = [Held {
            variable: 1,
            largest: true,
        }];
        match motion.status[frame] {
            Status::AtLimit => assert_eq!(held, pressed, "frame {frame}"),
            Status::Closest => assert_eq!(held, [], "frame {frame}"),
            Status::Reached | Status::Stalled | Status::Passing | Status::ClosureLost => {}
        }
        seen += usize::from(motion.status[frame] == Status::AtLimit);
    }
    assert!(seen > 10, "{seen} frames at the limit");
}

#[test]
fn planned_frames_are_explained() {
    for (name, problem, motion) in samples() {
        let m = &problem.mechanism;
        for frame in (0..motion.frames()).step_by(5) {
            let case = format!("{name}, frame {frame}");
            let (joints, goal) = (motion.joints_at(frame), &motion.goals[frame]);
            let insight = problem.explain(joints, &numbers(goal)).expect("an insight");
            is_consistent(&case, m, joints, goal, &metric_of(&problem), &insight);
            assert!(
                insight.projected_gradient < 1e-6,
                "{case}: {:e}",
                insight.projected_gradient
            );
            assert!(insight.least_curvature.is_none_or(|c| c > -1e-8), "{case}");
            // Certified: nothing of the gap is left in the free directions.
            let free = Vector6::from_column_slice(&insight.free_part).norm();
            assert!(free < 1e-6, "{case}: {free:e} of the gap is free");
            let held = insight.chains.iter().any(|h| h.share > 0.0);
            assert_eq!(held, motion.status[frame] != Status::Reached, "{case}");
            let gap = Vector3::from_column_slice(&insight.gap[..3]).norm();
            assert!((gap - motion.translation_gap[frame]).abs() < 1e-9, "{case}");
            let turn = Vector3::from_column_slice(&insight.gap[3..]).norm();
            assert!((turn - motion.rotation_gap[frame]).abs() < 1e-6, "{case}");
        }
    }
}

/// Pulling a little along a freedom, the workpiece goes there but for terms of second order; along
/// another direction it does not.
#[test]
fn freedoms_can_be_followed() {
    const STEP: f64 = 1e-4;
    for (name, problem, motion) in samples() {
        let frame = motion.frames() / 2;
        let joints = motion.joints_at(frame);
        let pose = motion.poses[frame];
        let insight = problem
            .explain(joints, &numbers(&motion.goals[frame]))
            .expect("an insight");
        assert!(!insight.freedoms.is_empty(), "{name}");
        let limits = problem.mechanism.chains().iter().flat_map(Chain::limits);
        let at_limit = limits
            .zip(joints)
            .any(|(l, x)| x - l.min < 1e-3 || l.max - x < 1e-3);
        if at_limit {
            continue;
        }
        for screw in &insight.freedoms {
            let goal = moved(&pose, &Vector6::from(screw.twist), STEP);
            let pulled = problem.pull(joints, &numbers(&goal)).expect("a posture");
            // In a unit of length that is the same for all.
            let off = (2.0 * Metric::default().value(&pulled.frame.poses[0], &goal)).sqrt();
            assert!(
                off < 30.0 * STEP * STEP,
                "{name}: {screw:?} is left by {off:e}"
            );
            // The axis and the pitch say the same as the twist.
            let axis = Vector3::from(screw.direction);
            let v = Vector3::new(screw.twist[0], screw.twist[1], screw.twist[2]);
            let d = pose.translation.vector;
            let expected = match screw.pitch {
                None => axis,
                Some(pitch) => axis.cross(&(d - Vector3::from(screw.point))) + axis * pitch,
            };
            assert!(
                (v - expected).norm() < 1e-7 * (1.0 + v.norm()),
                "{name}: {screw:?}"
            );
        }
    }
}

fn screws_of(name: &str) -> Insight {
    let (problem, motion) = sample(name);
    let frame = motion.frames() / 2;
    problem
        .explain(motion.joints_at(frame), &numbers(&motion.goals[frame]))
        .expect("an insight")
}

#[test]
fn known_linkages_have_known_freedoms() {
    let shifts = screws_of("cartesian.json").freedoms;
    assert_eq!(shifts.len(), 3);
    for (i, shift) in shifts.iter().enumerate() {
        assert_eq!(shift.pitch, None);
        let along = (Vector3::from(shift.direction) - Vector3::ith(i, 1.0)).norm();
        assert!(along < 1e-9, "{shift:?}");
    }
    let turn = screws_of("four-bar.json").freedoms;
    assert_eq!(turn.len(), 1);
    assert_eq!(
        turn[0].pitch,
        Some(0.0),
        "a planar linkage turns about its instant centre"
    );
    let screw = screws_of("bennett.json").freedoms;
    assert_eq!(screw.len(), 1);
    assert!(screw[0].pitch.is_some_and(|p| p != 0.0), "{screw:?}");
    let bearing = screws_of("spacecraft.json").freedoms;
    let pitches: Vec<Option<f64>> = bearing.iter().map(|s| s.pitch).collect();
    assert_eq!(pitches[..2], [None, None], "two shifts in the plane");
    assert_eq!(pitches.len(), 5);
    let scara = screws_of("scara.json").freedoms;
    assert_eq!(scara.iter().filter(|s| s.pitch.is_none()).count(), 3);
    assert_eq!(scara.len(), 4);
}

/// Of an overconstrained linkage every split of the load adds up; the one told is the least, so that no
/// internal load is in it.
#[test]
fn a_symmetric_load_is_shared_evenly() {
    let (problem, motion) = sample("cartesian.json");
    let joints = motion.joints_at(0);
    let mut goal = motion.poses[0];
    // A turn, which no leg of the 3CRR can follow.
    goal.rotation =
        UnitQuaternion::from_quaternion(Quaternion::new(1.0, 0.1, 0.1, 0.1)) * goal.rotation;
    let insight = problem
        .explain(joints, &numbers(&goal))
        .expect("an insight");
    for hold in &insight.chains {
        assert!(
            (hold.share - 1.0 / 3.0).abs() < 0.05,
            "{:?}",
            insight.chains
        );
    }
}

#[test]
fn a_limit_takes_its_share() {
    let (problem, motion) = sample("scara.json");
    let frame = motion
        .status
        .iter()
        .position(|s| *s == Status::AtLimit)
        .expect("its lesson");
    let insight = problem
        .explain(motion.joints_at(frame), &numbers(&motion.goals[frame]))
        .expect("an insight");
    assert!((insight.chains[0].share - 1.0).abs() < 1e-12);
    assert!(insight.projected_gradient < 1e-9);
    // Without the limit the same position is not stationary.
    assert_eq!(insight.freedoms.len(), 4);
}

#[test]
fn random_linkages_are_explained() {
    let mut random = Random(5);
    for kinds in assemblies(&mut random).iter().step_by(4) {
        let linkage = linkage(kinds, &mut random);
        let goals = goals(&linkage, 5, &mut random);
        let m = &linkage.mechanism;
        let motion = plan(m, &linkage.home, &goals, &Settings::PAPER);
        for frame in [1, 3] {
            if !motion.status[frame].is_certified() {
                continue;
            }
            let joints = motion.joints_at(frame);
            let goal = &goals[frame].pose;
            let mut solver = Settings::PAPER.solver(m, extent(&goals));
            let mut closed = joints.to_vec();
            assert_eq!(solver.close_start(&mut closed, 0.0), Start::Closed);
            let insight = explain(&mut solver, joints, goal);
            let case = format!("{kinds:?}, frame {frame}");
            is_consistent(&case, m, joints, goal, &Metric::PAPER, &insight);
            assert!(
                insight.projected_gradient < 1e-6,
                "{case}: {:e}",
                insight.projected_gradient
            );
        }
    }
}

#[test]
fn nonsense_is_refused_with_its_place() {
    let (problem, motion) = sample("3rps.json");
    let joints = motion.joints_at(0).to_vec();
    let goal = numbers(&motion.goals[0]);
    let place = |result: Result<Posture, synthetica::document::fault::Fault>| match result {
        Ok(_) => panic!("nonsense was taken"),
        Err(fault) => fault.place,
    };
    let with = |list: &[f64], i: usize, x: f64| {
        let mut list = list.to_vec();
        list[i] = x;
        list
    };
    assert_eq!(place(problem.pull(&joints[1..], &goal)), "joints");
    assert_eq!(
        place(problem.pull(&with(&joints, 3, f64::NAN), &goal)),
        "joints[3]"
    );
    assert_eq!(place(problem.pull(&joints, &goal[1..])), "goal");
    assert_eq!(
        place(problem.pull(&joints, &with(&goal, 1, f64::INFINITY))),
        "goal[1]"
    );
    assert_eq!(
        place(problem.pull(&joints, &with(&goal, 5, f64::NAN))),
        "goal"
    );
    assert_eq!(place(problem.pull(&joints, &[0.0; 7])), "goal");
    assert_eq!(place(problem.drive(&joints, 15, 0.0)), "variable");
    assert_eq!(place(problem.drive(&joints, 0, f64::NAN)), "value");
    assert_eq!(place(problem.drive(&joints, 0, 1e9)), "value");
    assert_eq!(place(problem.drive(&[], 0, 0.0)), "joints");
    assert!(problem.explain(&joints[1..], &goal).is_err());
    assert!(problem.explain(&joints, &goal[1..]).is_err());
    let open = with(&joints, 0, joints[0] + 0.3);
    let fault = problem.explain(&open, &goal).expect_err("open loops");
    assert!(
        fault.message.contains("the loops are open by"),
        "{}",
        fault.message
    );
    // Open joint values are closed first, where they can be.
    assert!(problem.pull(&open, &goal).expect("a posture").frame.closure[0] <= CLOSED);
    let wrong = with(&joints, 1, 500.0);
    let lost = problem.drive(&wrong, 0, 0.1).expect("a posture");
    if lost.frame.status[0] == Status::ClosureLost {
        assert!(lost.obstacle.is_some_and(|o| o.contains("do not close")));
    }
}
