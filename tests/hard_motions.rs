//! Starts that are open, goals that jump or lie half a turn away, linkages small and large, sliders
//! that run away: closed and honest whatever comes.

#[allow(dead_code, reason = "each test file wants some of it")]
#[path = "common/by_axes.rs"]
mod by_axes;
#[allow(dead_code, reason = "each test file wants some of it")]
#[path = "common/checks.rs"]
mod checks;
mod common;

use by_axes::{Line, chain, limited};
use checks::{
    GRADIENT, NEWTON, at, between, both_ways, goals, is_certified, is_honest, is_reached, mechanism,
};
use common::{Random, golden};
use std::f64::consts::PI;
use synthetica::math::metric::MetricKind;
use synthetica::math::pose::Pose;
use synthetica::model::chain::Chain;
use synthetica::model::dh::DhRow;
use synthetica::model::joint::{Joint, Limits};
use synthetica::model::mechanism::Mechanism;
use synthetica::motion::goal::Goal;
use synthetica::motion::trajectory::{Status, Warning};
use synthetica::plan::follow::plan;
use synthetica::plan::settings::Settings;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];
const ORIGIN: [f64; 3] = [0.0; 3];

fn four_bar(ground: f64) -> Mechanism {
    let w = at(1.0, 1.2, 0.0, 0.0, 0.0, 0.3);
    let leg = |p: [[f64; 2]; 2], w: &Pose| chain("RR", &p.map(|[x, y]| ([x, y, 0.0], Z)), w);
    let mut second = leg([[3.0, 0.0], [2.6, 1.4]], &w);
    // The second base moved away: the loop opens by so much.
    let base = at(ground - 3.0, 0.0, 0.0, 0.0, 0.0, 0.0) * second.base();
    second = Chain::new(
        "moved".into(),
        base,
        second.joints().to_vec(),
        *second.gripper(),
    )
    .expect("a chain");
    mechanism(vec![leg([[0.0, 0.0], [0.5, 0.9]], &w), second])
}

#[test]
fn start_that_does_not_close() {
    let m = four_bar(3.2);
    let goals = between(
        &m.chains()[0].pose(&[0.0; 4]),
        &at(1.4, 1.1, 0.0, 0.0, 0.0, 0.0),
        6,
    );
    for settings in [NEWTON, GRADIENT] {
        let t = plan(&m, &[0.0; 4], &goals, &settings);
        is_certified("open start", &t, 6);
        assert!(
            t.warnings
                .iter()
                .any(|w| matches!(w, Warning::StartMoved { moved, .. } if *moved > 0.01)),
            "{:?}",
            t.warnings
        );
        // The start that was used closes, and is then used as it is.
        let again = plan(&m, &t.start, &goals, &settings);
        assert!(
            !again
                .warnings
                .iter()
                .any(|w| matches!(w, Warning::StartMoved { .. })),
            "{:?}",
            again.warnings
        );
        assert_eq!(again.mobility_rank, 1);
    }
}

#[test]
fn start_that_cannot_close() {
    let m = four_bar(30.0);
    let size = m.size().expect("a linkage with lengths");
    let goals = between(
        &m.chains()[0].pose(&[0.0; 4]),
        &at(1.4, 1.1, 0.0, 0.0, 0.0, 0.0),
        6,
    );
    for settings in [NEWTON, GRADIENT] {
        let t = plan(&m, &[0.1, 0.2, 0.3, 0.4], &goals, &settings);
        is_honest("no assembly", &t, 6);
        assert!(
            t.status.iter().all(|s| *s == Status::ClosureLost),
            "{:?}",
            t.status
        );
        assert!(
            t.warnings
                .iter()
                .any(|w| matches!(w, Warning::StartOpen { error } if error * size > 20.0)),
            "{:?}",
            t.warnings
        );
        assert_eq!(t.start, [0.1, 0.2, 0.3, 0.4]);
    }
}

/// The same chain drawn in another unit of length.
fn in_unit(c: &Chain, factor: f64) -> Chain {
    let frame = |p: &Pose| {
        let mut p = *p;
        p.translation.vector *= factor;
        p
    };
    let joints = c.joints().iter().map(|j| {
        let rows = j.rows().iter().map(|r| DhRow {
            a: r.a * factor,
            d: r.d * factor,
            ..*r
        });
        Joint::new(j.kind(), rows.collect(), vec![]).expect("a joint")
    });
    Chain::new(
        c.name().into(),
        frame(c.base()),
        joints.collect(),
        frame(c.gripper()),
    )
    .expect("a chain")
}

