//! Orthogonal factorisation of all loops at once, chain by chain.

use nalgebra::Vector6;

/// Equations a chain.
const LOOP: usize = 6;
/// Entries of a row: those in one chain's columns, and those in the columns of any later chain.
const WIDTH: usize = 2 * LOOP;
/// Length of the rows of \[J_E\], which are orthogonal: η is the workpiece's twist by half.
pub const TWIST: f64 = 2.0;

/// Bᵀ = Q R, where row block i of B is J_i θ̇_i − 2 η: chain i moves the workpiece by the twist 2 η.
///
/// In Bᵀ the rows of chain i have entries in its own six columns only, and the six rows of η have the
/// same block −2 I in the columns of every chain. Six reflections on the rows of chain i and the shared
/// ones finish six rows of R, and leave fewer shared rows with one block for all later chains again.
/// R is then given by its diagonal blocks and one block beside each, and the cost of a factorisation
/// or of a solution grows with the number of chains and not with a power of it.
#[derive(Clone, Debug, Default)]
pub struct LoopFactor {
    /// The columns of all J_i, and where those of each chain end.
    columns: Vec<[f64; LOOP]>,
    ends: Vec<usize>,
    /// R, one block a chain.
    blocks: Vec<Block>,
    /// The shared rows and those of one chain while factoring.
    panel: Vec<f64>,
}

/// Six rows of R, divided by the diagonal, which is left out; and the squares of its inverse.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    rows: [[f64; WIDTH]; LOOP],
    columns: [[f64; LOOP]; WIDTH],
    weights: [f64; LOOP],
}

impl LoopFactor {
    /// Starts anew: no chains.
    pub fn clear(&mut self) {
        self.columns.clear();
        self.ends.clear();
    }

    /// Appends a chain by the columns of its Jacobian, twists (v, ω), and `raise` times I: with it, B Bᵀ is raised by its
    /// square.
    pub fn push(&mut self, jacobian: &[Vector6<f64>], raise: f64) {
        self.columns
            .extend(jacobian.iter().map(|c| <[f64; LOOP]>::from(*c)));
        if raise > 0.0 {
            for i in 0..LOOP {
                let mut row = [0.0; LOOP];
                row[i] = raise;
                self.columns.push(row);
            }
        }
        self.ends.push(self.columns.len());
    }

    /// Factors. False if R is singular up to rounding; solutions are then those of a matrix that
    /// differs from it by rounding.
    pub fn factor(&mut self) -> bool {
        // Every entry of a block that is there from before is written anew.
        self.blocks.resize(self.ends.len(), Block::default());
        self.start_shared();
        let mut first = 0;
        for (block, &end) in self.blocks.iter_mut().zip(&self.ends) {
            let shared = self.panel.len();
            let all = shared / WIDTH + end - first;
            self.panel.resize(all * WIDTH, 0.0);
            let own = rows(&mut self.panel[shared..]);
            for (row, column) in own.iter_mut().zip(&self.columns[first..end]) {
                // Not by copy_from_slice, which is a call in WebAssembly.
                for (x, entry) in row.iter_mut().zip(column) {
                    *x = *entry;
                }
            }
            let done = LOOP.min(all);
            for p in 0..done {
                // The six rows of η are a multiple of I at first: those after row p have nothing there.
                let others = if first == 0 { LOOP } else { p + 1 };
                let (pivot, rows) = rows(&mut self.panel)[p..].split_at_mut(others - p);
                reflect(p, &mut pivot[0], rows);
            }
            first = end;
            let block = block.rows.as_flattened_mut();
            block[..done * WIDTH].copy_from_slice(&self.panel[..done * WIDTH]);
            block[done * WIDTH..].fill(0.0);
            // What is left is shared by the later chains.
            self.panel.drain(..done * WIDTH);
            for row in rows(&mut self.panel) {
                for c in 0..LOOP {
                    row[c] = row[LOOP + c];
                }
            }
        }
        self.scale_rows()
    }

    /// The shared rows before the first chain: 2 I, the sign of which makes no difference to R.
    fn start_shared(&mut self) {
        self.panel.clear();
        self.panel.resize(LOOP * WIDTH, 0.0);
        for (c, row) in rows(&mut self.panel).iter_mut().enumerate() {
            row[c] = TWIST;
            row[LOOP + c] = TWIST;
        }
    }

