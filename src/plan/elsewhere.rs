//! A finite closest pose where the followed branch has none: from positions that closed walks join to the present one,
//! and in other assemblies. What a closed walk is: see [`walk`].

use crate::math::pose::Pose;
use crate::math::random::Random;
use crate::model::mechanism::Mechanism;
use crate::motion::trajectory::Warning;
use crate::plan::modes;
use crate::plan::settings::Settings;
use crate::plan::walk;
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

/// Walks, and positions on each from which a minimum is looked for. On every third walk a position is the minimum for a random
/// goal, on the others the end of a straight walk: only goals bring a slider back that has run far, and only straight
/// walks leave the neighbourhood of a minimum.
const WALKS: u64 = 12;
const POSITIONS: usize = 24;
/// Steps straight on from one position to the next: 4 rad, or sizes, across the workspace.
const STRIDE: usize = 66;

/// The closest finite certified pose found from positions that closed walks, within the limits, join to `joints`.
pub fn joined(solver: &mut Solver, joints: &[f64], goal: &Pose) -> Option<(Vec<f64>, Solved)> {
    let (mut best, mut least) = (None, f64::INFINITY);
    for walk in 0..WALKS {
        let mut random = Random::new(walk);
        let mut theta = solver.scaled().entered(joints);
        for _ in 0..POSITIONS {
            if walk % 3 == 0 {
                let aim = walk::random_goal(solver, goal, &mut random);
                if let Some((end, _)) = fallen(solver, &theta, &aim, f64::INFINITY) {
                    theta = end;
                }
            } else {
                go_straight(solver, &mut theta, &mut random);
            }
            if let Some((end, solved)) = fallen(solver, &theta, goal, least) {
                least = solved.value;
                best = Some((solver.scaled().left(&end), solved));
            }
        }
    }
    solver.clear_holding();
    best
}

/// Closed steps in a direction at random, in another one where that is not possible.
fn go_straight(solver: &mut Solver, theta: &mut Vec<f64>, random: &mut Random) {
    let mut heading = walk::random_heading(random, theta.len());
    for _ in 0..STRIDE {
        let mut next = theta.clone();
        let went = walk::step(solver, &mut next, &mut heading, walk::STEP);
        match walk::closed_near(solver, next) {
            Some(next) if went && walk::largest(theta, &next) <= walk::LONGEST => *theta = next,
            _ => heading = walk::random_heading(random, theta.len()),
        }
    }
}

/// The minimum, closer than `least`, to which the linkage falls from `theta`. The steps of the solver are longer than those
/// of a walk and may leap: none where no walk leads along them.
fn fallen(
    solver: &mut Solver,
    theta: &[f64],
    goal: &Pose,
    least: f64,
) -> Option<(Vec<f64>, Solved)> {
    let (end, solved, mut passed) = walk::fall(solver, theta, goal);
    if !(solved.end.is_minimum() && solved.value < least) {
        return None;
    }
    passed.push(end.clone());
    walk::through(solver, theta, &passed)?;
    Some((end, solved))
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
    let mut joints = modes::find(mechanism, &free, goal, extent, settings);
    let mut solver = settings.solver(mechanism, extent);
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
