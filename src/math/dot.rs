//! The scalar product of two vectors.

/// Σ aᵢ bᵢ, added one after the other from the first.
#[inline]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