    /// Divides the rows of R by its diagonal; false if an entry of that is rounding.
    fn scale_rows(&mut self) -> bool {
        let mut largest = 0.0_f64;
        for block in &self.blocks {
            for p in 0..LOOP {
                largest = largest.max(block.rows[p][p].abs());
            }
        }
        let rounding = f64::EPSILON * largest;
        let mut regular = true;
        for block in &mut self.blocks {
            for p in 0..LOOP {
                let row = &mut block.rows[p];
                let mut pivot = row[p];
                // Written so that NaN is singular.
                if !(pivot.abs() > rounding) {
                    regular = false;
                    pivot = rounding;
                }
                let inverse = 1.0 / pivot;
                block.weights[p] = inverse * inverse;
                for x in &mut row[..=p] {
                    *x = 0.0;
                }
                for (c, x) in row.iter_mut().enumerate() {
                    *x *= inverse;
                    block.columns[c][p] = *x;
                }
            }
        }
        regular
    }

    /// x ← (Rᵀ R)⁻¹ x, one entry an equation.
    pub fn solve(&self, x: &mut [f64]) {
        // With Rᵀ. What the rows so far leave of x in this chain's columns, and of 0 in the later ones'.
        let mut rest = [0.0; WIDTH];
        for (own, block) in x.chunks_exact_mut(LOOP).zip(&self.blocks) {
            for c in 0..LOOP {
                rest[c] = own[c] + rest[LOOP + c];
            }
            let rows = &block.rows;
            take_forward::<0>(&mut rest, rows);
            take_forward::<1>(&mut rest, rows);
            take_forward::<2>(&mut rest, rows);
            take_forward::<3>(&mut rest, rows);
            take_forward::<4>(&mut rest, rows);
            take_forward::<5>(&mut rest, rows);
            for c in 0..LOOP {
                own[c] = rest[c] * block.weights[c];
            }
        }
        // With R, from the last chain back.
        let mut later = [0.0; LOOP];
        for (own, block) in x.chunks_exact_mut(LOOP).zip(&self.blocks).rev() {
            let mut rest = [0.0; LOOP];
            rest.copy_from_slice(own);
            for (c, x) in later.iter().enumerate() {
                for p in 0..LOOP {
                    rest[p] -= x * block.columns[LOOP + c][p];
                }
            }
            let columns = &block.columns;
            take_back::<5>(&mut rest, columns);
            take_back::<4>(&mut rest, columns);
            take_back::<3>(&mut rest, columns);
            take_back::<2>(&mut rest, columns);
            take_back::<1>(&mut rest, columns);
            for c in 0..LOOP {
                later[c] += rest[c];
            }
            own.copy_from_slice(&rest);
        }
    }
}

/// The rows of a panel.
#[inline(always)]
fn rows(panel: &mut [f64]) -> &mut [[f64; WIDTH]] {
    panel.as_chunks_mut().0
}

/// Takes row P times unknown P from what is behind it. With a constant the loop unrolls, and the
/// numbers stay in registers: each step waits for the one before.
#[inline(always)]
fn take_forward<const P: usize>(rest: &mut [f64; WIDTH], rows: &[[f64; WIDTH]; LOOP]) {
    let x = rest[P];
    for c in P + 1..WIDTH {
        rest[c] -= x * rows[P][c];
    }
}

/// Takes column P times unknown P from what is before it.
#[inline(always)]
fn take_back<const P: usize>(rest: &mut [f64; LOOP], columns: &[[f64; LOOP]; WIDTH]) {
    let x = rest[P];
    for p in 0..P {
        rest[p] -= x * columns[P][p];
    }
}

/// Square of a column's length below which the column is zero; the columns of a linkage in units of its size are of
/// length 1, and rounding leaves 1e-32 of that.
const NOTHING: f64 = 1e-200;

/// Reflects so that column `p` of the `others` becomes 0. The column is not
/// used again, and holds what the reflection leaves there.
fn reflect(p: usize, pivot: &mut [f64; WIDTH], others: &mut [[f64; WIDTH]]) {
    let head = pivot[p];
    let norm2 = others
        .iter()
        .fold(head * head, |sum, row| sum + row[p] * row[p]);
    // What rounding leaves of a zero column, 1e-150 say, is a zero: its square would overflow 1 / ‖x‖².
    if norm2 < NOTHING {
        return;
    }
    // v = x − α e₁ with α = −sign(x₁) ‖x‖, and 2/vᵀv = 1 / (‖x‖ (‖x‖ + |x₁|)).
    let norm = norm2.sqrt();
    let alpha = if head > 0.0 { -norm } else { norm };
    let beta = 1.0 / (norm * (norm + head.abs()));
    let first = head - alpha;
    // All columns, those that are done too: with a constant number the loops unroll.
    let mut along = pivot.map(|x| first * x);
    for row in &*others {
        let v = row[p];
        for c in 0..WIDTH {
            along[c] += v * row[c];
        }
    }
    for c in 0..WIDTH {
        along[c] *= beta;
        pivot[c] -= first * along[c];
    }
    for row in others {
        let v = row[p];
        for c in 0..WIDTH {
            row[c] -= v * along[c];
        }
    }
    pivot[p] = alpha;
}
