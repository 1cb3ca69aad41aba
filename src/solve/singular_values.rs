//! How far a position is from a singular one: the smallest singular value of \[A\].

use crate::math::lanczos::{Lanczos, scatter};
use crate::math::linalg::dot;
use crate::solve::loop_factor::LoopFactor;
use nalgebra::Vector6;

/// The singular value that the conditions on a unit dual quaternion contribute: \[C\] has rows of
/// length 2 and 1.
const OF_CONDITIONS: f64 = 1.0;
/// The singular value that surplus constraints are given, so that none of them is the smallest: any that
/// is above [`OF_CONDITIONS`], beyond which none is looked for.
const OUT_OF_THE_WAY: f64 = 2.0;

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
/// joints hardly feel. It is found from R of Bᵀ = Q R without forming B Bᵀ, whose smallest eigenvalue
/// has lost half of the digits: relative 1e-6 where σ_min > 1e-7, absolute 1e-12 below.
#[derive(Clone, Debug, Default)]
pub struct SingularValues {
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
        jacobians: impl IntoIterator<Item = &'a [Vector6<f64>]>,
        surplus: usize,
    ) -> f64 {
        self.factor.clear();
        jacobians.into_iter().for_each(|j| self.factor.push(j));
        let n = self.factor.equations();
        // Six equations, as many as the workpiece's twist has, are always independent.
        let surplus = surplus.min(n.saturating_sub(6));
        if n <= 6 {
            // One chain: of ‖Bᵀu‖² the second part alone is 4.
            return OF_CONDITIONS;
        }
        self.wrenches.clear();
        for _ in 0..surplus {
            self.put_away_dependent(n);
        }
        if !self.factor.factor() {
            return 0.0;
        }
        let factor = &mut self.factor;
        let largest = self.lanczos.largest(n, |x| factor.solve(x));
        (1.0 / largest.sqrt()).min(OF_CONDITIONS)
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
