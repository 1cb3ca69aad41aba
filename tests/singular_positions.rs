//! Positions in which a chain loses a direction or a loop gains a freedom: at the start, at the
//! optimum, and on the way.

#[allow(dead_code, reason = "each test file wants some of it")]
#[path = "common/by_axes.rs"]
mod by_axes;
#[allow(dead_code, reason = "each test file wants some of it")]
#[path = "common/checks.rs"]
mod checks;
#[path = "common/dense.rs"]
mod dense;

use by_axes::{Line, chain};
use checks::{
    GRADIENT, NEWTON, at, between, both_ways, goals, is_certified, is_honest, is_reached, mechanism,
};
use std::f64::consts::FRAC_PI_2;
use synthetica::math::metric::Metric;
use synthetica::math::pose::Pose;
use synthetica::model::joint::{Joint, JointKind};
use synthetica::model::mechanism::Mechanism;
use synthetica::motion::goal::Goal;
use synthetica::motion::trajectory::Status;
use synthetica::plan::follow::plan;
use synthetica::plan::settings::Settings;
use synthetica::solve::close_start::Start;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];
const ORIGIN: [f64; 3] = [0.0; 3];

/// A planar arm with links 1 and 0.7 and a ball at its wrist, which holds the workpiece: reach 1.7.
fn arm(elbow: f64) -> Mechanism {
    let (s, c) = libm::sincos(elbow);
    let wrist = [1.0 + 0.7 * c, 0.7 * s, 0.0];
    // The ball's axes stand so that it is not in gimbal lock.
    let lines: [Line; 5] = [(ORIGIN, Z), (X, Z), (wrist, X), (wrist, Y), (wrist, Z)];
    mechanism(vec![chain(
        "RRS",
        &lines,
        &at(wrist[0], wrist[1], 0.0, 0.0, 0.0, 0.0),
    )])
}

fn points(list: &[[f64; 3]]) -> Vec<Goal> {
    goals(
        &list
            .iter()
            .map(|p| at(p[0], p[1], p[2], 0.1, -0.2, 0.3))
            .collect::<Vec<_>>(),
    )
}

/// Out of reach the closest position is the stretched arm: singular, and the optimum all the same.
#[test]
fn arm_out_of_reach() {
    let m = arm(0.8);
    let list: Vec<_> = (0..12)
        .map(|i| [1.2 + 0.1 * f64::from(i), 0.3, 0.05 * f64::from(i)])
        .collect();
    let t = plan(&m, &[0.0; 5], &points(&list), &NEWTON);
    is_certified("arm", &t, 12);
    for (i, [x, y, z]) in list.iter().enumerate() {
        let reach = (x * x + y * y).sqrt();
        let out = (reach - 1.7).max(0.0);
        // The metric trades a little of the position for the rotation.
        assert!(
            t.translation_gap[i] <= 1.1 * (out * out + z * z).sqrt() + 1e-9,
            "frame {i}"
        );
        if reach > 1.72 {
            // Stretched: the elbow's variable is its angle less the 0.8 of the drawing.
            assert!(
                (t.joints_at(i)[1] + 0.8).abs() < 1e-6,
                "frame {i}: elbow {}",
                t.joints_at(i)[1]
            );
            assert_eq!(t.status[i], Status::Closest);
        }
    }
}

/// The same when it starts stretched, and comes back within reach: it must bend again.
#[test]
fn arm_starts_stretched() {
    let m = arm(0.0);
    let list = [
        [2.0, 0.0, 0.0],
        [1.8, 0.0, 0.0],
        [1.6, 0.0, 0.0],
        [1.2, 0.2, 0.0],
        [0.6, 0.3, 0.0],
    ];
    let t = plan(&m, &[0.0; 5], &points(&list), &NEWTON);
    is_certified("stretched arm", &t, 5);
    assert!(
        t.status[2..].iter().all(|s| *s == Status::Reached),
        "{:?} {:?}",
        t.status,
        t.metric
    );
}

/// Goals exactly on the boundary of the workspace, where f rises with the fourth power of the
/// elbow's angle.
#[test]
fn goals_on_the_boundary() {
    let m = arm(0.8);
    let list: Vec<_> = (0..8)
        .map(|i| {
            let (s, c) = libm::sincos(0.1 * f64::from(i) + 0.3);
            [1.7 * c, 1.7 * s, 0.0]
        })
        .collect();
    let t = plan(&m, &[0.0; 5], &points(&list), &NEWTON);
    is_certified("arm on the boundary", &t, 8);
    assert!(t.metric.iter().all(|f| *f < 1e-12), "{:?}", t.metric);
}

