//! Closed walks: paths of short steps over positions whose loops are closed, within the joints' limits.
//!
//! Positions are joint values as the solver has them (rad, shares of the size).

use crate::math::linalg::dot;
use crate::math::norm::unit;
use crate::math::pose::Pose;
use crate::math::random::Random;
use crate::solve::close::{Reach, Shortest, add_rates, longest, solve_gram};
use crate::solve::limits::Holding;
use crate::solve::solver::{Solved, Solver};
use nalgebra::{Quaternion, Vector3, Vector4};

/// Length of a step along a free direction, root of the joints' squared motions.
pub const STEP: f64 = 0.06;
/// Largest joint motion from one point of a walk to the next, rad or sizes.
pub const LONGEST: f64 = 0.07;
/// Steps of a walk, and of one towards a position for each of the straight line's.
const STEPS: usize = 300;
const DETOUR: f64 = 2.0;
const MOST_STEPS: f64 = 2e4;
/// A walk has arrived where it is off by no more than this, rad or sizes: its last step but one is as good as the end.
const ARRIVED: f64 = 1e-3;
/// Share by which the distance to the end must fall in a step, and the least share of it that is a free motion.
const NEARER: f64 = 1e-4;
const ALONG: f64 = 1e-3;
/// How often a walk at random that is stuck turns, and how often a step is halved.
const TURNS: usize = 2;
const DIVISIONS: usize = 8;
/// Rate of a joint, of a direction of length 1, that is rounding.
const LEVEL: f64 = 1e-9;
/// How far a goal at random is from another along each axis, sizes.
const AWAY: f64 = 2.0;

/// A closed walk: the points after the first one, and its length, root of the joints' squared motions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Walk {
    /// Joint values, point by point.
    pub points: Vec<Vec<f64>>,
    /// The sum over the steps.
    pub length: f64,
}

