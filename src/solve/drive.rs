//! One joint variable driven to a value while the loops stay closed and the other joints follow.
//!
//! Where the linkage has more freedoms than one, the others follow at the least rates: of all joint
//! rates that keep the loops closed and move the driven joint, those with the least sum of squares
//! (rad, and lengths in units of the mechanism's size). So the path does not depend on how many
//! steps a hand took along it, but for the size of a step squared.
//!
//! A step predicts along these rates and closes the loops by the shortest corrections with the driven
//! joint held; it counts only if the corrections are short against it, else it is halved, so that the
//! branch is followed and not jumped from. Where the driven joint comes to a turning point (a dead
//! point) the rates of the others grow beyond all bounds, the steps shrink, and that is the end.
//! Joints that come to a limit are held there as long as the motion pushes them against it.

use crate::math::linalg;
use crate::model::chain::Chain;
use crate::model::joint::{Limits, Stop};
use crate::model::mechanism::Mechanism;
use crate::solve::tangent::Tangent;

/// Longest step, the root of the joints' squared motions: 0.1 still resembles its tangent.
const STEP: f64 = 0.1;
/// Step at which a dead point counts as reached. The driven value is then within its square, 1e-10.
const SMALLEST_STEP: f64 = 1e-5;
/// Corrections are at most this share of the step that they correct.
const CORRECTED: f64 = 0.5;
/// Corrections after a step: quadratic convergence needs three or four.
const CORRECTIONS: usize = 12;
/// Driven rate per unit of joint motion below which the driven joint stands still.
const DEAD: f64 = 1e-8;
/// Rate of a joint that is rounding.
const LEVEL: f64 = 1e-9;
/// How far from a limit a joint counts as at it, and how far beyond it rounding may carry it.
const LIMIT: f64 = 1e-10;
/// Steps across a position in which the driven joint stands still, to see whether it goes on behind it.
const KICKS: [f64; 2] = [1e-2, 1e-3];
/// Least progress of the driven joint that a kick must bring: above the error of a dead point.
const PROGRESS: f64 = 1e-9;
/// How far a slider without limits may run, in units of the size: where the driven value has an
/// asymptote, it would run for ever.
const FARTHEST: f64 = 20.0;
/// Steps of one drive: 30 turns of one joint alone.
const STEPS: usize = 2000;

/// Why a driven joint did not get its value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// Its own limit.
    OwnLimit,
    /// Other joints at their limits, and there is no way round them; or sliders without limits that
    /// have run as far as they may.
    Limits(Vec<usize>),
    /// The loops do not close any further.
    DeadPoint,
    /// Nothing of the linkage moves.
    Immobile,
    /// The way is longer than one drive goes.
    TooFar,
    /// The loops are open and do not close.
    Open,
}

/// How a drive ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Driven {
    /// None where the value was met.
    pub obstacle: Option<Obstacle>,
    /// Linear systems solved.
    pub iterations: usize,
}

/// Drives joint variable `variable` from the closed position `joints` to `value`, as far as it goes;
/// `joints` receives where that led, closed.
///
/// # Panics
/// When `joints` does not have one value a joint variable, or there is no such variable.
pub fn drive(mechanism: &Mechanism, joints: &mut [f64], variable: usize, value: f64) -> Driven {
    let size = mechanism.size();
    let chains = mechanism.scaled(1.0 / size).chains().to_vec();
    let mut theta = mechanism.in_unit(joints, size);
    let mut limits: Vec<Limits> = chains.iter().flat_map(Chain::limits).collect();
    let mut asked = joints.to_vec();
    asked[variable] = value;
    let asked = mechanism.in_unit(&asked, size)[variable];
    let own = limits[variable];
    let target = asked.max(own.min).min(own.max);
    let turns = chains.iter().flat_map(Chain::turns);
    for (joint, ((l, &t), turns)) in limits.iter_mut().zip(&theta).zip(turns).enumerate() {
        if !turns && joint != variable {
            l.min = l.min.max(-FARTHEST);
            l.max = l.max.min(FARTHEST);
        }
        // A joint beyond a limit may come back, and go no further.
        l.min = l.min.min(t);
        l.max = l.max.max(t);
    }
    let mut path = Path {
        tangent: Tangent::new(&chains),
        stops: vec![Stop::None; theta.len()],
        step: vec![0.0; theta.len()],
        correction: Vec::new(),
        redundant: 0,
        // As the solver's: ten times closer than what is published, not closer than rounding allows.
        closed: (1e-11 / size).clamp(1e-13, 1e-12),
        iterations: 0,
        chains,
        limits,
        variable,
    };
    let obstacle = path.follow(&mut theta, target);
    joints.copy_from_slice(&mechanism.in_unit(&theta, 1.0 / size));
    let own_limit = ((target - asked).abs() > 0.0).then_some(Obstacle::OwnLimit);
    if obstacle.is_none() && own_limit.is_none() {
        // Not its rounding in another unit; the loops do not feel the difference.
        joints[variable] = value;
    }
    Driven {
        obstacle: obstacle.or(own_limit),
        iterations: path.iterations,
    }
}