/// The wrist's path touches the boundary between two frames, on it, and close to it.
#[test]
fn path_through_the_stretched_arm() {
    let m = arm(0.8);
    for frames in [9, 10, 33] {
        let list: Vec<_> = (0..frames)
            .map(|i| {
                let x = -1.0 + 2.0 * f64::from(i) / f64::from(frames - 1);
                [1.7 - 0.5 * x * x, 0.4 * x, 0.0]
            })
            .collect();
        let t = plan(&m, &[0.0; 5], &points(&list), &NEWTON);
        is_certified(&format!("path of {frames}"), &t, list.len());
    }
}

/// A planar arm whose goals also turn the hand: f has no kink where it is stretched.
#[test]
fn planar_arm_out_of_reach() {
    let lines: [Line; 3] = [(ORIGIN, Z), (X, Z), ([1.5, 0.6, 0.0], Z)];
    let m = mechanism(vec![chain(
        "RRR",
        &lines,
        &at(1.9, 0.8, 0.0, 0.0, 0.0, 0.0),
    )]);
    let home = m.chains()[0].pose(&[0.0; 3]);
    for angle in [0.0, 0.7, 2.0, -1.5] {
        let t = both_ways(
            "planar arm",
            &m,
            &[0.0; 3],
            &between(&home, &at(4.0, 1.0, 0.2, 0.1, 0.0, angle), 8),
        );
        assert_eq!(t.status[7], Status::Closest);
    }
}

/// An S as the table's default rows give it: all variables 0 is gimbal lock.
#[test]
fn ball_starts_in_gimbal_lock() {
    let (joint, hand) = (
        Joint::standard(JointKind::S),
        at(0.2, 0.3, 0.4, 0.0, 0.0, 0.0),
    );
    let s = synthetica::model::chain::Chain::new("S".into(), Pose::identity(), vec![joint], hand)
        .expect("a chain");
    let m = mechanism(vec![s]);
    let turned = |longitude: f64, latitude: f64, roll: f64| {
        at(0.0, 0.0, 0.0, longitude, latitude, roll) * hand
    };
    // Axes 1 and 3 lie on z, axis 2 on x: y is the direction lost.
    for step in [
        turned(0.5, 0.0, 0.0),
        turned(0.0, 0.4, 0.0),
        turned(0.3, 0.2, 0.5),
        turned(2.5, 0.0, 0.0),
    ] {
        let t = plan(&m, &[0.0; 3], &goals(&[step]), &NEWTON);
        is_reached("gimbal lock", &t);
        let small: Vec<Pose> = between(&Pose::identity(), &(step * hand.inverse()), 20)
            .iter()
            .map(|g| g.pose * hand)
            .collect();
        let t = plan(&m, &[0.0; 3], &goals(&small), &NEWTON);
        is_reached("gimbal lock, small steps", &t);
    }
    // Through it: a turn about y carries the middle angle from one side to the other.
    let path: Vec<Pose> = (0..21)
        .map(|i| turned(0.1 * f64::from(i) - 1.0, 0.02, 0.0))
        .collect();
    let t = plan(&m, &[FRAC_PI_2, 1.0, -FRAC_PI_2], &goals(&path), &NEWTON);
    is_reached("through gimbal lock", &t);
}

/// A T and an R as a wrist, R along the T's first axis at the start.
#[test]
fn universal_joint_starts_in_gimbal_lock() {
    let lines: [Line; 3] = [(ORIGIN, Z), (ORIGIN, X), (ORIGIN, Z)];
    let hand = at(0.2, 0.3, 0.4, 0.0, 0.0, 0.0);
    let m = mechanism(vec![chain("TR", &lines, &hand)]);
    for step in [
        at(0.0, 0.0, 0.0, 0.5, 0.0, 0.0),
        at(0.0, 0.0, 0.0, 0.3, 0.2, 0.5),
    ] {
        is_reached(
            "T and R",
            &plan(&m, &[0.0; 3], &goals(&[step * hand]), &NEWTON),
        );
    }
    // Off the workspace too.
    let off = between(&hand, &(at(0.3, 0.1, -0.2, 0.6, 0.2, -0.3) * hand), 10);
    both_ways("T and R off", &m, &[0.0; 3], &off);
}

/// The same within a loop: 3RPS-like legs whose balls start in gimbal lock.
#[test]
fn legs_with_locked_balls() {
    let w = at(0.0, 0.0, 1.0, 0.0, 0.0, 0.0);
    let leg = |angle: f64| {
        let (s, c) = libm::sincos(angle);
        let (foot, ball) = ([c, s, 0.0], [0.6 * c, 0.6 * s, 1.0]);
        let (tangent, up) = ([-s, c, 0.0], [-0.4 * c, -0.4 * s, 1.0]);
        // First and third axis of the ball on one line.
        let lines = [(foot, tangent), (foot, up), (ball, X), (ball, Y), (ball, X)];
        chain("RPS", &lines, &w)
    };
    let m = mechanism(vec![leg(0.3), leg(2.3), leg(4.4)]);
    let t = both_ways(
        "locked balls",
        &m,
        &[0.0; 15],
        &between(&w, &at(0.2, -0.1, 1.3, 0.3, 0.3, 0.2), 6),
    );
    assert_eq!((t.mobility_count, t.status[5]), (3, Status::Closest));
}

