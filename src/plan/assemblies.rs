//! All ways to assemble a linkage at a key frame: its assembly modes there.
//!
//! With the workpiece at a pose the chains do not depend on each other: each has its own configurations, which starts at random
//! find, and every combination is a way. Where the goal cannot be met, the ways at the closest pose known go on to their own
//! closest poses, and positions drawn anew are closed and moved there too. Ways differ where a link is at another place and
//! no chain can go from the one to the other while the workpiece stands still.

use crate::math::metric::MetricKind;
use crate::math::pose::Pose;
use crate::math::random::Random;
use crate::model::mechanism::Mechanism;
use crate::model::scaled::Scaled;
use crate::motion::goal::Goal;
use crate::motion::trajectory::Trajectory;
use crate::plan::follow::Planning;
use crate::plan::found::Cost;
use crate::plan::one_chain::Part;
use crate::plan::places::Places;
use crate::plan::seeds::Variable;
use crate::plan::settings::{Settings, extent};
use crate::plan::unseen::Unseen;
use crate::solve::solver::Solver;

/// Combinations that are tried at one pose.
pub(super) const MOST: usize = 512;
pub(super) const AT_A_TIME: usize = 16;
/// Poses whose combinations are tried where the goal cannot be met, and positions drawn anew.
const POSES: usize = 6;
const DRAWN: usize = 48;

/// A way to assemble.
#[derive(Clone, Debug)]
pub struct Mode {
    /// Joint values at the key frame, rad or lengths.
    pub joints: Vec<f64>,
    /// The workpiece there.
    pub pose: Pose,
    /// f there.
    pub value: f64,
    /// Whether the goal is met.
    pub reached: bool,
    /// Starts that led to it: of the chain with the fewest.
    pub starts: usize,
    /// Whether the motion planned from the document's start is in it.
    pub is_start: bool,
    /// The motion planned from it: its cost, and its certified frames.
    pub planned: Option<(Cost, usize)>,
    pub(super) theta: Vec<f64>,
    pub(super) axes: Vec<f64>,
    /// Positions that came to it, and whether its pose's configurations were looked for.
    pub(super) met: usize,
    pub(super) used: bool,
}

/// One configuration of a chain at a pose.
#[derive(Clone, Debug)]
pub(super) struct Configuration {
    pub own: Vec<f64>,
    pub starts: usize,
}

/// What is done next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// One chain's configurations at the pose.
    Chain(usize),
    /// Their combinations, from this one on.
    Combine(usize),
    /// Positions drawn anew.
    Draw(usize),
    /// A motion from each way.
    Plan(usize),
    Done,
}

/// The search, in portions.
pub struct Assemblies {
    mechanism: Mechanism,
    pub(super) goals: Vec<Goal>,
    pub(super) frame: usize,
    pub(super) settings: Settings,
    pub(super) solver: Solver,
    pub(super) anywhere: Solver,
    pub(super) places: Places,
    pub(super) parts: Vec<Part>,
    pub(super) variables: Vec<Vec<Variable>>,
    /// Of the motion from the document's start, at the frame.
    pub(super) start: Option<Vec<f64>>,
    pub(super) random: Random,
    pub(super) pose: Pose,
    /// Poses whose combinations were tried.
    pub(super) poses: usize,
    pub(super) configurations: Vec<Vec<Configuration>>,
    pub(super) arrived: Vec<usize>,
    /// Of the first pose's chains.
    pub(super) unseen: Vec<Unseen>,
    pub(super) starts: usize,
    /// Positions that came to a closest pose, and combinations at the first pose.
    pub(super) taken: usize,
    pub(super) combinations: usize,
    pub(super) modes: Vec<Mode>,
    stage: Stage,
    planning: Option<Box<Planning>>,
}

impl Assemblies {
    /// For the goal of frame `frame`. `followed` is the motion planned from the document's start.
    ///
    /// # Panics
    /// When there is no such frame.
    pub fn new(
        mechanism: &Mechanism,
        goals: &[Goal],
        frame: usize,
        settings: &Settings,
        followed: &Trajectory,
    ) -> Self {
        let settings = settings.by_newton();
        let extent = extent(goals);
        let mut solver = settings.solver(mechanism, extent);
        let mut closed = followed.start.clone();
        let is_closed = solver
            .close_start(&mut closed, settings.dimension_tolerance)
            .is_closed();
        let scaled = solver.scaled().clone();
        let (mut parts, mut variables) = (Vec::new(), Vec::new());
        let mut first = 0;
        let alone = Settings {
            metric: MetricKind::Pose,
            metric_length: Some(1.0),
            metric_origin: None,
            ..settings
        };
        for (chain, unscaled) in scaled.chains().iter().zip(mechanism.chains()) {
            let range = first..first + chain.freedoms();
            first = range.end;
            let one = Mechanism::new(vec![chain.clone()]).expect("one chain is a mechanism");
            parts.push(Part {
                chain: chain.clone(),
                solver: alone.solver(&one, 1.0),
                range,
                given: false,
            });
            variables.push(Variable::of(chain, unscaled, scaled.unit(), false));
        }
        let at = followed.frames() > frame && is_closed;
        let start = at.then(|| scaled.entered(followed.joints_at(frame)));
        let pose = scaled.enter_pose(&goals[frame].pose);
        Self {
            places: Places::new(mechanism, &scaled),
            mechanism: mechanism.clone(),
            goals: goals.to_vec(),
            frame,
            settings,
            anywhere: solver.clone(),
            solver,
            configurations: vec![Vec::new(); parts.len()],
            arrived: vec![0; parts.len()],
            parts,
            variables,
            start,
            random: Random::new(88),
            pose,
            poses: 0,
            unseen: Vec::new(),
            starts: 0,
            taken: 0,
            combinations: 1,
            modes: Vec::new(),
            stage: Stage::Chain(0),
            planning: None,
        }
    }

