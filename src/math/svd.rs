//! Singular value decomposition of small dense matrices.

use crate::math::dot::dot;
use crate::math::sort::sort_few;

/// Sweeps over all pairs of columns before the rotations are given up; about eight are needed.
const SWEEPS: usize = 60;
/// Cosine of the angle between two columns that count as orthogonal: a few units of the last place.
const ORTHOGONAL: f64 = 1e-15;

/// Share of the Frobenius norm below which two columns are rounding, whatever their angle: it would
/// stay an arbitrary one however often they are turned.
const ROUNDING: f64 = 1e-16;

/// Thin singular value decomposition A = U Σ Vᵀ by one-sided Jacobi rotations on the columns.
///
/// Accurate to a few units of the last place of the largest singular value whatever the rank. At most
/// as many columns as rows are wanted: decompose the transpose otherwise, or the surplus shows as zero
/// singular values. The buffers are kept between factorisations.
#[derive(Clone, Debug, Default)]
pub struct Svd {
    rows: usize,
    /// A by columns; after the factorisation the left singular vectors in the order of `v`.
    a: Vec<f64>,
    /// The right singular vectors, one after the other.
    v: Vec<f64>,
    /// Number in `a` and `v` of the k-th singular value's vectors.
    order: Vec<usize>,
    /// In the order of `v` while the matrix is factored, then the largest first.
    sigma: Vec<f64>,
}

impl Svd {
    /// Starts a matrix of `rows` rows and no columns.
    pub fn clear(&mut self, rows: usize) {
        self.rows = rows;
        self.a.clear();
        self.v.clear();
        self.order.clear();
        self.sigma.clear();
    }

    /// Appends a column.
    pub fn push(&mut self, column: &[f64]) {
        debug_assert_eq!(column.len(), self.rows);
        self.order.push(self.order.len());
        self.a.extend_from_slice(column);
    }

    /// Decomposes the columns since [`Svd::clear`]; once, since it overwrites them.
    pub fn factor(&mut self) {
        let (m, n) = (self.rows, self.order.len());
        self.v.resize(n * n, 0.0);
        self.v.iter_mut().step_by(n + 1).for_each(|x| *x = 1.0);
        let rounding = ROUNDING * ROUNDING * dot(&self.a, &self.a);
        for _ in 0..SWEEPS {
            let mut turned = false;
            for p in 0..n {
                for q in p + 1..n {
                    let (x, y) = pair(&mut self.a, m, p, q);
                    let (xx, yy, xy) = (dot(x, x), dot(y, y), dot(x, y));
                    if xy.abs() <= rounding.max(ORTHOGONAL * (xx * yy).sqrt()) {
                        continue;
                    }
                    turned = true;
                    let tau = (yy - xx) / (2.0 * xy);
                    let t = tau.signum() / (tau.abs() + (1.0 + tau * tau).sqrt());
                    let c = 1.0 / (1.0 + t * t).sqrt();
                    let s = c * t;
                    rotate(x, y, c, s);
                    let (x, y) = pair(&mut self.v, n, p, q);
                    rotate(x, y, c, s);
                }
            }
            if !turned {
                break;
            }
        }
        for j in 0..n {
            let column = &mut self.a[j * m..(j + 1) * m];
            let norm = dot(column, column).sqrt();
            for x in column {
                *x = if norm > 0.0 { *x / norm } else { 0.0 };
            }
            self.sigma.push(norm);
        }
        let sigma = &self.sigma;
        // Equal values stay in the order of the columns.
        sort_few(&mut self.order, |&a, &b| sigma[a] > sigma[b]);
        sort_few(&mut self.sigma, |a, b| a > b);
    }

    /// The singular values, one a column, the largest first.
    pub fn sigma(&self) -> &[f64] {
        &self.sigma
    }

    /// Left singular vector of the k-th singular value, one entry a row; 0 where the value is 0.
    ///
    /// # Panics
    /// When there are not so many columns.
    pub fn u(&self, k: usize) -> &[f64] {
        let at = self.order[k] * self.rows;
        &self.a[at..at + self.rows]
    }

    /// Right singular vector of the k-th singular value, one entry a column.
    ///
    /// # Panics
    /// When there are not so many columns.
    pub fn v(&self, k: usize) -> &[f64] {
        let n = self.order.len();
        &self.v[self.order[k] * n..(self.order[k] + 1) * n]
    }
}

/// Columns `p` < `q` of a matrix of that many rows.
fn pair(a: &mut [f64], rows: usize, p: usize, q: usize) -> (&mut [f64], &mut [f64]) {
    let (head, tail) = a.split_at_mut(q * rows);
    (&mut head[p * rows..(p + 1) * rows], &mut tail[..rows])
}

fn rotate(x: &mut [f64], y: &mut [f64], c: f64, s: f64) {
    for (x, y) in x.iter_mut().zip(y) {
        (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
    }
}

/// What [`svd`] returns: [`Svd`] copied into vectors, for a matrix that is decomposed once.
#[derive(Clone, Debug)]
pub struct SvdFactors {
    /// Left singular vectors; those of zero singular values are 0.
    pub u: Vec<Vec<f64>>,
    /// Singular values, largest first.
    pub sigma: Vec<f64>,
    /// Right singular vectors, in the same order.
    pub v: Vec<Vec<f64>>,
}

/// The decomposition of a matrix given as columns of equal length; see [`Svd`].
pub fn svd(columns: Vec<Vec<f64>>) -> SvdFactors {
    let mut svd = Svd::default();
    let n = columns.len();
    for column in columns {
        if svd.order.is_empty() {
            svd.clear(column.len());
        }
        svd.push(&column);
    }
    svd.factor();
    SvdFactors {
        u: (0..n).map(|k| svd.u(k).to_vec()).collect(),
        v: (0..n).map(|k| svd.v(k).to_vec()).collect(),
        sigma: svd.sigma,
    }
}
