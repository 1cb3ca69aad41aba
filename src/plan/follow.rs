//! A motion, frame by frame: warm start, prediction, branch watch, report.

use crate::math::pose::{self, Pose};
use crate::model::chain::Chain;
use crate::model::joint::Limits;
use crate::model::mechanism::Mechanism;
use crate::motion::goal::Goal;
use crate::motion::trajectory::{Status, Trajectory, Warning};
use crate::solve::drive::{self, Obstacle};
use crate::solve::gradient;
use crate::solve::newton::{End, Solved, Solver};
use crate::solve::paper_matrix::{self, SingularValues};

/// Which of the two planners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Newton's method on the linkage's freedoms: the default.
    Newton,
    /// The paper's projected gradient (Fig. 3), for reference and teaching.
    Gradient,
}

/// What a plan needs to know beside mechanism and goals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The planner.
    pub method: Method,
    /// Characteristic length of the metric, in the document's unit: a translation by it weighs as
    /// much as a rotation by 1 rad. 1 is the paper's.
    pub metric_length: f64,
    /// Iterations a frame may take before it counts as stalled; `None` for the method's own limit.
    pub max_iterations: Option<usize>,
}

impl Default for Settings {
    /// Newton and the paper's metric.
    fn default() -> Self {
        Self {
            method: Method::Newton,
            metric_length: 1.0,
            max_iterations: None,
        }
    }
}

/// Linear systems that no certified frame was seen to need.
pub(crate) const NEWTON_ITERATIONS: usize = 500;
/// Gradient steps; near gimbal lock the 3RPS takes some 20,000.
pub(crate) const GRADIENT_ITERATIONS: usize = 30_000;
/// How far f may be above the minimum in a certified answer of the gradient planner: twice what its
/// stop leaves in the flattest directions met.
const GRADIENT_FALL: f64 = 2e-8;
/// Smallest singular value (in units of the metric's length) below which a position is reported as
/// nearly singular: some joint rate is then a hundred times the workpiece's.
const NEAR_SINGULAR: f64 = 1e-2;
/// A joint motion between neighbouring frames (rad, or lengths in units of the size) that may be a
/// jump to another branch, if it is also this many times the motion's median.
const JUMP: f64 = 0.5;
const JUMP_FACTOR: f64 = 8.0;

/// Plans the motion closest to `goals` from the joint values `start`, which choose the assembly
/// mode; where they do not close the loops, the nearest closed position is taken, with a warning.
///
/// # Panics
/// When `start` does not have one value a joint variable.
pub fn plan(
    mechanism: &Mechanism,
    start: &[f64],
    goals: &[Goal],
    settings: &Settings,
) -> Trajectory {
    plan_watched(mechanism, start, goals, settings, &mut |_| {})
}

/// The same, and tells `done` after each frame how many there are: long motions take minutes.
///
/// # Panics
/// When `start` does not have one value a joint variable.
pub fn plan_watched(
    mechanism: &Mechanism,
    start: &[f64],
    goals: &[Goal],
    settings: &Settings,
    done: &mut dyn FnMut(usize),
) -> Trajectory {
    let mut planning = Planning::new(mechanism, start, goals, settings);
    while planning.advance() {
        done(planning.done());
    }
    planning.finish()
}

/// A plan in portions of one frame.
#[derive(Debug)]
pub struct Planning {
    mechanism: Mechanism,
    /// The mechanism in units of the metric's length.
    reference: Mechanism,
    goals: Vec<Goal>,
    settings: Settings,
    max_iterations: usize,
    solver: Solver,
    closed: bool,
    joints: Vec<f64>,
    /// Everything of the frames so far but what [`measure_singular`] and [`survey`] add.
    planned: Trajectory,
}

