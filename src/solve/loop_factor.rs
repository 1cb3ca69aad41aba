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
    /// R: six rows a chain, each its part of the diagonal block and of S.
    rows: Vec<[f64; WIDTH]>,
    /// T of each of these rows.
    tied: Vec<f64>,
    /// 1 / the diagonal of R.
    inverse: Vec<f64>,
    /// The rows of one chain, then the shared ones, with T of each.
    panel: Vec<[f64; WIDTH]>,
    panel_tied: Vec<f64>,
    /// The shared rows' S and T while factoring.
    shared: Vec<[f64; LOOP]>,
    shared_tied: Vec<f64>,
    /// Sums over chains while solving, one entry an added row.
    sums: Vec<f64>,
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

    /// Adds rows below Bᵀ, of [`LoopFactor::equations`] entries each, times `factor`, once all chains
    /// are there.
    pub fn add_rows(&mut self, rows: &[f64], factor: f64) {
        debug_assert_eq!(rows.len() % self.equations(), 0);
        self.added.extend(rows.iter().map(|x| x * factor));
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
        self.rows.clear();
        self.tied.clear();
        // At first −2 I, whose sign makes no difference to R, and Nᵀ itself: T = I.
        self.shared.clear();
        self.shared_tied.clear();
        self.shared.resize(LOOP + added, [0.0; LOOP]);
        self.shared_tied.resize((LOOP + added) * added, 0.0);
        for c in 0..LOOP {
            self.shared[c][c] = TWIST;
        }
        for m in 0..added {
            self.shared_tied[(LOOP + m) * added + m] = 1.0;
        }
        let mut first = 0;
        for (chain, &end) in self.ends.iter().enumerate() {
            self.panel.clear();
            self.panel_tied.clear();
            for column in &self.columns[first..end] {
                let mut row = [0.0; WIDTH];
                row[..LOOP].copy_from_slice(column);
                self.panel.push(row);
            }
            self.panel_tied.resize((end - first) * added, 0.0);
            self.panel_tied.extend_from_slice(&self.shared_tied);
            for (i, s) in self.shared.iter().enumerate() {
                let mut row = [0.0; WIDTH];
                row[..LOOP].copy_from_slice(s);
                row[LOOP..].copy_from_slice(s);
                for m in 0..added {
                    let t = self.shared_tied[i * added + m];
                    for c in 0..LOOP {
                        row[c] += t * self.added[m * n + LOOP * chain + c];
                    }
                }
                self.panel.push(row);
            }
            first = end;
            let done = LOOP.min(self.panel.len());
            for p in 0..done {
                reflect(
                    &mut self.panel[p..],
                    p,
                    &mut self.panel_tied[p * added..],
                    added,
                );
            }
            for p in 0..LOOP {
                // Without enough rows R has empty ones.
                let mut row = self.panel.get(p).copied().unwrap_or_default();
                row[..p].fill(0.0);
                self.rows.push(row);
            }
            self.tied
                .extend_from_slice(&self.panel_tied[..done * added]);
            self.tied.resize(self.rows.len() * added, 0.0);
            self.shared.clear();
            for row in &self.panel[done..] {
                let mut s = [0.0; LOOP];
                s.copy_from_slice(&row[LOOP..]);
                self.shared.push(s);
            }
            self.shared_tied.clear();
            self.shared_tied
                .extend_from_slice(&self.panel_tied[done * added..]);
        }
        self.invert_pivots()
    }

    fn invert_pivots(&mut self) -> bool {
        let pivots = self.rows.iter().enumerate().map(|(i, row)| row[i % LOOP]);
        let largest = pivots.clone().fold(0.0, |m: f64, p| m.max(p.abs()));
        let rounding = f64::EPSILON * largest;
        self.inverse.clear();
        self.inverse.extend(pivots.clone().map(|p| {
            // Not a number counts as 0.
            if p.abs() > rounding {
                1.0 / p
            } else {
                1.0 / rounding
            }
        }));
        pivots.into_iter().all(|p| p.abs() > rounding)
    }

    /// x ← (Rᵀ R)⁻¹ x, one entry an equation.
    pub fn solve(&mut self, x: &mut [f64]) {
        self.solve_transposed(x);
        self.solve_upper(x);
    }

    /// x ← R⁻ᵀ x.
    fn solve_transposed(&mut self, x: &mut [f64]) {
        let (n, added) = (self.equations(), self.added_rows());
        self.sums.clear();
        self.sums.resize(added, 0.0);
        // What the rows so far leave of x in this chain's columns, and of 0 in all later ones'.
        let mut rest = [0.0; WIDTH];
        for (chain, own) in x.chunks_exact_mut(LOOP).enumerate() {
            for c in 0..LOOP {
                rest[c] = own[c] + rest[LOOP + c];
                for (m, sum) in self.sums.iter().enumerate() {
                    rest[c] -= sum * self.added[m * n + LOOP * chain + c];
                }
            }
            for p in 0..LOOP {
                let i = LOOP * chain + p;
                own[p] = rest[p] * self.inverse[i];
                for (rest, r) in rest.iter_mut().zip(&self.rows[i]) {
                    *rest -= own[p] * r;
                }
                for (sum, t) in self.sums.iter_mut().zip(&self.tied[i * added..]) {
                    *sum += own[p] * t;
                }
            }
        }
    }

    /// x ← R⁻¹ x.
    fn solve_upper(&mut self, x: &mut [f64]) {
        let (n, added) = (self.equations(), self.added_rows());
        self.sums.clear();
        self.sums.resize(added, 0.0);
        let mut later = [0.0; LOOP];
        for (chain, own) in x.chunks_exact_mut(LOOP).enumerate().rev() {
            let first = LOOP * chain;
            for p in 0..LOOP {
                for c in 0..LOOP {
                    own[p] -= self.rows[first + p][LOOP + c] * later[c];
                }
                for (sum, t) in self.sums.iter().zip(&self.tied[(first + p) * added..]) {
                    own[p] -= sum * t;
                }
            }
            for p in (0..LOOP).rev() {
                own[p] *= self.inverse[first + p];
                for q in 0..p {
                    own[q] -= self.rows[first + q][p] * own[p];
                }
            }
            for c in 0..LOOP {
                later[c] += own[c];
                for (m, sum) in self.sums.iter_mut().enumerate() {
                    *sum += self.added[m * n + first + c] * own[c];
                }
            }
        }
    }
}

