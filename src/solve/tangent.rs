//! What a closed linkage can do to first order: constraint wrenches, free twists, joint rates.
//!
//! The linearised loops J_i Δθ_i = ξ + e_i (Eq. 21 with the workpiece's twist ξ in place of Δq) are
//! solved chain by chain. A pivoted QR of the 6 × n_i matrix J_i leaves the chain's constraint
//! wrenches N_i, and N_iᵀ ξ = −N_iᵀ e_i is all that the workpiece feels of it.
//!
//! Joints that hardly add a direction of their own (a stretched arm, a spherical joint near gimbal
//! lock, a slider in the plane of an E) are not divided by: they stay explicit unknowns b, and the
//! chain contributes N_iᵀ ξ − R22 b = −N_iᵀ e_i. Both forms are exact; this one stays well
//! conditioned through the singular position, and there R22 = 0 makes b an inner freedom. The
//! unknowns together are y = (ξ, b).

use crate::math::linalg::PivotedQr;
use crate::model::chain::{Chain, ChainState, MAX_FREEDOMS};
use crate::model::joint::Stop;
use nalgebra::{Matrix6, Vector3, Vector6};

/// A joint whose twist is within this distance of the span of the others' (lengths in units of the
/// mechanism's size, angles in rad) stays explicit. The answer does not depend on it: larger costs
/// unknowns, smaller costs digits and step length near singular positions.
const EXPLICIT: f64 = 0.05;

/// Distance from dependence below which a constraint of a closed linkage counts as implied by the
/// others: the closure error of 1e-12 amplified a thousandfold.
const DEPENDENT: f64 = 1e-9;

/// First-order model of all chains at one set of joint values.
#[derive(Clone, Debug)]
pub struct Tangent {
    chains: Vec<ChainTangent>,
    /// QR of the stacked constraints' transpose, (6 + explicit joints) × (constraints).
    stacked: PivotedQr,
    unknowns: usize,
    /// Orthonormal directions of y that keep every loop closed, `unknowns` entries each.
    free: Vec<f64>,
    /// The joint rates of each, `variables` entries each.
    rates: Vec<f64>,
    variables: usize,
    scratch: Vec<f64>,
}

/// One chain's part.
#[derive(Clone, Debug)]
struct ChainTangent {
    /// First of the chain's joint variables in the joint vector.
    first: usize,
    freedoms: usize,
    state: ChainState,
    /// Workpiece minus end of chain: the loop's opening e_i.
    opening: Vector6<f64>,
    /// QR of the columns of J that may move, and their variables.
    qr: PivotedQr,
    active: Vec<usize>,
    /// First of the chain's explicit joints in y.
    explicit: usize,
    /// The wrench λ_i with which the chain holds the workpiece against the goal's pull.
    wrench: Vector6<f64>,
}

