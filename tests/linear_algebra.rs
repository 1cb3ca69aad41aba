//! The small linear algebra against what defines each factorisation, on random matrices of the
//! sizes met here, many of them rank-deficient.

mod common;

use common::Random;
use synthetica::math::gram_schmidt::GramSchmidt;
use synthetica::math::lanczos::Lanczos;
use synthetica::math::linalg::{
    PivotedQr, Svd, cholesky, solve_lower, solve_lower_transposed, svd, symmetric_eigen,
};

/// Columns of equal length.
type Columns = Vec<Vec<f64>>;

fn random(rows: usize, columns: usize, random: &mut Random) -> Columns {
    (0..columns)
        .map(|_| (0..rows).map(|_| random.between(-1.0, 1.0)).collect())
        .collect()
}

/// A matrix of that rank: a product of two, with columns or rows graded over some decades now and
/// then.
fn of_rank(rows: usize, columns: usize, rank: usize, source: &mut Random) -> Columns {
    let (left, right) = (random(rows, rank, source), random(rank, columns, source));
    let graded = source.below(3) == 0;
    let mut product = multiply(&left, &right);
    if graded {
        for column in &mut product {
            let scale = libm::pow(10.0, source.between(-3.0, 1.0));
            column.iter_mut().for_each(|x| *x *= scale);
        }
    }
    product
}

