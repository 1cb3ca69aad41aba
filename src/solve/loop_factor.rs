//! Orthogonal factorisation of all loops at once, chain by chain.

use nalgebra::Vector6;

/// Equations a chain.
const LOOP: usize = 6;
/// Entries of a row: those in one chain's columns, and those in the columns of any later chain.
const WIDTH: usize = 2 * LOOP;
/// Length of the rows of \[J_E\], which are orthogonal: η is the workpiece's twist by half.
const TWIST: f64 = 2.0;

/// Bᵀ = Q R, where row block i of B is J_i θ̇_i − 2 η: chain i moves the workpiece by the twist 2 η.
///
/// In Bᵀ the rows of chain i have entries in its own six columns only, and the six rows of η have the
/// same block −2 I in the columns of every chain. Six reflections on the rows of chain i and the shared
/// ones finish six rows of R, and leave fewer shared rows with one block for all later chains again.
/// R is then given by its diagonal blocks and one block beside each, and the cost of a factorisation
/// or of a solution grows with the number of chains and not with a power of it.
///
/// Rows Nᵀ may be added below Bᵀ, which differ from chain to chain: a shared row's block then is
/// S + T N_i, and S and T are the same for all chains.
#[derive(Clone, Debug, Default)]
pub struct LoopFactor {
    /// The columns of all J_i, and where those of each chain end.
    columns: Vec<[f64; LOOP]>,
    ends: Vec<usize>,
    /// Nᵀ, row by row.
    added: Vec<f64>,
    /// R, one block a chain, and T of each of its rows.
    blocks: Vec<Block>,
    tied: Vec<f64>,
    /// The shared rows and those of one chain, and T of each, while factoring.
    panel: Vec<f64>,
    panel_tied: Vec<f64>,
    /// Sums over chains while solving, one entry an added row.
    sums: Vec<f64>,
}

/// Six rows of R, divided by the diagonal, which is left out; and the squares of its inverse.
#[derive(Clone, Copy, Debug, Default)]
struct Block {
    rows: [[f64; WIDTH]; LOOP],
    columns: [[f64; LOOP]; WIDTH],
    weights: [f64; LOOP],
}

impl LoopFactor {
    /// Starts anew: no chains, no added rows.
    pub fn clear(&mut self) {
        self.columns.clear();
        self.ends.clear();
        self.added.clear();
    }

    /// Appends a chain by the columns of its Jacobian, twists (v, ω).
    pub fn push(&mut self, jacobian: &[Vector6<f64>]) {
        self.columns
            .extend(jacobian.iter().map(|c| <[f64; LOOP]>::from(*c)));
        self.ends.push(self.columns.len());
    }

    /// Adds a row below Bᵀ, `row` times `factor`, of one entry an equation, once all chains are there.
    pub fn add_row(&mut self, row: &[f64], factor: f64) {
        debug_assert_eq!(row.len(), self.equations());
        self.added.extend(row.iter().map(|x| x * factor));
    }

    /// Columns of Bᵀ, order of R.
    pub fn equations(&self) -> usize {
        LOOP * self.ends.len()
    }

    fn added_rows(&self) -> usize {
        self.added.len() / self.equations().max(1)
    }

    /// Factors. False if R is singular up to rounding; solutions are then those of a matrix that
    /// differs from it by rounding.
    pub fn factor(&mut self) -> bool {
        let (n, added) = (self.equations(), self.added_rows());
        // Every entry of a block that is there from before is written anew.
        self.blocks.resize(self.ends.len(), Block::default());
        self.tied.clear();
        self.start_shared(added);
        let mut first = 0;
        for (chain, &end) in self.ends.iter().enumerate() {
            for (i, row) in rows(&mut self.panel).iter_mut().enumerate() {
                for m in 0..added {
                    let t = self.panel_tied[i * added + m];
                    for c in 0..LOOP {
                        row[c] += t * self.added[m * n + LOOP * chain + c];
                    }
                }
            }
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
            first = end;
            self.panel_tied.resize(all * added, 0.0);
            let done = LOOP.min(all);
            for p in 0..done {
                // The six rows of η are a multiple of I at first: those after row p have nothing there.
                let others = if chain == 0 { LOOP } else { p + 1 };
                let (pivot, rows) = rows(&mut self.panel)[p..].split_at_mut(others - p);
                let (pivot_tied, tied) =
                    self.panel_tied[p * added..].split_at_mut((others - p) * added);
                reflect(p, &mut pivot[0], rows, &mut pivot_tied[..added], tied);
            }
            let block = self.blocks[chain].rows.as_flattened_mut();
            block[..done * WIDTH].copy_from_slice(&self.panel[..done * WIDTH]);
            block[done * WIDTH..].fill(0.0);
            self.tied
                .extend_from_slice(&self.panel_tied[..done * added]);
            self.tied.resize((chain + 1) * LOOP * added, 0.0);
            // What is left is shared by the later chains.
            self.panel.drain(..done * WIDTH);
            self.panel_tied.drain(..done * added);
            for row in rows(&mut self.panel) {
                for c in 0..LOOP {
                    row[c] = row[LOOP + c];
                }
            }
        }
        self.scale_rows()
    }

