//! Leaps of a motion: intervals between frames that do not go on as their neighbours do, and what happens inside them.
//!
//! A leap is a change of joints by more than 0.02 rad, or sizes, within 1e-6 of an interval. An interval is looked into
//! where its joint motion is not the one that its neighbours' give by interpolation. Between two frames the goal is taken
//! to go straight and to turn steadily, and the linkage is followed along that way: a step is taken where the position in
//! its middle is within a quarter of a leap of the mean of its ends, else it is halved; where it would become shorter than
//! 1e-6 of the interval, it leaps. This distinguishes a motion that is fast but continuous from one that leaves its branch.

use crate::math::pose::Pose;
use crate::model::scaled::Scaled;
use crate::motion::goal::Goal;
use crate::motion::trajectory::{Trajectory, Warning};
use crate::solve::solver::{Solved, Solver};

/// Joint motion, rad or sizes, that is a leap where it happens at once.
pub const LEAP: f64 = 0.02;
/// What an interval's joint motion may differ from that of its neighbours, and twice what the middle of a step may differ
/// from the mean of its ends: a leap inside differs by all, and by half of it.
const FINE: f64 = 0.5 * LEAP;
/// Joint motion, rad or sizes, up to which the middle of a step is predicted from its ends.
const NEAR: f64 = 0.15;
/// Shortest step, as a share of the interval.
const SHORTEST: f64 = 1e-6;
/// Slope along a leap, in units of the stationary one, above which it leads downhill.
const SLOPE: f64 = 10.0;
/// Joint motion in one interval that is always looked at.
const LARGE: f64 = 0.5;
/// Steps in one interval: those of a hundred leaps. Beyond, the interval is left as it was found.
const STEPS: usize = 4000;
/// Neighbours to each side from which the joint motion of an interval is interpolated.
pub const NEIGHBOURS: usize = 2;

/// One leap.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leap {
    /// It lies between this frame and the next.
    pub first: usize,
    /// When, in the key frames' unit of time.
    pub time: f64,
    /// Motion of the joint variable that moves most, rad or a length.
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

/// Whether a joint variable changes in the interval after frame `first` unlike in the intervals beside it, or by much;
/// false where a frame of it is not certified.
pub fn is_suspicious(t: &Trajectory, scaled: &Scaled, first: usize) -> bool {
    let certified = |frame: usize| {
        t.status
            .get(frame)
            .is_some_and(|status| status.is_certified())
    };
    let is_known = |interval: usize| certified(interval) && certified(interval + 1);
    if !is_known(first) {
        return false;
    }
    // The neighbours next to it, and their weights in the polynomial through them at the interval itself.
    let before = (1..=NEIGHBOURS).map_while(|k| first.checked_sub(k).filter(|&n| is_known(n)));
    let behind = (1..=NEIGHBOURS).map_while(|k| Some(first + k).filter(|&n| is_known(n)));
    let mut nodes = [(0, 1.0); 2 * NEIGHBOURS];
    let mut count = 0;
    for node in before.chain(behind) {
        nodes[count].0 = node;
        count += 1;
    }
    for k in 0..count {
        for other in (0..count).filter(|&other| other != k) {
            let (own, at) = (nodes[k].0 as f64, nodes[other].0 as f64);
            nodes[k].1 *= (first as f64 - at) / (own - at);
        }
    }
    let change = |frame: usize, joint: usize| {
        let moved = t.joints_at(frame + 1)[joint] - t.joints_at(frame)[joint];
        if scaled.turns()[joint] {
            moved
        } else {
            moved / scaled.unit()
        }
    };
    (0..t.variables).any(|joint| {
        let own = change(first, joint);
        let expected: f64 = nodes[..count]
            .iter()
            .map(|&(node, weight)| weight * change(node, joint))
            .sum();
        // Written so that NaN is suspicious.
        !((own - expected).abs() <= FINE && own.abs() <= LARGE)
    })
}

/// How an interval was passed in short steps.
#[derive(Clone, Debug)]
pub struct Way {
    /// Joint values at its end.
    pub joints: Vec<f64>,
    /// What is known of the frame there; none where it is as it was found.
    pub solved: Option<Solved>,
    /// The leaps on it.
    pub leaps: Vec<Leap>,
}

/// Follows the linkage from the joint values of a frame to the next, of which `joints_after` were found; none where a
/// step is not certified.
pub fn trace(
    solver: &mut Solver,
    joints: &[f64],
    joints_after: &[f64],
    from: &Goal,
    to: &Goal,
) -> Option<Way> {
    let mut at = joints.to_vec();
    let mut done = 0.0;
    let mut leaps = Vec::new();
    // The end of the step; of the first one as the frame was found.
    let mut step = 1.0_f64;
    let mut end = joints_after.to_vec();
    let mut solved: Option<Solved> = None;
    for _ in 0..STEPS {
        let holding = solver.holding().clone();
        let mean: Vec<f64> = at.iter().zip(&end).map(|(a, b)| 0.5 * (a + b)).collect();
        let whole = Leap::between(solver.scaled(), &at, &end).moved_scaled;
        let mut middle = at.clone();
        let predicted = if whole <= NEAR { &mean } else { &at };
        let half_way = between(from, to, done + 0.5 * step);
        let half = solver.solve(&half_way, &mut middle, predicted);
        let off = Leap::between(solver.scaled(), &mean, &middle).moved_scaled;
        let is_end = solved.is_none_or(|solved| solved.end.is_minimum());
        if is_end && half.end.is_minimum() && off <= 0.5 * FINE && whole <= LARGE {
            // Nothing leaps in it.
        } else if step > SHORTEST {
            // The middle is the end of the first half.
            solver.set_holding(holding);
            step *= 0.5;
            (end, solved) = (middle, Some(half));
            continue;
        } else {
            // From where it is, not from a prediction that a leap may have led astray.
            solver.set_holding(holding);
            let goal = between(from, to, done + step);
            let mut trial = at.clone();
            let found = solver.solve(&goal, &mut trial, &at);
            if !found.end.is_minimum() {
                return None;
            }
            let leap = Leap::between(solver.scaled(), &at, &trial);
            // In a valley that is nearly flat the answer is known to within the stationary slope only; a move that does
            // not lower the distance by more than that slope allows is no leap.
            let fall = solver.value(&goal, &at) - found.value;
            let slope = SLOPE * solver.tolerances().stationary;
            if leap.moved_scaled > LEAP && fall > slope * leap.moved_scaled {
                let time = from.time + (done + step) * (to.time - from.time);
                leaps.push(Leap { time, ..leap });
            }
            (end, solved) = (trial, Some(found));
        }
        at.clone_from(&end);
        done += step;
        if done >= 1.0 {
            return Some(Way {
                joints: at,
                solved,
                leaps,
            });
        }
        step = (2.0 * step).min(1.0 - done);
        solved = Some(solver.solve(&between(from, to, done + step), &mut end, &at));
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
