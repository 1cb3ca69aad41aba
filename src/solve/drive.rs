//! One joint variable driven to a value while the loops stay closed and the other joints follow.
//!
//! Where the linkage has more freedoms than one, the others follow at the least rates: of all joint
//! rates that keep the loops closed and move the driven joint, those with the least sum of squares
//! (rad, and lengths in units of the mechanism's size). So the path does not depend on the
//! number of steps, up to the square of their length.
//!
//! A step predicts along these rates and closes the loops by the shortest corrections with the driven
//! joint held; it counts only if the corrections are short against it, else it is halved, so that the
//! branch is followed without a leap. Where the driven joint comes to a turning point (a dead
//! point) the rates of the others grow beyond all bounds, the steps shrink, and the drive ends.
//! Joints that come to a limit are held there as long as the motion pushes them against it.

use crate::math::linalg::dot;
use crate::model::joint::Stop;
use crate::model::scaled::Scaled;
use crate::solve::close::{Closer, Reach, Shortest, add_rates, solve_gram};
use crate::solve::dependent::Dependence;
use crate::solve::limits::Holding;

/// Longest step, the root of the joints' squared motions: 0.1 still resembles its tangent.
const STEP: f64 = 0.1;
/// Step at which a dead point counts as reached. The driven value is then within its square, 1e-10.
const SMALLEST_STEP: f64 = 1e-5;
/// Corrections are at most this share of the step that they correct.
const CORRECTED: f64 = 0.5;
/// Driven rate per unit of joint motion below which the driven joint stands still.
const DEAD: f64 = 1e-8;
/// Rate of a joint that is rounding.
const LEVEL: f64 = 1e-9;
/// Steps across a position in which the driven joint stands still, to see whether it goes on behind it.
const KICKS: [f64; 2] = [1e-2, 1e-3];
/// Least progress of the driven joint that a kick must bring: above the error of a dead point.
const PROGRESS: f64 = 1e-9;
/// How far out a slider may move on a side on which it has no limit, in units of the size: where the driven value has
/// an asymptote, it would move on for ever.
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

/// Drives joint variable `variable` from the closed position `joints` to `value`, as far as it goes; `joints` receives
/// where that led, closed. `closer` knows the linkage's surplus constraints.
///
/// # Panics
/// When `joints` does not have one value a joint variable, or there is no such variable.
pub fn drive(
    scaled: &Scaled,
    closer: &mut Closer,
    joints: &mut [f64],
    variable: usize,
    value: f64,
) -> Driven {
    let mut theta = scaled.entered(joints);
    let mut asked = joints.to_vec();
    asked[variable] = value;
    let asked = scaled.entered(&asked)[variable];
    let own = scaled.limits()[variable];
    let target = asked.max(own.min).min(own.max);
    let mut holding = Holding::new(scaled.limits());
    for (joint, &turns) in scaled.turns().iter().enumerate() {
        if !turns && joint != variable {
            holding.bound(joint, FARTHEST);
        }
    }
    holding.widen(&theta);
    let known = closer.dependence();
    let mut path = Path {
        scaled,
        closer,
        holding,
        variable,
        iterations: 0,
    };
    let obstacle = path.follow(&mut theta, target);
    let iterations = path.iterations;
    closer.set_dependence(known);
    scaled.leave(&theta, joints);
    let own_limit = ((target - asked).abs() > 0.0).then_some(Obstacle::OwnLimit);
    if obstacle.is_none() && own_limit.is_none() {
        // As given, without the rounding of the change of units; the loops stay closed.
        joints[variable] = value;
    }
    Driven {
        obstacle: obstacle.or(own_limit),
        iterations,
    }
}

/// A path of closed positions.
struct Path<'a> {
    scaled: &'a Scaled,
    closer: &'a mut Closer,
    /// Joints held at limits in the present step.
    holding: Holding,
    variable: usize,
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

