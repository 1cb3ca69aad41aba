//! A motion with driven joints, frame by frame: the loops stay closed, the branch is kept, and where a driver's value is
//! out of reach the linkage waits as near as it comes until it is within reach again.

use crate::math::pose::Pose;
use crate::model::mechanism::Mechanism;
use crate::motion::drivers::Schedule;
use crate::motion::goal::Goal;
use crate::motion::trajectory::{DriveEnd, Trajectory, Warning};
use crate::plan::driven_start::{driven, positions_near};
use crate::plan::given;
use crate::plan::record::{Singularity, begin, record, warn_of_rounded};
use crate::plan::settings::Settings;
use crate::solve::drive::Obstacle;
use crate::solve::solver::{End, Solved, Solver};
use crate::solve::steer::Steering;
use nalgebra::{Quaternion, Translation3, UnitQuaternion};

/// Distance from a driver's value, rad or sizes, up to which it counts as reached.
const REACHED: f64 = 1e-9;

/// A plan in portions: frame by frame, and at any time what there is so far.
#[derive(Clone, Debug)]
pub struct Planning {
    schedule: Schedule,
    solver: Solver,
    closed: bool,
    steering: Steering,
    /// Indices in the schedule of the drivers that are driven: those that are independent.
    own: Vec<usize>,
    /// Joint values of the last frame, or of the start, rad or shares of the size.
    theta: Vec<f64>,
    /// The last frame has the values of its time.
    met: bool,
    t: Trajectory,
    /// Runs of frames that stop short of their values.
    ends: Vec<Ended>,
    choices: Vec<Warning>,
    singularity: Singularity,
}

/// Frames that stop short for the same reason.
#[derive(Clone, Debug)]
struct Ended {
    first: usize,
    last: usize,
    time: f64,
    why: DriveEnd,
    driven: Vec<(usize, f64)>,
}

impl Planning {
    /// Closes the loops at the joint values `start` (rad or lengths), which choose the branch; no frame is planned yet.
    /// `extent` stands in for the size of a mechanism without lengths.
    ///
    /// # Panics
    /// When `start` does not have one value a joint variable, or the schedule drives a variable that is not there.
    pub fn new(
        mechanism: &Mechanism,
        start: &[f64],
        schedule: &Schedule,
        extent: f64,
        settings: &Settings,
    ) -> Self {
        assert_eq!(
            start.len(),
            mechanism.variables(),
            "one start value a joint variable"
        );
        // There is no distance that a method or a metric would lower.
        let settings = settings.by_newton();
        let mut solver = settings.solver(mechanism, extent);
        let mut t = begin(mechanism, &solver, extent, &settings);
        t.warnings.clear();
        t.drivers = schedule.variables();
        let mut joints = start.to_vec();
        given::move_within_limits(mechanism, &mut joints, extent, &mut t.warnings);
        let closed = given::close_start(&mut solver, &mut joints, &settings, &mut t.warnings);
        t.mobility_rank = solver.mobility(&joints).0;
        if closed && t.mobility_rank.cast_signed() != t.mobility_count {
            let (count, rank) = (t.mobility_count, t.mobility_rank);
            t.warnings.push(Warning::MobilityDiffers { count, rank });
        }
        t.start.clone_from(&joints);
        let theta = solver.scaled().entered(&joints);
        let near = if closed {
            positions_near(&mut solver, &theta)
        } else {
            Vec::new()
        };
        let variables = schedule.variables();
        let driven = if closed {
            driven(&mut solver, &variables, &theta, &near, &mut t.warnings)
        } else {
            variables.clone()
        };
        let (scaled, closer, _) = solver.parts();
        let steering = Steering::new(scaled, closer, &driven, &theta, &near);
        Self {
            schedule: schedule.clone(),
            own: (0..variables.len())
                .filter(|&i| driven.contains(&variables[i]))
                .collect(),
            solver,
            closed,
            steering,
            theta,
            met: false,
            t,
            ends: Vec::new(),
            choices: Vec::new(),
            singularity: Singularity::default(),
        }
    }

    /// Frames in all.
    pub fn frames(&self) -> usize {
        self.schedule.frames
    }

