//! A certified frame is a minimum by factors of its own, also where it was certified with those of an iterate before.

mod common;
#[path = "common/fixtures.rs"]
mod fixtures;

use common::{Random, assemblies, goals, linkage};
use std::ops::Range;
use synthetica::document::text;
use synthetica::math::linalg::{cholesky, dot, solve_lower};
use synthetica::model::mechanism::Mechanism;
use synthetica::motion::goal::Goal;
use synthetica::plan::predict::predict;
use synthetica::plan::settings::{Settings, extent};
use synthetica::solve::objective::objective;
use synthetica::solve::solver::Solver;

const FRAMES: usize = 17;
/// What rounding leaves of a gradient, as a share of what counts as stationary.
const ROUNDING: f64 = 1e-5;

/// Follows the goals as a plan does, and factors anew at each frame that was certified on the direct
/// way: how many there are.
fn follow(
    case: &str,
    mechanism: &Mechanism,
    start: &[f64],
    goals: &[Goal],
    settings: &Settings,
) -> usize {
    let mut solver = settings.solver(mechanism, extent(goals));
    let (mut joints, mut predicted) = (start.to_vec(), start.to_vec());
    let (mut history, mut certified) = (Vec::new(), 0);
    if !solver
        .close_start(&mut joints, settings.dimension_tolerance)
        .is_closed()
    {
        return 0;
    }
    for (frame, goal) in goals.iter().enumerate() {
        let before = joints.clone();
        predict(solver.scaled(), &history, &joints, &mut predicted);
        let mut direct = true;
        let solved = solver.solve_watched(&goal.pose, &mut joints, &predicted, &mut |iterate| {
            direct &= !iterate.guarded;
        });
        history.extend_from_slice(&joints);
        if direct && solved.end.is_minimum() {
            let (gradient, curvature) = anew(&mut solver, goal, &before, &joints);
            let (stationary, flat) = (solver.tolerances().stationary, solver.tolerances().flat);
            let case = format!("{case}, frame {frame}");
            let bound = solved.projected_gradient;
            assert!(bound <= stationary, "{case}: {bound:e}");
            assert!(
                gradient <= bound + ROUNDING * stationary,
                "{case}: gradient {gradient:e}, bound {bound:e}"
            );
            assert!(curvature > flat, "{case}: curvature {curvature:e}");
            certified += 1;
        }
    }
    certified
}

/// The projected gradient at a position and the least curvature there, by factors made there. Both per unit of twist and
/// joint motions together: which joints count beside the twist in the solver's own unit may change between two positions.
fn anew(solver: &mut Solver, goal: &Goal, before: &[f64], joints: &[f64]) -> (f64, f64) {
    let (scaled, metric) = (solver.scaled().clone(), *solver.metric());
    let before = scaled.chains()[0].pose(&scaled.entered(before)).rotation;
    let target = metric.target(&scaled.enter_pose(&goal.pose), &before);
    let stops = solver.holding().stops().to_vec();
    let dependence = solver.closer().dependence();
    let tangent = solver.closer().tangent();
    tangent.evaluate(scaled.chains(), &scaled.entered(joints));
    let free = tangent.factor(&stops, dependence).free();
    let model = objective(free.pose(), &target);
    let (n, mut slope, mut curvature) = (free.count(), vec![], vec![]);
    free.project(&model.gradient, &mut slope);
    let mut gram: Vec<f64> = (0..n * n)
        .map(|k| (k / n, k % n))
        .map(|(i, j)| {
            let along = dot(free.direction(i), free.direction(j));
            along + dot(free.rates(i), free.rates(j))
        })
        .collect();
    let mut held = free.balance(&model.gradient);
    held.reduced_hessian(&model.hessian, &mut curvature);
    assert!(cholesky(&mut gram, n, n, 0.0));
    solve_lower(&gram, n, n, &mut slope);
    let least = if cholesky(&mut curvature, n, n, 0.0) {
        curvature
            .iter()
            .step_by(n + 1)
            .fold(f64::INFINITY, |least, l| least.min(l * l))
    } else {
        f64::NEG_INFINITY
    };
    (dot(&slope, &slope).sqrt(), least)
}

/// Each chain type once a seed, with random partners: towards goals off the workspace, in both metrics.
fn random(seeds: Range<u64>) -> usize {
    let mut frames = 0;
    for seed in seeds {
        let mut random = Random(seed);
        for kinds in assemblies(&mut random) {
            let linkage = linkage(&kinds, &mut random);
            let goals = goals(&linkage, FRAMES, &mut random);
            for settings in [Settings::PAPER, Settings::default()] {
                let case = format!("seed {seed}, {kinds:?}, {:?}", settings.metric);
                frames += follow(&case, &linkage.mechanism, &linkage.home, &goals, &settings);
            }
        }
    }
    println!("{frames} frames");
    frames
}

#[test]
fn random_linkages() {
    // 5,690 today: most must be looked at.
    assert!(random(0..1) > 4000);
}

#[test]
#[ignore = "minutes in release: cargo test --release --test certificates -- --ignored --nocapture"]
fn many_random_linkages() {
    random(100..200);
}

#[test]
fn golden_motions_and_samples() {
    let mut frames = 0;
    for task in common::golden::tasks() {
        frames += follow(
            &task.name,
            &task.mechanism,
            &task.start,
            &task.goals,
            &Settings::PAPER,
        );
    }
    for text in fixtures::SAMPLES {
        let problem = fixtures::problem(&text::parse(text).expect("a sample"));
        frames += follow(
            "sample",
            &problem.mechanism,
            &problem.find_start(),
            &problem.goals,
            &problem.settings,
        );
    }
    assert!(frames > 100);
}
