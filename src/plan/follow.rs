//! A motion, frame by frame: the start closed, each frame solved from an extrapolation of those before, leaps and
//! runaways checked, a report.

use crate::math::pose::Pose;
use crate::model::joint::Limits;
use crate::model::mechanism::Mechanism;
use crate::motion::goal::Goal;
use crate::motion::trajectory::{Trajectory, Warning};
use crate::plan::elsewhere::{self, Runaway};
use crate::plan::given;
use crate::plan::leaps::{self, Leap};
use crate::plan::predict::predict;
use crate::plan::record::{Singularity, begin, record, warn_of_rounded};
use crate::plan::settings::{IS_FIRST, Settings, extent};
use crate::solve::gradient;
use crate::solve::solver::{End, Solved, Solver};

/// How far f may be above the minimum in a certified answer of the gradient planner: twice what its
/// stopping rule leaves in the flattest directions met.
const GRADIENT_FALL: f64 = 2e-8;

/// Most gradient steps before other questions are let in between: at 24 chains, the most there may be, 0.1 s as
/// WebAssembly (median of portions, on two loaded cores), where a whole frame took 2.3 s.
const GRADIENT_PORTION: usize = 50;

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
    Planning::new(mechanism, start, goals, settings).finish()
}

/// A plan in portions: frame by frame, and at any time what there is so far.
///
/// ```
/// # use synthetica::document::{problem::Problem, text};
/// # let text = include_str!("../../www/mechanisms/3rps.json");
/// # let problem = Problem::new(&text::parse(text)?)?;
/// use synthetica::plan::follow::Planning;
///
/// let start = problem.find_start();
/// let mut planning = Planning::new(&problem.mechanism, &start, &problem.goals, &problem.settings);
/// while planning.done() < 10 && planning.advance() {}
/// assert_eq!(planning.so_far().frames(), 10);
/// assert_eq!(planning.finish().frames(), problem.goals.len());
/// # Ok::<(), synthetica::document::fault::Fault>(())
/// ```
#[derive(Clone, Debug)]
pub struct Planning {
    mechanism: Mechanism,
    goals: Vec<Goal>,
    settings: Settings,
    solver: Solver,
    closed: bool,
    /// Joint values of the last frame, or of the start.
    joints: Vec<f64>,
    predicted: Vec<f64>,
    t: Trajectory,
    /// Intervals between frames that were looked at for leaps.
    checked: usize,
    leaps: Vec<Leap>,
    runaways: Vec<Runaway>,
    is_for_whole: bool,
    /// The first frame at which the next search for a finite pose may be made: searches are slow, and get rarer.
    search_from: usize,
    searches: usize,
    /// The gradient method at a frame that takes long.
    descent: Option<gradient::Running>,
    singularity: Singularity,
}

impl Planning {
    /// Closes the loops at the start; no frame is planned yet.
    ///
    /// # Panics
    /// When `start` does not have one value a joint variable.
    pub fn new(mechanism: &Mechanism, start: &[f64], goals: &[Goal], settings: &Settings) -> Self {
        assert_eq!(
            start.len(),
            mechanism.variables(),
            "one start value a joint variable"
        );
        let extent = extent(goals);
        let mut solver = settings.solver(mechanism, extent);
        let mut t = begin(mechanism, &solver, extent, settings);
        let mut joints = start.to_vec();
        given::move_within_limits(mechanism, &mut joints, extent, &mut t.warnings);
        let mut closed = given::close_start(&mut solver, &mut joints, settings, &mut t.warnings);
        t.mobility_rank = solver.mobility(&joints).0;
        if closed && t.mobility_rank.cast_signed() != t.mobility_count {
            let (count, rank) = (t.mobility_count, t.mobility_rank);
            t.warnings.push(Warning::MobilityDiffers { count, rank });
        }
        if settings.is_gradient() {
            if solver.scaled().limits().iter().any(|l| *l != Limits::NONE) {
                t.warnings.push(Warning::LimitsUnknown);
            }
            if closed && solver.closer().dependence().is_rounded() {
                t.warnings.push(Warning::RoundedUnknown);
                closed = false;
            }
        }
        t.start.clone_from(&joints);
        Self {
            mechanism: mechanism.clone(),
            goals: goals.to_vec(),
            settings: *settings,
            solver,
            closed,
            predicted: joints.clone(),
            joints,
            t,
            checked: 0,
            leaps: Vec::new(),
            runaways: Vec::new(),
            is_for_whole: false,
            search_from: 0,
            searches: 0,
            descent: None,
            singularity: Singularity::default(),
        }
    }

