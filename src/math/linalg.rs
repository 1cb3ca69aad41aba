//! Small dense linear algebra: column-pivoted QR, singular values, symmetric eigenvalues.
//!
//! nalgebra's SVD returns wrong values on about one in a thousand to twenty thousand matrices of
//! the kind met here (its issue 1172), most often rank-deficient ones, and lacks the null space;
//! its factorisations also allocate. Matrices are slices, one column after the other.

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

    /// x ← Qᵀ x.
    #[inline]
    pub fn apply_qt(&self, x: &mut [f64]) {
        for k in 0..self.rank {
            self.reflect_by(k, x);
        }
    }

    /// x ← Q x.
    #[inline]
    pub fn apply_q(&self, x: &mut [f64]) {
        for k in (0..self.rank).rev() {
            self.reflect_by(k, x);
        }
    }

    #[inline]
    fn reflect_by(&self, k: usize, x: &mut [f64]) {
        reflect(&self.v[k * self.rows..(k + 1) * self.rows], self.beta[k], x);
    }

    /// Entry of Qᵀ A P: R11, R12 or, below the rank, the remainder.
    #[inline]
    pub fn entry(&self, row: usize, column: usize) -> f64 {
        self.a[column * self.rows + row]
    }

    /// x ← R11⁻¹ x, on the first `rank` entries.
    #[inline]
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
    #[inline]
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

/// Cholesky factor L of the leading `n` × `n` block of a symmetric matrix given by its lower
/// triangle, columns `stride` apart; false if it is not positive definite beyond `least` on the
/// diagonal of L².
#[inline]
pub fn cholesky(a: &mut [f64], n: usize, stride: usize, least: f64) -> bool {
    for j in 0..n {
        let mut diagonal = a[j * stride + j];
        for k in 0..j {
            diagonal -= a[k * stride + j] * a[k * stride + j];
        }
        if !(diagonal > least) {
            return false;
        }
        let diagonal = diagonal.sqrt();
        a[j * stride + j] = diagonal;
        for i in j + 1..n {
            let mut sum = a[j * stride + i];
            for k in 0..j {
                sum -= a[k * stride + i] * a[k * stride + j];
            }
            a[j * stride + i] = sum / diagonal;
        }
    }
    true
}

/// x ← L⁻¹ x.
#[inline]
pub fn solve_lower(l: &[f64], n: usize, stride: usize, x: &mut [f64]) {
    for j in 0..n {
        x[j] /= l[j * stride + j];
        for i in j + 1..n {
            x[i] -= l[j * stride + i] * x[j];
        }
    }
}

/// x ← L⁻ᵀ x.
#[inline]
pub fn solve_lower_transposed(l: &[f64], n: usize, stride: usize, x: &mut [f64]) {
    for j in (0..n).rev() {
        for i in j + 1..n {
            x[j] -= l[j * stride + i] * x[i];
        }
        x[j] /= l[j * stride + j];
    }
}

/// Eigenvalues of a symmetric matrix of order `n`, by cyclic Jacobi rotations: `a` becomes
/// diagonal, and `vectors` receives the eigenvectors as columns. Both have `n` × `n` entries.
pub fn symmetric_eigen(a: &mut [f64], n: usize, vectors: &mut [f64]) {
    /// Jacobi converges quadratically; 8 sweeps are the most seen on 40 × 40 random matrices.
    const SWEEPS: usize = 30;
    vectors.fill(0.0);
    vectors.iter_mut().step_by(n + 1).for_each(|x| *x = 1.0);
    let scale: f64 = a.iter().map(|x| x * x).sum();
    for _ in 0..SWEEPS {
        let mut off = 0.0;
        for p in 0..n {
            for q in p + 1..n {
                let apq = a[q * n + p];
                off += apq * apq;
                if apq == 0.0 {
                    continue;
                }
                let tau = (a[q * n + q] - a[p * n + p]) / (2.0 * apq);
                let t = tau.signum() / (tau.abs() + (1.0 + tau * tau).sqrt());
                let c = 1.0 / (1.0 + t * t).sqrt();
                let s = c * t;
                for k in 0..n {
                    (a[k * n + p], a[k * n + q]) = (
                        c * a[k * n + p] - s * a[k * n + q],
                        s * a[k * n + p] + c * a[k * n + q],
                    );
                }
                for m in [&mut *a, &mut *vectors] {
                    for k in 0..n {
                        (m[p * n + k], m[q * n + k]) = (
                            c * m[p * n + k] - s * m[q * n + k],
                            s * m[p * n + k] + c * m[q * n + k],
                        );
                    }
                }
            }
        }
        if off <= scale * 1e-32 {
            return;
        }
    }
}

