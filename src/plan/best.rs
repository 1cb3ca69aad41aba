//! The best motion: of all motions over the branches that closed walks join to the start, the one whose frames are closest
//! on average to their goals.
//!
//! What is known of it: every point of its path is closed; no motion over the branches known is closer than the mean of the
//! least f of every frame; and an estimate by Good and Turing of the starts that would lead to a branch not known.

use crate::math::pose::Pose;
use crate::model::mechanism::Mechanism;
use crate::model::scaled::Scaled;
use crate::motion::goal::Goal;
use crate::motion::trajectory::{Status, Trajectory};
use crate::plan::branches::Branches;
use crate::plan::calm::Calming;
use crate::plan::places::Form;
use crate::plan::record::{Singularity, begin, record, warn_of_rounded};
use crate::plan::route::Route;
use crate::plan::settings::{Method, Settings, extent};
use crate::plan::unseen::Unseen;
use crate::plan::walk;

/// Starts of a round from each of the frames that [`Branches::start_slots`] names; after each round the best motion so far
/// is known.
const STARTS: usize = 8;
/// One start of so many is from anywhere.
const ANYWHERE: usize = 3;
/// Rounds that are made, and those that are made where the last one found a better motion or where more than this share of
/// the starts led to a branch that no other led to.
const ROUNDS: usize = 3;
const MOST_ROUNDS: usize = 6;
const UNSEEN: f64 = 0.01;
/// Share by which the mean must fall for a motion to be a better one.
const BETTER: f64 = 1e-3;

/// Prices of calm that are looked at: so many, each a multiple of the one before. Of the mean square of the joints' speeds, in
/// rad and sizes a motion, in the unit of mean f.
const PRICES: usize = 8;
const FIRST_PRICE: f64 = 1e-9;
const NEXT_PRICE: f64 = 6.0;
/// How far f of a calm frame may fall nearby where it still is a closest pose.
const CALM_FALL: f64 = 1e-12;
/// Joint motion between two frames, root of squares, that is spread over frames to begin with, and how much a frame then has.
const SPREAD: f64 = 0.5;
const SHARE: f64 = 0.3;

/// A point of a closed motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The frame whose own point it is; none between frames.
    pub frame: Option<usize>,
    /// The frame whose goal it is measured against.
    pub towards: usize,
    /// Joint values, rad or lengths.
    pub joints: Vec<f64>,
    /// f against that goal.
    pub value: f64,
    /// Closure error and misfit, as published of frames.
    pub closure: f64,
}

/// How close a motion comes to its goals.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Mean of f over the frames.
    pub mean: f64,
    /// Largest f.
    pub largest: f64,
    /// Largest joint motion from one frame to the next, rad or sizes.
    pub largest_step: f64,
}

impl Cost {
    /// Of a motion.
    pub fn of(t: &Trajectory, scaled: &Scaled) -> Self {
        let step = |frame: usize| {
            let [a, b] = [frame, frame + 1].map(|i| scaled.entered(t.joints_at(i)));
            walk::largest(&a, &b)
        };
        Self {
            mean: t.metric.iter().sum::<f64>() / t.frames().max(1) as f64,
            largest: t.metric.iter().copied().fold(0.0, f64::max),
            largest_step: (1..t.frames()).map(|i| step(i - 1)).fold(0.0, f64::max),
        }
    }
}

/// A change of branch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Switch {
    /// It comes before this frame, while its goal stands; before frame 0 it comes after the start.
    pub frame: usize,
    /// The branches, as [`Found::lanes`] has them.
    pub from: usize,
    /// The branch behind it.
    pub to: usize,
    /// Joint motion on the way, root of squares, rad and sizes.
    pub length: f64,
    /// Largest f on the way.
    pub largest: f64,
    /// Points on the way, the frame's own included.
    pub points: usize,
}

/// A run of frames on one branch.
#[derive(Clone, Debug, PartialEq)]
pub struct Lane {
    /// Its first frame.
    pub first: usize,
    /// f, frame by frame.
    pub values: Vec<f64>,
}