/// A path of closed positions, in units of the mechanism's size.
struct Path {
    chains: Vec<Chain>,
    limits: Vec<Limits>,
    variable: usize,
    closed: f64,
    tangent: Tangent,
    /// Joints held at limits in the present step.
    stops: Vec<Stop>,
    /// Constraints implied by the others at the present position.
    redundant: usize,
    step: Vec<f64>,
    correction: Vec<f64>,
    iterations: usize,
}

/// How a step ends.
#[derive(Clone, Copy)]
enum End {
    /// With the driven joint at this value.
    Value(f64),
    /// With this joint at a limit.
    Limit(usize, Stop),
    /// Anywhere.
    Free,
}

impl Path {
    fn follow(&mut self, theta: &mut Vec<f64>, target: f64) -> Option<Obstacle> {
        let mut radius = STEP;
        for _ in 0..STEPS {
            let gap = target - theta[self.variable];
            if gap == 0.0 {
                return None;
            }
            let direction = self.direction(theta, gap.signum());
            let next = match &direction {
                Some(direction) => self.advance(theta, direction, target, &mut radius),
                None => None,
            };
            match next {
                Some(next) => *theta = next,
                None => {
                    let held = self.held();
                    let moves = self.mobile(theta);
                    match self.kick(theta, direction, gap.signum()) {
                        Some(next) => *theta = next,
                        None if !held.is_empty() => return Some(Obstacle::Limits(held)),
                        None if moves => return Some(Obstacle::DeadPoint),
                        None => return Some(Obstacle::Immobile),
                    }
                    radius = STEP;
                }
            }
        }
        Some(Obstacle::TooFar)
    }

    fn held(&self) -> Vec<usize> {
        let held = self.stops.iter().enumerate();
        held.filter(|(_, stop)| **stop != Stop::None)
            .map(|(joint, _)| joint)
            .collect()
    }

    /// Can anything move with the present stops?
    fn mobile(&mut self, theta: &[f64]) -> bool {
        self.tangent.evaluate(&self.chains, theta);
        self.tangent.factor(&self.stops, None, 0);
        self.tangent.freedoms() > 0
    }

    /// The least joint rates, of unit length, that move the driven joint to the side `sign` and no
    /// joint beyond its limit; none where it stands still. Sets the stops.
    fn direction(&mut self, theta: &[f64], sign: f64) -> Option<Vec<f64>> {
        self.stops.fill(Stop::None);
        loop {
            self.iterations += 1;
            self.tangent.evaluate(&self.chains, theta);
            self.tangent.factor(&self.stops, None, 0);
            self.redundant = self.tangent.redundant();
            self.tangent.span();
            let n = self.tangent.freedoms();
            let driven: Vec<f64> = (0..n)
                .map(|i| self.tangent.rates(i)[self.variable])
                .collect();
            // Of all Θᵀ a with Θ_j·a = 1 the shortest is along G⁻¹ Θ_j, G = Θ Θᵀ.
            let coefficients = self.solve_gram(&driven)?;
            let speed = dot(&driven, &coefficients).max(0.0).sqrt();
            if !(speed > DEAD) {
                return None;
            }
            let mut rates = vec![0.0; theta.len()];
            self.add_rates(&coefficients, sign / speed, &mut rates);
            let Some((joint, stop)) = self.pushed(theta, &rates) else {
                return Some(rates);
            };
            self.stops[joint] = stop;
        }
    }

