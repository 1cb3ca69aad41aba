//! Motions that run away on the branch that is followed: a finite pose is looked for before there is said to be none.

#[path = "common/fixtures.rs"]
mod fixtures;

use fixtures::{document, lines, problem, sample};
use synthetica::document::problem::Problem;
use synthetica::document::text::parse;
use synthetica::math::random::Random;
use synthetica::motion::trajectory::{Status, Warning};
use synthetica::solve::close::{Reach, Shortest, add_rates};
use synthetica::solve::solver::Solver;

/// Starts of the independent search.
const STARTS: u64 = 200;

/// Whether a walk of closed steps in random directions, of its own and not the planner's, comes to a position from which
/// the frame ends at a finite certified pose.
fn joined(problem: &Problem, joints: &[f64], frame: usize) -> bool {
    let mut solver = problem
        .settings
        .solver(&problem.mechanism, problem.extent());
    let mut from = joints.to_vec();
    let _ = solver.close_start(&mut from, problem.settings.dimension_tolerance);
    (0..STARTS).any(|start| {
        let mut random = Random::new(1000 + start);
        let mut theta = solver.scaled().entered(&from);
        for _ in 0..30 {
            step(&mut solver, &mut theta, &mut random);
        }
        let mut at = solver.scaled().left(&theta);
        let predicted = at.clone();
        solver.clear_holding();
        solver
            .solve(&problem.goals[frame].pose, &mut at, &predicted)
            .end
            .is_minimum()
    })
}

fn step(solver: &mut Solver, theta: &mut Vec<f64>, random: &mut Random) {
    const LENGTH: f64 = 0.15;
    let (scaled, closer, holding) = solver.parts();
    let dependence = closer.dependence_anywhere();
    let stops = vec![synthetica::model::joint::Stop::None; theta.len()];
    closer.tangent().evaluate(scaled.chains(), theta);
    let free = closer.tangent().factor(&stops, dependence).free();
    let coefficients: Vec<f64> = (0..free.count())
        .map(|_| random.between(-1.0, 1.0))
        .collect();
    let mut rates = vec![0.0; theta.len()];
    add_rates(&free, &coefficients, 1.0, &mut rates);
    let length = rates.iter().map(|r| r * r).sum::<f64>().sqrt();
    let mut next: Vec<f64> = theta
        .iter()
        .zip(&rates)
        .map(|(t, r)| t + LENGTH / length * r)
        .collect();
    let reach = Reach {
        shortest: Shortest::Joints,
        each: 0.5 * LENGTH,
        all: 0.5 * LENGTH,
    };
    if closer.close(scaled, &stops, &reach, &mut next, &mut 0) && holding.contains(&next) {
        *theta = next;
    }
}

fn check(step: usize) {
    let mut failures = Vec::new();
    let (mut planned, mut mended) = (0, 0);
    for line in sample(lines("runaway"), step) {
        let case = line["case"].as_str().expect("a name").to_owned();
        let problem = problem(&document(&line));
        let t = problem.plan();
        planned += 1;
        let first = t.warnings.iter().find_map(|w| {
            if let Warning::Runaway { first, .. } = w {
                Some(*first)
            } else {
                None
            }
        });
        match first {
            None => mended += 1,
            Some(frame) => {
                assert_eq!(t.status[frame], Status::Stalled, "{case}");
                let before = if frame > 0 {
                    t.joints_at(frame - 1)
                } else {
                    &t.start
                };
                if joined(&problem, before, frame) {
                    failures.push(format!("{case}, frame {frame}"));
                }
            }
        }
    }
    println!("{mended} of {planned} motions keep to finite poses");
    assert!(planned > 0, "no motion");
    assert!(
        failures.is_empty(),
        "a finite pose is joined:\n{}",
        failures.join("\n")
    );
}

#[test]
fn no_runaway_where_a_finite_pose_is_joined() {
    check(8);
}

#[test]
#[ignore = "a minute in release: cargo test --release --test runaway -- --ignored --nocapture"]
fn no_runaway_where_a_finite_pose_is_joined_in_any() {
    check(1);
}

/// A goal that is far away by the mechanism's own size is a far goal and no runaway; and a length that is rounding beside
/// the motion, such as a conversion of units leaves, is not the size.
#[test]
fn a_far_goal_is_no_runaway() {
    for a in [1e-3, 1e-6, 1e-8, 1e-11, 1e-15] {
        let text = format!(
            r#"{{"version": 1, "chains": [{{"joints": [
                {{"type": "P", "rows": [{{"a": {a}}}]}}, {{"type": "P", "rows": [{{"alpha": 90, "theta": 90}}]}},
                {{"type": "P", "rows": [{{"alpha": 90}}]}}], "start": [0, 0, 0]}}],
              "motion": {{"frames": 5, "key_frames": [{{}}, {{"x": 1.1, "y": 0.4, "z": -0.3}}]}}}}"#
        );
        let problem = Problem::new(&parse(&text).expect("a document")).expect("a problem");
        let t = problem.plan();
        assert!(
            t.status.iter().all(|s| s.is_certified()),
            "{a:e}: {:?}",
            t.warnings
        );
        assert!(
            t.translation_gap.iter().all(|gap| *gap <= 1e-9),
            "{a:e}: {:?}",
            t.translation_gap
        );
    }
}
