//! The calm form of what the search for the best motion found, at any price of joint motion.

use crate::math::pose::Pose;
use crate::model::scaled::Scaled;
use crate::motion::trajectory::{Status, Trajectory};
use crate::plan::best::{FIRST_PRICE, NEXT_PRICE, Search};
use crate::plan::calm::Calming;
use crate::plan::found::{Cost, Point};
use crate::plan::record::{Singularity, begin, record, warn_of_rounded};
use crate::plan::settings::extent;
use crate::plan::walk;

/// How far f of a calm frame may fall nearby where it still is a closest pose.
const CALM_FALL: f64 = 1e-12;
/// The highest price: at it, a motion by 1 rad or size costs more than the farthest pose.
pub const MOST_PRICE: f64 = 1.0;
/// Joint motion between two frames, root of squares, that is spread over frames to begin with, and how much a frame then has.
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

impl Search {
    /// The best and the followed motion as positions, those between frames of the best one spread over frames.
    pub(super) fn begin_calm(&self) -> Vec<Calming> {
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
    pub(super) fn settle(&mut self, from: &mut [Calming], price: f64) -> Option<Calm> {
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
        let extent = extent(&self.goals);
        let mut t = begin(&self.mechanism, solver, extent, &self.settings);
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

    /// The calm form of what was found at a price, up to [`MOST_PRICE`]; none before the search is done, or beyond.
    pub fn calm(&mut self, price: f64) -> Option<Calm> {
        if !(self.done && price <= MOST_PRICE) {
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