    /// Frames planned so far.
    pub fn done(&self) -> usize {
        self.t.frames()
    }

    /// Plans one more frame, or computes what is left of the report; false when there is nothing left.
    pub fn advance(&mut self) -> bool {
        let frame = self.done();
        if frame < self.frames() {
            self.plan_frame(frame);
        }
        let left = self.singularity.advance(&mut self.t, &mut self.solver);
        self.done() < self.frames() || left
    }

    /// The frames planned so far as a motion with its report.
    pub fn so_far(&self) -> Trajectory {
        self.clone().report()
    }

    /// Plans the rest; the whole motion.
    pub fn finish(mut self) -> Trajectory {
        while self.advance() {}
        self.report()
    }

    fn plan_frame(&mut self, frame: usize) {
        let time = self.schedule.time(frame);
        let before = self.solver.scaled().left(&self.theta);
        let mut joints = before.clone();
        let mut solved = Solved::OPEN;
        if self.closed {
            let at = self.steering.driven(&self.theta);
            let obstacle = self.drive(frame, time);
            if self.steering.take_choice() {
                let driven = self.named(&at);
                self.choices.push(Warning::BranchChosen { frame, driven });
            }
            self.solver.scaled().leave(&self.theta, &mut joints);
            let end = self.end(frame, time, obstacle, &mut joints);
            solved = Solved {
                end,
                reached: end == End::Minimum,
                value: 0.0,
                projected_gradient: f64::NAN,
                iterations: self.steering.take_iterations(),
            };
        }
        self.keep(time, &before, &joints, &solved);
    }

    /// Drives the joints to their values at `time`, as far as they go.
    fn drive(&mut self, frame: usize, time: f64) -> Option<Obstacle> {
        let (schedule, own) = (&self.schedule, &self.own);
        let limits = self.solver.scaled().limits().to_vec();
        let (turns, unit) = (
            self.solver.scaled().turns().to_vec(),
            self.solver.scaled().unit(),
        );
        let variables = self.steering.variables().to_vec();
        // Up to the driven joints' own limits, in the solver's unit.
        let wanted = |time: f64| -> Vec<f64> {
            let values = schedule.values(time);
            let pairs = own.iter().zip(&variables);
            pairs
                .map(|(&i, &v)| {
                    let value = if turns[v] {
                        values[i]
                    } else {
                        values[i] / unit
                    };
                    value.max(limits[v].min).min(limits[v].max)
                })
                .collect()
        };
        let (scaled, closer, _) = self.solver.parts();
        let mut obstacle = None;
        if self.met && frame > 0 {
            // As the drivers go, from one of their values to the next.
            let mut from = schedule.time(frame - 1);
            let mut to = schedule.breaks(from, time);
            to.push(time);
            for to in to {
                let path = |part: f64| {
                    wanted(if part < 1.0 {
                        from + part * (to - from)
                    } else {
                        to
                    })
                };
                obstacle = self.steering.follow(scaled, closer, &mut self.theta, &path);
                if obstacle.is_some() {
                    break;
                }
                from = to;
            }
        }
        if !self.met || obstacle.is_some() {
            let target = wanted(time);
            let mut straight = |theta: &mut Vec<f64>, only: Option<usize>| {
                let from = self.steering.driven(theta);
                let path = |part: f64| -> Vec<f64> {
                    let pairs = from.iter().zip(&target).enumerate();
                    pairs
                        .map(|(i, (from, to))| match only {
                            Some(own) if own != i => *from,
                            _ if part < 1.0 => from + part * (to - from),
                            _ => *to,
                        })
                        .collect()
                };
                self.steering.follow(scaled, closer, theta, &path)
            };
            obstacle = straight(&mut self.theta, None);
            if obstacle.is_some() && target.len() > 1 {
                // Some of them may go on where all together cannot.
                for only in 0..target.len() {
                    straight(&mut self.theta, Some(only));
                }
                obstacle = straight(&mut self.theta, None);
            }
        }
        self.met = obstacle.is_none();
        obstacle
    }