impl Walk {
    /// A single step.
    pub fn straight(from: &[f64], to: &[f64]) -> Self {
        Self {
            points: vec![to.to_vec()],
            length: distance(from, to),
        }
    }

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

/// A goal at random around another, turned in any way: the linkage falls far towards it.
pub fn random_goal(solver: &Solver, goal: &Pose, random: &mut Random) -> Pose {
    let mut number = || random.between(-1.0, 1.0);
    let away = Vector3::from_fn(|_, _| number()) * (AWAY * solver.scaled().unit());
    let rotation = unit(Quaternion::from(Vector4::from_fn(|_, _| number())));
    Pose::from_parts((goal.translation.vector + away).into(), rotation)
}

/// A random direction of the joints.
pub fn random_heading(random: &mut Random, variables: usize) -> Vec<f64> {
    (0..variables).map(|_| random.between(-1.0, 1.0)).collect()
}

/// One step of at most `length` along the free direction nearest to `heading`, and `heading` becomes that direction. Joints
/// at a limit that it would push beyond it stand still, and it ends at the first limit that it meets. In the same step the
/// loops are closed to first order, so that one factorisation serves a step; what it leaves open itself is closed by the next.
/// False where nothing is left of the direction or closing takes as long as the step.
pub fn step(solver: &mut Solver, theta: &mut [f64], heading: &mut [f64], length: f64) -> bool {
    let wanted = heading.to_vec();
    let (scaled, closer, holding) = solver.parts();
    let mut holding = holding.clone();
    holding.clear();
    let (mut correction, mut coefficients, mut gram) = (Vec::new(), Vec::new(), Vec::new());
    let mut closing = vec![0.0; theta.len()];
    // As it is known: where the loops are not quite closed, surplus constraints look independent.
    let dependence = closer.dependence();
    closer.tangent().evaluate(scaled.chains(), theta);
    loop {
        let mut factored = closer.tangent().factor(holding.stops(), dependence);
        factored.close(&mut correction, &mut closing);
        let free = factored.free();
        coefficients.clear();
        coefficients.extend((0..free.count()).map(|i| dot(free.rates(i), &wanted)));
        if !solve_gram(&free, &mut gram, &mut coefficients) {
            return false;
        }
        heading.fill(0.0);
        add_rates(&free, &coefficients, 1.0, heading);
        let rate = dot(heading, heading).sqrt();
        if !(rate > 0.0 && longest(&closing) <= 0.5 * STEP) {
            return false;
        }
        if let Some((joint, stop)) = holding.pushed(theta, heading, LEVEL * rate, usize::MAX) {
            holding.set(joint, stop);
            continue;
        }
        let moves: Vec<f64> = heading
            .iter()
            .zip(&closing)
            .map(|(d, c)| d * length / rate + c)
            .collect();
        let (share, met) = holding.share(theta, &moves, LEVEL * length, None);
        theta
            .iter_mut()
            .zip(&moves)
            .for_each(|(t, m)| *t += share * m);
        if let Some((joint, stop)) = met {
            holding.set(joint, stop);
        }
        holding.apply(theta);
        return true;
    }
}

/// A walk from the closed position `theta`, at random and straight on where that is possible, for about `length`; ends
/// earlier where it is stuck. The points are nearly closed; see [`closed_through`].
pub fn random_walk(
    solver: &mut Solver,
    theta: &[f64],
    length: f64,
    random: &mut Random,
) -> Vec<Vec<f64>> {
    let mut points: Vec<Vec<f64>> = Vec::new();
    let mut heading = random_heading(random, theta.len());
    let mut at = theta.to_vec();
    let (mut gone, mut turns) = (0.0, 0);
    // At a corner of the limits a step may have no length.
    while gone < length && points.len() < STEPS {
        let before = at.clone();
        if step(solver, &mut at, &mut heading, STEP.min(length - gone)) {
            gone += distance(&before, &at);
            points.push(at.clone());
        } else if turns < TURNS {
            turns += 1;
            heading = random_heading(random, theta.len());
        } else {
            break;
        }
    }
    points
}

/// The closed walk from one closed position to another that goes as straight as it can; none where it does not arrive.
pub fn walk(solver: &mut Solver, from: &[f64], to: &[f64]) -> Option<Walk> {
    let mut points = Vec::new();
    let mut at = from.to_vec();
    let mut last = f64::INFINITY;
    let straight = libm::ceil(DETOUR * distance(from, to) / STEP);
    // Not a number at all, or a slider that goes a thousand sizes: there is no such walk.
    if !(straight <= MOST_STEPS) {
        return None;
    }
    for step_number in 0.. {
        if step_number >= STEPS && step_number as f64 >= straight {
            return None;
        }
        let mut heading: Vec<f64> = at.iter().zip(to).map(|(a, b)| b - a).collect();
        let mut far = dot(&heading, &heading).sqrt();
        if far <= STEP && step_number > 0 {
            // Near the end what is left open counts: most of the distance may be across the free directions.
            at = closed_near(solver, at)?;
            heading = at.iter().zip(to).map(|(a, b)| b - a).collect();
            far = dot(&heading, &heading).sqrt();
        }
        if far <= ARRIVED {
            points.pop();
            points.push(to.to_vec());
            return closed_through(solver, from, points);
        }
        if !(far < last * (1.0 - NEARER)) {
            return None;
        }
        last = far;
        if !step(solver, &mut at, &mut heading, STEP.min(far)) {
            return None;
        }
        if !(dot(&heading, &heading).sqrt() >= ALONG * far) {
            return None;
        }
        points.push(at.clone());
    }
    None
}

/// The closed walk through points that are nearly closed, the last of them as it is; none where one does not close nearby or
/// a step between two cannot be divided.
pub fn closed_through(
    solver: &mut Solver,
    from: &[f64],
    mut points: Vec<Vec<f64>>,
) -> Option<Walk> {
    let last = points.len().saturating_sub(1);
    for point in &mut points[..last] {
        *point = closed_near(solver, std::mem::take(point))?;
    }
    through(solver, from, &points)
}

/// The closed walk through closed positions, with more of them between where steps are long; none where two are not joined so.
pub fn through(solver: &mut Solver, from: &[f64], points: &[Vec<f64>]) -> Option<Walk> {
    let mut walk = Walk::default();
    let mut at = from;
    for point in points {
        if !divide(solver, &mut walk, at, point, DIVISIONS) {
            return None;
        }
        at = point;
    }
    Some(walk)
}

/// Appends a step to a walk, with closed positions between where it is long: however far the corrections go, what counts is
/// that no step is long in the end. False where it is not divided.
fn divide(
    solver: &mut Solver,
    walk: &mut Walk,
    from: &[f64],
    to: &[f64],
    divisions: usize,
) -> bool {
    let far = largest(from, to);
    if far <= LONGEST {
        walk.push(from, to.to_vec());
        return true;
    }
    if divisions == 0 {
        return false;
    }
    let middle = from.iter().zip(to).map(|(a, b)| 0.5 * (a + b)).collect();
    closed_within(solver, middle, 0.5 * far).is_some_and(|middle| {
        divide(solver, walk, from, &middle, divisions - 1)
            && divide(solver, walk, &middle, to, divisions - 1)
    })
}

/// The closed position next to one that is nearly closed, within the limits.
pub fn closed_near(solver: &mut Solver, theta: Vec<f64>) -> Option<Vec<f64>> {
    closed_within(solver, theta, 0.5 * STEP)
}

fn closed_within(solver: &mut Solver, mut theta: Vec<f64>, far: f64) -> Option<Vec<f64>> {
    let (scaled, closer, holding) = solver.parts();
    let mut holding = holding.clone();
    holding.hold_all_at(&theta);
    let reach = Reach {
        shortest: Shortest::Joints,
        each: far,
        all: far,
    };
    let mut closes = |holding: &Holding| {
        closer.close(scaled, holding.stops(), &reach, &mut theta, &mut 0)
            && holding.contains(&theta)
    };
    let held = closes(&holding);
    holding.clear();
    (held || closes(&holding)).then_some(theta)
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
