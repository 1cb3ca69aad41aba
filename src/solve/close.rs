//! Closing the loops near a position, by a few short corrections; from anywhere: see [`close_start`](super::close_start).
//!
//! A correction is a Gauss–Newton step of the loop equations. Of the many that close the loops to first order it is the
//! shortest, in the workpiece's twist or in the joints.

use crate::math::linalg::{self, dot};
use crate::math::pose::Pose;
use crate::model::joint::Stop;
use crate::model::scaled::{SOLVED, Scaled, larger};
use crate::solve::dependent::Dependence;
use crate::solve::free::Free;
use crate::solve::limits::Holding;
use crate::solve::singular_values::SingularValues;
use crate::solve::tangent::Tangent;

/// Corrections near a closed position: quadratic convergence needs three or four.
const CORRECTIONS: usize = 12;

/// A correction that leaves less than this share of the closure error before it, so that another with its factors leaves
/// hardly more than one with new ones.
const STALE_FAST: f64 = 0.02;

/// In what a correction is the shortest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shortest {
    /// The workpiece's twist.
    Twist,
    /// The joints' motions.
    Joints,
}

/// How far corrections may go before they count as a leap.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    /// In what they are the shortest.
    pub shortest: Shortest,
    /// Largest joint motion of one correction, rad or sizes.
    pub each: f64,
    /// Root of the sum of squares of all joint motions together.
    pub all: f64,
}

/// Closes loops; its buffers serve all positions.
#[derive(Clone, Debug)]
pub struct Closer {
    tangent: Tangent,
    /// What is known of the linkage's surplus constraints.
    dependence: Dependence,
    at: Vec<f64>,
    step: Vec<f64>,
    correction: Vec<f64>,
    coefficients: Vec<f64>,
    gram: Vec<f64>,
}

impl Closer {
    /// Buffers for this linkage.
    pub fn new(scaled: &Scaled) -> Self {
        let n = scaled.variables();
        Self {
            tangent: Tangent::new(scaled.chains()),
            dependence: Dependence::FOUND,
            at: vec![0.0; n],
            step: vec![0.0; n],
            correction: Vec::new(),
            coefficients: Vec::new(),
            gram: Vec::new(),
        }
    }

    /// The tangent at the last evaluation.
    pub fn tangent(&mut self) -> &mut Tangent {
        &mut self.tangent
    }

    /// The workpiece at `theta`.
    pub fn pose_at(&self, scaled: &Scaled, theta: &[f64]) -> Pose {
        self.tangent.pose_at(scaled.chains(), theta)
    }

    /// What is known of the surplus constraints: found at each position, implied, or rounded.
    pub fn dependence(&self) -> Dependence {
        self.dependence
    }

    /// For positions where the surplus is to be found anew: a rounded linkage's stays what it is.
    pub fn dependence_anywhere(&self) -> Dependence {
        if self.dependence.is_rounded() {
            self.dependence
        } else {
            Dependence::FOUND
        }
    }

    /// Sets what is known of the surplus constraints.
    pub fn set_dependence(&mut self, dependence: Dependence) {
        self.dependence = dependence;
    }

    /// Notes that so many constraints are surplus at a closed position: fewer than thought where the position before was
    /// singular.
    pub fn note_surplus(&mut self, surplus: usize) {
        if let Dependence::Implied(known) = self.dependence {
            self.dependence = Dependence::Implied(known.min(surplus));
        }
    }

    /// Corrects `theta` until the loops are closed, with the joints of `stops` held; false, and `theta` as it was, if
    /// they do not close within `reach`. The tangent is then evaluated at `theta`. Counts linear systems.
    pub fn close(
        &mut self,
        scaled: &Scaled,
        stops: &[Stop],
        reach: &Reach,
        theta: &mut [f64],
        iterations: &mut usize,
    ) -> bool {
        let found = self.dependence_anywhere();
        // In a singular position more constraints look surplus than are.
        let tries = [self.dependence, found];
        let tries = if self.dependence == found {
            &tries[1..]
        } else {
            &tries[..]
        };
        tries
            .iter()
            .any(|&dependence| self.close_with(dependence, scaled, stops, reach, theta, iterations))
    }

