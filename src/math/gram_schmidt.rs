//! A few columns of six entries: what they span, and what is across it.

/// Columns at most.
const COLUMNS: usize = 5;

/// A P = Q R of a 6 × n matrix by modified Gram–Schmidt with column pivoting, n ≤ 5, stopped where the rest is below a
/// threshold, with Q made whole. Half the work of reflections where R11⁻¹ Q1ᵀ and the rest of Qᵀ are wanted themselves.
///
/// Gram–Schmidt leaves Q1 orthonormal up to rounding times the largest column over the threshold.
#[derive(Clone, Debug, Default)]
pub struct GramSchmidt {
    /// Number of columns that were found independent.
    pub rank: usize,
    /// R11⁻¹ Q1ᵀ, and below it the rest of Qᵀ, orthonormal and across the columns.
    pub rows: [[f64; 6]; 6],
    /// Of each pivoted column after the rank: R11⁻¹ R12, and below it the remainder.
    pub rest: [[f64; 6]; COLUMNS],
}

impl GramSchmidt {
    /// Factors the columns `a`, until none that remains is longer than `threshold`; `order` is put in pivoted order with them.
    pub fn factor(&mut self, a: &mut [[f64; 6]], order: &mut [usize], threshold: f64) {
        let count = a.len();
        let mut r = [[0.0; COLUMNS]; COLUMNS];
        let mut inverse = [0.0; COLUMNS];
        // Squares of what Q1 leaves of the unit vectors.
        let mut left = [1.0; 6];
        let rows = &mut self.rows;
        let mut rank = 0;
        while rank < count {
            let mut best = (rank, 0.0);
            for (j, column) in a.iter().enumerate().skip(rank) {
                let norm2 = dot6(column, column);
                if norm2 > best.1 {
                    best = (j, norm2);
                }
            }
            let norm = best.1.sqrt();
            // Written so that NaN ends the factorisation too.
            if !(norm > threshold) {
                break;
            }
            a.swap(rank, best.0);
            order.swap(rank, best.0);
            for row in &mut r[..rank] {
                row.swap(rank, best.0);
            }
            inverse[rank] = 1.0 / norm;
            let q = a[rank].map(|x| x * inverse[rank]);
            for (j, column) in a.iter_mut().enumerate().skip(rank + 1) {
                let along = dot6(&q, column);
                r[rank][j] = along;
                take6(column, &q, along);
            }
            for i in 0..6 {
                left[i] -= q[i] * q[i];
            }
            rows[rank] = q;
            rank += 1;
        }
        // Across: what is left of the unit vector of which most is, twice, since once leaves rounding along Q1.
        for p in rank..6 {
            let mut best = 0;
            for i in 1..6 {
                if left[i] > left[best] {
                    best = i;
                }
            }
            let mut x = [0.0; 6];
            x[best] = 1.0;
            for _ in 0..2 {
                let mut along = [0.0; 6];
                for (c, q) in along.iter_mut().zip(&rows[..p]) {
                    *c = dot6(q, &x);
                }
                for (c, q) in along.iter().zip(&rows[..p]) {
                    take6(&mut x, q, *c);
                }
            }
            let inverse = 1.0 / dot6(&x, &x).sqrt();
            for i in 0..6 {
                x[i] *= inverse;
                left[i] -= x[i] * x[i];
            }
            rows[p] = x;
        }
        for (j, column) in a.iter().enumerate().skip(rank) {
            for p in rank..6 {
                self.rest[j][p] = dot6(&rows[p], column);
            }
        }
        // R11⁻¹, from the last row up.
        for i in (0..rank).rev() {
            let (above, below) = rows.split_at_mut(i + 1);
            for (j, row) in below[..rank - i - 1].iter().enumerate() {
                take6(&mut above[i], row, r[i][i + 1 + j]);
            }
            above[i].iter_mut().for_each(|x| *x *= inverse[i]);
            for j in rank..count {
                let mut x = r[i][j];
                for l in i + 1..rank {
                    x -= r[i][l] * self.rest[j][l];
                }
                self.rest[j][i] = x * inverse[i];
            }
        }
        self.rank = rank;
    }
}

/// Summed in pairs: the additions do not wait for each other.
#[inline(always)]
pub fn dot6(a: &[f64; 6], x: &[f64; 6]) -> f64 {
    (a[0] * x[0] + a[1] * x[1]) + (a[2] * x[2] + a[3] * x[3]) + (a[4] * x[4] + a[5] * x[5])
}

/// x ← x − along · q.
#[inline(always)]
fn take6(x: &mut [f64; 6], q: &[f64; 6], along: f64) {
    for i in 0..6 {
        x[i] -= along * q[i];
    }
}
