//! The normal matrix of all loops at once, shifted and inverted chain by chain.

use nalgebra::Vector6;

/// Equations a chain.
const LOOP: usize = 6;
/// Square of the length of the rows of \[J_E\], which are orthogonal.
const TWIST2: f64 = 4.0;
/// Pivot that may be rounding, as a share of the largest diagonal entry.
const PIVOT: f64 = 1e-12;

/// M = B Bᵀ less a shift, M u_i = P_i u_i + 4 Σ u_j with P_i = J_i J_iᵀ; see
/// [`SingularValues`](crate::solve::singular_values::SingularValues).
///
/// All chains share the block 4 I. Once the first chain's unknowns are eliminated, the later ones share another block in its
/// place, S ← S − S A⁻¹ S with A = P + S, and so on: the cost grows with the number of chains. Blocks are kept as inverses:
/// products with them are independent operations, where substitutions find each unknown from the one before.
#[derive(Clone, Debug, Default)]
pub struct LoopNormal {
    blocks: Vec<Block>,
}

type Matrix = [[f64; LOOP]; LOOP];

/// A⁻¹, and A⁻¹ S by rows and by columns: all products with vectors add up rows.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    inverse: Matrix,
    across: Matrix,
    columns: Matrix,
}

impl LoopNormal {
    /// Inverts M − `shift` I. Returns the largest entry of M's diagonal; none unless the matrix is positive definite beyond
    /// rounding, which says that all eigenvalues of M are above the shift.
    pub fn factor<'a>(
        &mut self,
        jacobians: impl IntoIterator<Item = &'a [Vector6<f64>]>,
        shift: f64,
    ) -> Option<f64> {
        self.blocks.clear();
        let mut shared = Matrix::default();
        for i in 0..LOOP {
            shared[i][i] = TWIST2;
        }
        let mut largest = 0.0_f64;
        for jacobian in jacobians {
            let mut a = shared;
            let mut diagonal = [TWIST2; LOOP];
            for i in 0..LOOP {
                a[i][i] -= shift;
            }
            for column in jacobian {
                for i in 0..LOOP {
                    diagonal[i] += column[i] * column[i];
                    for j in 0..LOOP {
                        a[i][j] += column[i] * column[j];
                    }
                }
            }
            largest = diagonal.into_iter().fold(largest, f64::max);
            if !invert(&mut a, PIVOT * largest) {
                return None;
            }
            let mut block = Block {
                inverse: a,
                ..Block::default()
            };
            for i in 0..LOOP {
                add_product(&mut block.across[i], &a[i], &shared, 1.0);
            }
            let mut left = shared;
            for i in 0..LOOP {
                add_product(&mut left[i], &shared[i], &block.across, -1.0);
                for j in 0..LOOP {
                    block.columns[j][i] = block.across[i][j];
                }
            }
            shared = left;
            self.blocks.push(block);
        }
        Some(largest)
    }

    /// x ← (M − shift)⁻¹ x, one entry an equation.
    pub fn solve(&self, x: &mut [f64]) {
        let (own, _) = x.as_chunks_mut::<LOOP>();
        // What the chains so far leave of 0 in all later ones.
        let mut rest = [0.0; LOOP];
        for (own, block) in own.iter_mut().zip(&self.blocks) {
            let mut y = rest;
            for i in 0..LOOP {
                y[i] += own[i];
            }
            *own = [0.0; LOOP];
            add_product(own, &y, &block.inverse, 1.0);
            add_product(&mut rest, &y, &block.across, -1.0);
        }
        let mut later = [0.0; LOOP];
        for (own, block) in own.iter_mut().zip(&self.blocks).rev() {
            add_product(own, &later, &block.columns, -1.0);
            for i in 0..LOOP {
                later[i] += own[i];
            }
        }
    }
}

/// sum ← sum + sign · x M.
#[inline(never)]
fn add_product(sum: &mut [f64; LOOP], x: &[f64; LOOP], m: &Matrix, sign: f64) {
    for i in 0..LOOP {
        let x = sign * x[i];
        for j in 0..LOOP {
            sum[j] += x * m[i][j];
        }
    }
}

/// A ← A⁻¹ by Gauss–Jordan steps, which need no pivoting where A is positive definite; false if a pivot is not above `least`.
#[inline(never)]
fn invert(a: &mut Matrix, least: f64) -> bool {
    for k in 0..LOOP {
        // Written so that NaN is singular.
        if !(a[k][k] > least) {
            return false;
        }
        let inverse = 1.0 / a[k][k];
        a[k][k] = 1.0;
        for x in &mut a[k] {
            *x *= inverse;
        }
        let pivot = a[k];
        for (i, row) in a.iter_mut().enumerate() {
            if i != k {
                let x = row[k];
                row[k] = 0.0;
                for j in 0..LOOP {
                    row[j] -= x * pivot[j];
                }
            }
        }
    }
    true
}
