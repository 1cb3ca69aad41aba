//! How far a position is from a singular one: the smallest singular value of \[A\].

use crate::math::lanczos::{Lanczos, scatter};
use crate::math::linalg::dot;
use crate::solve::loop_factor::LoopFactor;
use crate::solve::loop_normal::LoopNormal;
use nalgebra::Vector6;

/// Equations a chain.
const LOOP: usize = 6;
/// The singular value that the conditions on a unit dual quaternion contribute: \[C\] has rows of
/// length 2 and 1.
const OF_CONDITIONS: f64 = 1.0;
/// The singular value that surplus constraints are given, so that none of them is the smallest: any that
/// is above [`OF_CONDITIONS`], beyond which none is looked for.
const OUT_OF_THE_WAY: f64 = 2.0;
/// Share of the largest diagonal entry of B Bᵀ from which its smallest eigenvalue is found from B Bᵀ itself: rounding then
/// leaves it a dozen digits.
const PLAIN: f64 = 1e-4;
/// How far below an expected σ_min the shift is, as a share of it: less makes Lanczos's method no faster.
const BELOW: f64 = 1e-3;

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
/// joints hardly feel. It is the root of the smallest eigenvalue of B Bᵀ, shifted to just below it where a value is
/// expected. Where it is small that has lost half of the digits, and it is found from R of Bᵀ = Q R: relative 1e-6 where
/// σ_min > 1e-7, absolute 1e-12 below.
#[derive(Clone, Debug, Default)]
pub struct SingularValues {
    normal: LoopNormal,
    factor: LoopFactor,
    lanczos: Lanczos,
    /// Wrench systems of the surplus constraints.
    wrenches: Vec<f64>,
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

    /// The same after the values of the positions `before`, which only make it faster.
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
        let shift = shift_after(before);
        // Where the last one was small, this is likely to be as well.
        let small = before.last().is_some_and(|last| last * last < PLAIN);
        let mut plain = None;
        if surplus == 0 && !small {
            let mut factor = |shift| Some((shift, self.normal.factor(jacobians.clone(), shift)?));
            plain = factor(shift).or_else(|| factor(0.5 * shift));
        }
        loop {
            if plain.is_none() && !self.factor_apart(jacobians.clone(), surplus, n) {
                return 0.0;
            }
            let (shift, largest) = plain.unwrap_or_default();
            let (normal, factor) = (&self.normal, &mut self.factor);
            let above = self.lanczos.largest(n, shift, |x| match plain {
                Some(_) => normal.solve(x),
                None => factor.solve(x),
            });
            let least = shift + 1.0 / above;
            if plain.is_none() || least > PLAIN * largest {
                return least.sqrt().min(OF_CONDITIONS);
            }
            plain = None;
        }
    }

    /// Factors Bᵀ with the surplus constraints put away; false if it is singular.
    fn factor_apart<'a>(
        &mut self,
        jacobians: impl Iterator<Item = &'a [Vector6<f64>]>,
        surplus: usize,
        n: usize,
    ) -> bool {
        self.factor.clear();
        jacobians.for_each(|j| self.factor.push(j));
        self.wrenches.clear();
        // Six equations, as many as the workpiece's twist has, are always independent.
        for _ in 0..surplus.min(n - LOOP) {
            self.put_away_dependent(n);
        }
        self.factor.factor()
    }

    /// Finds one more wrench system u with the smallest ‖Bᵀu‖, and adds it to B, where it then has the
    /// singular value 2. An error of the direction changes the other singular values by its square only.
    fn put_away_dependent(&mut self, n: usize) {
        /// Inverse iterations. One suffices where the dimensions are exact. Where dimensions are
        /// rounded, each one brings u nearer by the square of the ratio of the singular value that
        /// ought to be 0 to σ_min: four give six digits of σ_min up to a ratio of a third.
        const ROUNDS: usize = 4;
        self.factor.factor();
        let found = self.wrenches.len();
        self.wrenches.resize(found + n, 0.0);
        let (before, own) = self.wrenches.split_at_mut(found);
        scatter(own);
        for _ in 0..ROUNDS {
            self.factor.solve(own);
            // Those before have no part in it but for rounding.
            for other in before.chunks_exact(n) {
                let along = dot(other, own);
                own.iter_mut().zip(other).for_each(|(x, o)| *x -= along * o);
            }
            let norm = dot(own, own).sqrt();
            own.iter_mut().for_each(|x| *x /= norm);
        }
        self.factor.add_row(own, OUT_OF_THE_WAY);
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