/// A document in millimetres, or in light years, is the same motion.
#[test]
fn unit_of_length() {
    for task in golden::tasks() {
        let frames = 12;
        let one = plan(&task.mechanism, &task.start, &task.goals[..frames], &NEWTON);
        for factor in [1e-3, 0.1, 7.0, 1e3, 1e4] {
            let m = mechanism(
                task.mechanism
                    .chains()
                    .iter()
                    .map(|c| in_unit(c, factor))
                    .collect(),
            );
            let turns: Vec<bool> = m.chains().iter().flat_map(Chain::turns).collect();
            let scale = |joints: &[f64]| -> Vec<f64> {
                joints
                    .iter()
                    .zip(&turns)
                    .map(|(x, turns)| if *turns { *x } else { x * factor })
                    .collect()
            };
            let goals: Vec<Goal> = task.goals[..frames]
                .iter()
                .map(|g| {
                    let mut pose = g.pose;
                    pose.translation.vector *= factor;
                    Goal { pose, ..*g }
                })
                .collect();
            let settings = Settings {
                metric_length: Some(factor),
                ..NEWTON
            };
            let t = plan(&m, &scale(&task.start), &goals, &settings);
            let name = format!("{} times {factor}", task.name);
            // Closed to the same share of the size in every unit.
            is_certified(&name, &t, frames);
            for i in 0..frames {
                assert_eq!(t.status[i], one.status[i], "{name}, frame {i}");
                assert!(
                    (t.metric[i] - one.metric[i]).abs() < 1e-10,
                    "{name}, frame {i}"
                );
                for ((x, y), turns) in t.joints_at(i).iter().zip(one.joints_at(i)).zip(&turns) {
                    let y = if *turns { *y } else { y * factor };
                    let unit = if *turns { 1.0 } else { factor };
                    // A projected gradient of 1e-9 leaves about 1e-8 of a joint.
                    assert!((x - y).abs() < 1e-7 * unit, "{name}, frame {i}: {x} {y}");
                }
            }
        }
    }
}

/// A metric whose length is large or small against the linkage.
#[test]
fn metric_length() {
    for task in golden::tasks() {
        for metric_length in [1e-2, 0.1, 10.0, 1000.0] {
            let settings = Settings {
                metric_length: Some(metric_length),
                ..NEWTON
            };
            let t = plan(&task.mechanism, &task.start, &task.goals, &settings);
            let name = format!("{} with length {metric_length}", task.name);
            is_certified(&name, &t, task.goals.len());
        }
    }
}

/// The metric of a large length weighs rotations only, and the translations are then still the best
/// that go with them.
#[test]
fn large_metric_length_still_places_the_workpiece() {
    let c = chain(
        "PRP",
        &[(ORIGIN, X), (ORIGIN, Z), (ORIGIN, Z)],
        &at(0.5, 0.0, 0.0, 0.0, 0.0, 0.0),
    );
    let m = mechanism(vec![c]);
    let goal = at(1.3, 0.2, 0.7, 0.0, 0.0, 0.4);
    for metric_length in [1.0, 30.0, 1000.0] {
        let t = plan(
            &m,
            &[0.0; 3],
            &goals(&[goal]),
            &Settings {
                metric_length: Some(metric_length),
                ..NEWTON
            },
        );
        is_certified("PRP", &t, 1);
        // y cannot be met; x and z can, and the rotation to within what y pulls.
        assert!(
            (t.poses[0].translation.z - 0.7).abs() < 1e-3,
            "{metric_length}: {:?}",
            t.poses[0]
        );
    }
}

#[test]
fn goals_that_jump() {
    let mut random = Random(7);
    for task in golden::tasks() {
        // The frames of the golden motion in random order, with others from anywhere between.
        let mut list = Vec::new();
        for _ in 0..20 {
            list.push(task.goals[random.below(task.goals.len())].pose);
            list.push(random.pose(2.0, PI));
        }
        let t = plan(&task.mechanism, &task.start, &goals(&list), &NEWTON);
        is_certified(&format!("{} jumping", task.name), &t, 40);
    }
}

