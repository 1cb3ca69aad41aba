//! Closed walks: paths of short steps over positions whose loops are closed, within the joints' limits.
//!
//! Positions are joint values as the solver has them (rad, shares of the size).

use crate::math::linalg::dot;
use crate::math::pose::Pose;
use crate::math::random::Random;
use crate::solve::close::{Reach, Shortest, add_rates, solve_gram};
use crate::solve::limits::Holding;
use crate::solve::solver::{Solved, Solver};

/// Length of a step along a free direction, root of the joints' squared motions.
const STEP: f64 = 0.065;
/// Largest joint motion from one point of a walk to the next, rad or sizes.
pub const LONGEST: f64 = 0.07;
/// Corrections that close the loops after a step: no longer than half of it, so that a walk does not leap.
const REACH: Reach = Reach {
    shortest: Shortest::Joints,
    each: 0.5 * STEP,
    all: 0.5 * STEP,
};
/// Steps of one walk towards a position: 20 rad or sizes.
const STEPS: usize = 300;
/// A walk has arrived where it is off by no more than this, rad or sizes.
const ARRIVED: f64 = 1e-9;
/// Share by which the distance to the end must fall in a step, and the least share of the way that is a free motion.
const NEARER: f64 = 1e-4;
const ALONG: f64 = 1e-3;
/// Share of a step below which it is not made shorter any more.
const SHORTEST: f64 = 0.1;
/// Rate of a joint, of a direction of length 1, that is rounding.
const LEVEL: f64 = 1e-9;

/// A closed walk: the points after the first one, and its length, root of the joints' squared motions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Walk {
    /// Joint values, point by point.
    pub points: Vec<Vec<f64>>,
    /// The sum over the steps.
    pub length: f64,
}

impl Walk {
    fn push(&mut self, from: &[f64], to: Vec<f64>) {
        self.length += distance(from, &to);
        self.points.push(to);
    }

    /// Goes on with another walk that begins where this one ends.
    pub fn append(&mut self, other: Self) {
        self.length += other.length;
        self.points.extend(other.points);
    }

    /// The same walk, which begins at `from`, in the other direction.
    pub fn reversed(&self, from: &[f64]) -> Self {
        let before = self.points.iter().rev().skip(1).cloned();
        Self {
            points: before.chain(std::iter::once(from.to_vec())).collect(),
            length: self.length,
        }
    }
}

