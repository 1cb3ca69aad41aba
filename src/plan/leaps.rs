//! Leaps of a motion: intervals between frames that do not go on as their neighbours do, and what happens inside them.
//!
//! A leap is a change of joints by more than 0.02 rad, or sizes, within 1e-6 of an interval. Between two frames the goal
//! is taken to go straight and to turn steadily. The linkage is followed along that way in steps so short that no joint
//! moves by more than half a leap; where the steps would become shorter than 1e-6 of the interval, it leaps. So a motion
//! that is fast but continuous is told from one that leaves its branch.

use crate::math::pose::Pose;
use crate::model::scaled::Scaled;
use crate::motion::goal::Goal;
use crate::motion::trajectory::{Trajectory, Warning};
use crate::solve::solver::{Solved, Solver};

/// Joint motion, rad or sizes, that is a leap where it happens at once.
pub const LEAP: f64 = 0.02;
/// Joint motion of one step inside an interval.
const FINE: f64 = 0.5 * LEAP;
/// Shortest step, as a share of the interval.
const SHORTEST: f64 = 1e-6;
/// Slope along a leap, in units of the stationary one, above which it leads downhill.
const SLOPE: f64 = 10.0;
/// Joint motion in one interval that is always looked at.
const LARGE: f64 = 0.3;
/// Steps in one interval: 40 rad of joint motion, and room for a dozen leaps. Beyond, the interval is left as it was
/// found.
const STEPS: usize = 6000;

/// One leap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leap {
    /// It lies between this frame and the next.
    pub first: usize,
    /// When.
    pub time: f64,
    /// By how much the joint that moves most moves, rad or a length.
    pub moved: f64,
    /// The same, rad or sizes.
    pub moved_scaled: f64,
    /// That joint variable, from 0 through all chains.
    pub variable: usize,
}

impl Leap {
    /// From one set of joint values to another.
    pub fn between(scaled: &Scaled, from: &[f64], to: &[f64]) -> Self {
        let (moved_scaled, variable) =
            Scaled::largest_motion(&scaled.entered(from), &scaled.entered(to));
        let moved = (to[variable] - from[variable]).abs();
        Self {
            first: 0,
            time: 0.0,
            moved,
            moved_scaled,
            variable,
        }
    }

    /// As a warning.
    pub fn warning(&self) -> Warning {
        let Self {
            first,
            time,
            moved,
            variable,
            ..
        } = *self;
        Warning::BranchJump {
            first,
            time,
            moved,
            variable,
        }
    }
}

/// Whether the interval after frame `first` goes on unlike its neighbours.
pub fn is_suspicious(t: &Trajectory, scaled: &Scaled, first: usize) -> bool {
    let certified = |frame: usize| {
        t.status
            .get(frame)
            .is_some_and(|status| status.is_certified())
    };
    if !(certified(first) && certified(first + 1)) {
        return false;
    }
    let change = |frame: usize, joint: usize| {
        let moved = t.joints_at(frame + 1)[joint] - t.joints_at(frame)[joint];
        if scaled.turns()[joint] {
            moved
        } else {
            moved / scaled.unit()
        }
    };
    let last = t.frames() - 2;
    (0..t.variables).any(|joint| {
        let own = change(first, joint);
        let expected = match (first.checked_sub(1), first < last) {
            (Some(before), true) => 0.5 * (change(before, joint) + change(first + 1, joint)),
            (None, true) if first + 1 < last => {
                2.0 * change(first + 1, joint) - change(first + 2, joint)
            }
            (None, true) => change(first + 1, joint),
            (Some(before), false) if before > 0 => {
                2.0 * change(before, joint) - change(before - 1, joint)
            }
            (Some(before), false) => change(before, joint),
            (None, false) => 0.0,
        };
        !((own - expected).abs() <= FINE && own.abs() <= LARGE)
    })
}

/// How an interval was passed in short steps.
#[derive(Clone, Debug)]
pub struct Way {
    /// Joint values at its end.
    pub joints: Vec<f64>,
    /// What is known of the frame there.
    pub solved: Solved,
    /// The leaps on it.
    pub leaps: Vec<Leap>,
}

/// Follows the linkage from the joint values of a frame to the next in short steps; none where a step is not certified.
pub fn trace(solver: &mut Solver, joints: &[f64], from: &Goal, to: &Goal) -> Option<Way> {
    let mut at = joints.to_vec();
    let (mut done, mut step) = (0.0, 0.125_f64);
    let mut leaps = Vec::new();
    // The change of the joints a unit of the interval, for the prediction.
    let mut rate = vec![0.0; at.len()];
    for _ in 0..STEPS {
        let next = (done + step).min(1.0);
        let mut trial = at.clone();
        let predicted: Vec<f64> = at
            .iter()
            .zip(&rate)
            .map(|(x, r)| x + r * (next - done))
            .collect();
        let holding = solver.holding().clone();
        let goal = between(from, to, next);
        let solved = solver.solve(&goal, &mut trial, &predicted);
        let leap = Leap::between(solver.scaled(), &at, &trial);
        if !solved.end.is_minimum() || !(leap.moved_scaled <= FINE) {
            if step > SHORTEST {
                solver.set_holding(holding);
                // The prediction may be what led astray.
                rate.fill(0.0);
                step = (0.25 * step).max(0.5 * SHORTEST);
                continue;
            }
            if !solved.end.is_minimum() {
                return None;
            }
            // In a valley that is nearly flat the answer is known to within the stationary slope only; a move that does
            // not lower the distance by more than that slope allows is no leap.
            let fall = solver.value(&goal, &at) - solved.value;
            if leap.moved_scaled > LEAP
                && fall > SLOPE * solver.tolerances().stationary * leap.moved_scaled
            {
                let time = from.time + next * (to.time - from.time);
                leaps.push(Leap { time, ..leap });
            }
            rate.fill(0.0);
        } else {
            for ((rate, a), b) in rate.iter_mut().zip(&at).zip(&trial) {
                *rate = (b - a) / (next - done);
            }
        }
        at = trial;
        done = next;
        if done >= 1.0 {
            return Some(Way {
                joints: at,
                solved,
                leaps,
            });
        }
        step *= 2.0;
    }
    None
}

/// The goal at the part `s` of the way between two frames.
fn between(from: &Goal, to: &Goal, s: f64) -> Pose {
    if s >= 1.0 {
        return to.pose;
    }
    let (a, b) = (&from.pose, &to.pose);
    let turned = if a.rotation.coords.dot(&b.rotation.coords) < 0.0 {
        nalgebra::UnitQuaternion::new_unchecked(-b.rotation.into_inner())
    } else {
        b.rotation
    };
    let position = a.translation.vector.lerp(&b.translation.vector, s);
    Pose::from_parts(position.into(), a.rotation.nlerp(&turned, s))
}