/// Thin singular value decomposition A = U Σ Vᵀ by one-sided Jacobi rotations on the columns.
///
/// Accurate to a few units of the last place of the largest singular value whatever the rank.
#[derive(Clone, Debug)]
pub struct Svd {
    /// Left singular vectors, one after the other; those of zero singular values are 0.
    pub u: Vec<Vec<f64>>,
    /// Singular values, largest first.
    pub sigma: Vec<f64>,
    /// Right singular vectors, in the same order.
    pub v: Vec<Vec<f64>>,
}

/// The decomposition of a matrix given as columns of equal length.
///
/// At most as many columns as rows are wanted: decompose the transpose otherwise, or the surplus
/// shows as zero singular values.
pub fn svd(mut columns: Vec<Vec<f64>>) -> Svd {
    const SWEEPS: usize = 60;
    /// Cosine of the angle between two columns that count as orthogonal.
    const ORTHOGONAL: f64 = 1e-15;
    let n = columns.len();
    let mut v: Vec<Vec<f64>> = (0..n)
        .map(|j| (0..n).map(|i| f64::from(i == j)).collect())
        .collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    for _ in 0..SWEEPS {
        let mut turned = false;
        for p in 0..n {
            for q in p + 1..n {
                let (pp, qq) = (dot(&columns[p], &columns[p]), dot(&columns[q], &columns[q]));
                let pq = dot(&columns[p], &columns[q]);
                if pq.abs() <= ORTHOGONAL * (pp * qq).sqrt() {
                    continue;
                }
                turned = true;
                let tau = (qq - pp) / (2.0 * pq);
                let t = tau.signum() / (tau.abs() + (1.0 + tau * tau).sqrt());
                let c = 1.0 / (1.0 + t * t).sqrt();
                let s = c * t;
                for m in [&mut columns, &mut v] {
                    let (head, tail) = m.split_at_mut(q);
                    for (x, y) in head[p].iter_mut().zip(&mut tail[0]) {
                        (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
                    }
                }
            }
        }
        if !turned {
            break;
        }
    }
    let norms: Vec<f64> = columns.iter().map(|c| dot(c, c).sqrt()).collect();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| norms[b].total_cmp(&norms[a]));
    let normalised = |c: &Vec<f64>, norm: f64| -> Vec<f64> {
        c.iter()
            .map(|x| if norm > 0.0 { x / norm } else { 0.0 })
            .collect()
    };
    Svd {
        u: order
            .iter()
            .map(|&j| normalised(&columns[j], norms[j]))
            .collect(),
        sigma: order.iter().map(|&j| norms[j]).collect(),
        v: order.iter().map(|&j| v[j].clone()).collect(),
    }
}