/// Root of the joints' squared motions from one position to another.
pub fn distance(from: &[f64], to: &[f64]) -> f64 {
    let squares = from.iter().zip(to).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

/// Largest joint motion from one position to another.
pub fn largest(from: &[f64], to: &[f64]) -> f64 {
    let moves = from.iter().zip(to).map(|(a, b)| (a - b).abs());
    moves.fold(0.0, f64::max)
}

/// A random direction of the joints.
pub fn random_heading(random: &mut Random, variables: usize) -> Vec<f64> {
    (0..variables).map(|_| random.between(-1.0, 1.0)).collect()
}

/// Where joints go when all move along the free direction nearest to `heading`, which becomes that direction; joints at a
/// limit that it would push beyond it stand still. None where nothing is left of it.
fn project(solver: &mut Solver, theta: &[f64], heading: &mut [f64]) -> Option<Holding> {
    let (scaled, closer, holding) = solver.parts();
    let mut holding = holding.clone();
    holding.clear();
    let wanted = heading.to_vec();
    let mut coefficients = Vec::new();
    let mut gram = Vec::new();
    loop {
        let dependence = closer.dependence_anywhere();
        let tangent = closer.tangent();
        tangent.evaluate(scaled.chains(), theta);
        let free = tangent.factor(holding.stops(), dependence).free();
        coefficients.clear();
        coefficients.extend((0..free.count()).map(|i| dot(free.rates(i), &wanted)));
        if !solve_gram(&free, &mut gram, &mut coefficients) {
            return None;
        }
        heading.fill(0.0);
        add_rates(&free, &coefficients, 1.0, heading);
        let length = dot(heading, heading).sqrt();
        if !(length > 0.0) {
            return None;
        }
        match holding.pushed(theta, heading, LEVEL * length, usize::MAX) {
            Some((joint, stop)) => holding.set(joint, stop),
            None => return Some(holding),
        };
    }
}

/// One closed step of at most `step` along the free direction nearest to `heading`, and `heading` becomes that direction;
/// it ends at the first limit that it meets. False where the loops do not close there.
fn step(solver: &mut Solver, theta: &mut Vec<f64>, heading: &mut [f64], step: f64) -> bool {
    let Some(holding) = project(solver, theta, heading) else {
        return false;
    };
    let length = dot(heading, heading).sqrt();
    let along: Vec<f64> = heading.iter().map(|d| d * step / length).collect();
    let (share, met) = holding.share(theta, &along, LEVEL * step, None);
    let mut held = holding;
    if let Some((joint, stop)) = met {
        held.set(joint, stop);
    }
    let mut next: Vec<f64> = theta
        .iter()
        .zip(&along)
        .map(|(t, d)| t + share * d)
        .collect();
    held.apply(&mut next);
    let (scaled, closer, _) = solver.parts();
    let closed = closer.close(scaled, held.stops(), &REACH, &mut next, &mut 0)
        && held.contains(&next)
        && largest(theta, &next) <= LONGEST;
    if closed {
        *theta = next;
    }
    closed
}

/// Wanders over closed positions from `theta`, at random and straight on where that is possible, for about `length`; ends
/// earlier where it is stuck.
pub fn wander(solver: &mut Solver, theta: &[f64], length: f64, random: &mut Random) -> Walk {
    let mut walk = Walk::default();
    let mut heading = random_heading(random, theta.len());
    let mut at = theta.to_vec();
    let mut turns = 0;
    while walk.length < length {
        let before = at.clone();
        let long = STEP.min(length - walk.length);
        if step(solver, &mut at, &mut heading, long) {
            walk.push(&before, at.clone());
            // At a corner of the limits a step may have no length.
            if walk.points.len() > STEPS {
                break;
            }
        } else if turns < 2 {
            turns += 1;
            heading = random_heading(random, theta.len());
        } else {
            break;
        }
    }
    walk
}

/// The closed walk from one closed position to another that goes as straight as it can; none where it does not arrive.
pub fn walk(solver: &mut Solver, from: &[f64], to: &[f64]) -> Option<Walk> {
    let mut walk = Walk::default();
    let mut at = from.to_vec();
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let mut heading: Vec<f64> = at.iter().zip(to).map(|(a, b)| b - a).collect();
        let far = dot(&heading, &heading).sqrt();
        if far <= ARRIVED {
            // The end itself, which is closed, in place of what is as good as it.
            match walk.points.last_mut() {
                Some(end) => end.copy_from_slice(to),
                None => walk.points.push(to.to_vec()),
            }
            return Some(walk);
        }
        if !(far < last * (1.0 - NEARER)) {
            return None;
        }
        last = far;
        let before = at.clone();
        let wanted = heading.clone();
        let mut long = STEP.min(far);
        while !step(solver, &mut at, &mut heading, long) {
            long *= 0.5;
            if !(long >= SHORTEST * STEP.min(far)) {
                return None;
            }
            heading.clone_from(&wanted);
        }
        if !(dot(&heading, &heading).sqrt() >= ALONG * far) {
            return None;
        }
        walk.push(&before, at.clone());
    }
    None
}

/// The minimum of the distance from `goal` downhill from a closed position: joint values, what is known of it, and closed
/// positions that were passed.
pub fn fall(solver: &mut Solver, theta: &[f64], goal: &Pose) -> (Vec<f64>, Solved, Vec<Vec<f64>>) {
    let mut joints = solver.scaled().left(theta);
    let from = joints.clone();
    let mut passed: Vec<Vec<f64>> = Vec::new();
    solver.clear_holding();
    let solved = solver.solve_watched(goal, &mut joints, &from, &mut |iterate| {
        if iterate.guarded {
            passed.push(iterate.theta.to_vec());
        }
    });
    (solver.scaled().entered(&joints), solved, passed)
}

/// The closed walk from a position to the minimum that [`fall`] found from there; none where the loops do not stay closed.
pub fn retrace(
    solver: &mut Solver,
    theta: &[f64],
    passed: Vec<Vec<f64>>,
    end: &[f64],
) -> Option<Walk> {
    if let Some(straight) = walk(solver, theta, end) {
        return Some(straight);
    }
    let mut whole = Walk::default();
    let mut at = theta.to_vec();
    for point in passed.into_iter().chain([end.to_vec()]) {
        whole.append(walk(solver, &at, &point)?);
        at = point;
    }
    Some(whole)
}