    /// Some starts of one chain, some combinations, or a frame of a motion; false when there is nothing left.
    pub fn advance(&mut self) -> bool {
        match self.stage {
            Stage::Chain(chain) => {
                self.configure(chain);
                self.stage = if chain + 1 < self.parts.len() {
                    Stage::Chain(chain + 1)
                } else {
                    Stage::Combine(0)
                };
            }
            Stage::Combine(first) => {
                self.stage = if self.combine(first) {
                    Stage::Combine(first + AT_A_TIME)
                } else {
                    self.poses += 1;
                    self.next_pose()
                };
            }
            Stage::Draw(count) => {
                self.draw();
                self.stage = if count + 1 < DRAWN {
                    Stage::Draw(count + 1)
                } else {
                    self.next_pose()
                };
            }
            Stage::Plan(number) => {
                if number >= self.modes.len() {
                    self.rank();
                    self.stage = Stage::Done;
                } else if self.plan(number) {
                    self.stage = Stage::Plan(number + 1);
                }
            }
            Stage::Done => return false,
        }
        self.stage != Stage::Done
    }

    /// Does all that is left.
    pub fn finish(&mut self) -> &[Mode] {
        while self.advance() {}
        &self.modes
    }

    /// The ways found so far: the nearest first; when all are planned, those whose motions are closest on average.
    pub fn modes(&self) -> &[Mode] {
        &self.modes
    }

    /// Starts made so far, each of one chain or of a whole position.
    pub fn starts(&self) -> usize {
        self.starts
    }

    /// An estimate of the starts that would lead to configurations that are not known: a way is not known where one of its
    /// chains' is not. Where the goal cannot be met it is that of the positions drawn anew.
    pub fn unseen(&self) -> Unseen {
        if self.poses > 0 && !self.modes.iter().any(|mode| mode.reached) {
            return Unseen::of(self.modes.iter().map(|mode| mode.met), self.taken);
        }
        let seen =
            |part: fn(&Unseen) -> f64| self.unseen.iter().map(|u| 1.0 - part(u)).product::<f64>();
        if self.unseen.is_empty() {
            return Unseen::of(std::iter::empty(), 0);
        }
        // Of combinations that were left out nothing is known.
        let tried = (MOST as f64 / self.combinations as f64).min(1.0);
        Unseen {
            share: 1.0 - tried * seen(|u| u.share),
            bound: 1.0 - tried * seen(|u| u.bound),
        }
    }

    /// From 0 to 1; the search is the first half, planning the second.
    pub fn progress(&self) -> f64 {
        let all = self.parts.len() + 1;
        match self.stage {
            Stage::Chain(chain) if self.poses == 0 => 0.5 * chain as f64 / all as f64,
            Stage::Combine(_) if self.poses == 0 => 0.5 * (all - 1) as f64 / all as f64,
            Stage::Chain(_) | Stage::Combine(_) | Stage::Draw(_) => 0.5,
            Stage::Plan(number) => 0.5 + 0.5 * number as f64 / self.modes.len().max(1) as f64,
            Stage::Done => 1.0,
        }
    }

    /// What follows the combinations at a pose, or the positions drawn anew.
    fn next_pose(&mut self) -> Stage {
        let reached = self.modes.iter().any(|mode| mode.reached);
        if reached {
            self.modes.retain(|mode| mode.reached);
            return Stage::Plan(0);
        }
        // Where no chain comes to the goal, other positions.
        if self.poses == 1 && matches!(self.stage, Stage::Combine(_)) {
            return Stage::Draw(0);
        }
        let next = self.modes.iter_mut().find(|mode| !mode.used);
        match next.filter(|_| self.poses <= POSES) {
            Some(mode) => {
                mode.used = true;
                self.pose = self.solver.scaled().chains()[0].pose(&mode.theta);
                Stage::Chain(0)
            }
            None => Stage::Plan(0),
        }
    }

    /// A frame of the motion from a way; true when it is planned.
    fn plan(&mut self, number: usize) -> bool {
        let mut planning = self.planning.take().unwrap_or_else(|| {
            let start = &self.modes[number].joints;
            Box::new(Planning::new(
                &self.mechanism,
                start,
                &self.goals,
                &self.settings,
            ))
        });
        if planning.advance() {
            self.planning = Some(planning);
            return false;
        }
        let t = planning.finish();
        let scaled: &Scaled = self.solver.scaled();
        let certified = t.status.iter().filter(|s| s.is_certified()).count();
        self.modes[number].planned = Some((Cost::of(&t, scaled), certified));
        true
    }

    /// Those whose motions have most certified frames, and of these the closest on average, first.
    fn rank(&mut self) {
        let key = |mode: &Mode| {
            mode.planned
                .map_or((0, f64::INFINITY), |(cost, n)| (n, cost.mean))
        };
        self.modes.sort_by(|a, b| {
            let ((n, mean), (m, other)) = (key(a), key(b));
            m.cmp(&n).then(mean.total_cmp(&other))
        });
    }
}