    /// The shared rows before the first chain: 2 I, the sign of which makes no difference to R, and Nᵀ
    /// as T = I.
    fn start_shared(&mut self, added: usize) {
        self.panel.clear();
        self.panel.resize((LOOP + added) * WIDTH, 0.0);
        for (c, row) in rows(&mut self.panel)[..LOOP].iter_mut().enumerate() {
            row[c] = TWIST;
            row[LOOP + c] = TWIST;
        }
        self.panel_tied.clear();
        self.panel_tied.resize((LOOP + added) * added, 0.0);
        for m in 0..added {
            self.panel_tied[(LOOP + m) * added + m] = 1.0;
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
        let added = self.added_rows();
        for (i, block) in self.blocks.iter_mut().enumerate() {
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
                let at = (LOOP * i + p) * added;
                for t in &mut self.tied[at..at + added] {
                    *t *= inverse;
                }
            }
        }
        regular
    }

    /// x ← (Rᵀ R)⁻¹ x, one entry an equation.
    pub fn solve(&mut self, x: &mut [f64]) {
        let (n, added) = (self.equations(), self.added_rows());
        self.sums.clear();
        self.sums.resize(added, 0.0);
        // With Rᵀ. What the rows so far leave of x in this chain's columns, and of 0 in the later ones'.
        let mut rest = [0.0; WIDTH];
        let mut first = 0;
        for (own, block) in x.chunks_exact_mut(LOOP).zip(&self.blocks) {
            for c in 0..LOOP {
                rest[c] = own[c] + rest[LOOP + c];
            }
            for (sum, added) in self.sums.iter().zip(self.added.chunks_exact(n)) {
                for c in 0..LOOP {
                    rest[c] -= sum * added[first + c];
                }
            }
            let rows = &block.rows;
            take_forward::<0>(&mut rest, rows);
            take_forward::<1>(&mut rest, rows);
            take_forward::<2>(&mut rest, rows);
            take_forward::<3>(&mut rest, rows);
            take_forward::<4>(&mut rest, rows);
            take_forward::<5>(&mut rest, rows);
            for (m, sum) in self.sums.iter_mut().enumerate() {
                for p in 0..LOOP {
                    *sum += rest[p] * self.tied[(first + p) * added + m];
                }
            }
            for c in 0..LOOP {
                own[c] = rest[c] * block.weights[c];
            }
            first += LOOP;
        }
        // With R, from the last chain back.
        self.sums.fill(0.0);
        let mut later = [0.0; LOOP];
        for (own, block) in x.chunks_exact_mut(LOOP).zip(&self.blocks).rev() {
            first -= LOOP;
            let mut rest = [0.0; LOOP];
            rest.copy_from_slice(own);
            for (m, sum) in self.sums.iter().enumerate() {
                for p in 0..LOOP {
                    rest[p] -= sum * self.tied[(first + p) * added + m];
                }
            }
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
            for (sum, added) in self.sums.iter_mut().zip(self.added.chunks_exact(n)) {
                *sum += (0..LOOP).map(|c| rest[c] * added[first + c]).sum::<f64>();
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

/// Reflects so that column `p` of the `others` becomes 0, T of these rows with them. The column is not
/// used again, and holds what the reflection leaves there.
fn reflect(
    p: usize,
    pivot: &mut [f64; WIDTH],
    others: &mut [[f64; WIDTH]],
    pivot_tied: &mut [f64],
    tied: &mut [f64],
) {
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
    let added = pivot_tied.len();
    for m in 0..added {
        let mut along = first * pivot_tied[m];
        for (row, t) in others.iter().zip(tied.chunks_exact(added)) {
            along += row[p] * t[m];
        }
        along *= beta;
        pivot_tied[m] -= first * along;
        for (row, t) in others.iter().zip(tied.chunks_exact_mut(added)) {
            t[m] -= row[p] * along;
        }
    }
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