/// Half a turn away q and −q are as near: a ridge of the metric, never a minimum.
#[test]
fn goals_half_a_turn_away() {
    for task in golden::tasks() {
        let home = task.mechanism.chains()[0].pose(&task.start);
        for turn in [
            at(0.0, 0.0, 0.0, PI, 0.0, 0.0),
            at(0.0, 0.0, 0.0, 0.0, PI, 0.0),
            at(0.0, 0.0, 0.0, 0.0, 0.0, PI),
        ] {
            for list in [vec![home * turn], vec![home * turn; 3]] {
                let t = plan(&task.mechanism, &task.start, &goals(&list), &NEWTON);
                is_certified(&format!("{} half a turn away", task.name), &t, list.len());
            }
        }
    }
    // Nor is it one where the translations pull at the rotation from far away.
    let m = mechanism(vec![chain(
        "RP",
        &[(ORIGIN, Z), (ORIGIN, X)],
        &Pose::identity(),
    )]);
    for (x, y) in [(5.0, 2.0), (50.0, 20.0), (-5.0, 3.0), (0.0, 8.0)] {
        for roll in [2.0, 3.0, PI, -3.0] {
            let t = plan(
                &m,
                &[0.0, 0.3],
                &goals(&[at(x, y, 0.0, 0.0, 0.0, roll)]),
                &NEWTON,
            );
            is_certified(&format!("RP to {x}, {y}, {roll}"), &t, 1);
        }
    }
    // A free hand goes all the way round.
    let lines: [Line; 3] = [(ORIGIN, Z), (X, Z), ([1.5, 0.6, 0.0], Z)];
    let m = mechanism(vec![chain(
        "RRR",
        &lines,
        &at(1.5, 0.6, 0.0, 0.0, 0.0, 0.0),
    )]);
    let t = plan(
        &m,
        &[0.0; 3],
        &goals(&[at(1.5, 0.6, 0.0, 0.0, 0.0, PI)]),
        &NEWTON,
    );
    is_reached("hand", &t);
}

#[test]
fn one_and_two_goals() {
    for task in golden::tasks() {
        for frames in [0, 1, 2, 3, 4, 5] {
            let t = plan(&task.mechanism, &task.start, &task.goals[..frames], &NEWTON);
            is_certified(&task.name, &t, frames);
        }
    }
}

/// The same goal for a long time: nothing drifts.
#[test]
fn standing_still() {
    for task in golden::tasks() {
        let goal = task.goals[10].pose;
        let t = plan(&task.mechanism, &task.start, &goals(&[goal; 200]), &NEWTON);
        is_certified(&task.name, &t, 200);
        let (first, last) = (t.joints_at(1), t.joints_at(199));
        assert!(
            first.iter().zip(last).all(|(a, b)| (a - b).abs() < 1e-8),
            "{}",
            task.name
        );
    }
}

/// A goal that is hundreds of sizes away has a closest pose as any other has, and the frame after it comes back. The size
/// is 1, the hand's length; what the goal turns otherwise than the slider points costs some sizes at most.
#[test]
fn a_goal_that_is_far_away() {
    let c = chain(
        "RP",
        &[(ORIGIN, Z), (ORIGIN, X)],
        &at(1.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    );
    let m = mechanism(vec![c]);
    for far in [
        at(500.0, 20.0, 0.0, 0.0, 0.0, 3.0),
        at(-1e4, 1e4, 3.0, 0.3, 0.0, 1.0),
    ] {
        let near = at(1.5, 0.1, 0.0, 0.0, 0.0, 0.2);
        let settings = Settings {
            metric: MetricKind::Pose,
            ..NEWTON
        };
        let t = plan(&m, &[0.0, 0.3], &goals(&[far, near]), &settings);
        is_certified("RP far away", &t, 2);
        assert!(t.translation_gap[0] < 5.0, "{:?}", t.translation_gap);
    }
}

/// With limits the same goal has an answer.
#[test]
fn slider_within_limits() {
    let free = Limits::NONE;
    let lines = [(ORIGIN, Z), (ORIGIN, X)];
    let hand = at(0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    let m = mechanism(vec![limited(
        "RP",
        &lines,
        &hand,
        &[
            free,
            Limits {
                min: -2.0,
                max: 3.0,
            },
        ],
    )]);
    let t = plan(
        &m,
        &[0.0, 0.3],
        &goals(&[at(500.0, 20.0, 0.0, 0.0, 0.0, 1.0)]),
        &NEWTON,
    );
    is_certified("RP within limits", &t, 1);
    assert_eq!(t.status, [Status::AtLimit]);
}

/// A workpiece on a single joint of each kind.
#[test]
fn single_joints() {
    let hand = at(0.3, 0.2, 0.1, 0.1, 0.2, 0.3);
    let far = at(0.5, -0.2, 0.4, 0.4, -0.3, 0.8);
    let all: [(&str, &[Line]); 6] = [
        ("R", &[(ORIGIN, Z)]),
        ("P", &[(ORIGIN, Z)]),
        ("C", &[(ORIGIN, Z)]),
        ("T", &[(ORIGIN, Z), (ORIGIN, X)]),
        ("S", &[(ORIGIN, X), (ORIGIN, Y), (ORIGIN, Z)]),
        ("E", &[(ORIGIN, X), (ORIGIN, Y), (ORIGIN, Z)]),
    ];
    for (letter, lines) in all {
        let m = mechanism(vec![chain(letter, lines, &hand)]);
        let start = vec![0.0; m.variables()];
        let t = both_ways(letter, &m, &start, &between(&hand, &far, 6));
        assert_eq!(t.mobility_rank, start.len());
    }
}
