//! One Newton step of joints and wrenches together, with the factors of this iterate or of one before.
//!
//! A minimum of f over closed positions is a root of three residuals: the openings e_i of the loops, τ_i = J_iᵀ λ_i of the
//! joints, and ρ = g − Σ λ_i of the workpiece. Their linearisation for joint motions Δθ_i, a twist ξ and wrenches Δλ_i,
//!
//! > J_i Δθ_i = ξ + e_i,   K_i Δθ_i + J_iᵀ Δλ_i = −τ_i,   H ξ − ½ Σ e_i × M_i − Σ Δλ_i = −ρ,
//!
//! is solved along the free directions first, with their reduced Hessian, and then for the wrenches. The residuals are
//! always those of the present iterate, so that the steps lead to the same minimum with older factors too, more slowly.

use crate::math::linalg;
use crate::math::norm::norm;
use crate::solve::free::Balanced;
use crate::solve::free::Free;
use crate::solve::objective::Objective;
use crate::solve::tangent::{Factored, Tangent};
use nalgebra::Vector6;

/// How much longer the joint rates along a free direction may be at an iterate than where the factors were made.
/// An estimate: of 97,000 frames of random linkages and of the samples that were certified with older factors, one in ten
/// thousand had rates more than 1.05 times as long, and the bound was in none below 1.1 times the projected gradient.
const LONGER: f64 = 2.0;
/// How much the least curvature may fall, per unit of joint motion, of the joint rates along the free directions, and of
/// those that close the loops. Its change is a product of the three and of the objective's curvature, at most about 1; of
/// the frames above the largest was 5.5, where hardly anything had moved, and nothing lost more than a third of its
/// curvature of what passes with 2. tests/certificates.rs factors anew.
const SOFTENING: f64 = 2.0;

impl<'a> Factored<'a> {
    /// The linkage with the free directions and the wrenches that it has.
    #[inline]
    pub(super) fn balanced(self) -> Balanced<'a> {
        Balanced(Free(self.0))
    }
}

impl Balanced<'_> {
    fn tangent(&self) -> &Tangent {
        self.free().0
    }

    /// ρ: the part of a pull that the wrenches do not hold.
    fn unheld(&self, gradient: &Vector6<f64>) -> Vector6<f64> {
        self.tangent()
            .chains
            .iter()
            .fold(*gradient, |rest, chain| rest - chain.wrench)
    }

    /// τ goes to `torques`, the gradient along the free directions to `slope`: for each g·ξ = Σ τ_i·Δθ_i + ρ·ξ. Returns a
    /// bound of its norm at the last evaluation, which holds with older factors: |ρ| + |τ| times the longest joint rates.
    pub(super) fn residuals(
        &self,
        gradient: &Vector6<f64>,
        torques: &mut [f64],
        slope: &mut Vec<f64>,
    ) -> f64 {
        torques.fill(0.0);
        for chain in &self.tangent().chains {
            chain.torques(torques);
        }
        let (rho, free) = (self.unheld(gradient), self.free());
        slope.clear();
        slope.extend(
            (0..free.count())
                .map(|i| free.twist(i).dot(&rho) + linalg::dot(free.rates(i), torques)),
        );
        let rates = &self.tangent().rates;
        let longest = linalg::dot(rates, rates) * linalg::dot(torques, torques);
        norm(&rho) + LONGER * longest.sqrt()
    }

    /// A lower bound of the curvature, after this joint motion since the factors were made, by the estimate [`SOFTENING`]:
    /// from the Cholesky factor of the reduced Hessian, with room for a column of it.
    pub(super) fn least_curvature(&self, factor: &[f64], moved: f64, column: &mut [f64]) -> f64 {
        let (n, tangent) = (self.free().count(), self.tangent());
        // The trace of the inverse is the sum of the inverse eigenvalues.
        let mut trace = 0.0;
        for i in 0..n {
            let column = &mut column[..n];
            column.fill(0.0);
            column[i] = 1.0;
            linalg::solve_lower(factor, n, n, column);
            trace += linalg::dot(column, column);
        }
        let rates = linalg::dot(&tangent.rates, &tangent.rates) * tangent.stacked.inverse_size();
        1.0 / trace - SOFTENING * moved * rates.sqrt()
    }

    /// See [`Factored::close`].
    pub(super) fn close(&mut self, correction: &mut Vec<f64>, step: &mut [f64]) {
        Factored(self.0.0).close(correction, step);
    }

    /// Completes the closing step (`correction`, `step`) by the free motion that descends, and changes the wrenches with it.
    /// `factor` is the Cholesky factor of the reduced Hessian; `slope` and `torques` are used up.
    pub(super) fn step(
        &mut self,
        model: &Objective,
        factor: &[f64],
        slope: &mut [f64],
        torques: &mut [f64],
        correction: &mut [f64],
        step: &mut [f64],
    ) {
        // A rotation ω of the workpiece turns the end of an open chain by ω + e + ½ ω × e: the
        // moment acts on the last term too.
        let mut swirl = Vector6::zeros();
        for chain in &self.tangent().chains {
            let e = chain.open.fixed_rows::<3>(3).into_owned();
            let turned = e.cross(&chain.wrench.fixed_rows::<3>(3)) * 0.5;
            swirl += Vector6::new(0.0, 0.0, 0.0, turned.x, turned.y, turned.z);
        }
        let (n, free) = (slope.len(), self.free());
        let pulled = model.hessian * Vector6::from_column_slice(&correction[..6]) - swirl;
        for (i, s) in slope.iter_mut().enumerate() {
            *s = -*s - free.twist(i).dot(&pulled);
        }
        for chain in &self.tangent().chains {
            let bent = chain.bent(step);
            for (i, s) in slope.iter_mut().enumerate() {
                let rates = &free.rates(i)[chain.first..chain.first + chain.freedoms];
                *s -= rates.iter().zip(&bent).map(|(r, b)| r * b).sum::<f64>();
            }
        }
        linalg::solve_lower(factor, n, n, slope);
        linalg::solve_lower_transposed(factor, n, n, slope);
        for (i, a) in slope.iter().enumerate() {
            let rates = step.iter_mut().zip(free.rates(i));
            let directions = correction.iter_mut().zip(free.direction(i));
            rates
                .chain(directions)
                .for_each(|(sum, part)| *sum += a * part);
        }
        let twist = Vector6::from_column_slice(&correction[..6]);
        let rest = self.unheld(&model.gradient) + model.hessian * twist - swirl;
        let tangent = &mut *self.0.0;
        tangent.scratch.clear();
        tangent.scratch.extend_from_slice(rest.as_slice());
        tangent.scratch.resize(tangent.unknowns, 0.0);
        for chain in &mut tangent.chains {
            let bent = chain.bent(step);
            let own = &mut torques[chain.first..chain.first + chain.freedoms];
            own.iter_mut().zip(&bent).for_each(|(t, b)| *t += b);
            let omega = (twist + chain.open).fixed_rows::<3>(3).into_owned();
            let turned = omega.cross(&chain.wrench.fixed_rows::<3>(3)) * 0.5;
            chain.wrench += chain.react(torques, &mut tangent.scratch);
            chain.wrench += Vector6::new(0.0, 0.0, 0.0, turned.x, turned.y, turned.z);
        }
        tangent.distribute();
    }
}
