//! Leaps of a motion: intervals between frames that do not go on as their neighbours do, and what happens inside them.
//!
//! A leap is a change of joints by more than 0.02 rad, or sizes, within 1e-6 of an interval. An interval is looked into
//! where its joint motion is not the one that its neighbours' give by interpolation. Between two frames the goal is taken
//! to go straight and to turn steadily.
//!
//! Most of these intervals go as the joint rates at their ends say, or their halves do. Through the others the linkage is
//! followed: a step is taken where it ends within half a leap of the position that the points before it give by
//! extrapolation, else it is made shorter; where it would become shorter than 1e-6 of the interval, it leaps. This
//! distinguishes a motion that is fast but continuous from one that leaves its branch.

use crate::math::metric::nearer;
use crate::math::pose::Pose;
use crate::model::scaled::{Scaled, larger};
use crate::motion::goal::Goal;
use crate::motion::trajectory::{Trajectory, Warning};
use crate::solve::solver::{Solved, Solver};

/// Joint motion, rad or sizes, that is a leap where it happens at once.
pub const LEAP: f64 = 0.02;
/// What an interval's joint motion may differ from that of its neighbours, and the end of a step from its extrapolation:
/// a leap inside differs by all of it.
const FINE: f64 = 0.5 * LEAP;
/// First step inside an interval, where points before it are known and where none are, as shares of it.
const FIRST: [f64; 2] = [0.25, 0.02];
/// How often an interval is halved to see whether its parts go as their ends say.
const HALVINGS: usize = 3;
/// How far from its prediction the middle may be for that, rad or sizes.
const FAR: f64 = 0.3;
/// Part of an interval after which the goal's motion is told from its place: rates are known to about as much.
const MOMENT: f64 = 1e-4;
/// Points that an extrapolation goes through: with four it errs by the fourth power of a step.
const POINTS: usize = 4;
/// Shortest step, as a share of the interval.
const SHORTEST: f64 = 1e-6;
/// Slope along a leap, in units of the stationary one, above which it leads downhill.
const SLOPE: f64 = 10.0;
/// Joint motion in one interval that is always looked at.
const LARGE: f64 = 0.5;
/// Steps in one interval: those of a few dozen leaps. Beyond, the interval is left as it was found.
const STEPS: usize = 2000;
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
    let after = (1..=NEIGHBOURS).map_while(|k| Some(first + k).filter(|&n| is_known(n)));
    let mut nodes = [(0, 1.0); 2 * NEIGHBOURS];
    let mut count = 0;
    for node in before.chain(after) {
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

/// Whether an interval goes as the joint rates at its ends say, or its halves do and theirs, so that nothing leaps inside: a
/// cheap answer for most of the intervals that are suspicious, and false where it takes more to know.
pub fn goes_as_its_ends(
    solver: &mut Solver,
    t: &Trajectory,
    first: usize,
    from: &Goal,
    to: &Goal,
) -> bool {
    let mut end = |part: f64, frame: usize| Point::new(solver, from, to, part, t.joints_at(frame));
    let (Some(start), Some(stop)) = (end(0.0, first), end(1.0, first + 1)) else {
        return false;
    };
    go_as_their_ends(solver, from, to, [&start, &stop], HALVINGS)
}

/// A minimum at a part of an interval, with the joint rates per interval, as the solver has them.
struct Point {
    part: f64,
    theta: Vec<f64>,
    rates: Vec<f64>,
}

impl Point {
    fn new(solver: &mut Solver, from: &Goal, to: &Goal, part: f64, joints: &[f64]) -> Option<Self> {
        let mut rates = vec![0.0; joints.len()];
        let moment = if part + MOMENT <= 1.0 {
            MOMENT
        } else {
            -MOMENT
        };
        let [goal, ahead] = [part, part + moment].map(|part| between(from, to, part));
        let known = solver.rates(&goal, &ahead, moment, joints, &mut rates);
        known.then(|| Self {
            part,
            theta: solver.scaled().entered(joints),
            rates,
        })
    }
}

/// With the rates r at the ends of a step, per step, the motion of the step is (r₀ + r₁)/2; or else, by the cubic polynomial
/// through the ends, its middle is (θ₀ + θ₁)/2 + (r₀ − r₁)/8 and the rate there (θ₁ − θ₀)·3/2 − (r₀ + r₁)/4. A leap
/// changes the motion and the place of the middle, and no rate.
fn go_as_their_ends(
    solver: &mut Solver,
    from: &Goal,
    to: &Goal,
    ends: [&Point; 2],
    halvings: usize,
) -> bool {
    let [a, b] = ends;
    let long = b.part - a.part;
    let joints = || {
        let places = a.theta.iter().zip(&b.theta);
        let rates = a.rates.iter().zip(&b.rates);
        places
            .zip(rates)
            .map(|((x, y), (r, s))| (x, y, long * r, long * s))
    };
    let moved = joints().map(|(x, y, r, s)| (y - x - 0.5 * (r + s)).abs());
    if moved.fold(0.0, larger) <= FINE {
        return true;
    }
    let middle: Vec<f64> = joints()
        .map(|(x, y, r, s)| 0.5 * (x + y) + 0.125 * (r - s))
        .collect();
    let predicted = solver.scaled().left(&middle);
    let mut found = solver.scaled().left(&a.theta);
    let part = 0.5 * (a.part + b.part);
    let solved = solver.solve(&between(from, to, part), &mut found, &predicted);
    if !solved.end.is_minimum() {
        return false;
    }
    let off = Leap::between(solver.scaled(), &predicted, &found).moved_scaled;
    // Further off the rates at the ends say nothing of what is between them.
    if !(off <= FAR) {
        return false;
    }
    let Some(middle) = Point::new(solver, from, to, part, &found) else {
        return false;
    };
    let expected = joints().map(|(x, y, r, s)| 1.5 * (y - x) - 0.25 * (r + s));
    let rates = expected.zip(&middle.rates);
    let rates = rates.map(|(rate, found)| (rate - long * found).abs());
    if off <= 0.5 * FINE && rates.fold(0.0, larger) <= 2.0 * FINE {
        return true;
    }
    if halvings == 0 {
        return false;
    }
    [[a, &middle], [&middle, b]]
        .into_iter()
        .all(|half| go_as_their_ends(solver, from, to, half, halvings - 1))
}

/// How an interval was passed in short steps.
#[derive(Clone, Debug)]
pub struct Traced {
    /// Joint values at its end.
    pub joints: Vec<f64>,
    /// What is known of the frame there.
    pub solved: Solved,
    /// The leaps on it.
    pub leaps: Vec<Leap>,
}

/// Follows the linkage through the interval after frame `first` of a motion, in short steps; none where a step is not
/// certified.
///
/// A step that misses its extrapolation by up to four times as much as it may is halved, another is cut to a fifth; one
/// that misses by a tenth of that at most is followed by one twice as long, any other by one a fifth longer.
pub fn trace(
    solver: &mut Solver,
    t: &Trajectory,
    first: usize,
    from: &Goal,
    to: &Goal,
) -> Option<Traced> {
    // Points of the motion, the latest first: the part of the interval, negative before it, and joint values.
    let mut points: Vec<(f64, Vec<f64>)> = (0..POINTS)
        .map_while(|back| first.checked_sub(back))
        .take_while(|&frame| t.status[frame].is_certified())
        .map(|frame| (frame as f64 - first as f64, t.joints_at(frame).to_vec()))
        .collect();
    let mut step = FIRST[usize::from(points.len() < 2)];
    let mut leaps = Vec::new();
    let mut predicted = vec![0.0; t.variables];
    for _ in 0..STEPS {
        let (done, at) = &points[0];
        let next = if done + step > 1.0 - SHORTEST {
            1.0
        } else {
            done + step
        };
        let goal = between(from, to, next);
        let holding = solver.holding().clone();
        extrapolate(&points, next, &mut predicted);
        let mut end = at.clone();
        let mut solved = solver.solve(&goal, &mut end, &predicted);
        let off = Leap::between(solver.scaled(), &predicted, &end).moved_scaled;
        let smooth = solved.end.is_minimum() && off <= FINE;
        if !smooth && step > SHORTEST {
            solver.set_holding(holding);
            // The error falls with the power of the step; where it does not, it is a leap that comes nearer.
            step *= if off <= 4.0 * FINE { 0.5 } else { 0.2 };
            continue;
        }
        let mut leapt = false;
        if !smooth {
            // From where it is, not from a prediction that a leap may have led astray.
            solver.set_holding(holding);
            end.clone_from(at);
            solved = solver.solve(&goal, &mut end, at);
            if !solved.end.is_minimum() {
                return None;
            }
            let leap = Leap::between(solver.scaled(), at, &end);
            leapt = leap.moved_scaled > FINE;
            // In a valley that is nearly flat the answer is known to within the stationary slope only; a move that does
            // not lower the distance by more than that slope allows is no leap.
            let fall = solver.value(&goal, at) - solved.value;
            let slope = SLOPE * solver.tolerances().stationary;
            if leap.moved_scaled > LEAP && fall > slope * leap.moved_scaled {
                let time = from.time + next * (to.time - from.time);
                leaps.push(Leap { time, ..leap });
            }
        }
        if next >= 1.0 {
            return Some(Traced {
                joints: end,
                solved,
                leaps,
            });
        }
        if leapt {
            points.clear();
        }
        points.insert(0, (next, end));
        points.truncate(POINTS);
        step *= if off <= 0.1 * FINE { 2.0 } else { 1.2 };
    }
    None
}

/// The joint values at the part `s` of the interval, by the polynomial through the points.
fn extrapolate(points: &[(f64, Vec<f64>)], s: f64, joints: &mut [f64]) {
    joints.fill(0.0);
    for (k, (own, values)) in points.iter().enumerate() {
        let others = points.iter().enumerate().filter(|(other, _)| *other != k);
        let weight: f64 = others.map(|(_, (at, _))| (s - at) / (own - at)).product();
        joints
            .iter_mut()
            .zip(values)
            .for_each(|(x, value)| *x += weight * value);
    }
}

/// The goal at the part `s` of the way between two frames.
fn between(from: &Goal, to: &Goal, s: f64) -> Pose {
    if s >= 1.0 {
        return to.pose;
    }
    let (a, b) = (&from.pose, &to.pose);
    let position = a.translation.vector.lerp(&b.translation.vector, s);
    let rotation = a.rotation.nlerp(&nearer(&b.rotation, &a.rotation), s);
    Pose::from_parts(position.into(), rotation)
}
