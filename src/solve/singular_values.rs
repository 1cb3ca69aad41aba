//! How far a position is from a singular one: the smallest singular value of \[A\].

use crate::math::lanczos::{Lanczos, scatter};
use crate::math::linalg::dot;
use crate::solve::loop_factor::{LoopFactor, TWIST};
use crate::solve::loop_normal::LoopNormal;
use nalgebra::Vector6;

/// Equations a chain.
const LOOP: usize = 6;
/// The singular value that the conditions on a unit dual quaternion contribute: \[C\] has rows of
/// length 2 and 1.
const OF_CONDITIONS: f64 = 1.0;
/// Share of the largest diagonal entry of B Bᵀ from which its smallest eigenvalue is found from B Bᵀ itself: rounding then
/// leaves it nine digits.
const PLAIN: f64 = 1e-6;
/// The same with surplus constraints: higher, so that four inverse iterations separate their wrench systems from the others.
const PLAIN_OF_SURPLUS: f64 = 1e-4;
/// How far below an expected σ_min the shift is, as a share of it: less makes Lanczos's method no faster.
const BELOW: f64 = 1e-3;
/// With surplus constraints some eigenvalues are 0: by this much all are raised before B Bᵀ is inverted.
const RAISED: f64 = 1e-5;
/// With surplus constraints R is singular: so many times I, times the largest entry of B, is appended to each J_i.
const APPENDED: f64 = 3e-13;

/// The smallest singular value of the linearised loops, position after position.
///
/// σ_min of a position is the smallest singular value of the paper's \[A\] (Eq. 21), not counting those
/// that are 0 because of surplus constraints, with
/// - lengths in units of the mechanism's size, and
/// - the dual quaternion measured from the workpiece's origin, d = 0.
///
/// It depends on no unit and no place: moving the mechanism, or measuring it in millimetres, changes
/// nothing. Its range is 0 to 1.
///
/// With d = 0 the rows of \[J_E\] are orthogonal and of length 2, those of \[C\] are orthogonal to them
/// and have lengths 2 and 1. The singular values of \[A\] therefore are 2, 1 and those of
///
/// > B = \[diag(J_1, …, J_k) | −2 I\],   ‖Bᵀu‖² = Σ ‖J_iᵀ u_i‖² + 4 ‖Σ u_i‖²,
///
/// one wrench u_i a chain: σ_min is small where chains can hold wrenches against each other that their
/// joints hardly feel. It is the root of the smallest eigenvalue of B Bᵀ, found from the inverse of B Bᵀ less a shift just
/// below it. A small eigenvalue of B Bᵀ has lost half of its digits: σ_min is then found from R of Bᵀ = Q R. Relative 1e-6
/// where σ_min > 1e-7, absolute 1e-12 below.
#[derive(Clone, Debug, Default)]
pub struct SingularValues {
    normal: LoopNormal,
    factor: LoopFactor,
    lanczos: Lanczos,
    /// Wrench systems of the surplus constraints: orthonormal, those with the smallest ‖Bᵀu‖.
    wrenches: Vec<f64>,
    /// The largest diagonal entry of the last B Bᵀ that was factored.
    size: f64,
}