/// The calm form of a motion at a price.
#[derive(Clone, Debug)]
pub struct Calm {
    /// The price of the mean square of the joints' speeds, in rad and sizes a motion, in the unit of mean f.
    pub price: f64,
    /// The motion; a frame that is no closest pose by itself is [`Status::Passing`].
    pub motion: Trajectory,
    /// How close it comes.
    pub cost: Cost,
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Found {
    /// The best motion, one frame a goal.
    pub motion: Trajectory,
    /// All its points; those between frames are closed as the frames are.
    pub path: Vec<Point>,
    /// How close it comes.
    pub cost: Cost,
    /// How close the followed motion comes.
    pub followed: Cost,
    /// Mean over the frames of the least f seen there.
    pub lower_bound: f64,
    /// The branches; the followed motion is the first.
    pub lanes: Vec<Lane>,
    /// The lane of each frame.
    pub lane: Vec<usize>,
    /// Changes of branch.
    pub switches: Vec<Switch>,
    /// Frames that the followed motion has no certified pose in, and this has.
    pub found_where_lost: Vec<usize>,
}

/// The search for the best motion, in portions.
#[derive(Clone, Debug)]
pub struct Search {
    mechanism: Mechanism,
    goals: Vec<Goal>,
    settings: Settings,
    followed: Trajectory,
    branches: Option<Branches>,
    route: Route,
    /// Slots from which starts are to be made in this round.
    waiting: Vec<usize>,
    /// Rounds that were begun.
    rounds: usize,
    /// The mean before the last round.
    before: f64,
    found: Option<Found>,
    /// The calm forms of the last price, from the best and the followed motion.
    calming: Vec<Calming>,
    curve: Vec<(f64, Cost)>,
    done: bool,
}

impl Search {
    /// For a motion that was planned by [`plan`](crate::plan::follow::plan).
    pub fn new(
        mechanism: &Mechanism,
        goals: &[Goal],
        settings: &Settings,
        followed: Trajectory,
    ) -> Self {
        let branches = Branches::new(mechanism, goals, settings, &followed);
        Self {
            mechanism: mechanism.clone(),
            goals: goals.to_vec(),
            settings: *settings,
            followed,
            done: branches.is_none(),
            branches,
            route: Route::default(),
            waiting: Vec::new(),
            rounds: 0,
            before: f64::INFINITY,
            found: None,
            calming: Vec::new(),
            curve: Vec::new(),
        }
    }

    /// One start, or one look for the best motion; false when there is nothing left.
    pub fn advance(&mut self) -> bool {
        if self.done {
            return false;
        }
        if self.calming.is_empty() {
            self.search();
            return true;
        }
        let price = FIRST_PRICE * NEXT_PRICE.powi(i32::try_from(self.curve.len()).unwrap_or(0));
        let mut calming = std::mem::take(&mut self.calming);
        if let Some(calm) = self.settle(&mut calming, price) {
            self.curve.push((price, calm.cost));
        }
        self.calming = calming;
        self.done = self.curve.len() >= PRICES;
        !self.done
    }

    /// One start, or one look for the best motion.
    fn search(&mut self) {
        let Some(branches) = self.branches.as_mut() else {
            return;
        };
        if let Some(slot) = self.waiting.pop() {
            if self.waiting.len().is_multiple_of(ANYWHERE) {
                branches.start_anywhere(slot);
            } else {
                branches.start_from(slot);
            }
            if self.waiting.is_empty() {
                branches.try_apart_again(&self.route.values(branches));
            }
        } else if !self.route.continue_branch(branches)
            && !self.route.reach_branch(branches)
            && self.route.advance(branches)
        {
            self.found = self.look();
            if !self.begin_round() {
                self.calming = self.begin_calm();
                self.done = self.calming.is_empty();
            }
        }
    }

