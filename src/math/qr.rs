//! Column-pivoted Householder QR of small dense matrices.

use crate::math::dot::dot;

/// Householder QR with column pivoting, A P = Q R, stopped where the rest is below a threshold.
///
/// The buffers are kept between factorisations, so that a solver's iterations do not allocate.
#[derive(Clone, Debug, Default)]
pub struct PivotedQr {
    rows: usize,
    /// Qᵀ A P: R11 and R12 in the first `rank` rows, the remainder below the threshold in the others
    /// of the columns after the rank.
    a: Vec<f64>,
    /// The reflections' vectors v, `rows` entries each, and 2 / vᵀv.
    v: Vec<f64>,
    beta: Vec<f64>,
    /// 1 / the diagonal of R11.
    inverse: Vec<f64>,
    /// `order[j]` is the original index of pivoted column j.
    order: Vec<usize>,
    rank: usize,
}

impl PivotedQr {
    /// Starts a matrix of `rows` rows and no columns.
    pub fn clear(&mut self, rows: usize) {
        self.rows = rows;
        self.a.clear();
        self.order.clear();
        self.v.clear();
        self.inverse.clear();
        self.beta.clear();
        self.rank = 0;
    }

    /// Appends a column.
    #[inline]
    pub fn push(&mut self, column: &[f64]) {
        debug_assert_eq!(column.len(), self.rows);
        self.order.push(self.order.len());
        self.a.extend_from_slice(column);
    }

    /// Appends a column of zeros, to be written.
    #[inline]
    pub fn push_zeros(&mut self) -> &mut [f64] {
        self.order.push(self.order.len());
        let at = self.a.len();
        self.a.resize(at + self.rows, 0.0);
        &mut self.a[at..]
    }

    /// Factors until no remaining column is longer than `threshold`, or `max_rank` is reached.
    #[inline]
    pub fn factor(&mut self, threshold: f64, max_rank: usize) {
        // Six rows are the common case; with the constant the loops below unroll.
        if self.rows == 6 {
            self.factor_rows(6, threshold, max_rank);
        } else {
            self.factor_rows(self.rows, threshold, max_rank);
        }
    }

    #[inline(always)]
    fn factor_rows(&mut self, rows: usize, threshold: f64, max_rank: usize) {
        let columns = self.order.len();
        let limit = rows.min(columns).min(max_rank);
        while self.rank < limit {
            let k = self.rank;
            // Norms are formed anew: updating them loses digits just where the rank is decided.
            let mut best = (k, 0.0);
            for (j, column) in self.a.chunks_exact(rows).enumerate().skip(k) {
                let norm2: f64 = column[k..].iter().map(|x| x * x).sum();
                if norm2 > best.1 {
                    best = (j, norm2);
                }
            }
            let norm = best.1.sqrt();
            // Written so that NaN ends the factorisation too.
            if !(norm > threshold) {
                return;
            }
            if best.0 != k {
                let (head, tail) = self.a.split_at_mut(best.0 * rows);
                head[k * rows..(k + 1) * rows].swap_with_slice(&mut tail[..rows]);
                self.order.swap(k, best.0);
            }
            // v = x − α e₁ with α = −sign(x₁) ‖x‖, and 2/vᵀv = 1 / (‖x‖ (‖x‖ + |x₁|)).
            let (head, tail) = self.a.split_at_mut((k + 1) * rows);
            let pivot = &mut head[k * rows..];
            let alpha = if pivot[k] > 0.0 { -norm } else { norm };
            let beta = 1.0 / (norm * (norm + pivot[k].abs()));
            self.v.extend_from_slice(pivot);
            let v = &mut self.v[k * rows..];
            v[..k].fill(0.0);
            v[k] -= alpha;
            pivot[k] = alpha;
            for column in tail.chunks_exact_mut(rows) {
                reflect(v, beta, column);
            }
            self.beta.push(beta);
            self.inverse.push(1.0 / alpha);
            self.rank += 1;
        }
    }

    /// Number of columns that were found independent.
    #[inline]
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// Original column indices in pivoted order; the first `rank` are the independent ones.
    #[inline]
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// About the sum of the squares of R11⁻¹: those on its diagonal. With pivots the whole is seldom twice that.
    pub fn inverse_size(&self) -> f64 {
        dot(&self.inverse, &self.inverse)
    }

    /// x ← Qᵀ x.
    pub fn apply_qt(&self, x: &mut [f64]) {
        for k in 0..self.rank {
            self.reflect_by(k, x);
        }
    }

    /// x ← Q x.
    pub fn apply_q(&self, x: &mut [f64]) {
        for k in (0..self.rank).rev() {
            self.reflect_by(k, x);
        }
    }

    fn reflect_by(&self, k: usize, x: &mut [f64]) {
        reflect(&self.v[k * self.rows..(k + 1) * self.rows], self.beta[k], x);
    }

    /// Entry of Qᵀ A P: R11, R12 or, below the rank, the remainder.
    #[inline]
    pub fn entry(&self, row: usize, column: usize) -> f64 {
        self.a[column * self.rows + row]
    }

    /// x ← R11⁻¹ x, on the first `rank` entries.
    pub fn solve_r(&self, x: &mut [f64]) {
        for i in (0..self.rank).rev() {
            let column = &self.a[i * self.rows..];
            let xi = x[i] * self.inverse[i];
            x[i] = xi;
            for (xj, r) in x[..i].iter_mut().zip(column) {
                *xj -= xi * r;
            }
        }
    }

    /// x ← R11⁻ᵀ x, on the first `rank` entries.
    pub fn solve_rt(&self, x: &mut [f64]) {
        for i in 0..self.rank {
            let column = &self.a[i * self.rows..];
            let sum: f64 = x[..i].iter().zip(column).map(|(x, r)| x * r).sum();
            x[i] = (x[i] - sum) * self.inverse[i];
        }
    }
}

/// x ← (I − β v vᵀ) x.
#[inline(always)]
fn reflect(v: &[f64], beta: f64, x: &mut [f64]) {
    // Six rows are the common case; with the constant the loops unroll.
    if let (Ok(v), Ok(x)) = (<&[f64; 6]>::try_from(v), <&mut [f64; 6]>::try_from(&mut *x)) {
        // Summed in pairs: the additions do not wait for each other.
        let dot =
            (v[0] * x[0] + v[1] * x[1]) + (v[2] * x[2] + v[3] * x[3]) + (v[4] * x[4] + v[5] * x[5]);
        let scale = beta * dot;
        for i in 0..6 {
            x[i] -= scale * v[i];
        }
    } else {
        let dot: f64 = v.iter().zip(&*x).map(|(v, x)| v * x).sum();
        let scale = beta * dot;
        for (x, v) in x.iter_mut().zip(v) {
            *x -= scale * v;
        }
    }
}
