//! The calm forms of what the search for the best motion found, at any price of joint motion.

use crate::math::pose::Pose;
use crate::model::scaled::Scaled;
use crate::motion::goal::Goal;
use crate::motion::trajectory::{Status, Trajectory};
use crate::plan::branches::Branches;
use crate::plan::calm::Calming;
use crate::plan::found::{Cost, Found, Point};
use crate::plan::record::{Singularity, begin, record, warn_of_rounded};
use crate::plan::settings::extent;
use crate::plan::task::Task;
use crate::plan::walk;
use crate::solve::solver::Solver;

/// Prices that are looked at: so many, each a multiple of the one before. Of the mean square of the joints' speeds, in rad
/// and sizes a motion, in the unit of mean f.
const PRICES: usize = 8;
const FIRST_PRICE: f64 = 1e-9;
const NEXT_PRICE: f64 = 6.0;
/// How far f of a calm frame may fall nearby where it still is a closest pose.
const CALM_FALL: f64 = 1e-12;
/// The highest price: at it, a motion by 1 rad or size costs more than the farthest pose.
pub const MOST_PRICE: f64 = 1.0;
/// Joint motion between two slots, root of squares, that is spread over slots to begin with, and how much a slot then has.
const SPREAD: f64 = 0.5;
const SHARE: f64 = 0.3;

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

/// The calm forms of what a search found, price by price.
#[derive(Clone, Debug)]
pub(super) struct CalmForms {
    /// On the way to the next price, from the best and the followed motion; so many of them are settled for it.
    forms: Vec<Calming>,
    settled: usize,
    /// Those that the first price began with, and those of each price of the curve.
    known: Vec<Vec<Calming>>,
    curve: Vec<(f64, Cost)>,
}

impl CalmForms {
    /// The best and the followed motion as positions of the slots, those between slots of the best one spread over slots.
    pub fn new(task: &Task, branches: &Branches, found: &Found) -> Self {
        let (scaled, frames) = (branches.solver.scaled(), &branches.frames);
        let entered = |t: &Trajectory| -> Vec<Vec<f64>> {
            let frames = frames.iter();
            frames
                .map(|&frame| scaled.entered(t.joints_at(frame)))
                .collect()
        };
        let best = spread(scaled, frames, &found.path, entered(&found.motion));
        let mut forms = vec![Calming::new(&branches.solver, best)];
        if !found.switches.is_empty() {
            forms.push(Calming::new(&branches.solver, entered(&task.followed)));
        }
        Self {
            known: vec![forms.clone()],
            forms,
            settled: 0,
            curve: Vec::new(),
        }
    }

    /// A step towards the calm forms at the next price; when they are there, what the one costs whose frames are closest.
    pub fn advance(&mut self, task: &Task, branches: &mut Branches) -> Option<Cost> {
        let price = (self.curve.last()).map_or(FIRST_PRICE, |(price, _)| price * NEXT_PRICE);
        if let Some(form) = self.forms.get_mut(self.settled) {
            let (goals, mu) = (slot_goals(branches), weight(branches, price));
            let more = form.advance(&mut branches.solver, &goals, mu);
            self.settled += usize::from(!more);
            return None;
        }
        self.settled = 0;
        let theta = closest(branches, &self.forms);
        let cost = cost(task, branches, &theta);
        self.curve.push((price, cost));
        self.known.push(self.forms.clone());
        Some(cost)
    }

    /// Of each price the cost of the form whose frames are closest.
    pub fn curve(&self) -> &[(f64, Cost)] {
        &self.curve
    }

    /// From 0 to 1.
    pub fn progress(&self) -> f64 {
        self.curve.len() as f64 / PRICES as f64
    }

    /// Whether there are those of all prices of the curve.
    pub fn are_complete(&self) -> bool {
        self.curve.len() >= PRICES
    }

    /// The one at a price whose frames are closest; none before those of the curve are complete, or beyond [`MOST_PRICE`].
    pub fn at(&self, task: &Task, branches: &mut Branches, price: f64) -> Option<Calm> {
        /// Of two prices that are the same.
        const SAME: f64 = 1e-12;
        if !(self.are_complete() && price <= MOST_PRICE) {
            return None;
        }
        // From the curve on, step by step as it was found: at once a high price may lead elsewhere.
        let below = |(known, _): &&(f64, Cost)| *known <= price * (1.0 + SAME);
        let count = self.curve.iter().filter(below).count();
        let mut forms = self.known[count].clone();
        let mut step = if let Some(last) = count.checked_sub(1) {
            self.curve[last].0
        } else {
            let first = price.min(FIRST_PRICE);
            settle(branches, &mut forms, first);
            first
        };
        while step < price * (1.0 - SAME) {
            step = price.min(step * NEXT_PRICE);
            settle(branches, &mut forms, step);
        }
        let theta = closest(branches, &forms);
        let motion = published(task, &mut branches.solver, &theta);
        let cost = Cost::of(&motion, branches.solver.scaled());
        Some(Calm {
            price,
            motion,
            cost,
        })
    }
}

