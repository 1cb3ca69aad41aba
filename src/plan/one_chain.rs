//! One chain on its own, in the search of a start: it goes to a pose, and its inner freedoms are moved to small joint
//! values while the workpiece stands still.
//!
//! Where a chain can move so, one pose has a continuum of joint values, and which of them a search comes to
//! depends on rounding. The least sum of squares is one of them.

use crate::math::linalg::{SvdFactors, svd};
use crate::math::norm::norm;
use crate::math::pose::{Pose, difference};
use crate::model::chain::{Chain, ChainState, MAX_FREEDOMS};
use crate::solve::solver::Solver;
use nalgebra::{SVector, Vector6};
use std::ops::Range;

/// One entry a freedom, the rest 0.
type Values = SVector<f64, MAX_FREEDOMS>;

/// Singular value of the Jacobian, over the largest, of a motion that leaves the workpiece where it is: those of closed
/// positions are rounding, 1e-16, or far above.
const STILL: f64 = 1e-6;
/// Steps; they converge linearly, most often by a third or better each.
const STEPS: usize = 200;
/// Length of a step, rad or sizes, at which the sum of squares counts as least: a tenth of the closure bound, so that
/// starts in two units agree to it.
const LEAST: f64 = 1e-11;
/// Corrections of a step, and how far the workpiece may stay away, rad and sizes.
const CORRECTIONS: usize = 6;
const STANDS_STILL: f64 = 1e-12;
/// Share by which the sum of squares must fall, above its rounding; near the least one, where it cannot, the next step must
/// be shorter than this share of the last.
const FALL: f64 = 1e-12;
const SHRINKS: f64 = 0.999;
/// Share of a step at which the search ends.
const SMALLEST_SHARE: f64 = 1e-3;

/// A chain on its own.
pub struct Part {
    pub chain: Chain,
    pub solver: Solver,
    /// Its variables among those of the mechanism.
    pub range: Range<usize>,
    /// Whether its values were given.
    pub given: bool,
}

impl Part {
    /// From the joint values `own` to the pose nearest to `target`, by the size as the metric's length.
    pub fn go(&mut self, target: &Pose, own: &mut [f64]) {
        // Puts the values within the limits, and forgets the joints that were held at limits before.
        let _ = self.solver.close_start(own, 0.0);
        let from = own.to_vec();
        self.solver.solve(target, own, &from);
    }
}

/// Moves the joint values `own`, lengths in sizes, along the inner freedoms of `chain` to the least sum of squares
/// that is next to them; the workpiece stands still, and they stay within their limits.
pub fn relax(chain: &Chain, own: &mut [f64]) {
    let n = chain.freedoms();
    let mut values = Values::zeros();
    values.as_mut_slice()[..n].copy_from_slice(own);
    let mut here = Tangent::new(chain, &values);
    let pose = here.pose;
    let mut share = 1.0;
    for _ in 0..STEPS {
        let step = -here.still(&values);
        if !(norm(&step) > LEAST) {
            break;
        }
        let mut trial = values + step * share;
        let there = close(chain, &pose, &mut trial).filter(|there| {
            let falls = trial.norm_squared() < values.norm_squared() * (1.0 - FALL);
            falls || norm(&there.still(&trial)) < SHRINKS * norm(&step)
        });
        if let Some(there) = there {
            (values, here) = (trial, there);
            share = (1.5 * share).min(1.0);
        } else {
            share *= 0.5;
            if share < SMALLEST_SHARE {
                break;
            }
        }
    }
    own.copy_from_slice(&values.as_slice()[..n]);
}

/// Whether a chain can go from the joint values `from` to `to`, lengths in sizes, while the workpiece stands still; both have
/// it at the same pose.
#[cfg(feature = "study")]
pub fn joined_still(chain: &Chain, from: &[f64], to: &[f64]) -> bool {
    /// Longest step, how often one is taken, and how far off the end may be: what poses may differ by.
    const STEP: f64 = 0.1;
    const MOST: usize = 200;
    const ARRIVED: f64 = 5e-3;
    let n = chain.freedoms();
    let [mut values, mut end] = [Values::zeros(); 2];
    values.as_mut_slice()[..n].copy_from_slice(from);
    end.as_mut_slice()[..n].copy_from_slice(to);
    let mut here = Tangent::new(chain, &values);
    let pose = here.pose;
    let mut last = f64::INFINITY;
    for _ in 0..MOST {
        let left = end - values;
        let far = norm(&left);
        if far <= ARRIVED {
            return true;
        }
        let still = here.still(&left);
        let length = norm(&still);
        // Straight on, or it is another configuration.
        if !(length > 0.1 * far && far < last) {
            return false;
        }
        last = far;
        let mut next = values + still * (STEP / length).min(1.0);
        match close(chain, &pose, &mut next) {
            Some(there) => (values, here) = (next, there),
            None => return false,
        }
    }
    false
}

/// Corrects the values until the workpiece is at `pose`; none if it does not come there within the limits.
fn close(chain: &Chain, pose: &Pose, values: &mut Values) -> Option<Tangent> {
    for _ in 0..CORRECTIONS {
        let tangent = Tangent::new(chain, values);
        let away = difference(pose, &tangent.pose);
        if away.amax() <= STANDS_STILL {
            let mut pairs = values.iter().zip(chain.limits());
            let within = pairs.all(|(x, limits)| limits.min <= *x && *x <= limits.max);
            return within.then_some(tangent);
        }
        *values += tangent.shortest(&away);
    }
    None
}

/// How the joint variables move the workpiece at one position.
struct Tangent {
    pose: Pose,
    /// Of the Jacobian J = U Σ Vᵀ, the twists and the joint motions that cause them, with the values σ; without those
    /// that leave the workpiece where it is.
    moving: Vec<(Vector6<f64>, Values, f64)>,
}

impl Tangent {
    fn new(chain: &Chain, values: &Values) -> Self {
        let freedoms = chain.freedoms();
        let mut state = ChainState::default();
        chain.evaluate(values.as_slice(), &mut state);
        let columns = state.jacobian[..freedoms].iter();
        let SvdFactors { u, sigma, v } =
            svd(columns.map(|twist| twist.as_slice().to_vec()).collect());
        let least = STILL * sigma.first().copied().unwrap_or(0.0);
        let moving = (u.iter().zip(&v).zip(sigma))
            .filter(|(_, sigma)| *sigma > least)
            .map(|((twist, motion), sigma)| {
                let mut all = Values::zeros();
                all.as_mut_slice()[..freedoms].copy_from_slice(motion);
                (Vector6::from_column_slice(twist), all, sigma)
            })
            .collect();
        Self {
            pose: state.pose,
            moving,
        }
    }

    /// The part of `values` that leaves the workpiece where it is.
    fn still(&self, values: &Values) -> Values {
        let mut part = *values;
        for (_, motion, _) in &self.moving {
            part -= motion * motion.dot(values);
        }
        part
    }

    /// The shortest motion by the twist `away`.
    fn shortest(&self, away: &Vector6<f64>) -> Values {
        let share = |(twist, motion, sigma): &(Vector6<f64>, Values, f64)| {
            motion * (twist.dot(away) / sigma)
        };
        self.moving.iter().map(share).sum()
    }
}
