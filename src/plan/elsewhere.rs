//! A finite closest pose where the followed branch has none: from positions that closed walks join to the present one,
//! and in other assemblies. A closed walk is a path of short steps over positions whose loops are closed.

use crate::math::linalg::dot;
use crate::math::pose::Pose;
use crate::math::random::Random;
use crate::model::mechanism::Mechanism;
use crate::motion::trajectory::Warning;
use crate::plan::modes;
use crate::plan::settings::Settings;
use crate::solve::close::{Reach, Shortest, add_rates, solve_gram};
use crate::solve::solver::{Solved, Solver};

/// Frames in which a slider runs away; see [`Warning::Runaway`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Runaway {
    first: usize,
    last: usize,
    searched: usize,
    elsewhere: bool,
}

impl Runaway {
    /// Adds a frame to the frames before it, or as the first of others.
    pub fn add(runaways: &mut Vec<Self>, frame: usize, searched: bool, elsewhere: bool) {
        match runaways.last_mut() {
            Some(before) if before.last + 1 == frame => {
                before.last = frame;
                before.searched += usize::from(searched);
                before.elsewhere |= elsewhere;
            }
            _ => runaways.push(Self {
                first: frame,
                last: frame,
                searched: usize::from(searched),
                elsewhere,
            }),
        }
    }

    /// Forgets the frames after `frame`.
    pub fn keep_to(runaways: &mut Vec<Self>, frame: usize) {
        runaways.retain_mut(|runaway| {
            runaway.last = runaway.last.min(frame);
            let count = (runaway.last + 1).saturating_sub(runaway.first);
            runaway.searched = runaway.searched.min(count);
            runaway.first <= frame
        });
    }

    /// As a warning.
    pub fn warning(&self) -> Warning {
        let Self {
            first,
            last,
            searched,
            elsewhere,
        } = *self;
        Warning::Runaway {
            first,
            last,
            searched,
            elsewhere,
        }
    }
}

/// Walks, and positions on each from which a minimum is looked for: about 200 starts.
const WALKS: u64 = 8;
const POSITIONS: usize = 24;
/// Steps from one to the next, straight on where that is possible: 4 rad, or sizes, so that a walk crosses the workspace.
const STRIDE: usize = 20;
/// Length of a step, root of the joints' squared motions, and of its corrections: half of it, so that the walk does not
/// leap.
const STEP: f64 = 0.2;
const REACH: Reach = Reach {
    shortest: Shortest::Joints,
    each: 0.5 * STEP,
    all: 0.5 * STEP,
};

/// The closest finite certified pose found from positions that closed walks, within the limits, join to `joints`.
pub fn joined(solver: &mut Solver, joints: &[f64], goal: &Pose) -> Option<(Vec<f64>, Solved)> {
    let mut best: Option<(Vec<f64>, Solved)> = None;
    for walk in 0..WALKS {
        let mut random = Random::new(walk);
        let mut theta = solver.scaled().entered(joints);
        for _ in 0..POSITIONS {
            let mut heading = random_heading(&mut random, theta.len());
            for _ in 0..STRIDE {
                if !step(solver, &mut theta, &mut heading) {
                    heading = random_heading(&mut random, theta.len());
                }
            }
            let mut at = solver.scaled().left(&theta);
            let predicted = at.clone();
            solver.clear_holding();
            let solved = solver.solve(goal, &mut at, &predicted);
            let better = best
                .as_ref()
                .is_none_or(|(_, least)| solved.value < least.value);
            if solved.end.is_minimum() && better {
                best = Some((at, solved));
            }
        }
    }
    solver.clear_holding();
    best
}

/// One closed step along the free direction nearest to `heading`, and `heading` becomes that direction; false where the
/// loops do not close there or a joint would be beyond a limit.
fn step(solver: &mut Solver, theta: &mut Vec<f64>, heading: &mut Vec<f64>) -> bool {
    let (scaled, closer, holding) = solver.parts();
    let mut holding = holding.clone();
    holding.clear();
    let dependence = closer.dependence_anywhere();
    let tangent = closer.tangent();
    tangent.evaluate(scaled.chains(), theta);
    let free = tangent.factor(holding.stops(), dependence).free();
    let mut coefficients: Vec<f64> = (0..free.count())
        .map(|i| dot(free.rates(i), heading))
        .collect();
    if !solve_gram(&free, &mut Vec::new(), &mut coefficients) {
        return false;
    }
    heading.fill(0.0);
    add_rates(&free, &coefficients, 1.0, heading);
    let length = dot(heading, heading).sqrt();
    if !(length > 0.0) {
        return false;
    }
    let mut next: Vec<f64> = theta
        .iter()
        .zip(&*heading)
        .map(|(t, d)| t + STEP / length * d)
        .collect();
    let closed =
        closer.close(scaled, holding.stops(), &REACH, &mut next, &mut 0) && holding.contains(&next);
    if closed {
        *theta = next;
    }
    closed
}

fn random_heading(random: &mut Random, variables: usize) -> Vec<f64> {
    (0..variables).map(|_| random.between(-1.0, 1.0)).collect()
}

/// Whether another assembly has a finite certified pose that is closer than `value`.
pub fn another_assembly(
    mechanism: &Mechanism,
    goal: &Pose,
    settings: &Settings,
    extent: f64,
    value: f64,
) -> bool {
    let free = vec![None; mechanism.chains().len()];
    let found = modes::find(mechanism, &free, goal, extent, settings);
    let mut solver = settings.solver(mechanism, extent);
    let mut joints = found.clone();
    if !solver
        .close_start(&mut joints, settings.dimension_tolerance)
        .is_closed()
    {
        return false;
    }
    let predicted = joints.clone();
    let solved = solver.solve(goal, &mut joints, &predicted);
    solved.end.is_minimum() && solved.value < value
}

#[cfg(test)]
mod tests {
    use super::Runaway;

    #[test]
    fn frames_in_a_row_are_one_runaway() {
        let mut runaways = Vec::new();
        for (frame, elsewhere) in [(3, false), (4, true), (5, false), (8, false), (9, false)] {
            Runaway::add(&mut runaways, frame, frame != 5, elsewhere);
        }
        let of = |first, last, searched, elsewhere| Runaway {
            first,
            last,
            searched,
            elsewhere,
        };
        assert_eq!(runaways, [of(3, 5, 2, true), of(8, 9, 2, false)]);
        Runaway::keep_to(&mut runaways, 8);
        assert_eq!(runaways, [of(3, 5, 2, true), of(8, 8, 1, false)]);
        Runaway::keep_to(&mut runaways, 4);
        assert_eq!(runaways, [of(3, 4, 2, true)]);
    }
}