impl ChainTangent {
    /// Joint rates that realise ξ + e with explicit joints as in `y`; fixed joints stay 0.
    #[inline]
    fn rates(&self, y: &[f64], opening: Option<&Vector6<f64>>, out: &mut [f64]) {
        let mut x = [y[0], y[1], y[2], y[3], y[4], y[5]];
        if let Some(e) = opening {
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

    /// The second derivative of the workpiece's place along the wrench (F, M), per pair of joints:
    /// K[j, l] = F·(S_j × (S_l × (d − C_l))) + ½ M·(S_j × S_l), j ≤ l, with S_l in place of
    /// S_l × (d − C_l) where l slides, and 0 where j slides. Upper triangle.
    #[inline]
    fn curvature(&self) -> [[f64; MAX_FREEDOMS]; MAX_FREEDOMS] {
        let mut k = [[0.0; MAX_FREEDOMS]; MAX_FREEDOMS];
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
        k
    }
}

impl Tangent {
    /// Buffers for these chains.
    pub fn new(chains: &[Chain]) -> Self {
        let mut first = 0;
        let chains: Vec<_> = chains
            .iter()
            .map(|chain| {
                let freedoms = chain.freedoms();
                first += freedoms;
                ChainTangent {
                    first: first - freedoms,
                    freedoms,
                    state: ChainState::default(),
                    opening: Vector6::zeros(),
                    qr: PivotedQr::default(),
                    active: Vec::with_capacity(freedoms),
                    explicit: 0,
                    wrench: Vector6::zeros(),
                }
            })
            .collect();
        Self {
            chains,
            stacked: PivotedQr::default(),
            unknowns: 6,
            free: Vec::new(),
            rates: Vec::new(),
            variables: first,
            scratch: Vec::new(),
        }
    }

    /// Evaluates the chains at `theta`, and returns how far the loops are open: the largest entry of
    /// any opening, lengths and rad alike. The workpiece is where the first chain puts it.
    #[inline]
    pub fn evaluate(&mut self, chains: &[Chain], theta: &[f64]) -> f64 {
        let mut worst = 0.0_f64;
        for i in 0..self.chains.len() {
            let (done, rest) = self.chains.split_at_mut(i);
            let own = &mut rest[0];
            chains[i].evaluate(&theta[own.first..], &mut own.state);
            if let Some(leader) = done.first() {
                own.opening = crate::math::pose::difference(&leader.state.pose, &own.state.pose);
                // NaN must not pass for closed.
                let open = own
                    .opening
                    .iter()
                    .fold(0.0_f64, |m, x| if x.abs() <= m { m } else { x.abs() });
                worst = if open <= worst { worst } else { open };
            }
        }
        worst
    }

    /// The workpiece at the last evaluation.
    #[inline]
    pub fn pose(&self) -> &crate::math::pose::Pose {
        &self.chains[0].state.pose
    }

    /// Factors the constraints at the last evaluation; joints held at a stop stand still.
    /// `threshold` is the distance from dependence below which a constraint is dropped, and
    /// `redundant` how many are dropped in any case, being implied by the others.
    #[inline]
    pub fn factor(&mut self, stops: &[Stop], threshold: Option<f64>, redundant: usize) {
        let mut unknowns = 6;
        let mut constraints = 0;
        for chain in &mut self.chains {
            chain.qr.clear(6);
            chain.active.clear();
            for j in 0..chain.freedoms {
                if stops[chain.first + j] == Stop::None {
                    chain.active.push(j);
                    chain.qr.push(chain.state.jacobian[j].as_slice());
                }
            }
            chain.qr.factor(EXPLICIT, MAX_FREEDOMS);
            chain.explicit = unknowns;
            unknowns += chain.active.len() - chain.qr.rank();
            constraints += 6 - chain.qr.rank();
        }
        self.unknowns = unknowns;
        self.stacked.clear(unknowns);
        self.scratch.clear();
        self.scratch.resize(unknowns, 0.0);
        for chain in &self.chains {
            let rank = chain.qr.rank();
            for p in rank..6 {
                self.scratch.fill(0.0);
                self.scratch[p] = 1.0;
                chain.qr.apply_q(&mut self.scratch[..6]);
                for j in rank..chain.active.len() {
                    self.scratch[chain.explicit + j - rank] = -chain.qr.entry(p, j);
                }
                self.stacked.push(&self.scratch);
            }
        }
        self.stacked.factor(
            threshold.unwrap_or(DEPENDENT),
            constraints.saturating_sub(redundant),
        );
    }

    /// Constraints that the others imply, as found by the last factorisation.
    pub fn redundant(&self) -> usize {
        self.stacked.order().len() - self.stacked.rank()
    }

    /// Number of independent motions, inner freedoms of the chains included.
    #[inline]
    pub fn freedoms(&self) -> usize {
        self.unknowns - self.stacked.rank()
    }

    /// Forms the free directions and their joint rates; call once after [`Tangent::factor`].
    #[inline]
    pub fn span(&mut self) {
        let freedoms = self.freedoms();
        let rank = self.stacked.rank();
        self.free.clear();
        self.free.resize(freedoms * self.unknowns, 0.0);
        self.rates.clear();
        self.rates.resize(freedoms * self.variables, 0.0);
        for i in 0..freedoms {
            let y = &mut self.free[i * self.unknowns..(i + 1) * self.unknowns];
            y[rank + i] = 1.0;
            self.stacked.apply_q(y);
            let rates = &mut self.rates[i * self.variables..(i + 1) * self.variables];
            for chain in &self.chains {
                chain.rates(y, None, rates);
            }
        }
    }

    /// Free direction `i`: its twist and, behind it, the explicit joints.
    #[inline]
    pub fn free(&self, i: usize) -> &[f64] {
        &self.free[i * self.unknowns..(i + 1) * self.unknowns]
    }

    /// Length of a joint vector.
    pub fn variables(&self) -> usize {
        self.variables
    }

    /// Twist of free direction `i`.
    #[inline]
    pub fn twist(&self, i: usize) -> Vector6<f64> {
        Vector6::from_column_slice(&self.free(i)[..6])
    }

    /// Joint rates of free direction `i`.
    #[inline]
    pub fn rates(&self, i: usize) -> &[f64] {
        &self.rates[i * self.variables..(i + 1) * self.variables]
    }

    /// The shortest y that closes the loops to first order goes to `correction`, its joint rates to
    /// `step`.
    #[inline]
    pub fn close(&mut self, correction: &mut Vec<f64>, step: &mut [f64]) {
        let rank = self.stacked.rank();
        self.scratch.clear();
        for chain in &self.chains {
            let mut e = chain.opening;
            chain.qr.apply_qt(e.as_mut_slice());
            self.scratch
                .extend(e.iter().skip(chain.qr.rank()).map(|x| -x));
        }
        correction.clear();
        correction.extend(
            self.stacked.order()[..rank]
                .iter()
                .map(|&i| self.scratch[i]),
        );
        self.stacked.solve_rt(correction);
        correction.resize(self.unknowns, 0.0);
        self.stacked.apply_q(correction);
        step.fill(0.0);
        for chain in &self.chains {
            chain.rates(correction, Some(&chain.opening), step);
        }
    }

    /// Distributes the goal's pull over the chains: wrenches λ_i with Σ λ_i = `gradient` as far as
    /// the constraints can hold it. Where constraints are dependent one of the many splits is taken.
    #[inline]
    pub fn balance(&mut self, gradient: &Vector6<f64>) {
        let rank = self.stacked.rank();
        self.scratch.clear();
        self.scratch.extend_from_slice(gradient.as_slice());
        self.scratch.resize(self.unknowns, 0.0);
        self.stacked.apply_qt(&mut self.scratch);
        self.stacked.solve_r(&mut self.scratch[..rank]);
        let mut column = 0;
        let order = &self.stacked.order()[..rank];
        for chain in &mut self.chains {
            let mut wrench = Vector6::zeros();
            for p in chain.qr.rank()..6 {
                if let Some(place) = order.iter().position(|&c| c == column) {
                    wrench[p] = self.scratch[place];
                }
                column += 1;
            }
            chain.qr.apply_q(wrench.as_mut_slice());
            chain.wrench = wrench;
        }
    }

    /// The wrench systems that the chains can hold up among themselves without any pull, a basis of
    /// them: one for each constraint that the others imply, one wrench a chain, Σ λ_i = 0. They are
    /// what the split of [`Tangent::balance`] is open by.
    pub fn internal_wrenches(&self) -> Vec<Vec<Vector6<f64>>> {
        let rank = self.stacked.rank();
        let order = self.stacked.order();
        (rank..order.len())
            .map(|dependent| {
                // B z = 0 with z = 1 for the dependent constraint and −R11⁻¹ R12 for the others.
                let mut z: Vec<f64> = (0..rank)
                    .map(|row| -self.stacked.entry(row, dependent))
                    .collect();
                self.stacked.solve_r(&mut z);
                let mut multipliers = vec![0.0; order.len()];
                for (&c, z) in order.iter().zip(z) {
                    multipliers[c] = z;
                }
                multipliers[order[dependent]] = 1.0;
                let mut rest = &multipliers[..];
                let wrench = |chain: &ChainTangent| {
                    let rank = chain.qr.rank();
                    let (own, others) = rest.split_at(6 - rank);
                    rest = others;
                    let mut wrench = Vector6::zeros();
                    wrench.as_mut_slice()[rank..].copy_from_slice(own);
                    chain.qr.apply_q(wrench.as_mut_slice());
                    wrench
                };
                self.chains.iter().map(wrench).collect()
            })
            .collect()
    }

    /// λ_i of chain `i`, as (force, moment about the workpiece's origin).
    pub fn wrench(&self, i: usize) -> &Vector6<f64> {
        &self.chains[i].wrench
    }

    /// The change of the objective per unit of joint variable `variable` if it were let go: the
    /// power of its chain's wrench on its twist.
    pub fn torque(&self, variable: usize) -> f64 {
        let after = self.chains.partition_point(|c| c.first <= variable);
        let chain = &self.chains[after - 1];
        chain
            .wrench
            .dot(&chain.state.jacobian[variable - chain.first])
    }

    /// Second derivative of the objective along the free directions, given its Hessian in the twist
    /// and the balanced wrenches: lower triangle, `freedoms` × `freedoms`. With a closing step
    /// (`correction`, `step`), `mixed` receives the change of the gradient along it.
    #[inline]
    pub fn reduced_hessian(
        &self,
        hessian: &Matrix6<f64>,
        closing: Option<(&[f64], &[f64])>,
        reduced: &mut Vec<f64>,
        mixed: &mut Vec<f64>,
    ) {
        let n = self.freedoms();
        reduced.clear();
        reduced.resize(n * n, 0.0);
        mixed.clear();
        mixed.resize(n, 0.0);
        // A rotation ω of the workpiece turns the end of an open chain by ω + e + ½ ω × e: the
        // moment acts on the last term too.
        let mut swirl = Vector3::zeros();
        for chain in &self.chains {
            let e = chain.opening.fixed_rows::<3>(3).into_owned();
            swirl += e.cross(&chain.wrench.fixed_rows::<3>(3)) * 0.5;
        }
        for i in 0..n {
            let twist = self.twist(i);
            let pulled = hessian * twist;
            for j in i..n {
                reduced[i * n + j] = pulled.dot(&self.twist(j));
            }
            if let Some((correction, _)) = closing {
                mixed[i] = pulled.dot(&Vector6::from_column_slice(&correction[..6]))
                    - swirl.dot(&twist.fixed_rows::<3>(3));
            }
        }
        for chain in &self.chains {
            let k = chain.curvature();
            let own = chain.first..chain.first + chain.freedoms;
            for i in 0..n {
                let rates = &self.rates(i)[own.clone()];
                let mut bent = [0.0; MAX_FREEDOMS];
                for j in 0..chain.freedoms {
                    bent[j] += k[j][j] * rates[j];
                    for l in j + 1..chain.freedoms {
                        bent[j] += k[j][l] * rates[l];
                        bent[l] += k[j][l] * rates[j];
                    }
                }
                let along =
                    |rates: &[f64]| -> f64 { rates.iter().zip(&bent).map(|(r, b)| r * b).sum() };
                for j in i..n {
                    reduced[i * n + j] += along(&self.rates(j)[own.clone()]);
                }
                if let Some((_, step)) = closing {
                    mixed[i] += along(&step[own.clone()]);
                }
            }
        }
    }
}