    /// The best and the followed motion as positions, those between frames of the best one spread over frames.
    fn begin_calm(&self) -> Vec<Calming> {
        let (Some(branches), Some(found)) = (&self.branches, &self.found) else {
            return Vec::new();
        };
        let scaled = branches.solver.scaled();
        let entered = |t: &Trajectory| -> Vec<Vec<f64>> {
            (0..t.frames())
                .map(|i| scaled.entered(t.joints_at(i)))
                .collect()
        };
        let best = spread(scaled, &found.path, entered(&found.motion));
        let mut from = vec![Calming::new(&branches.solver, best)];
        if !found.switches.is_empty() {
            from.push(Calming::new(&branches.solver, entered(&self.followed)));
        }
        from
    }

    /// The calm form at a price: of those that are downhill from these motions the one whose frames are closest.
    fn settle(&mut self, from: &mut [Calming], price: f64) -> Option<Calm> {
        let branches = self.branches.as_mut()?;
        let goals: Vec<Pose> = self.goals.iter().map(|goal| goal.pose).collect();
        // With N frames the mean of f and the mean square of the speeds N |θ_{i+1} − θ_i| are N times less than the sums.
        let frames = goals.len() as f64;
        let mu = price * frames * frames;
        let solver = &mut branches.solver;
        let mut best: Option<(f64, usize)> = None;
        for (i, calming) in from.iter_mut().enumerate() {
            calming.settle(solver, &goals, mu);
            let far = calming.cost(solver, &goals, 0.0);
            if best.is_none_or(|(least, _)| far < least) {
                best = Some((far, i));
            }
        }
        let (_, best) = best?;
        let motion = self.published(from[best].theta())?;
        let scaled = self.branches.as_ref()?.solver.scaled();
        let cost = Cost::of(&motion, scaled);
        Some(Calm {
            price,
            motion,
            cost,
        })
    }

    /// Positions as a motion with its report.
    fn published(&mut self, theta: &[Vec<f64>]) -> Option<Trajectory> {
        let solver = &mut self.branches.as_mut()?.solver;
        let newton = Settings {
            method: Method::Newton,
            ..self.settings
        };
        let mut t = begin(&self.mechanism, solver, extent(&self.goals), &newton);
        t.mobility_rank = self.followed.mobility_rank;
        t.start.clone_from(&self.followed.start);
        let mut before = t.start.clone();
        for (goal, theta) in self.goals.iter().zip(theta) {
            let joints = solver.scaled().left(theta);
            let mut solved = solver.certify(&goal.pose, &joints, &joints, CALM_FALL);
            solved.value = solver.value(&goal.pose, &joints);
            record(&mut t, solver, goal, &before, &joints, &solved);
            if let Some(status) = t.status.last_mut().filter(|s| **s == Status::Stalled) {
                *status = Status::Passing;
            }
            before = joints;
        }
        Singularity::default().finish(&mut t, solver);
        warn_of_rounded(&mut t, solver);
        Some(t)
    }

    /// The calm form of what was found at a price; none before the search is done.
    pub fn calm(&mut self, price: f64) -> Option<Calm> {
        if !self.done {
            return None;
        }
        let mut from = self.begin_calm();
        // Step by step, as the curve was found: at once a high price may lead elsewhere.
        let mut step = FIRST_PRICE;
        while step < price {
            self.settle(&mut from, step);
            step *= NEXT_PRICE;
        }
        self.settle(&mut from, price)
    }

    /// The calm form whose largest joint step from frame to frame is `step` (rad or sizes) or less; none before the search
    /// is done, or where no price makes it so calm.
    pub fn calm_at_step(&mut self, step: f64) -> Option<Calm> {
        /// Halvings of the price's logarithm.
        const HALVINGS: usize = 12;
        let below = |(_, cost): &(f64, Cost)| cost.largest_step <= step;
        let high = self.curve.iter().find(|point| below(point))?.0;
        let (mut low, mut high) = (high / NEXT_PRICE, high);
        let mut best = self.calm(high)?;
        for _ in 0..HALVINGS {
            let middle = (low * high).sqrt();
            let calm = self.calm(middle)?;
            if calm.cost.largest_step <= step {
                high = middle;
                best = calm;
            } else {
                low = middle;
            }
        }
        Some(best)
    }

    /// Of each price the cost of the calm form; complete when the search is done.
    pub fn curve(&self) -> &[(f64, Cost)] {
        &self.curve
    }