impl Path<'_> {
    fn follow(&mut self, theta: &mut Vec<f64>, target: f64) -> Option<Obstacle> {
        let mut radius = STEP;
        // The position before the last step, and the direction and length of that.
        let mut last: Option<(Vec<f64>, Vec<f64>, f64)> = None;
        for _ in 0..STEPS {
            let gap = target - theta[self.variable];
            if gap == 0.0 {
                return None;
            }
            let mut direction = self.direction(theta, gap.signum());
            // A step that turns the heading round has gone across a dead point, to the other branch, and one after which
            // the driven joint stands still may have: it is taken back.
            let crossed = last.take().filter(|(_, heading, _)| {
                direction
                    .as_ref()
                    .is_none_or(|direction| dot(direction, heading) < 0.0)
            });
            let next = if let Some((before, heading, length)) = crossed {
                theta.clone_from(&before);
                if length > SMALLEST_STEP {
                    radius = 0.5 * length;
                    continue;
                }
                direction = Some(heading);
                None
            } else {
                match &direction {
                    Some(direction) => self.advance(theta, direction, target, &mut radius),
                    None => None,
                }
            };
            match next {
                Some(next) => {
                    let moved: f64 = next
                        .iter()
                        .zip(&*theta)
                        .map(|(a, b)| (a - b) * (a - b))
                        .sum();
                    last = direction.map(|heading| (theta.clone(), heading, moved.sqrt()));
                    *theta = next;
                }
                None => {
                    let held = self.holding.held();
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

    /// Can anything move with the present stops?
    fn mobile(&mut self, theta: &[f64]) -> bool {
        let dependence = self.closer.dependence_anywhere();
        let tangent = self.closer.tangent();
        tangent.evaluate(self.scaled.chains(), theta);
        tangent.factor(self.holding.stops(), dependence).freedoms() > 0
    }

    /// The least joint rates, of unit length, that move the driven joint to the side `sign` and no
    /// joint beyond its limit; none where it stands still. Sets the stops.
    fn direction(&mut self, theta: &[f64], sign: f64) -> Option<Vec<f64>> {
        self.holding.clear();
        loop {
            self.iterations += 1;
            let dependence = self.closer.dependence_anywhere();
            let tangent = self.closer.tangent();
            tangent.evaluate(self.scaled.chains(), theta);
            let factored = tangent.factor(self.holding.stops(), dependence);
            let surplus = factored.surplus();
            let free = factored.free();
            let driven: Vec<f64> = (0..free.count())
                .map(|i| free.rates(i)[self.variable])
                .collect();
            // Of all Θᵀ a with Θ_j·a = 1 the shortest is along G⁻¹ Θ_j, G = Θ Θᵀ.
            let mut coefficients = driven.clone();
            if !solve_gram(&free, &mut Vec::new(), &mut coefficients) {
                return None;
            }
            let speed = dot(&driven, &coefficients).max(0.0).sqrt();
            let mut rates = vec![0.0; theta.len()];
            add_rates(&free, &coefficients, sign / speed, &mut rates);
            if !dependence.is_rounded() {
                self.closer.set_dependence(Dependence::Implied(surplus));
            }
            if !(speed > DEAD) {
                return None;
            }
            let Some((joint, stop)) = self.holding.pushed(theta, &rates, LEVEL, self.variable)
            else {
                return Some(rates);
            };
            self.holding.set(joint, stop);
        }
    }

    /// The longest step along `direction` up to `radius` after which the loops close; none where there is none.
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
        let whole: Vec<f64> = direction.iter().map(|d| d * length).collect();
        let (mut share, hit) =
            self.holding
                .share(theta, &whole, LEVEL * length, Some(self.variable));
        let mut end = match hit {
            Some((joint, stop)) => End::Limit(joint, stop),
            None if driven.abs() >= gap.abs() => End::Value(target),
            None => End::Value(theta[self.variable] + driven),
        };
        // A correction may carry a joint beyond a limit that the prediction kept; then the step ends
        // there.
        for _ in 0..2 {
            let mut next: Vec<f64> = theta
                .iter()
                .zip(&whole)
                .map(|(t, d)| t + share * d)
                .collect();
            if !self.close(&mut next, end, share * length) {
                return None;
            }
            match self.holding.overrun(theta, &next) {
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

    /// Closes the loops near `theta` by the shortest corrections, in all not longer than half of
    /// `length`; false if they do not close so.
    fn close(&mut self, theta: &mut [f64], end: End, length: f64) -> bool {
        let held = match end {
            End::Value(value) => {
                theta[self.variable] = value;
                // `Min` or `Max`: it is only held.
                Some((self.variable, Stop::Min))
            }
            End::Limit(joint, stop) => {
                theta[joint] = stop.bound(self.holding.limits(joint));
                Some((joint, stop))
            }
            End::Free => None,
        };
        let before = held.map(|(joint, stop)| (joint, self.holding.set(joint, stop)));
        let reach = Reach {
            shortest: Shortest::Joints,
            each: f64::INFINITY,
            all: CORRECTED * length,
        };
        let stops = self.holding.stops();
        let closed = self
            .closer
            .close(self.scaled, stops, &reach, theta, &mut self.iterations);
        if let Some((joint, stop)) = before {
            self.holding.set(joint, stop);
        }
        closed
    }

    /// A short step in some free direction after which the driven joint is further on the side `sign`.
    /// First in the direction, if there is one, in which the driven joint still moves: at a dead point
    /// it points along the way that the linkage came.
    fn kick(&mut self, theta: &[f64], direction: Option<Vec<f64>>, sign: f64) -> Option<Vec<f64>> {
        let dependence = self.closer.dependence_anywhere();
        let tangent = self.closer.tangent();
        tangent.evaluate(self.scaled.chains(), theta);
        let factored = tangent.factor(self.holding.stops(), dependence);
        let surplus = factored.surplus();
        let free = factored.free();
        let mut directions: Vec<Vec<f64>> = direction.into_iter().collect();
        directions.extend((0..free.count()).map(|i| free.rates(i).to_vec()));
        if !dependence.is_rounded() {
            self.closer.set_dependence(Dependence::Implied(surplus));
        }
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
                        && self.holding.overrun(theta, &next).is_none()
                    {
                        return Some(next);
                    }
                }
            }
        }
        None
    }
}
