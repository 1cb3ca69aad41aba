//! A finite closest pose where the followed branch has none: at positions that closed walks join to the present one, and
//! in other assemblies.

use crate::math::pose::Pose;
use crate::model::mechanism::Mechanism;
use crate::plan::modes;
use crate::math::random::Random;
use crate::plan::settings::Settings;
use crate::solve::close::{Reach, Shortest};
use crate::solve::close_start::Start;
use crate::solve::newton::{Solved, Solver};

/// Walks, and positions on each from which a minimum is looked for.
const WALKS: u64 = 12;
const STOPS: usize = 16;
/// Steps from one to the next, and the length of one, root of the joints' squared motions.
const STRIDE: usize = 3;
const STEP: f64 = 0.3;
/// Corrections after a step stay in its range: the walk does not leap.
const REACH: Reach = Reach { shortest: Shortest::Joints, each: STEP, all: STEP };

/// The closest finite certified pose found from positions that closed walks, within the limits, join to `joints`.
pub fn joined(solver: &mut Solver, joints: &[f64], goal: &Pose) -> Option<(Vec<f64>, Solved)> {
    let mut best: Option<(Vec<f64>, Solved)> = None;
    for walk in 0..WALKS {
        let mut random = Random::new(walk);
        let mut theta = solver.scaled().entered(joints);
        for _ in 0..STOPS {
            for _ in 0..STRIDE {
                step(solver, &mut theta, &mut random);
            }
            let mut at = solver.scaled().left(&theta);
            let predicted = at.clone();
            solver.clear_holding();
            let solved = solver.solve(goal, &mut at, &predicted);
            let better = best.as_ref().is_none_or(|(_, least)| solved.value < least.value);
            if solved.end.is_minimum() && better {
                best = Some((at, solved));
            }
        }
    }
    solver.clear_holding();
    best
}

/// One closed step in a random free direction; none where it does not close or leaves the limits.
fn step(solver: &mut Solver, theta: &mut Vec<f64>, random: &mut Random) {
    let (scaled, closer, holding) = solver.parts();
    let mut holding = holding.clone();
    holding.clear();
    let dependence = closer.dependence_anywhere();
    let tangent = closer.tangent();
    tangent.evaluate(scaled.chains(), theta);
    let free = tangent.factor(holding.stops(), dependence).free();
    let mut direction = vec![0.0; theta.len()];
    for i in 0..free.count() {
        let c = random.between(-1.0, 1.0);
        direction.iter_mut().zip(free.rates(i)).for_each(|(d, r)| *d += c * r);
    }
    let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
    if !(length > 0.0) {
        return;
    }
    let mut next: Vec<f64> = theta.iter().zip(&direction).map(|(t, d)| t + STEP / length * d).collect();
    if closer.close(scaled, holding.stops(), &REACH, &mut next, &mut 0) && holding.contains(&next) {
        *theta = next;
    }
}

/// Whether another assembly has a finite certified pose that is closer than `value`.
pub fn another_assembly(mechanism: &Mechanism, goal: &Pose, settings: &Settings, extent: f64, value: f64) -> bool {
    let free = vec![None; mechanism.chains().len()];
    let found = modes::find(mechanism, &free, goal, extent, settings);
    let mut solver = settings.solver(mechanism, extent);
    let mut joints = found.clone();
    if matches!(
        solver.close_start(&mut joints, settings.dimension_tolerance),
        Start::Open { .. }
    ) {
        return false;
    }
    let predicted = joints.clone();
    let solved = solver.solve(goal, &mut joints, &predicted);
    solved.end.is_minimum() && solved.value < value
}