/// The eigenvalue of index `index` (0 the smallest) of a symmetric matrix of order `n`, whose lower
/// triangle is destroyed: Householder tridiagonalisation, then Laguerre's method for the smallest and
/// bisection on Sturm counts for the others.
///
/// The absolute error is a few units of the last place of the largest eigenvalue.
pub fn symmetric_eigenvalue(a: &mut [f64], n: usize, index: usize, work: &mut Vec<f64>) -> f64 {
    work.clear();
    work.resize(3 * n, 0.0);
    let (diagonal, rest) = work.split_at_mut(n);
    let (off2, p) = rest.split_at_mut(n);
    for k in 0..n {
        diagonal[k] = a[k * n + k];
        if k + 1 == n {
            break;
        }
        // Reflect column k below the diagonal onto its first entry.
        let (head, tail) = a.split_at_mut((k + 1) * n);
        let v = &mut head[k * n + k + 1..];
        let norm2: f64 = v.iter().map(|x| x * x).sum();
        off2[k] = norm2;
        let m = v.len();
        if norm2 == 0.0 || m == 1 {
            continue;
        }
        let norm = norm2.sqrt();
        let beta = 1.0 / (norm * (norm + v[0].abs()));
        v[0] += if v[0] > 0.0 { norm } else { -norm };
        // Rank-two update of the remaining block B ← B − v wᵀ − w vᵀ, lower triangle only.
        let p = &mut p[..m];
        p.fill(0.0);
        for j in 0..m {
            let column = &tail[j * n + k + 1..(j + 1) * n];
            p[j] += column[j] * v[j];
            let (mut sum, vj) = (0.0, v[j]);
            for i in j + 1..m {
                sum += column[i] * v[i];
                p[i] += column[i] * vj;
            }
            p[j] += sum;
        }
        let mut dot = 0.0;
        for (p, v) in p.iter_mut().zip(&*v) {
            *p *= beta;
            dot += *p * v;
        }
        let half = 0.5 * beta * dot;
        for (p, v) in p.iter_mut().zip(&*v) {
            *p -= half * v;
        }
        for j in 0..m {
            let (vj, pj) = (v[j], p[j]);
            let column = &mut tail[j * n + k + 1..(j + 1) * n];
            for i in j..m {
                column[i] -= v[i] * pj + p[i] * vj;
            }
        }
    }
    let (diagonal, off2) = (&*diagonal, &off2[..n - 1]);
    // Gershgorin's bounds.
    let radius = |i: usize| {
        let left = if i > 0 { off2[i - 1].sqrt() } else { 0.0 };
        left + off2.get(i).map_or(0.0, |x| x.sqrt())
    };
    let low = (0..n)
        .map(|i| diagonal[i] - radius(i))
        .fold(f64::INFINITY, f64::min);
    let high = (0..n)
        .map(|i| diagonal[i] + radius(i))
        .fold(f64::NEG_INFINITY, f64::max);
    let resolution = f64::EPSILON * low.abs().max(high.abs());
    if index == 0 {
        smallest_by_laguerre(diagonal, off2, low, resolution)
    } else {
        by_bisection(diagonal, off2, index, (low, high), resolution)
    }
}

/// The smallest eigenvalue of a tridiagonal matrix, from `x` below it: Laguerre's method on
/// det(T − x I) stays below and converges cubically.
fn smallest_by_laguerre(diagonal: &[f64], off2: &[f64], mut x: f64, resolution: f64) -> f64 {
    /// Six are the most seen; each at least halves the distance.
    const STEPS: usize = 60;
    let n = diagonal.len() as f64;
    for _ in 0..STEPS {
        // Pivots q of T − x I with their first two derivatives in x; Σ (ln q)′ and −Σ (ln q)″.
        let (mut q1, mut q2) = (-1.0, 0.0);
        let mut inverse = 1.0 / (diagonal[0] - x);
        let mut slope = q1 * inverse;
        let mut bend = slope * slope;
        let mut below = inverse > 0.0;
        for (d, b) in diagonal[1..].iter().zip(off2) {
            let ratio = q1 * inverse;
            let scaled = b * inverse;
            q2 = scaled * (q2 * inverse - 2.0 * ratio * ratio);
            q1 = scaled * ratio - 1.0;
            inverse = 1.0 / (d - x - scaled);
            below &= inverse > 0.0;
            slope += q1 * inverse;
            bend += q1 * inverse * q1 * inverse - q2 * inverse;
        }
        let root = ((n - 1.0) * (n * bend - slope * slope)).max(0.0).sqrt();
        let step = n / (root - slope);
        // A pivot that is not positive: rounding has carried x past the eigenvalue, so it is there.
        if !(below && step > resolution) {
            break;
        }
        x += step;
    }
    x
}

/// Any eigenvalue of a tridiagonal matrix between bounds.
fn by_bisection(
    diagonal: &[f64],
    off2: &[f64],
    index: usize,
    bounds: (f64, f64),
    resolution: f64,
) -> f64 {
    let (mut low, mut high) = bounds;
    while high - low > resolution {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        // Sturm: the negative pivots of T − x I count the eigenvalues below x.
        let mut below = 0;
        let mut pivot = 1.0;
        for i in 0..diagonal.len() {
            let coupling = if i > 0 { off2[i - 1] / pivot } else { 0.0 };
            pivot = diagonal[i] - middle - coupling;
            if pivot.abs() < f64::MIN_POSITIVE / f64::EPSILON {
                pivot = -f64::MIN_POSITIVE / f64::EPSILON;
            }
            below += usize::from(pivot < 0.0);
        }
        if below > index {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}