/// A flat parallelogram may go two ways, as a parallelogram and as an antiparallelogram. From that
/// very position, and through it.
fn parallelogram(angle: f64) -> Mechanism {
    let (s, c) = libm::sincos(angle);
    let w = at(1.0 + c, s, 0.0, 0.0, 0.0, 0.0);
    let crank = |x: f64| chain("RR", &[([x, 0.0, 0.0], Z), ([x + c, s, 0.0], Z)], &w);
    mechanism(vec![crank(0.0), crank(2.0)])
}

#[test]
fn flat_parallelogram() {
    let m = parallelogram(0.0);
    let home = m.chains()[0].pose(&[0.0; 4]);
    for (x, y, roll) in [
        (1.6, 0.8, 0.0),
        (1.6, -0.8, 0.0),
        (1.5, 0.4, 0.7),
        (2.5, 0.0, 0.0),
        (1.9, 0.1, 0.1),
    ] {
        for frames in [1, 2, 7] {
            let goals = between(&home, &at(x, y, 0.0, 0.0, 0.0, roll), frames);
            let t = plan(&m, &[0.0; 4], &goals, &NEWTON);
            is_honest("flat parallelogram", &t, frames);
            // Whatever it calls an answer is one: no closed position nearby is closer to the goal.
            for i in (0..frames).filter(|&i| t.status[i].is_certified()) {
                is_local_minimum(&m, t.joints_at(i), &goals[i], t.metric[i]);
            }
            assert!(t.status.iter().any(|s| s.is_certified()), "{:?}", t.status);
        }
    }
}

/// A seeded swarm of closed neighbours, none of which is nearer to the goal.
fn is_local_minimum(m: &Mechanism, joints: &[f64], goal: &Goal, f: f64) {
    for step in [0.02, 0.1] {
        for code in 0..3_usize.pow(4) {
            let mut near = joints.to_vec();
            near.iter_mut().enumerate().for_each(|(i, x)| {
                *x += step
                    * ((code / 3_usize.pow(u32::try_from(i).expect("four joints"))) % 3) as f64
                    - step;
            });
            let mut solver = Settings::PAPER.solver(m, 1.0);
            if solver.close_start(&mut near, 0.0) != Start::Closed {
                continue;
            }
            // Only neighbours count: the corrections may lead elsewhere.
            let far = near
                .iter()
                .zip(joints)
                .map(|(a, b)| (a - b).abs())
                .fold(0.0, f64::max);
            if far < 2.0 * step {
                let other = Metric::PAPER.value(&m.chains()[0].pose(&near), &goal.pose);
                assert!(
                    other >= f - 1e-10,
                    "{joints:?}: f {f}, but {other} at {near:?}"
                );
            }
        }
    }
}

#[test]
fn parallelogram_through_its_flat_position() {
    let m = parallelogram(1.0);
    for frames in [8, 9, 16, 33] {
        // The crank turns from 1 rad through 0 to −1 rad; the middle frame of an odd number is flat.
        let path: Vec<Goal> = (0..frames)
            .map(|i| {
                let (s, c) = libm::sincos(1.0 - 2.0 * f64::from(i) / f64::from(frames - 1));
                Goal {
                    time: f64::from(i),
                    pose: at(1.0 + c, s, 0.0, 0.0, 0.0, 0.0),
                }
            })
            .collect();
        let t = plan(&m, &[0.0; 4], &path, &NEWTON);
        is_honest("through flat", &t, path.len());
        let reached = t.status.iter().filter(|s| **s == Status::Reached).count();
        assert!(
            reached + 1 >= path.len(),
            "{frames} frames: {:?} {:?}",
            t.status,
            t.metric
        );
    }
}

/// The singular values along a motion are those of the positions, not of where it began: a flat
/// start has one more dependent equation than the rest.
#[test]
fn singular_values_after_a_singular_start() {
    let m = parallelogram(0.0);
    let home = m.chains()[0].pose(&[0.0; 4]);
    for settings in [NEWTON, GRADIENT] {
        let t = plan(
            &m,
            &[0.0; 4],
            &between(&home, &at(1.6, 0.8, 0.0, 0.0, 0.0, 0.2), 4),
            &settings,
        );
        is_honest("flat parallelogram", &t, 4);
        for i in 0..4 {
            let sigma = dense::singular_values(&m, t.joints_at(i));
            // 14 equations, 4 + 8 unknowns, one freedom: three equations depend on the others.
            let least = sigma[10];
            assert!(
                (t.sigma_min[i] - least).abs() < 1e-7,
                "frame {i}: {} for {least}",
                t.sigma_min[i]
            );
        }
    }
}
