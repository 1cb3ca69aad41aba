//! One chain of a closed linkage to first and second order: what it withstands, its joint rates, its curvature.

use crate::math::gram_schmidt::{GramSchmidt, dot6};
use crate::model::chain::{Chain, ChainState, MAX_FREEDOMS};
use crate::model::joint::Stop;
use nalgebra::Vector6;

/// A joint whose twist is within this distance of the span of the others' (lengths as shares of the mechanism's size,
/// angles in rad) stays an explicit unknown. The answer does not depend on it: larger costs unknowns, smaller costs
/// digits and step length near singular positions.
const EXPLICIT: f64 = 0.05;

/// One chain's part of a [`Tangent`](crate::solve::tangent::Tangent).
#[derive(Clone, Debug)]
pub(super) struct ChainTangent {
    /// First of the chain's joint variables in the joint vector.
    pub first: usize,
    pub freedoms: usize,
    pub state: ChainState,
    /// Workpiece minus end of chain: the twist e_i by which the loop is open.
    pub open: Vector6<f64>,
    /// The columns of J that may move, factored: R11⁻¹ Q1ᵀ and N_iᵀ are its rows. Products with them wait less than
    /// reflections, each for the one before.
    qr: GramSchmidt,
    /// The chain's joints that may move; once factored, in pivoted order.
    active: Vec<usize>,
    /// First of the chain's explicit joints in y.
    explicit: usize,
    /// The wrench λ_i with which the chain holds the workpiece against the goal's pull.
    pub wrench: Vector6<f64>,
    /// The second derivative of the workpiece's pose along it; see [`ChainTangent::bend`].
    pub curvature: [[f64; MAX_FREEDOMS]; MAX_FREEDOMS],
}

impl ChainTangent {
    pub fn new(first: usize, chain: &Chain) -> Self {
        let freedoms = chain.freedoms();
        Self {
            first,
            freedoms,
            state: ChainState::default(),
            open: Vector6::zeros(),
            qr: GramSchmidt::default(),
            active: Vec::with_capacity(freedoms),
            explicit: 0,
            wrench: Vector6::zeros(),
            curvature: [[0.0; MAX_FREEDOMS]; MAX_FREEDOMS],
        }
    }

    /// Number of constraints: rows of N_iᵀ.
    pub fn constraints(&self) -> usize {
        6 - self.qr.rank
    }

    /// Factors the columns of the joints that are not held; its explicit joints follow the `unknowns` before it.
    /// Returns how many unknowns there are then.
    #[inline]
    pub fn factor(&mut self, stops: &[Stop], unknowns: usize) -> usize {
        let mut columns = [[0.0; 6]; MAX_FREEDOMS];
        self.active.clear();
        for j in 0..self.freedoms {
            if stops[self.first + j] == Stop::None {
                columns[self.active.len()] = self.state.jacobian[j].into();
                self.active.push(j);
            }
        }
        let count = self.active.len();
        (self.qr).factor(&mut columns[..count], &mut self.active, EXPLICIT);
        self.explicit = unknowns;
        unknowns + count - self.qr.rank
    }

    /// Writes constraint `p` (from the rank to 5) over zeros as a linear form in y: a column of N_i, and −R22 of the
    /// explicit joints.
    #[inline]
    pub fn constraint(&self, p: usize, form: &mut [f64]) {
        form[..6].copy_from_slice(&self.qr.rows[p]);
        let rank = self.qr.rank;
        for j in rank..self.active.len() {
            form[self.explicit + j - rank] = -self.qr.rest[j][p];
        }
    }

    /// Rows of N_iᵀ.
    pub fn constraint_rows(&self) -> std::ops::Range<usize> {
        self.qr.rank..6
    }

    /// Appends −N_iᵀ e_i.
    pub fn residuals(&self, out: &mut Vec<f64>) {
        let e = self.open.into();
        out.extend(self.qr.rows[self.qr.rank..].iter().map(|n| -dot6(n, &e)));
    }

    /// N_i times the multipliers of its constraints.
    pub fn combine(&self, multipliers: &[f64]) -> Vector6<f64> {
        sum6(&self.qr.rows[self.qr.rank..], multipliers)
    }