    /// Begins another round of starts; false where there have been enough.
    fn begin_round(&mut self) -> bool {
        let mean = self.found.as_ref().map_or(0.0, |found| found.cost.mean);
        let better = mean < self.before * (1.0 - BETTER);
        self.before = mean;
        let more = match self.rounds {
            // Where all goals are reached nothing is closer.
            0 => self.followed.status.iter().any(|s| *s != Status::Reached),
            rounds if rounds < ROUNDS => true,
            rounds => rounds < MOST_ROUNDS && (better || self.unseen().share > UNSEEN),
        };
        if let Some(branches) = self.branches.as_ref().filter(|_| more) {
            let slots = branches.start_slots();
            self.waiting = std::iter::repeat_n(slots, STARTS).flatten().collect();
            self.rounds += 1;
        }
        more
    }

    /// Does all that is left; what was found, none where the loops of the followed motion do not close.
    pub fn finish(&mut self) -> Option<&Found> {
        while self.advance() {}
        self.found()
    }

    /// The best motion so far.
    pub fn found(&self) -> Option<&Found> {
        self.found.as_ref()
    }

    /// The motion that the planner follows.
    pub fn followed(&self) -> &Trajectory {
        &self.followed
    }

    /// How close it comes.
    pub fn followed_cost(&self) -> Cost {
        let scaled = Scaled::new(&self.mechanism, extent(&self.goals));
        Cost::of(&self.followed, &scaled)
    }

    /// From 0 to 1.
    pub fn progress(&self) -> f64 {
        if self.done {
            return 1.0;
        }
        let Some(branches) = &self.branches else {
            return 1.0;
        };
        let round = branches.start_slots().len() * STARTS;
        let made = (self.rounds * round).saturating_sub(self.waiting.len());
        // Rounds that may follow are not known before; the look for the best motion is short beside them.
        let all = ROUNDS.max(self.rounds) * round + STARTS;
        made as f64 / all as f64
    }

    /// What starts say of branches that are not known.
    pub fn unseen(&self) -> Unseen {
        let Some(branches) = &self.branches else {
            return Unseen::of(std::iter::empty(), 0);
        };
        Unseen::of(branches.list.iter().map(|b| b.starts), branches.arrived)
    }

    /// Starts made so far.
    pub fn starts(&self) -> usize {
        self.branches.as_ref().map_or(0, |branches| branches.starts)
    }

