//! Singular value decomposition of small dense matrices.

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