impl Planning {
    /// Closes the loops at `start`; no frame is planned yet.
    ///
    /// # Panics
    /// When `start` does not have one value a joint variable.
    pub fn new(mechanism: &Mechanism, start: &[f64], goals: &[Goal], settings: &Settings) -> Self {
        assert_eq!(
            start.len(),
            mechanism.variables(),
            "one start value a joint variable"
        );
        let mut t = Trajectory {
            variables: start.len(),
            mobility_count: mechanism.mobility_count(),
            ..Trajectory::default()
        };
        let own_limit = match settings.method {
            Method::Newton => NEWTON_ITERATIONS,
            Method::Gradient => GRADIENT_ITERATIONS,
        };
        let max_iterations = settings.max_iterations.unwrap_or(own_limit);
        let mut solver = Solver::new(mechanism, settings.metric_length, max_iterations);
        let mut joints = start.to_vec();
        let closed = assemble(mechanism, &mut solver, &mut joints, &mut t.warnings);
        t.mobility_rank = solver.mobility(&joints);
        if closed && t.mobility_rank.cast_signed() != t.mobility_count {
            let (count, rank) = (t.mobility_count, t.mobility_rank);
            t.warnings.push(Warning::MobilityDiffers { count, rank });
        }
        let limited = mechanism.chains().iter().flat_map(Chain::limits);
        if settings.method == Method::Gradient && limited.into_iter().any(|l| l != Limits::NONE) {
            t.warnings.push(Warning::LimitsUnknown);
        }
        t.start.clone_from(&joints);
        Self {
            reference: mechanism.scaled(1.0 / settings.metric_length),
            mechanism: mechanism.clone(),
            goals: goals.to_vec(),
            settings: *settings,
            max_iterations,
            solver,
            closed,
            joints,
            planned: t,
        }
    }

    /// Frames in all.
    pub fn frames(&self) -> usize {
        self.goals.len()
    }

    /// Frames planned so far.
    pub fn done(&self) -> usize {
        self.planned.frames()
    }

    /// Plans one more frame; `false` where there is none left.
    pub fn advance(&mut self) -> bool {
        let (mechanism, length) = (&self.mechanism, self.settings.metric_length);
        let frame = self.planned.frames();
        let Some(goal) = self.goals.get(frame) else {
            return false;
        };
        let joints = &mut self.joints;
        let mut predicted = joints.clone();
        predict(&self.planned.joints, frame, joints, &mut predicted);
        let solved = match (self.closed, self.settings.method) {
            (false, _) => OPEN,
            (true, Method::Newton) => self.solver.solve(&goal.pose, joints, &predicted),
            (true, Method::Gradient) => {
                let mut scaled = mechanism.in_unit(joints, length);
                let mut near = goal.pose;
                near.translation.vector /= length;
                let most = self.max_iterations;
                let descent =
                    gradient::descend(&self.reference, &near, &mut scaled, most, &mut |_| {});
                *joints = mechanism.in_unit(&scaled, 1.0 / length);
                let mut solved = self.solver.certify(&goal.pose, joints, GRADIENT_FALL);
                solved.iterations = descent.iterations;
                solved.projected_gradient = descent.projected_gradient;
                solved
            }
        };
        record(&mut self.planned, mechanism, goal, joints, &solved, length);
        if solved.end == End::Runaway {
            self.planned.warnings.push(Warning::Runaway { frame });
        }
        true
    }

    /// The motion of the frames planned so far, with the warnings of what is there.
    pub fn so_far(&self) -> Trajectory {
        let mut t = self.planned.clone();
        let (mechanism, length) = (&self.mechanism, self.settings.metric_length);
        let mut solver = Solver::new(mechanism, length, self.max_iterations);
        measure_singular(&mut t, mechanism, &mut solver, &self.reference, length);
        survey(&mut t, mechanism);
        t
    }

    /// Plans the rest; the whole motion.
    pub fn finish(mut self) -> Trajectory {
        while self.advance() {}
        self.so_far()
    }
}

/// One position outside any motion, as a motion of one frame: the closest reachable pose to `goal` on
/// the branch of the joint values `from`, or the end of a drive of one joint variable to a value.
#[derive(Clone, Debug)]
pub struct Moved {
    /// The one frame.
    pub frame: Trajectory,
    /// What kept a driven joint from its value.
    pub obstacle: Option<Obstacle>,
}