    /// The same plan with these warnings before its own.
    pub fn noted(mut self, notes: &[Warning]) -> Self {
        let own = std::mem::replace(&mut self.t.warnings, notes.to_vec());
        self.t.warnings.extend(own);
        self
    }

    /// Frames in all.
    pub fn frames(&self) -> usize {
        self.goals.len()
    }

    /// Frames planned so far.
    pub fn done(&self) -> usize {
        self.t.frames()
    }

    /// Plans one more frame, or a portion of one by the gradient method, or computes what is left of the report; false
    /// when there is nothing left. The last frames may be taken back and planned again where a leap shows, so that
    /// [`Planning::done`] falls.
    pub fn advance(&mut self) -> bool {
        let frame = self.done();
        if frame < self.frames() {
            if self.settings.is_gradient() && self.closed && self.descend(frame) {
                return true;
            }
            let scaled = self.solver.scaled();
            predict(scaled, &self.t.joints, &self.joints, &mut self.predicted);
            let before = self.joints.clone();
            let solved = self.solve(frame);
            self.keep(frame, &before, &solved);
            self.check_leaps();
        }
        let left = self.singularity.advance(&mut self.t, &mut self.solver);
        self.done() < self.frames() || left
    }

    /// In the package that a page loads first: a slider runs away, and the whole one plans the motion, since it looks for a
    /// finite pose.
    pub fn is_for_whole(&self) -> bool {
        self.is_for_whole
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

    fn solve(&mut self, frame: usize) -> Solved {
        let goal = self.goals[frame].pose;
        if !self.closed {
            return Solved::OPEN;
        }
        if self.settings.is_gradient() {
            return self.descended(&goal);
        }
        let solved = self.solver.solve(&goal, &mut self.joints, &self.predicted);
        if solved.end == End::Runaway {
            self.search(frame, solved)
        } else {
            solved
        }
    }

    /// Where the steps that `descend` took have led.
    fn descended(&mut self, goal: &Pose) -> Solved {
        let Some(running) = self.descent.take() else {
            return Solved::OPEN;
        };
        let before = self.joints.clone();
        let descent = running.leave(&mut self.joints);
        let certified = self
            .solver
            .certify(goal, &before, &self.joints, GRADIENT_FALL);
        Solved {
            // Where rounding keeps f from falling the slope may stay above the one at which the method stops.
            end: if descent.projected_gradient <= gradient::CERTIFIED {
                certified.end
            } else {
                End::Stalled
            },
            iterations: descent.iterations,
            projected_gradient: descent.projected_gradient,
            ..certified
        }
    }

    /// A portion of the gradient method's steps at a frame; true where there are more to take.
    fn descend(&mut self, frame: usize) -> bool {
        let running = self.descent.get_or_insert_with(|| {
            let rotation = self.mechanism.chains()[0].pose(&self.joints).rotation;
            let target = (self.t.metric_used).target(&self.goals[frame].pose, &rotation);
            gradient::Running::new(&self.mechanism, &target, &self.joints)
        });
        let most = self.settings.iterations();
        let portion = most.min(running.iterations() + GRADIENT_PORTION);
        running.advance(portion, &mut |_| {}) && portion < most
    }

    fn keep(&mut self, frame: usize, before: &[f64], solved: &Solved) {
        record(
            &mut self.t,
            &mut self.solver,
            &self.goals[frame],
            before,
            &self.joints,
            solved,
        );
    }

    /// Looks for a finite closest pose where a slider runs away, from positions that closed walks join to this one; where
    /// there is none, the warning says whether another assembly has one.
    fn search(&mut self, frame: usize, runaway: Solved) -> Solved {
        /// Searches of one motion: each takes as long as a few hundred frames.
        const MOST: usize = 8;
        if IS_FIRST {
            self.is_for_whole = true;
            return runaway;
        }
        let goal = self.goals[frame].pose;
        let searched = frame >= self.search_from && self.searches < MOST;
        let joined = searched.then(|| {
            self.searches += 1;
            self.search_from = frame + (1 << self.searches);
            elsewhere::joined(&mut self.solver, &self.joints, &goal)
        });
        if let Some((joints, solved)) = joined.flatten() {
            let leap = Leap::between(self.solver.scaled(), &self.joints, &joints);
            if frame > 0 {
                let time = self.goals[frame].time;
                self.leaps.push(Leap {
                    first: frame - 1,
                    time,
                    ..leap
                });
            }
            self.joints = joints;
            return solved;
        }
        let elsewhere = searched
            && elsewhere::another_assembly(
                &self.mechanism,
                &goal,
                &self.settings,
                extent(&self.goals),
                runaway.value,
            );
        Runaway::add(&mut self.runaways, frame, searched, elsewhere);
        runaway
    }

    /// Checks the intervals whose neighbours are known. Where short steps through an interval lead to another branch than
    /// the planned one, its end is replaced and the frames after it are taken back.
    fn check_leaps(&mut self) {
        let known = if self.done() == self.frames() {
            self.done()
        } else {
            self.done().saturating_sub(leaps::NEIGHBOURS)
        };
        while self.checked + 1 < known {
            let first = self.checked;
            self.checked += 1;
            // The leap away from a runaway has its warning already.
            let told = self.leaps.iter().any(|leap| leap.first == first);
            if !self.closed || told || !leaps::is_suspicious(&self.t, self.solver.scaled(), first) {
                continue;
            }
            let (from, to) = (self.goals[first], self.goals[first + 1]);
            // The present stops are those of the last frame; those of this one are not known any more.
            let holding = self.solver.holding().clone();
            self.solver.clear_holding();
            if leaps::goes_as_its_ends(&mut self.solver, &self.t, first, &from, &to) {
                self.solver.set_holding(holding);
                continue;
            }
            self.solver.clear_holding();
            let Some(traced) = leaps::trace(&mut self.solver, &self.t, first, &from, &to) else {
                self.solver.set_holding(holding);
                continue;
            };
            let scaled = self.solver.scaled();
            let other = Leap::between(scaled, self.t.joints_at(first + 1), &traced.joints);
            let leaps = traced.leaps.iter().map(|leap| Leap { first, ..*leap });
            if other.moved_scaled < leaps::LEAP {
                self.leaps.extend(leaps);
                self.solver.set_holding(holding);
                continue;
            }
            if self.settings.is_gradient() {
                // The gradient planner keeps the branch that it came to; the leap gets a warning.
                let whole =
                    Leap::between(scaled, self.t.joints_at(first), self.t.joints_at(first + 1));
                self.leaps.push(Leap {
                    first,
                    time: to.time,
                    ..whole
                });
                self.solver.set_holding(holding);
                continue;
            }
            self.leaps.retain(|leap| leap.first < first);
            self.leaps.extend(leaps);
            Runaway::keep_to(&mut self.runaways, first);
            let before = self.t.joints_at(first).to_vec();
            self.t.truncate(first + 1);
            self.joints = traced.joints;
            self.keep(first + 1, &before, &traced.solved);
            return;
        }
    }

    fn report(mut self) -> Trajectory {
        std::mem::take(&mut self.singularity).finish(&mut self.t, &mut self.solver);
        warn_of_rounded(&mut self.t, &mut self.solver);
        let leaps = self.leaps.iter().map(Leap::warning);
        self.t.warnings.extend(leaps);
        let runaways = self.runaways.iter().map(Runaway::warning);
        self.t.warnings.extend(runaways);
        self.t
    }
}

#[cfg(test)]
mod tests {
    use crate::document::{problem::Problem, text};
    use crate::plan::follow::GRADIENT_PORTION;
    use crate::plan::settings::Method;
    use crate::solve::gradient;

    /// That they end where the method in one go ends is a test of tests/trace.rs.
    #[test]
    fn gradient_steps_of_one_frame_go_in_portions() {
        let text = include_str!("../../www/mechanisms/3rps.json");
        let mut problem = Problem::new(&text::parse(text).expect("a document")).expect("a problem");
        problem.settings.method = Method::Gradient;
        problem.goals.truncate(20);
        let mut planning = super::Planning::new(
            &problem.mechanism,
            &problem.find_start(),
            &problem.goals,
            &problem.settings,
        );
        let (mut portions, mut longest, mut before) = (0, 0, 0);
        while planning.advance() {
            portions += 1;
            let steps = planning
                .descent
                .as_ref()
                .map_or(0, gradient::Running::iterations);
            longest = longest.max(steps.saturating_sub(before));
            before = steps;
        }
        assert_eq!(planning.done(), 20);
        assert!(portions > 20, "{portions} portions");
        assert_eq!(longest, GRADIENT_PORTION);
    }
}