impl SingularValues {
    /// σ_min of the position where the chains have these Jacobians: the columns of each, twists (v, ω)
    /// of the workpiece's origin a unit of each joint variable, lengths in units of the mechanism's
    /// size. So many of the smallest singular values as there are `surplus` constraints do not count.
    ///
    /// Numbers that are not finite give 0.
    pub fn smallest<'a>(
        &mut self,
        jacobians: impl IntoIterator<Item = &'a [Vector6<f64>], IntoIter: Clone>,
        surplus: usize,
    ) -> f64 {
        self.smallest_after(jacobians, surplus, &[])
    }

    /// The same after the values of the positions `before`, which make it faster, and change it by no more than rounding.
    pub fn smallest_after<'a>(
        &mut self,
        jacobians: impl IntoIterator<Item = &'a [Vector6<f64>], IntoIter: Clone>,
        surplus: usize,
        before: &[f64],
    ) -> f64 {
        let jacobians = jacobians.into_iter();
        let n = LOOP * jacobians.clone().count();
        if n <= LOOP {
            // One chain: of ‖Bᵀu‖² the second part alone is 4.
            return OF_CONDITIONS;
        }
        // Six equations, as many as the workpiece's twist has, are always independent.
        let surplus = surplus.min(n - LOOP);
        let (shift, plain) = if surplus == 0 {
            (shift_after(before), PLAIN)
        } else {
            (-RAISED, PLAIN_OF_SURPLUS)
        };
        // Where the last one was small, this is likely to be as well.
        let is_small = before
            .last()
            .is_some_and(|last| last * last < plain * self.size);
        let mut normal = |shift| Some((shift, self.normal.factor(jacobians.clone(), shift)?));
        let mut factored = None;
        if !is_small {
            factored = normal(shift);
            if factored.is_none() && shift > 0.0 {
                // The value has fallen by more than expected.
                factored = normal(0.5 * shift).or_else(|| normal(0.0));
            }
        }
        if let Some((shift, size)) = factored {
            self.size = size;
            let small = plain * size;
            let enough = if shift < small {
                1.0 / (small - shift)
            } else {
                f64::INFINITY
            };
            let least = shift + 1.0 / self.largest(n, shift, enough, surplus, true);
            if least > small {
                return least.sqrt().min(OF_CONDITIONS);
            }
        }
        let mut raise = 0.0;
        if surplus > 0 {
            let entries = jacobians.clone().flatten().flat_map(|column| column.iter());
            raise = APPENDED * entries.fold(TWIST, |most, x| most.max(x.abs()));
        }
        self.factor.clear();
        jacobians.for_each(|j| self.factor.push(j, raise));
        if !self.factor.factor() {
            return 0.0;
        }
        let above = self.largest(n, 0.0, f64::INFINITY, surplus, false);
        let least = (1.0 / above - raise * raise).max(0.0);
        least.sqrt().min(OF_CONDITIONS)
    }

    /// The largest eigenvalue of the inverse, across the wrench systems of the surplus constraints. An error of their
    /// directions changes it by its square only.
    fn largest(
        &mut self,
        n: usize,
        shift: f64,
        enough: f64,
        surplus: usize,
        is_normal: bool,
    ) -> f64 {
        /// Inverse iterations. One suffices where the dimensions are exact. Where dimensions are
        /// rounded, each one brings u nearer by the square of the ratio of the singular value that
        /// ought to be 0 to σ_min: four give six digits of σ_min up to a ratio of a third.
        const ROUNDS: usize = 4;
        let (normal, factor) = (&self.normal, &self.factor);
        let divide = |x: &mut [f64]| {
            if is_normal {
                normal.solve(x);
            } else {
                factor.solve(x);
            }
        };
        self.wrenches.resize(surplus * n, 0.0);
        scatter(&mut self.wrenches);
        for found in 0..surplus {
            let (before, rest) = self.wrenches.split_at_mut(found * n);
            let own = &mut rest[..n];
            for _ in 0..ROUNDS {
                put_away(before, own);
                divide(own);
                put_away(before, own);
                let norm = dot(own, own).sqrt();
                own.iter_mut().for_each(|x| *x /= norm);
            }
        }
        let wrenches = &self.wrenches;
        self.lanczos.largest(n, shift, enough, |x| {
            put_away(wrenches, x);
            divide(x);
            put_away(wrenches, x);
        })
    }
}

/// Takes from x what it has along orthonormal vectors.
fn put_away(vectors: &[f64], x: &mut [f64]) {
    for other in vectors.chunks_exact(x.len()) {
        let along = dot(other, x);
        x.iter_mut().zip(other).for_each(|(x, o)| *x -= along * o);
    }
}

/// Somewhat less than the next square of these values.
fn shift_after(values: &[f64]) -> f64 {
    let Some(&last) = values.last() else {
        return 0.0;
    };
    let back = |n: usize, or: f64| {
        let at = values.len().checked_sub(n);
        at.map_or(or, |at| values[at])
    };
    let before = back(2, last);
    let first = back(3, before);
    // Straight on, with room for twice the bend so far.
    let (change, earlier) = (last - before, before - first);
    let expected = last + change - 2.0 * (change - earlier).abs() - BELOW * last;
    let expected = expected.max(0.0);
    expected * expected
}