/// Makes motions calm at a price.
fn settle(branches: &mut Branches, forms: &mut [Calming], price: f64) {
    let (goals, mu) = (slot_goals(branches), weight(branches, price));
    for form in forms {
        while form.advance(&mut branches.solver, &goals, mu) {}
    }
}

/// How close positions of all frames come.
fn cost(task: &Task, branches: &Branches, theta: &[Vec<f64>]) -> Cost {
    let solver = &branches.solver;
    let value =
        |(goal, theta): (&Goal, &Vec<f64>)| solver.value(&goal.pose, &solver.scaled().left(theta));
    let values: Vec<f64> = task.goals.iter().zip(theta).map(value).collect();
    Cost::new(&values, theta)
}

/// Positions as a motion with its report.
fn published(task: &Task, solver: &mut Solver, theta: &[Vec<f64>]) -> Trajectory {
    let extent = extent(&task.goals);
    let mut t = begin(&task.mechanism, solver, extent, &task.settings);
    t.mobility_rank = task.followed.mobility_rank;
    t.start.clone_from(&task.followed.start);
    let mut before = t.start.clone();
    for (goal, theta) in task.goals.iter().zip(theta) {
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
    t
}

/// Of calm forms the one whose slots are closest to their goals: the positions of all frames.
fn closest(branches: &mut Branches, calming: &[Calming]) -> Vec<Vec<f64>> {
    let goals = slot_goals(branches);
    let far = |calming: &Calming| calming.cost(&mut branches.solver, &goals, 0.0);
    let far: Vec<f64> = calming.iter().map(far).collect();
    let best = (0..far.len()).min_by(|&a, &b| far[a].total_cmp(&far[b]));
    best.map_or_else(Vec::new, |best| fill(branches, calming[best].theta()))
}

/// The goals of the slots.
fn slot_goals(branches: &Branches) -> Vec<Pose> {
    let slots = 1..branches.slots();
    slots.map(|slot| *branches.goal(slot)).collect()
}

/// μ of a price: with N slots the mean of f and the mean square of the speeds N |θ_{i+1} − θ_i| are N times less than the sums.
fn weight(branches: &Branches, price: f64) -> f64 {
    let slots = branches.frames.len() as f64;
    price * slots * slots
}

/// The positions of all frames from those of the slots: between them a cubic through the slots around, closed.
fn fill(branches: &mut Branches, theta: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let frames = branches.frames.clone();
    let last = theta.len() - 1;
    let time = |slot: usize| frames[slot] as f64;
    let slope = |slot: usize| -> Vec<f64> {
        let (a, b) = (slot.saturating_sub(1), (slot + 1).min(last));
        let moves = theta[b].iter().zip(&theta[a]);
        moves
            .map(|(b_, a_)| (b_ - a_) / (time(b) - time(a)))
            .collect()
    };
    let mut all = Vec::with_capacity(frames[last] + 1);
    for slot in 0..last {
        all.push(theta[slot].clone());
        let count = frames[slot + 1] - frames[slot];
        if count == 1 {
            continue;
        }
        let slopes = [slope(slot), slope(slot + 1)];
        for i in 1..count {
            let (s, width) = (i as f64 / count as f64, count as f64);
            let (h, r) = (s * s * (3.0 - 2.0 * s), 1.0 - s);
            let point = (0..theta[slot].len()).map(|joint| {
                theta[slot][joint] * (1.0 - h)
                    + theta[slot + 1][joint] * h
                    + width * s * r * (r * slopes[0][joint] - s * slopes[1][joint])
            });
            let closed = walk::closed_near(&mut branches.solver, point.collect());
            // It can always stay.
            let closed = closed.unwrap_or_else(|| all[all.len() - 1].clone());
            all.push(closed);
        }
    }
    all.push(theta[last].clone());
    all
}

/// The slots' positions, with those of a long walk between two slots taken from all along it.
fn spread(
    scaled: &Scaled,
    frames: &[usize],
    path: &[Point],
    mut theta: Vec<Vec<f64>>,
) -> Vec<Vec<f64>> {
    let mut free = 1;
    let mut points: Vec<Vec<f64>> = Vec::new();
    for point in path {
        points.push(scaled.entered(&point.joints));
        let slot = point.frame.map(|frame| frames.binary_search(&frame));
        let Some(Ok(slot)) = slot else {
            continue;
        };
        let length: f64 = points
            .windows(2)
            .map(|w| walk::distance(&w[0], &w[1]))
            .sum();
        if length > SPREAD && slot > 0 {
            let half = index(libm::ceil(0.5 * length / SHARE)).max(1);
            let (first, end) = (slot.saturating_sub(half), slot + half);
            for at in first.max(free)..end.min(theta.len()) {
                let share = ((at - first) as f64 + 0.5) / (end - first) as f64;
                theta[at].clone_from(&points[index(share * (points.len() - 1) as f64)]);
            }
            free = end;
        }
        points = points.split_off(points.len() - 1);
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
