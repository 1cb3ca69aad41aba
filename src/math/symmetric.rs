//! Eigenvalues of small symmetric matrices.

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