    fn close_with(
        &mut self,
        dependence: Dependence,
        scaled: &Scaled,
        stops: &[Stop],
        reach: &Reach,
        theta: &mut [f64],
        iterations: &mut usize,
    ) -> bool {
        self.at.copy_from_slice(theta);
        let mut last = f64::INFINITY;
        for correction in 0..CORRECTIONS {
            let mut open = self.tangent.evaluate(scaled.chains(), &self.at);
            if open <= SOLVED {
                theta.copy_from_slice(&self.at);
                return true;
            }
            let fast = correction > 0 && open < STALE_FAST * last && !dependence.is_rounded();
            let mut factored = if fast {
                self.tangent.stale()
            } else {
                self.tangent.factor(stops, dependence)
            };
            if dependence.is_rounded() {
                (open, _) = factored.closure();
                if open <= SOLVED {
                    theta.copy_from_slice(&self.at);
                    return true;
                }
            }
            if !(open < last) {
                return false;
            }
            last = open;
            *iterations += 1;
            factored.close(&mut self.correction, &mut self.step);
            if reach.shortest == Shortest::Joints {
                let free = factored.free();
                self.coefficients.clear();
                self.coefficients
                    .extend((0..free.count()).map(|i| dot(free.rates(i), &self.step)));
                if !solve_gram(&free, &mut self.gram, &mut self.coefficients) {
                    return false;
                }
                add_rates(&free, &self.coefficients, -1.0, &mut self.step);
            }
            if !(longest(&self.step) <= reach.each) {
                return false;
            }
            self.at
                .iter_mut()
                .zip(&self.step)
                .for_each(|(t, s)| *t += s);
            let moved: f64 = self
                .at
                .iter()
                .zip(&*theta)
                .map(|(a, t)| (a - t) * (a - t))
                .sum();
            if !(moved.sqrt() <= reach.all) {
                return false;
            }
        }
        false
    }

    /// The largest closure error at `theta`, and the misfit of a rounded linkage there (else 0).
    pub fn closure(&mut self, scaled: &Scaled, theta: &[f64]) -> (f64, f64) {
        let open = self.tangent.evaluate(scaled.chains(), theta);
        if !self.dependence.is_rounded() {
            return (open, 0.0);
        }
        // The stop of an idle joint may contradict the others as well.
        let mut holding = Holding::new(scaled.limits());
        holding.hold_all_at(theta);
        self.tangent
            .factor(holding.stops(), self.dependence)
            .closure()
    }

    /// The smallest singular value of a position after those of the positions `before`, not counting so many that are 0
    /// because of surplus constraints; see [`SingularValues`].
    pub fn smallest_singular_value(
        &mut self,
        scaled: &Scaled,
        theta: &[f64],
        surplus: usize,
        values: &mut SingularValues,
        before: &[f64],
    ) -> f64 {
        self.tangent.evaluate(scaled.chains(), theta);
        values.smallest_after(self.tangent.jacobians(), surplus, before)
    }

    /// Number of independent motions at a closed position, inner freedoms included, and of surplus constraints.
    pub fn mobility(&mut self, scaled: &Scaled, theta: &[f64]) -> (usize, usize) {
        let free = vec![Stop::None; theta.len()];
        let dependence = self.dependence_anywhere();
        self.tangent.evaluate(scaled.chains(), theta);
        let factored = self.tangent.factor(&free, dependence);
        (factored.freedoms(), factored.surplus())
    }
}

/// x ← G⁻¹ x for the Gram matrix G of the free joint rates; false where it is singular.
pub fn solve_gram(free: &Free<'_>, gram: &mut Vec<f64>, x: &mut [f64]) -> bool {
    let n = x.len();
    gram.clear();
    gram.resize(n * n, 0.0);
    for i in 0..n {
        for j in i..n {
            gram[i * n + j] = dot(free.rates(i), free.rates(j));
        }
    }
    if !linalg::cholesky(gram, n, n, 0.0) {
        return false;
    }
    linalg::solve_lower(gram, n, n, x);
    linalg::solve_lower_transposed(gram, n, n, x);
    true
}

/// Adds the free joint rates with these coefficients times `scale`.
pub fn add_rates(free: &Free<'_>, coefficients: &[f64], scale: f64, sum: &mut [f64]) {
    for (i, c) in coefficients.iter().enumerate() {
        for (s, r) in sum.iter_mut().zip(free.rates(i)) {
            *s += scale * c * r;
        }
    }
}

/// The largest entry; NaN if there is one.
pub fn longest(step: &[f64]) -> f64 {
    step.iter().fold(0.0, |most, s| larger(most, s.abs()))
}
