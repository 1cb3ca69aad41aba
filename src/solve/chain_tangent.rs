//! One chain of a closed linkage to first and second order: what it withstands, its joint rates, its curvature.

use crate::math::linalg::PivotedQr;
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
    /// QR of the columns of J that may move, and their variables.
    qr: PivotedQr,
    active: Vec<usize>,
    /// First of the chain's explicit joints in y.
    explicit: usize,
    /// The wrench λ_i with which the chain holds the workpiece against the goal's pull.
    pub wrench: Vector6<f64>,
}

impl ChainTangent {
    pub fn new(first: usize, chain: &Chain) -> Self {
        let freedoms = chain.freedoms();
        Self {
            first,
            freedoms,
            state: ChainState::default(),
            open: Vector6::zeros(),
            qr: PivotedQr::default(),
            active: Vec::with_capacity(freedoms),
            explicit: 0,
            wrench: Vector6::zeros(),
        }
    }

    /// Number of constraints: rows of N_iᵀ.
    pub fn constraints(&self) -> usize {
        6 - self.qr.rank()
    }

    /// Factors the columns of the joints that are not held; its explicit joints follow the `unknowns` before it.
    /// Returns how many unknowns there are then.
    #[inline]
    pub fn factor(&mut self, stops: &[Stop], unknowns: usize) -> usize {
        self.qr.clear(6);
        self.active.clear();
        for j in 0..self.freedoms {
            if stops[self.first + j] == Stop::None {
                self.active.push(j);
                self.qr.push(self.state.jacobian[j].as_slice());
            }
        }
        self.qr.factor(EXPLICIT, MAX_FREEDOMS);
        self.explicit = unknowns;
        unknowns + self.active.len() - self.qr.rank()
    }

    /// Writes constraint `p` (from the rank to 5) over zeros as a linear form in y: a column of N_i, and −R22 of the
    /// explicit joints.
    #[inline]
    pub fn constraint(&self, p: usize, form: &mut [f64]) {
        let rank = self.qr.rank();
        form[p] = 1.0;
        self.qr.apply_q(&mut form[..6]);
        for j in rank..self.active.len() {
            form[self.explicit + j - rank] = -self.qr.entry(p, j);
        }
    }

    /// Rows of N_iᵀ.
    pub fn constraint_rows(&self) -> std::ops::Range<usize> {
        self.qr.rank()..6
    }

    /// Appends −N_iᵀ e_i.
    #[inline]
    pub fn residuals(&self, out: &mut Vec<f64>) {
        let mut e = self.open;
        self.qr.apply_qt(e.as_mut_slice());
        out.extend(e.iter().skip(self.qr.rank()).map(|x| -x));
    }

    /// N_i times the multipliers of its constraints.
    #[inline]
    pub fn combine(&self, multipliers: &[f64]) -> Vector6<f64> {
        let mut wrench = Vector6::zeros();
        for (part, multiplier) in wrench.iter_mut().skip(self.qr.rank()).zip(multipliers) {
            *part = *multiplier;
        }
        self.qr.apply_q(wrench.as_mut_slice());
        wrench
    }

    /// Joint rates that realise ξ + e with explicit joints as in `y`; those of held joints stay 0.
    #[inline]
    pub fn rates(&self, y: &[f64], open: Option<&Vector6<f64>>, out: &mut [f64]) {
        let mut x = [y[0], y[1], y[2], y[3], y[4], y[5]];
        if let Some(e) = open {
            x.iter_mut().zip(e.iter()).for_each(|(x, e)| *x += e);
        }
        let rank = self.qr.rank();
        self.qr.apply_qt(&mut x);
        let order = self.qr.order();
        for (j, &column) in order.iter().enumerate().skip(rank) {
            let b = y[self.explicit + j - rank];
            for (i, x) in x[..rank].iter_mut().enumerate() {
                *x -= self.qr.entry(i, j) * b;
            }
            out[self.first + self.active[column]] = b;
        }
        self.qr.solve_r(&mut x);
        for (x, &column) in x.iter().zip(&order[..rank]) {
            out[self.first + self.active[column]] = *x;
        }
    }

    /// The second derivative of the workpiece's pose along the wrench (F, M), per pair of joints:
    /// K[j, l] = F·(S_j × (S_l × (d − C_l))) + ½ M·(S_j × S_l), j ≤ l, with S_l in place of
    /// S_l × (d − C_l) where l slides, and 0 where j slides. Into the upper triangle; the rest of `k` stays.
    #[inline]
    pub fn curvature(&self, k: &mut [[f64; MAX_FREEDOMS]; MAX_FREEDOMS]) {
        let force = self.wrench.fixed_rows::<3>(0).into_owned();
        let half_moment = self.wrench.fixed_rows::<3>(3) * 0.5;
        let columns = &self.state.jacobian[..self.freedoms];
        for (j, column) in columns.iter().enumerate() {
            let axis = column.fixed_rows::<3>(3).into_owned();
            let (f, m) = (force.cross(&axis), half_moment.cross(&axis));
            for (l, other) in columns.iter().enumerate().skip(j) {
                k[j][l] = f.dot(&other.fixed_rows::<3>(0)) + m.dot(&other.fixed_rows::<3>(3));
            }
        }
    }
}