    /// The joint at a limit that the rates push hardest against it.
    fn pushed(&self, theta: &[f64], rates: &[f64]) -> Option<(usize, Stop)> {
        let mut hardest = (LEVEL, None);
        for (joint, l) in self.limits.iter().enumerate() {
            // The driven joint ends at its limit by its target.
            if joint == self.variable || self.stops[joint] != Stop::None {
                continue;
            }
            if rates[joint] > hardest.0 && theta[joint] >= l.max - LIMIT {
                hardest = (rates[joint], Some((joint, Stop::Max)));
            }
            if -rates[joint] > hardest.0 && theta[joint] <= l.min + LIMIT {
                hardest = (-rates[joint], Some((joint, Stop::Min)));
            }
        }
        hardest.1
    }

    /// The longest step along `direction` up to `radius` that can be had; none where there is none.
    fn advance(
        &mut self,
        theta: &[f64],
        direction: &[f64],
        target: f64,
        radius: &mut f64,
    ) -> Option<Vec<f64>> {
        let gap = target - theta[self.variable];
        let whole = gap / direction[self.variable];
        loop {
            let length = radius.min(whole);
            let next = self.step_along(theta, direction, length, target);
            if next.is_some() {
                *radius = (2.0 * *radius).min(STEP);
                return next;
            }
            *radius = 0.5 * length;
            if *radius < SMALLEST_STEP.min(0.5 * whole) {
                return None;
            }
        }
    }

    fn step_along(
        &mut self,
        theta: &[f64],
        direction: &[f64],
        length: f64,
        target: f64,
    ) -> Option<Vec<f64>> {
        let gap = target - theta[self.variable];
        let driven = direction[self.variable] * length;
        let (mut share, mut end) = self.room(theta, direction, length);
        if matches!(end, End::Free) {
            end = End::Value(if driven.abs() >= gap.abs() {
                target
            } else {
                theta[self.variable] + driven
            });
        }
        // A correction may carry a joint beyond a limit that the prediction kept; then the step ends
        // there.
        for _ in 0..2 {
            let mut next: Vec<f64> = theta
                .iter()
                .zip(direction)
                .map(|(t, d)| t + share * length * d)
                .collect();
            if !self.close(&mut next, end, share * length) {
                return None;
            }
            match self.overrun(theta, &next) {
                Some((part, joint, stop)) => {
                    share *= part;
                    end = End::Limit(joint, stop);
                }
                None => {
                    let progress = (next[self.variable] - theta[self.variable]) * gap.signum();
                    return (progress > 0.0).then_some(next);
                }
            }
        }
        None
    }

    /// The share of a step that keeps the joints within their limits, and what ends it there.
    fn room(&self, theta: &[f64], direction: &[f64], length: f64) -> (f64, End) {
        let mut first = (1.0, End::Free);
        for (joint, l) in self.limits.iter().enumerate() {
            let rate = direction[joint];
            if joint == self.variable || self.stops[joint] != Stop::None || rate.abs() <= LEVEL {
                continue;
            }
            let (room, stop) = if rate > 0.0 {
                (l.max - theta[joint], Stop::Max)
            } else {
                (theta[joint] - l.min, Stop::Min)
            };
            let share = room / (rate.abs() * length);
            if share < first.0 {
                first = (share.max(0.0), End::Limit(joint, stop));
            }
        }
        first
    }

    /// The first joint beyond its limit on the way from `theta` to `next`, and the part of the way
    /// up to it.
    fn overrun(&self, theta: &[f64], next: &[f64]) -> Option<(f64, usize, Stop)> {
        let mut first: Option<(f64, usize, Stop)> = None;
        for (joint, l) in self.limits.iter().enumerate() {
            let (beyond, stop) = if next[joint] > l.max + LIMIT {
                (l.max - theta[joint], Stop::Max)
            } else if next[joint] < l.min - LIMIT {
                (l.min - theta[joint], Stop::Min)
            } else {
                continue;
            };
            let part = (beyond / (next[joint] - theta[joint])).clamp(0.0, 1.0);
            if first.is_none_or(|(least, ..)| part < least) {
                first = Some((part, joint, stop));
            }
        }
        first
    }

