//! The scalar product of two vectors.

/// a·b, summed in four parts: the additions do not wait for each other.
// A copy at each of its callers would be 1 kB more of wasm.
#[inline(never)]
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (mut a4, mut b4) = (a.chunks_exact(4), b.chunks_exact(4));
    let mut sum = [0.0; 4];
    for (a, b) in (&mut a4).zip(&mut b4) {
        for i in 0..4 {
            sum[i] += a[i] * b[i];
        }
    }
    let rest = a4.remainder().iter().zip(b4.remainder());
    (sum[0] + sum[1]) + (sum[2] + sum[3]) + rest.map(|(a, b)| a * b).sum::<f64>()
}