/// The closest reachable pose to `goal`, from the closed position `from` along its branch, by Newton's
/// method; certified as the frames of a plan are.
///
/// # Panics
/// When `from` does not have one value a joint variable.
pub fn pull(mechanism: &Mechanism, from: &[f64], goal: &Pose, settings: &Settings) -> Moved {
    let most = settings.max_iterations.unwrap_or(NEWTON_ITERATIONS);
    move_from(mechanism, from, settings, most, |solver, joints| {
        let predicted = joints.to_vec();
        let solved = solver.solve(goal, joints, &predicted);
        (solved, Some(*goal), None)
    })
}

/// Drives one joint variable to `value`, from the closed position `from`; see [`drive::drive`].
///
/// # Panics
/// When `from` does not have one value a joint variable, or there is no such variable.
pub fn drive_joint(
    mechanism: &Mechanism,
    from: &[f64],
    variable: usize,
    value: f64,
    settings: &Settings,
) -> Moved {
    move_from(mechanism, from, settings, NEWTON_ITERATIONS, |_, joints| {
        let driven = drive::drive(mechanism, joints, variable, value);
        let solved = Solved {
            end: End::Minimum,
            // The pose is its own goal.
            reached: true,
            projected_gradient: 0.0,
            iterations: driven.iterations,
        };
        (solved, None, driven.obstacle)
    })
}

/// Closes the loops where `from` leaves them open, moves, and records where that led.
fn move_from(
    mechanism: &Mechanism,
    from: &[f64],
    settings: &Settings,
    max_iterations: usize,
    go: impl FnOnce(&mut Solver, &mut [f64]) -> (Solved, Option<Pose>, Option<Obstacle>),
) -> Moved {
    let length = settings.metric_length;
    let mut solver = Solver::new(mechanism, length, max_iterations);
    let mut joints = from.to_vec();
    let mut t = Trajectory {
        variables: joints.len(),
        mobility_count: mechanism.mobility_count(),
        ..Trajectory::default()
    };
    let closed = assemble(mechanism, &mut solver, &mut joints, &mut t.warnings);
    t.start.clone_from(&joints);
    let (solved, goal, obstacle) = if closed {
        go(&mut solver, &mut joints)
    } else {
        (OPEN, None, Some(Obstacle::Open))
    };
    let pose = goal.unwrap_or_else(|| mechanism.chains()[0].pose(&joints));
    let goal = Goal { time: 0.0, pose };
    record(&mut t, mechanism, &goal, &joints, &solved, length);
    let reference = mechanism.scaled(1.0 / length);
    measure_singular(&mut t, mechanism, &mut solver, &reference, length);
    Moved { frame: t, obstacle }
}

const OPEN: Solved = Solved {
    end: End::Open,
    reached: false,
    projected_gradient: f64::INFINITY,
    iterations: 0,
};

/// Closes the loops at the start; warns if that moved it, or failed.
fn assemble(
    mechanism: &Mechanism,
    solver: &mut Solver,
    joints: &mut [f64],
    warnings: &mut Vec<Warning>,
) -> bool {
    /// Motion below which a start counts as closed as given: the last digits of a printed table.
    const MOVED: f64 = 1e-6;
    let given = joints.to_vec();
    if solver.assemble(joints) {
        let moved = largest_difference(joints, &given);
        if moved > MOVED {
            warnings.push(Warning::StartMoved { moved });
        }
        return true;
    }
    joints.copy_from_slice(&given);
    let first = &mechanism.chains()[0];
    let opening = paper_matrix::opening(mechanism, joints, &first.pose(joints));
    warnings.push(Warning::StartOpen { opening });
    false
}

/// Where the joints of frame `frame` are expected, extrapolated from the joint values `history` of up
/// to four frames before it: cubically where there are four.
pub fn predict(history: &[f64], frame: usize, joints: &[f64], predicted: &mut [f64]) {
    let n = joints.len();
    let coefficients: &[f64] = match frame {
        0 | 1 => &[1.0],
        2 => &[2.0, -1.0],
        3 => &[3.0, -3.0, 1.0],
        _ => &[4.0, -6.0, 4.0, -1.0],
    };
    predicted.copy_from_slice(joints);
    if frame == 0 {
        return;
    }
    predicted.fill(0.0);
    for (back, c) in coefficients.iter().enumerate() {
        let past = &history[(frame - 1 - back) * n..(frame - back) * n];
        for (p, x) in predicted.iter_mut().zip(past) {
            *p += c * x;
        }
    }
}

