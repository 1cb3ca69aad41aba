//! Cholesky factorisation of small symmetric matrices, and its triangular solves.

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