fn multiply(a: &Columns, b: &Columns) -> Columns {
    b.iter()
        .map(|column| {
            let mut sum = vec![0.0; a.first().map_or(0, Vec::len)];
            for (a, x) in a.iter().zip(column) {
                sum.iter_mut().zip(a).for_each(|(s, a)| *s += a * x);
            }
            sum
        })
        .collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn frobenius(a: &Columns) -> f64 {
    a.iter().map(|c| dot(c, c)).sum::<f64>().sqrt()
}

/// Largest entry of A − B.
fn apart(a: &Columns, b: &Columns) -> f64 {
    assert_eq!(a.len(), b.len());
    let columns = a.iter().zip(b);
    columns
        .flat_map(|(a, b)| a.iter().zip(b))
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}

/// Symmetric, as one slice.
fn gram(a: &Columns) -> Vec<f64> {
    a.iter().flat_map(|x| a.iter().map(|y| dot(x, y))).collect()
}

/// The shapes of [A]ᵀ for the linkages of the paper and of the golden file, and small ones.
const SHAPES: [(usize, usize); 9] = [
    (1, 1),
    (6, 1),
    (6, 5),
    (6, 6),
    (8, 5),
    (16, 14),
    (23, 20),
    (27, 26),
    (38, 33),
];

#[test]
fn svd_reconstructs_and_keeps_the_frobenius_norm() {
    let mut source = Random(1172);
    for round in 0..4000 {
        let (rows, columns) = SHAPES[round % SHAPES.len()];
        let rank = columns
            - if source.below(2) == 0 {
                source.below(columns.min(4))
            } else {
                0
            };
        let a = of_rank(rows, columns, rank, &mut source);
        let s = svd(a.clone());
        let norm = frobenius(&a);
        let tolerance = 1e-14 * norm * (columns as f64).sqrt();
        // Σσ² = ‖A‖²: what nalgebra's issue 1172 breaks.
        let sum = dot(&s.sigma, &s.sigma).sqrt();
        assert!(
            (sum - norm).abs() <= tolerance,
            "{rows}×{columns} rank {rank}: {sum} for {norm}"
        );
        assert!(s.sigma.is_sorted_by(|x, y| x >= y));
        assert!(s.sigma.iter().all(|x| *x >= 0.0));
        assert!(
            s.sigma[rank..].iter().all(|x| *x <= tolerance),
            "{rows}×{columns} rank {rank}: {:?}",
            s.sigma
        );
        assert!(
            s.sigma[rank - 1] > 1e-9 * norm || rank == columns || s.sigma[rank - 1] > tolerance
        );
        // A = U Σ Vᵀ.
        let scaled: Columns =
            s.u.iter()
                .zip(&s.sigma)
                .map(|(u, x)| u.iter().map(|u| u * x).collect())
                .collect();
        let vt: Columns = (0..columns)
            .map(|j| s.v.iter().map(|v| v[j]).collect())
            .collect();
        assert!(apart(&multiply(&scaled, &vt), &a) <= tolerance);
        for i in 0..columns {
            for j in 0..columns {
                let one = f64::from(i == j);
                assert!((dot(&s.v[i], &s.v[j]) - one).abs() < 1e-13);
                if i.max(j) < rank && s.sigma[i.max(j)] > 1e-3 * norm {
                    assert!((dot(&s.u[i], &s.u[j]) - one).abs() < 1e-11);
                }
            }
        }
    }
}

#[test]
fn svd_of_nothing_much() {
    assert!(svd(vec![]).sigma.is_empty());
    assert_eq!(svd(vec![vec![0.0; 6]; 3]).sigma, [0.0; 3]);
    let same = svd(vec![vec![1.0, 2.0, 2.0]; 4]);
    assert!((same.sigma[0] - 6.0).abs() < 1e-14 && same.sigma[1..].iter().all(|x| *x < 1e-14));
    // More columns than rows: the surplus is zero.
    let wide = svd(vec![vec![3.0, 0.0], vec![0.0, 4.0], vec![0.0, 0.0]]);
    assert_eq!(wide.sigma, [4.0, 3.0, 0.0]);
}

/// One value after matrices of other shapes gives what a new one gives.
#[test]
fn svd_again() {
    let mut source = Random(3);
    let mut again = Svd::default();
    for round in 0..200 {
        let (rows, columns) = SHAPES[round % SHAPES.len()];
        let a = of_rank(rows, columns, columns.min(1 + source.below(6)), &mut source);
        again.clear(rows);
        a.iter().for_each(|c| again.push(c));
        again.factor();
        let once = svd(a);
        assert_eq!(again.sigma(), once.sigma);
        for k in 0..columns {
            assert_eq!(again.u(k), once.u[k]);
            assert_eq!(again.v(k), once.v[k]);
        }
    }
}

/// Eigenvalues over decades, equal ones, and ones that are close to the largest.
#[test]
fn lanczos_finds_the_largest_eigenvalue() {
    let mut source = Random(1950);
    let mut lanczos = Lanczos::default();
    for round in 0..3000 {
        let n = 1 + round % 30;
        let mut values: Vec<f64> = (0..n)
            .map(|_| libm::pow(10.0, source.between(-3.0, 3.0)))
            .collect();
        let largest = values.iter().copied().fold(0.0, f64::max);
        if n > 2 && source.below(2) == 0 {
            values[0] = largest;
            values[1] = largest * (1.0 - libm::pow(10.0, source.between(-9.0, -1.0)));
        }
        // On axes turned by a reflection.
        let axis = &random(n, 1, &mut source)[0];
        let turn = |x: &mut [f64]| {
            let along = 2.0 * dot(axis, x) / dot(axis, axis);
            x.iter_mut().zip(axis).for_each(|(x, a)| *x -= along * a);
        };
        let found = lanczos.largest(n, 0.0, f64::INFINITY, |x| {
            turn(x);
            x.iter_mut().zip(&values).for_each(|(x, v)| *x *= v);
            turn(x);
        });
        assert!(
            (found - largest).abs() <= 1e-7 * largest,
            "order {n}: {found:e} for {largest:e}"
        );
    }
}

#[test]
fn pivoted_qr_factors_and_finds_the_rank() {
    let mut source = Random(2003);
    let mut qr = PivotedQr::default();
    for round in 0..6000 {
        let (rows, columns) = if round % 2 == 0 {
            SHAPES[round / 2 % SHAPES.len()]
        } else {
            (6, 1 + source.below(12))
        };
        let full = rows.min(columns);
        let rank = full
            - if source.below(2) == 0 {
                source.below(full.min(4))
            } else {
                0
            };
        let a = of_rank(rows, columns, rank, &mut source);
        let norm = frobenius(&a);
        qr.clear(rows);
        a.iter().for_each(|c| qr.push(c));
        qr.factor(1e-12 * norm, usize::MAX);
        assert_eq!(qr.rank(), rank, "{rows}×{columns}");
        // Q R = A P, remainder included.
        for (j, &original) in qr.order().iter().enumerate() {
            let mut column: Vec<f64> = (0..rows)
                .map(|i| {
                    if i <= j.min(rank) || j >= rank {
                        qr.entry(i, j)
                    } else {
                        0.0
                    }
                })
                .collect();
            if j < rank {
                // The diagonal's place holds the Householder vector; R's own entry by Qᵀ a.
                column = a[original].clone();
                qr.apply_qt(&mut column);
                assert!(
                    column[j + 1..].iter().all(|x| x.abs() <= 1e-14 * norm),
                    "R is triangular"
                );
                assert!((0..j).all(|i| (column[i] - qr.entry(i, j)).abs() <= 1e-14 * norm));
            }
            qr.apply_q(&mut column);
            let difference = column
                .iter()
                .zip(&a[original])
                .map(|(x, y)| (x - y).abs())
                .fold(0.0, f64::max);
            assert!(
                difference <= 1e-14 * norm,
                "{rows}×{columns}, column {j}: {difference:e}"
            );
        }
        let mut order = qr.order().to_vec();
        order.sort_unstable();
        assert!(
            order.iter().enumerate().all(|(i, o)| i == *o),
            "a permutation"
        );
        // The columns of Q after the rank: orthonormal, and across every column of A.
        for k in rank..rows {
            let mut z = vec![0.0; rows];
            z[k] = 1.0;
            qr.apply_q(&mut z);
            assert!((dot(&z, &z) - 1.0).abs() < 1e-14);
            assert!(a.iter().all(|c| dot(c, &z).abs() <= 1e-14 * norm));
        }
        solves(&qr, &a, &mut source);
    }
}

/// R11 x = b and R11ᵀ x = b, checked by multiplying back.
fn solves(qr: &PivotedQr, a: &Columns, source: &mut Random) {
    let rank = qr.rank();
    let b: Vec<f64> = (0..rank).map(|_| source.between(-1.0, 1.0)).collect();
    let r: Columns = qr.order()[..rank]
        .iter()
        .map(|&j| {
            let mut c = a[j].clone();
            qr.apply_qt(&mut c);
            c.truncate(rank);
            c
        })
        .collect();
    let mut x = b.clone();
    qr.solve_r(&mut x);
    let size = x.iter().fold(1.0_f64, |m, x| m.max(x.abs())) * (1.0 + frobenius(&r));
    let back = &multiply(&r, &vec![x])[0];
    assert!(
        back.iter()
            .zip(&b)
            .all(|(x, y)| (x - y).abs() <= 1e-13 * size)
    );
    let mut x = b.clone();
    qr.solve_rt(&mut x);
    let size = x.iter().fold(1.0_f64, |m, x| m.max(x.abs())) * (1.0 + frobenius(&r));
    assert!(
        r.iter()
            .zip(&b)
            .all(|(c, y)| (dot(c, &x) - y).abs() <= 1e-13 * size)
    );
}

/// The rank is decided at the threshold, neither a decade above nor below, and never beyond the most
/// that is asked for.
#[test]
fn pivoted_qr_decides_at_the_threshold() {
    let mut source = Random(5);
    for _ in 0..500 {
        let gap = libm::pow(10.0, source.between(-11.0, -3.0));
        let (mut u, mut v) = (random(8, 1, &mut source), random(8, 1, &mut source));
        let (u, v) = (u.remove(0), v.remove(0));
        let across = dot(&v, &u) / dot(&u, &u);
        let v: Vec<f64> = v.iter().zip(&u).map(|(v, u)| v - across * u).collect();
        let length = dot(&v, &v).sqrt();
        let near: Vec<f64> = u
            .iter()
            .zip(&v)
            .map(|(u, v)| u + gap * v / length)
            .collect();
        let mut qr = PivotedQr::default();
        for (threshold, rank) in [(0.1 * gap, 2), (10.0 * gap, 1)] {
            qr.clear(8);
            qr.push(&u);
            qr.push(&near);
            qr.factor(threshold, 8);
            assert_eq!(qr.rank(), rank, "gap {gap:e}");
        }
        qr.clear(8);
        qr.push(&u);
        qr.push(&near);
        qr.factor(0.0, 1);
        assert_eq!(qr.rank(), 1);
    }
    let mut qr = PivotedQr::default();
    qr.clear(3);
    qr.push(&[f64::NAN; 3]);
    qr.factor(1e-9, 3);
    assert_eq!(qr.rank(), 0, "what is not a number is no direction");
}

#[test]
fn symmetric_eigenvectors() {
    let mut source = Random(9);
    for round in 0..2000 {
        let n = 1 + round % 12;
        let rank = 1 + source.below(n);
        let a = gram(&of_rank(n + 2, n, rank, &mut source));
        // Indefinite now and then.
        let shift = if source.below(2) == 0 {
            source.between(0.0, 1.0)
        } else {
            0.0
        };
        let a: Vec<f64> = a
            .iter()
            .enumerate()
            .map(|(i, x)| if i % (n + 1) == 0 { x - shift } else { *x })
            .collect();
        let size = dot(&a, &a).sqrt();
        let (mut d, mut v) = (a.clone(), vec![0.0; n * n]);
        symmetric_eigen(&mut d, n, &mut v);
        for (i, vector) in v.chunks_exact(n).enumerate() {
            for (j, other) in v.chunks_exact(n).enumerate() {
                assert!((dot(vector, other) - f64::from(i == j)).abs() < 1e-13);
                assert!(i == j || d[i * n + j].abs() <= 1e-14 * size);
            }
            for (row, v) in a.chunks_exact(n).zip(vector) {
                assert!(
                    (dot(row, vector) - d[i * n + i] * v).abs() <= 1e-13 * size,
                    "order {n}"
                );
            }
        }
    }
}

#[test]
fn cholesky_solves() {
    let mut source = Random(21);
    for round in 0..2000 {
        let n = 1 + round % 10;
        // A wider stride than the order, as where a block of a larger matrix is meant.
        let stride = n + source.below(3);
        let columns = random(n + 4, n, &mut source);
        let full = gram(&columns);
        let mut l = vec![f64::NAN; stride * n];
        for j in 0..n {
            l[j * stride + j..j * stride + n].copy_from_slice(&full[j * n + j..(j + 1) * n]);
        }
        assert!(cholesky(&mut l, n, stride, 0.0));
        let b: Vec<f64> = (0..n).map(|_| source.between(-1.0, 1.0)).collect();
        let mut x = b.clone();
        solve_lower(&l, n, stride, &mut x);
        solve_lower_transposed(&l, n, stride, &mut x);
        let size = x.iter().fold(1.0_f64, |m, x| m.max(x.abs())) * dot(&full, &full).sqrt();
        for (row, b) in full.chunks_exact(n).zip(&b) {
            assert!((dot(row, &x) - b).abs() <= 1e-14 * size, "order {n}");
        }
    }
    // Not definite, or not enough.
    assert!(!cholesky(&mut [1.0, 2.0, 0.0, 1.0], 2, 2, 0.0));
    assert!(!cholesky(&mut [1.0, 0.0, 0.0, 1e-3], 2, 2, 1e-2));
    assert!(!cholesky(&mut [f64::NAN], 1, 1, 0.0));
    assert!(cholesky(&mut [], 0, 0, 0.0));
}

/// Columns of six entries: the rows give back what the columns are combined of, and those across are orthonormal.
#[test]
fn columns_of_six_entries() {
    let mut source = Random(17);
    for round in 0..3000 {
        let count = source.below(6);
        let rank = 1 + source.below(6);
        let given = of_rank(6, count, rank, &mut source);
        let mut columns: Vec<[f64; 6]> = given
            .iter()
            .map(|c| std::array::from_fn(|i| c[i]))
            .collect();
        let mut order: Vec<usize> = (0..count).collect();
        let mut qr = GramSchmidt::default();
        let threshold = 0.05;
        qr.factor(&mut columns, &mut order, threshold);
        assert!(qr.rank <= rank.min(count), "{round}");
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        for p in qr.rank..6 {
            for l in qr.rank..6 {
                let unit = f64::from(u8::from(p == l));
                assert!((dot(&qr.rows[p], &qr.rows[l]) - unit).abs() < 1e-14);
            }
            for (k, &column) in order.iter().enumerate() {
                let remainder = if k < qr.rank { 0.0 } else { qr.rest[k][p] };
                let found = dot(&qr.rows[p], &given[column]);
                assert!((found - remainder).abs() < 1e-12, "{round}: {found:e}");
            }
        }
        for i in 0..qr.rank {
            for (k, &column) in order.iter().enumerate() {
                let unit = f64::from(u8::from(k == i));
                let wanted = if k < qr.rank { unit } else { qr.rest[k][i] };
                let found = dot(&qr.rows[i], &given[column]);
                assert!((found - wanted).abs() < 1e-11, "{round}: {found} {wanted}");
            }
        }
        for k in qr.rank..count {
            let rest = qr.rest[k][qr.rank..].iter().map(|x| x * x).sum::<f64>();
            assert!(rest.sqrt() <= threshold * (1.0 + 1e-12), "{round}");
        }
    }
}