/// Reflects the rows so that column `p` becomes 0 but for the first row's entry. Below that row the
/// column is not used again, and holds what rounding and the reflection's vector leave there.
fn reflect(rows: &mut [[f64; WIDTH]], p: usize, tied: &mut [f64], added: usize) {
    let norm2: f64 = rows.iter().map(|row| row[p] * row[p]).sum();
    if norm2 == 0.0 {
        return;
    }
    let norm = norm2.sqrt();
    // v = x − α e₁ with α = −sign(x₁) ‖x‖, and 2/vᵀv = 1 / (‖x‖ (‖x‖ + |x₁|)).
    let head = rows[0][p];
    let alpha = if head > 0.0 { -norm } else { norm };
    let beta = 1.0 / (norm * (norm + head.abs()));
    rows[0][p] = head - alpha;
    for m in 0..added {
        let pairs = rows.iter().zip(tied.chunks_exact(added));
        let along = beta * pairs.map(|(row, t)| row[p] * t[m]).sum::<f64>();
        for (row, t) in rows.iter().zip(tied.chunks_exact_mut(added)) {
            t[m] -= along * row[p];
        }
    }
    // All columns, those that are done too: with a constant number the loops unroll.
    let mut along = [0.0; WIDTH];
    for row in &*rows {
        for c in 0..WIDTH {
            along[c] += row[p] * row[c];
        }
    }
    for a in &mut along {
        *a *= beta;
    }
    for row in &mut *rows {
        let v = row[p];
        for c in 0..WIDTH {
            row[c] -= v * along[c];
        }
    }
    rows[0][p] = alpha;
}
