//! The largest eigenvalue of a symmetric operator by Lanczos's method.

/// The residual that a result is left with, as a share of the eigenvalue: some eigenvalue is within
/// that distance of the result, and callers promise six digits. As a rule the error is the
/// residual's square over the gap to the next eigenvalue, hence far less.
const RESIDUAL: f64 = 1e-7;
/// Newton steps for an eigenvalue of the tridiagonal matrix, a guard only: six are the most seen.
const STEPS: usize = 30;

/// The largest eigenvalue of a symmetric operator M of positive eigenvalues.
///
/// Close eigenvalues cost steps, not digits as they do in the power method. The buffers are kept
/// between calls.
#[derive(Clone, Debug, Default)]
pub struct Lanczos {
    /// Orthonormal vectors, one after the other, on which M is a tridiagonal matrix T.
    basis: Vec<f64>,
    /// The diagonal of T, and what is beside it, row by row.
    diagonal: Vec<f64>,
    beside: Vec<f64>,
    work: Vec<f64>,
}

impl Lanczos {
    /// The largest eigenvalue of the operator of order `order` ≥ 1 by which `apply` multiplies a
    /// vector. The first vector is [`scatter`]'s.
    pub fn largest(&mut self, order: usize, mut apply: impl FnMut(&mut [f64])) -> f64 {
        self.basis.clear();
        self.diagonal.clear();
        self.beside.clear();
        self.work.resize(order, 0.0);
        scatter(&mut self.work, 0);
        let mut beside = dot(&self.work, &self.work).sqrt();
        let (mut largest, mut residual) = (0.0, 0.0);
        loop {
            self.basis.extend(self.work.iter().map(|x| x / beside));
            let newest = self.basis.len() - order;
            self.work.copy_from_slice(&self.basis[newest..]);
            apply(&mut self.work);
            // Against all vectors, not the last two alone: `order` of them are then the end.
            let mut along = 0.0;
            for q in self.basis.chunks_exact(order) {
                along = dot(q, &self.work);
                let pairs = self.work.iter_mut().zip(q);
                pairs.for_each(|(w, q)| *w -= along * q);
            }
            self.diagonal.push(along);
            let last;
            (largest, last) = self.extend(largest, residual);
            // M times the eigenvector of T is θ times it, but for the last entry's share of what is new.
            beside = dot(&self.work, &self.work).sqrt();
            residual = beside * last;
            if self.diagonal.len() == order || !(residual > RESIDUAL * largest) {
                return largest;
            }
            self.beside.push(beside);
        }
    }

    /// The largest eigenvalue θ of T with its last row, and the last entry of its unit vector without
    /// sign, from θ and the residual of T without that row.
    fn extend(&self, before: f64, residual: f64) -> (f64, f64) {
        let alpha = self.diagonal[self.diagonal.len() - 1];
        if self.beside.is_empty() {
            return (alpha, 1.0);
        }
        // On the old vector and the new row alone: between the old eigenvalue and the new one.
        let half = 0.5 * (before - alpha);
        let root = (half * half + residual * residual).sqrt();
        let mut theta = if half > 0.0 {
            before + residual * residual / (half + root)
        } else {
            alpha + residual * residual / (root - half)
        };
        // The last pivot p of θ − T is 0 at θ, and from the old eigenvalue on grows ever slower: Newton's
        // method comes from below and does not pass it. The last entry is 1 / √p′.
        let mut slope = 1.0;
        for _ in 0..STEPS {
            let least = f64::EPSILON * theta;
            let mut pivot = theta - self.diagonal[0];
            slope = 1.0;
            for (alpha, beside) in self.diagonal[1..].iter().zip(&self.beside) {
                // All but the last are positive, up to rounding.
                let ratio = beside / pivot.max(least);
                slope = 1.0 + ratio * ratio * slope;
                pivot = theta - alpha - beside * ratio;
            }
            let step = -pivot / slope;
            if !(step > least) {
                break;
            }
            theta += step;
        }
        (theta, 1.0 / slope.sqrt())
    }
}

/// Numbers in ±½ without any pattern that a linkage's symmetry could answer, the same in every call: a
/// vector to begin with. Different `seed`s give different ones.
pub fn scatter(out: &mut [f64], seed: u64) {
    // A linear congruence (Knuth's MMIX); the first numbers of small seeds would be alike.
    let next = |x: u64| {
        x.wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407)
    };
    let mut state = next(next(seed));
    for x in out {
        state = next(state);
        // The upper 53 bits, which a double holds.
        *x = (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