    /// Joint rates that realise ξ + e with explicit joints as in `y`; those of held joints stay 0.
    pub fn rates(&self, y: &[f64], open: Option<&Vector6<f64>>, out: &mut [f64]) {
        let mut x = [y[0], y[1], y[2], y[3], y[4], y[5]];
        if let Some(e) = open {
            x.iter_mut().zip(e.iter()).for_each(|(x, e)| *x += e);
        }
        let rank = self.qr.rank;
        let out = &mut out[self.first..];
        for (row, &joint) in self.qr.rows[..rank].iter().zip(&self.active) {
            out[joint] = dot6(row, &x);
        }
        for (j, &joint) in self.active.iter().enumerate().skip(rank) {
            let b = y[self.explicit + j - rank];
            out[joint] = b;
            for (i, &other) in self.active[..rank].iter().enumerate() {
                out[other] -= self.qr.rest[j][i] * b;
            }
        }
    }

    /// τ = Jᵀ λ of the joints that are not held: what keeps them from being in balance.
    pub fn torques(&self, out: &mut [f64]) {
        for &j in &self.active {
            out[self.first + j] = self.wrench.dot(&self.state.jacobian[j]);
        }
    }

    /// The wrench w along the joints with Jᵀ w = −`torques`, as far as the joints are not explicit; their rest is taken from
    /// the explicit unknowns in `rest`, and w from its first six. N_i μ may be added to w.
    pub fn react(&self, torques: &[f64], rest: &mut [f64]) -> Vector6<f64> {
        let rank = self.qr.rank;
        let mut own = [0.0; MAX_FREEDOMS];
        for (x, &joint) in own.iter_mut().zip(&self.active) {
            *x = -torques[self.first + joint];
        }
        for j in rank..self.active.len() {
            let along: f64 = (0..rank).map(|i| self.qr.rest[j][i] * own[i]).sum();
            rest[self.explicit + j - rank] += along - own[j];
        }
        let w = sum6(&self.qr.rows[..rank], &own);
        rest.iter_mut().zip(w.iter()).for_each(|(r, w)| *r -= w);
        w
    }

    /// The second derivative of the workpiece's pose along the wrench (F, M), per pair of joints:
    /// K[j, l] = F·(S_j × (S_l × (d − C_l))) + ½ M·(S_j × S_l), j ≤ l, with S_l in place of
    /// S_l × (d − C_l) where l slides, and 0 where j slides; symmetric.
    pub fn bend(&mut self) {
        let force = self.wrench.fixed_rows::<3>(0).into_owned();
        let half_moment = self.wrench.fixed_rows::<3>(3) * 0.5;
        let columns = &self.state.jacobian[..self.freedoms];
        for (j, column) in columns.iter().enumerate() {
            let axis = column.fixed_rows::<3>(3).into_owned();
            let (f, m) = (force.cross(&axis), half_moment.cross(&axis));
            for (l, other) in columns.iter().enumerate().skip(j) {
                let k = f.dot(&other.fixed_rows::<3>(0)) + m.dot(&other.fixed_rows::<3>(3));
                self.curvature[j][l] = k;
                self.curvature[l][j] = k;
            }
        }
    }

    /// K Δθ for the chain's part of joint motions `step`.
    pub fn bent(&self, step: &[f64]) -> [f64; MAX_FREEDOMS] {
        let mut bent = [0.0; MAX_FREEDOMS];
        let own = &step[self.first..self.first + self.freedoms];
        for (row, x) in self.curvature.iter().zip(own) {
            for j in 0..MAX_FREEDOMS {
                bent[j] += row[j] * x;
            }
        }
        bent
    }
}

/// The sum of rows with these coefficients.
#[inline]
fn sum6(rows: &[[f64; 6]], coefficients: &[f64]) -> Vector6<f64> {
    let mut sum = [0.0; 6];
    for (row, c) in rows.iter().zip(coefficients) {
        for i in 0..6 {
            sum[i] += c * row[i];
        }
    }
    sum.into()
}