    /// How the frame ends; keeps the reason where it stops short. Values that are met are put exactly.
    fn end(
        &mut self,
        frame: usize,
        time: f64,
        obstacle: Option<Obstacle>,
        joints: &mut [f64],
    ) -> End {
        let scaled = self.solver.scaled();
        let asked = self.schedule.values(time);
        let variables = self.schedule.variables();
        let mut missed = Vec::new();
        for (&variable, &value) in variables.iter().zip(&asked) {
            let unit = if scaled.turns()[variable] {
                1.0
            } else {
                scaled.unit()
            };
            if (joints[variable] - value).abs() <= REACHED * unit {
                if self.steering.variables().contains(&variable) {
                    // Without the rounding of the change of units; the loops stay closed.
                    joints[variable] = value;
                }
            } else {
                missed.push(variable);
            }
        }
        if missed.is_empty() {
            return End::Minimum;
        }
        let why = match obstacle {
            None => {
                let own = missed
                    .iter()
                    .copied()
                    .filter(|v| self.steering.variables().contains(v));
                let own: Vec<usize> = own.collect();
                if own.is_empty() {
                    // A driver that depends on the others: told once, of the whole motion.
                    return End::Stalled;
                }
                DriveEnd::OwnLimit(own)
            }
            Some(Obstacle::OwnLimit) => DriveEnd::OwnLimit(missed),
            Some(Obstacle::Limits(held)) => DriveEnd::Limits(held),
            Some(Obstacle::DeadPoint | Obstacle::Open) => DriveEnd::DeadPoint,
            Some(Obstacle::Immobile) => DriveEnd::Immobile,
            Some(Obstacle::TooFar) => DriveEnd::TooFar,
        };
        let end = match why {
            DriveEnd::OwnLimit(_) | DriveEnd::Limits(_) => End::MinimumAtLimit,
            DriveEnd::DeadPoint | DriveEnd::Immobile | DriveEnd::TooFar => End::Stalled,
        };
        match self.ends.last_mut() {
            Some(run) if run.last + 1 == frame && run.why == why => run.last = frame,
            _ => {
                let driven = self.steering.variables().iter().map(|&v| (v, joints[v]));
                self.ends.push(Ended {
                    first: frame,
                    last: frame,
                    time,
                    why,
                    driven: driven.collect(),
                });
            }
        }
        end
    }

    /// The driven variables with these values, which are in the solver's unit.
    fn named(&self, values: &[f64]) -> Vec<(usize, f64)> {
        let scaled = self.solver.scaled();
        let pairs = self.steering.variables().iter().zip(values);
        pairs
            .map(|(&v, &x)| {
                (
                    v,
                    if scaled.turns()[v] {
                        x
                    } else {
                        x * scaled.unit()
                    },
                )
            })
            .collect()
    }

    fn keep(&mut self, time: f64, before: &[f64], joints: &[f64], solved: &Solved) {
        // The pose is its own goal while it is recorded; then there is none.
        let scaled = self.solver.scaled();
        let pose = scaled.leave_pose(&scaled.chains()[0].pose(&scaled.entered(joints)));
        let goal = Goal { time, pose };
        let t = &mut self.t;
        record(t, &mut self.solver, &goal, before, joints, solved);
        let frame = t.frames() - 1;
        t.goals[frame] = Pose::from_parts(
            Translation3::new(f64::NAN, f64::NAN, f64::NAN),
            UnitQuaternion::new_unchecked(Quaternion::new(f64::NAN, f64::NAN, f64::NAN, f64::NAN)),
        );
        for column in [
            &mut t.metric,
            &mut t.translation_gap,
            &mut t.rotation_gap,
            &mut t.projected_gradient,
        ] {
            column[frame] = f64::NAN;
        }
    }

    fn report(mut self) -> Trajectory {
        std::mem::take(&mut self.singularity).finish(&mut self.t, &mut self.solver);
        warn_of_rounded(&mut self.t, &mut self.solver);
        self.t.warnings.append(&mut self.choices);
        let ends = self.ends.into_iter().map(|run| Warning::DriveEnds {
            first: run.first,
            last: run.last,
            time: run.time,
            why: run.why,
            driven: run.driven,
        });
        self.t.warnings.extend(ends);
        self.t
    }
}
