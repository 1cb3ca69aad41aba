//! The largest eigenvalue of a symmetric operator by Lanczos's method.

use crate::math::dot::dot;

/// The residual that a result is left with, as a share of the eigenvalue, for a shift of 0: some eigenvalue is within
/// that distance of the result. It is small because of nearly equal ones: from a first vector with
/// little of the largest one's in it the second is found for it as long as their distance, times that
/// little, is below. With 1e-8, one in 7,000 nearly symmetric linkages was wrong by 1e-6; with this
/// none of 100,000.
const RESIDUAL: f64 = 1e-10;
/// Share of the eigenvalue below which what is new in a step is orthogonalised against all vectors
/// before, not the last two alone: its rounding lies along them, and they would come again.
const SMALL: f64 = 1e-2;
/// How much less the residual may be than it is guessed to be.
const GUESS: f64 = 2.0;
/// Steps after which the guess is corrected: by then it may be some percent too low, and a correction
/// costs a step's time.
const CORRECTED: usize = 6;
/// Steps an unknown, a guard only. In exact arithmetic one each is the end, and a dozen are usual for
/// 18 unknowns; rounding may cost more where many eigenvalues are close.
const STEPS: usize = 3;
/// Step of Newton's method that is the last: its convergence is quadratic.
const CHANGE: f64 = 1e-8;
/// Factor by which a guess is raised that is too low for Newton's method: guesses are not far off.
const RAISED: f64 = 1.1;
/// Any number; it chooses the vector that all calls begin with.
const SEED: u64 = 2003;
/// Newton steps for an eigenvalue of the tridiagonal matrix, a guard only: five are the most seen.
const NEWTON_STEPS: usize = 40;

/// The largest eigenvalue of a symmetric operator M that has no negative ones.
///
/// Close eigenvalues cost steps, not digits as they do in the power method. The buffers are kept
/// between calls.
#[derive(Clone, Debug, Default)]
pub struct Lanczos {
    /// Orthonormal vectors, one after the other, on which M is a tridiagonal matrix T.
    basis: Vec<f64>,
    work: Vec<f64>,
    /// The diagonal of T, and what is beside it, row by row.
    diagonal: Vec<f64>,
    beside: Vec<f64>,
}

impl Lanczos {
    /// The largest eigenvalue θ of the operator of order `order` ≥ 1 by which `apply` multiplies a
    /// vector. The first vector is [`scatter`]'s. Stops when λ = `shift` + 1 / θ has a relative error of 1e-10; θ
    /// itself then has one of that times λ θ. Stops too when θ is found to be above `enough`.
    pub fn largest(
        &mut self,
        order: usize,
        shift: f64,
        enough: f64,
        mut apply: impl FnMut(&mut [f64]),
    ) -> f64 {
        let allowed = |theta: f64| RESIDUAL * (theta + shift * theta * theta);
        self.diagonal.clear();
        self.beside.clear();
        self.basis.clear();
        self.work.clear();
        self.work.resize(order, 0.0);
        scatter(&mut self.work);
        let mut beside = dot(&self.work, &self.work).sqrt();
        // The largest eigenvalue of T, and the residual: M times T's eigenvector is the eigenvalue times
        // it, but for its last entry times what comes beside it.
        let (mut theta, mut residual) = (0.0, 0.0);
        loop {
            let inverse = 1.0 / beside;
            self.work.iter_mut().for_each(|x| *x *= inverse);
            self.basis.extend_from_slice(&self.work);
            apply(&mut self.work);
            let (older, newest) = self.basis.split_at(self.basis.len() - order);
            if let Some(before) = older.rchunks_exact(order).next() {
                take(&mut self.work, before, beside);
            }
            let alpha = dot(newest, &self.work);
            take(&mut self.work, newest, alpha);
            beside = dot(&self.work, &self.work).sqrt();
            if !(beside > SMALL * theta) {
                for q in self.basis.chunks_exact(order) {
                    let along = dot(q, &self.work);
                    take(&mut self.work, q, along);
                }
                beside = dot(&self.work, &self.work).sqrt();
            }
            self.diagonal.push(alpha);
            let steps = self.diagonal.len();
            // The best combination of T's eigenvector and the new vector: a guess of the new one.
            let half = 0.5 * (theta - alpha);
            let above = half + (half * half + residual * residual).sqrt();
            let last = residual / (residual * residual + above * above).sqrt();
            (theta, residual) = if steps == 1 {
                (alpha, beside)
            } else {
                (alpha + above, beside * last)
            };
            let end = steps == STEPS * order || theta > enough;
            if !(residual > GUESS * allowed(theta)) || steps.is_multiple_of(CORRECTED) || end {
                let last = self.find_largest(&mut theta);
                residual = beside * last;
                if !(residual > allowed(theta)) || end {
                    return theta;
                }
            }
            self.beside.push(beside);
        }
    }

    /// Makes a guess the largest eigenvalue of T; returns the last entry of its unit vector, without
    /// sign.
    fn find_largest(&self, theta: &mut f64) -> f64 {
        let n = self.diagonal.len();
        let mut last = 1.0;
        let mut from_above = false;
        for _ in 0..NEWTON_STEPS {
            // Pivots of θ − T from the last row up, all positive above the eigenvalues. The first row is
            // that of the first vector, which has its part in the eigenvector: without it the rows have
            // no eigenvalue as large, so that at the largest one only the last pivot is 0.
            let mut pivot = *theta - self.diagonal[n - 1];
            let (mut slope, mut product, mut sum) = (1.0, 1.0, 1.0 / pivot);
            let mut others_positive = true;
            for (alpha, beside) in self.diagonal.iter().zip(&self.beside).rev() {
                others_positive &= pivot > 0.0;
                let ratio = beside / pivot;
                product *= ratio;
                slope = 1.0 + ratio * ratio * slope;
                pivot = *theta - alpha - beside * ratio;
                sum += slope / pivot;
            }
            last = product.abs() / slope.sqrt();
            // Newton's method on the product of the pivots, the determinant. It comes from above, or
            // from near below by one step.
            let step = -1.0 / sum;
            let above = others_positive && pivot > 0.0;
            if !above && from_above {
                // Passed by rounding.
                break;
            }
            from_above = above;
            if above || (others_positive && step >= 0.0) {
                *theta += step;
                if step.abs() <= CHANGE * *theta {
                    break;
                }
            } else {
                *theta *= RAISED;
            }
        }
        last
    }
}

/// Numbers in ±½ without any pattern that a linkage's symmetry could answer, the same in every call: a
/// vector to begin with.
pub fn scatter(out: &mut [f64]) {
    // A linear congruence (Knuth's MMIX).
    let mut state = SEED;
    for x in out {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        // The upper 53 bits, which a double holds.
        *x = (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
    }
}

/// x ← x − along · q.
fn take(x: &mut [f64], q: &[f64], along: f64) {
    x.iter_mut().zip(q).for_each(|(x, q)| *x -= along * q);
}