    /// Closes the loops near `theta` by the shortest corrections, in all not longer than half of
    /// `length`; false, and `theta` as it was, if that does not do.
    fn close(&mut self, theta: &mut Vec<f64>, end: End, length: f64) -> bool {
        let held = match end {
            End::Value(value) => {
                theta[self.variable] = value;
                // Either stop says that it stands still.
                Some((self.variable, Stop::Min))
            }
            End::Limit(joint, stop) => {
                theta[joint] = stop.bound(&self.limits[joint]);
                Some((joint, stop))
            }
            End::Free => None,
        };
        let before = held.map(|(joint, stop)| std::mem::replace(&mut self.stops[joint], stop));
        // In a singular position more constraints look redundant than are.
        let counts = [self.redundant, 0];
        let counts = if self.redundant > 0 {
            &counts[..]
        } else {
            &counts[1..]
        };
        let closed = counts
            .iter()
            .any(|&redundant| self.close_with(redundant, theta, length));
        if let (Some((joint, _)), Some(before)) = (held, before) {
            self.stops[joint] = before;
        }
        closed
    }

    fn close_with(&mut self, redundant: usize, theta: &mut Vec<f64>, length: f64) -> bool {
        let mut at = theta.clone();
        let mut last = f64::INFINITY;
        for _ in 0..CORRECTIONS {
            let open = self.tangent.evaluate(&self.chains, &at);
            if open <= self.closed {
                *theta = at;
                return true;
            }
            if !(open < last) {
                return false;
            }
            last = open;
            self.iterations += 1;
            self.tangent.factor(&self.stops, None, redundant);
            self.tangent.span();
            self.tangent.close(&mut self.correction, &mut self.step);
            // The shortest in the joints, not in the twist.
            let n = self.tangent.freedoms();
            let along: Vec<f64> = (0..n)
                .map(|i| dot(self.tangent.rates(i), &self.step))
                .collect();
            let Some(coefficients) = self.solve_gram(&along) else {
                return false;
            };
            let mut step = std::mem::take(&mut self.step);
            self.add_rates(&coefficients, -1.0, &mut step);
            at.iter_mut().zip(&step).for_each(|(t, s)| *t += s);
            self.step = step;
            let moved: f64 = at.iter().zip(&*theta).map(|(a, t)| (a - t) * (a - t)).sum();
            if !(moved.sqrt() <= CORRECTED * length) {
                return false;
            }
        }
        false
    }

    /// A short step in some free direction after which the driven joint is further on the side `sign`.
    /// First in the direction, if there is one, in which the driven joint still moves: at a dead point
    /// it tells the side from which the linkage came.
    fn kick(&mut self, theta: &[f64], direction: Option<Vec<f64>>, sign: f64) -> Option<Vec<f64>> {
        self.tangent.evaluate(&self.chains, theta);
        self.tangent.factor(&self.stops, None, 0);
        self.redundant = self.tangent.redundant();
        self.tangent.span();
        let free = (0..self.tangent.freedoms()).map(|i| self.tangent.rates(i).to_vec());
        let directions: Vec<Vec<f64>> = direction.into_iter().chain(free).collect();
        for length in KICKS {
            for rates in &directions {
                for side in [1.0, -1.0] {
                    let scale = side * length / dot(rates, rates).sqrt();
                    let mut next: Vec<f64> = theta
                        .iter()
                        .zip(rates)
                        .map(|(t, r)| t + scale * r)
                        .collect();
                    if self.close(&mut next, End::Free, length)
                        && (next[self.variable] - theta[self.variable]) * sign > PROGRESS
                        && self.overrun(theta, &next).is_none()
                    {
                        return Some(next);
                    }
                }
            }
        }
        None
    }

    /// G⁻¹ x for the Gram matrix G of the free joint rates.
    fn solve_gram(&self, x: &[f64]) -> Option<Vec<f64>> {
        let n = x.len();
        let mut gram = vec![0.0; n * n];
        for i in 0..n {
            for j in i..n {
                gram[i * n + j] = dot(self.tangent.rates(i), self.tangent.rates(j));
            }
        }
        let mut x = x.to_vec();
        if !linalg::cholesky(&mut gram, n, n, 0.0) {
            return None;
        }
        linalg::solve_lower(&gram, n, n, &mut x);
        linalg::solve_lower_transposed(&gram, n, n, &mut x);
        Some(x)
    }

    /// Adds the free joint rates with these coefficients times `scale`.
    fn add_rates(&self, coefficients: &[f64], scale: f64, sum: &mut [f64]) {
        for (i, c) in coefficients.iter().enumerate() {
            for (s, r) in sum.iter_mut().zip(self.tangent.rates(i)) {
                *s += scale * c * r;
            }
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