    /// The way that was found as a motion.
    fn look(&mut self) -> Option<Found> {
        let branches = self.branches.as_mut()?;
        let nodes = self.route.nodes();
        if nodes.is_empty() {
            return None;
        }
        let newton = Settings {
            method: Method::Newton,
            ..self.settings
        };
        let extent = extent(&self.goals);
        let mut t = begin(&self.mechanism, &branches.solver, extent, &newton);
        t.mobility_rank = self.followed.mobility_rank;
        let start = branches.nodes[0][0].theta.clone();
        t.start = branches.solver.scaled().left(&start);
        // Lane 0 has the whole followed motion.
        let lane_of = |branch: usize| (branch + 1).saturating_sub(branches.followed);
        let mut path = vec![Point {
            frame: None,
            towards: 0,
            joints: t.start.clone(),
            value: branches.nodes[0][0].solved.value,
            closure: 0.0,
        }];
        let (mut switches, mut lane) = (Vec::new(), Vec::new());
        let mut form = Form::same(start.len());
        let mut before = t.start.clone();
        for slot in 1..nodes.len() {
            let frame = slot - 1;
            let first = path.len();
            let mut length = 0.0;
            for edge in self.route.edges(branches, slot) {
                length += edge.walk.length;
                for point in &edge.walk.points {
                    let joints = branches.solver.scaled().left(&form.apply(point));
                    path.push(Point {
                        frame: None,
                        towards: frame,
                        value: branches.solver.value(branches.goal(slot), &joints),
                        joints,
                        closure: 0.0,
                    });
                }
                form = form.of(&edge.form);
            }
            let node = &branches.nodes[slot][nodes[slot]];
            let joints = branches.solver.scaled().left(&form.apply(&node.theta));
            record(
                &mut t,
                &mut branches.solver,
                &self.goals[frame],
                &before,
                &joints,
                &node.solved,
            );
            let last = path.last_mut().expect("the start is one");
            last.frame = Some(frame);
            last.value = t.metric[frame];
            lane.push(lane_of(node.branch));
            let from = branches.nodes[slot - 1][nodes[slot - 1]].branch;
            if self.route.changes(slot) {
                switches.push(Switch {
                    frame,
                    from: lane_of(from),
                    to: lane_of(node.branch),
                    length,
                    largest: path[first..].iter().map(|p| p.value).fold(0.0, f64::max),
                    points: path.len() - first,
                });
            }
            before = joints;
        }
        for point in &mut path {
            let (scaled, closer, _) = branches.solver.parts();
            let (closure, misfit) = closer.closure(scaled, &scaled.entered(&point.joints));
            point.closure = closure.max(misfit - self.settings.dimension_tolerance);
        }
        Singularity::default().finish(&mut t, &mut branches.solver);
        warn_of_rounded(&mut t, &mut branches.solver);
        let certified = |t: &Trajectory, frame: usize| t.status[frame].is_certified();
        let lost = (0..t.frames()).filter(|&i| certified(&t, i) && !certified(&self.followed, i));
        let joined = branches.joined();
        let least = |slot: usize| {
            let nodes = branches.nodes[slot].iter();
            let values = nodes
                .filter(|node| joined[node.branch])
                .map(|node| node.solved.value);
            // Where the way passes a pose that no walk joins to the start, it is known all the same.
            values.fold(t.metric[slot - 1], f64::min)
        };
        let scaled = branches.solver.scaled();
        Some(Found {
            cost: Cost::of(&t, scaled),
            followed: Cost::of(&self.followed, scaled),
            lower_bound: (1..branches.slots()).map(least).sum::<f64>() / t.frames() as f64,
            lanes: lanes(branches),
            lane,
            switches,
            found_where_lost: lost.collect(),
            path,
            motion: t,
        })
    }
}

/// The frames' positions, with those of a long way between two frames taken from all along the way.
fn spread(scaled: &Scaled, path: &[Point], mut theta: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let mut free = 1;
    let mut way: Vec<Vec<f64>> = Vec::new();
    for point in path {
        way.push(scaled.entered(&point.joints));
        let Some(frame) = point.frame else {
            continue;
        };
        let length: f64 = way.windows(2).map(|w| walk::distance(&w[0], &w[1])).sum();
        if length > SPREAD && frame > 0 {
            let half = index(libm::ceil(0.5 * length / SHARE)).max(1);
            let (first, end) = (frame.saturating_sub(half), frame + half);
            for at in first.max(free)..end.min(theta.len()) {
                let share = ((at - first) as f64 + 0.5) / (end - first) as f64;
                theta[at].clone_from(&way[index(share * (way.len() - 1) as f64)]);
            }
            free = end;
        }
        way = way.split_off(way.len() - 1);
    }
    theta
}

/// A number that is none or positive, cut to a whole one.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "positive and below the length of a list, or what fits"
)]
fn index(x: f64) -> usize {
    x as usize
}

/// The branches as runs of frames.
fn lanes(branches: &Branches) -> Vec<Lane> {
    let values = |branch: usize, from: usize| -> Vec<f64> {
        let list = &branches.list[branch];
        let slots = (list.first..).zip(&list.nodes).skip(from);
        slots
            .map(|(slot, &node)| branches.nodes[slot][node].solved.value)
            .collect()
    };
    // The start is no frame, and the followed motion is one lane though it may leap.
    let first = usize::from(branches.list[0].first == 0);
    let mut followed = values(0, first);
    (1..branches.followed).for_each(|branch| followed.extend(values(branch, 0)));
    let others = (branches.followed..branches.list.len()).map(|branch| Lane {
        first: branches.list[branch].first - 1,
        values: values(branch, 0),
    });
    let followed = Lane {
        first: 0,
        values: followed,
    };
    std::iter::once(followed).chain(others).collect()
}