/// Appends a frame. The opening is measured anew, from the joint values that are published.
fn record(
    t: &mut Trajectory,
    mechanism: &Mechanism,
    goal: &Goal,
    joints: &[f64],
    solved: &Solved,
    length: f64,
) {
    let reached = mechanism.chains()[0].pose(joints);
    let opening = paper_matrix::opening(mechanism, joints, &reached);
    let (translation, rotation) = pose::gaps(&reached, &goal.pose);
    t.time.push(goal.time);
    t.goals.push(goal.pose);
    t.poses.push(reached);
    t.joints.extend_from_slice(joints);
    t.metric.push(pose::metric(&reached, &goal.pose, length));
    t.translation_gap.push(translation);
    t.rotation_gap.push(rotation);
    t.closure.push(opening);
    t.projected_gradient.push(solved.projected_gradient);
    t.iterations
        .push(u32::try_from(solved.iterations).unwrap_or(u32::MAX));
    t.status.push(match solved.end {
        // Written so that NaN is open.
        _ if !(opening <= paper_matrix::closed(mechanism.size())) => Status::ClosureLost,
        End::Open => Status::ClosureLost,
        End::Stalled | End::Runaway => Status::Stalled,
        _ if solved.reached => Status::Reached,
        End::Minimum => Status::Closest,
        End::MinimumAtLimit => Status::AtLimit,
    });
}

/// The smallest singular value of each frame, that is not zero by equations which depend on the others
/// all along.
fn measure_singular(
    t: &mut Trajectory,
    mechanism: &Mechanism,
    solver: &mut Solver,
    reference: &Mechanism,
    length: f64,
) {
    // In a singular start there are more dependent equations.
    let mut redundant = solver.redundancy(&t.start);
    for frame in 0..t.frames() {
        if redundant > 0 {
            redundant = redundant.min(solver.redundancy(t.joints_at(frame)));
        }
    }
    let mut values = SingularValues::default();
    for frame in 0..t.frames() {
        let scaled = mechanism.in_unit(t.joints_at(frame), length);
        t.sigma_min
            .push(values.smallest(reference.chains(), &scaled, redundant));
    }
}

/// What only the whole motion shows: nearly singular intervals, jumps.
fn survey(t: &mut Trajectory, mechanism: &Mechanism) {
    let turns: Vec<bool> = mechanism.chains().iter().flat_map(Chain::turns).collect();
    let mut frame = 0;
    while frame < t.frames() {
        let run = t.sigma_min[frame..]
            .iter()
            .take_while(|s| **s < NEAR_SINGULAR)
            .count();
        if run > 0 {
            let (first, last) = (frame, frame + run - 1);
            let smallest = t.sigma_min[first..=last]
                .iter()
                .copied()
                .fold(f64::INFINITY, f64::min);
            t.warnings.push(Warning::NearSingular {
                first,
                last,
                smallest,
            });
        }
        frame += run + 1;
    }
    let size = mechanism.size();
    let moved: Vec<f64> = (1..t.frames())
        .map(|frame| {
            let pairs = t.joints_at(frame).iter().zip(t.joints_at(frame - 1));
            pairs.zip(&turns).fold(0.0, |m: f64, ((a, b), turns)| {
                m.max((a - b).abs() / if *turns { 1.0 } else { size })
            })
        })
        .collect();
    let mut sorted = moved.clone();
    sorted.sort_by(f64::total_cmp);
    let median = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0);
    for (first, &moved) in moved.iter().enumerate() {
        if moved > JUMP && moved > JUMP_FACTOR * median {
            t.warnings.push(Warning::BranchJump { first, moved });
        }
    }
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}
