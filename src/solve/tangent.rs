//! What a closed linkage can do to first and second order: constraint wrenches, free twists, joint rates, curvature.
//!
//! The linearised loops J_i Δθ_i = ξ + e_i (Eq. 21 with the workpiece's twist ξ in place of Δq) are
//! solved chain by chain. A pivoted QR of the 6 × n_i matrix J_i leaves the chain's constraint
//! wrenches N_i, and N_iᵀ ξ = −N_iᵀ e_i is its whole effect on the workpiece.
//!
//! Joints that hardly add a direction of their own (a stretched arm, a spherical joint near gimbal
//! lock, a slider in the plane of an E) are not divided by: they stay explicit unknowns b, and the
//! chain contributes N_iᵀ ξ − R22 b = −N_iᵀ e_i. Both forms are exact; this one stays well
//! conditioned through the singular position, and there R22 = 0 makes b an inner freedom. The
//! unknowns together are y = (ξ, b).
//!
//! Each step of the evaluation is a view of the one before: [`Tangent::evaluate`] and [`Tangent::factor`], whose
//! [`Factored`] closes the loops; [`free`](crate::solve::free) has what follows from there. What is not asked for is not computed, and the types allow no other order.

use crate::math::linalg::PivotedQr;
use crate::math::pose::{Pose, difference};
use crate::model::chain::Chain;
use crate::model::joint::Stop;
use crate::model::scaled::{closure_error, larger};
use crate::solve::chain_tangent::ChainTangent;
use crate::solve::dependent::{self, Combination, Dependence};
use nalgebra::Vector6;
use std::ops::RangeInclusive;

/// First-order model of all chains at one set of joint values; its buffers serve all evaluations.
#[derive(Clone, Debug)]
pub struct Tangent {
    pub(super) chains: Vec<ChainTangent>,
    /// The joint values of the last evaluation.
    at: Vec<f64>,
    /// The largest of the last evaluation.
    pub(super) closure_error: f64,
    /// QR of the stacked constraints' transpose, (6 + explicit joints) × (constraints).
    pub(super) stacked: PivotedQr,
    /// Of a rounded linkage: the combinations of its constraints that were stacked in their place.
    pub(super) combination: Option<Combination>,
    pub(super) unknowns: usize,
    pub(super) constraints: usize,
    /// Orthonormal directions of y that keep every loop closed, `unknowns` entries each.
    pub(super) free: Vec<f64>,
    /// The joint rates of each, `variables` entries each.
    pub(super) rates: Vec<f64>,
    pub(super) variables: usize,
    pub(super) scratch: Vec<f64>,
}

impl Tangent {
    /// Buffers for these chains.
    pub fn new(chains: &[Chain]) -> Self {
        let mut variables = 0;
        let chains: Vec<_> = chains
            .iter()
            .map(|chain| {
                variables += chain.freedoms();
                ChainTangent::new(variables - chain.freedoms(), chain)
            })
            .collect();
        Self {
            chains,
            at: Vec::with_capacity(variables),
            closure_error: f64::INFINITY,
            stacked: PivotedQr::default(),
            combination: None,
            unknowns: 6,
            constraints: 0,
            free: Vec::new(),
            rates: Vec::new(),
            variables,
            scratch: Vec::new(),
        }
    }

    /// Evaluates the chains at `theta`, and returns the largest [`closure_error`]. The workpiece
    /// is where the first chain puts it. At the joint values of the last evaluation nothing is left to do.
    pub fn evaluate(&mut self, chains: &[Chain], theta: &[f64]) -> f64 {
        if self.at == theta {
            return self.closure_error;
        }
        self.at.clear();
        self.at.extend_from_slice(theta);
        let mut worst = 0.0_f64;
        for i in 0..self.chains.len() {
            let (done, rest) = self.chains.split_at_mut(i);
            let own = &mut rest[0];
            chains[i].evaluate(&theta[own.first..], &mut own.state);
            if let Some(leader) = done.first() {
                own.open = difference(&leader.state.pose, &own.state.pose);
                worst = larger(worst, closure_error(&own.open));
            }
        }
        self.closure_error = worst;
        worst
    }

    /// The workpiece at the last evaluation.
    #[inline]
    pub fn pose(&self) -> &Pose {
        &self.chains[0].state.pose
    }

    /// The workpiece at `theta`, without an evaluation where that was the last one.
    pub fn pose_at(&self, chains: &[Chain], theta: &[f64]) -> Pose {
        if self.at == theta {
            *self.pose()
        } else {
            chains[0].pose(theta)
        }
    }

    /// The Jacobian's columns of each chain at the last evaluation.
    pub fn jacobians(&self) -> impl Iterator<Item = &[Vector6<f64>]> + Clone {
        self.chains
            .iter()
            .map(|chain| &chain.state.jacobian[..chain.freedoms])
    }

    /// Factors the constraints at the last evaluation; joints with a stop do not move.
    pub fn factor(&mut self, stops: &[Stop], dependence: Dependence) -> Factored<'_> {
        self.stack(stops);
        let mut most = self.constraints.saturating_sub(dependence.known());
        if let Dependence::Rounded { surplus, within } = dependence {
            let held = stops.iter().filter(|stop| **stop != Stop::None).count();
            most = self.combine(surplus..=surplus + held, within);
        }
        self.stacked.factor(dependence.threshold(), most);
        Factored(self)
    }

    /// The factors of an evaluation before, for steps from the last one.
    #[inline]
    pub(super) fn stale(&mut self) -> Factored<'_> {
        Factored(self)
    }

    /// How many combinations of the constraints are within this distance of dependence at the last evaluation.
    pub fn surplus_within(&mut self, stops: &[Stop], distance: f64) -> usize {
        self.stack(stops);
        dependent::surplus_within(
            &self.forms(),
            self.unknowns,
            self.chains[0].constraints(),
            distance,
        )
    }

    /// Stacks the chains' constraints.
    fn stack(&mut self, stops: &[Stop]) {
        let mut unknowns = 6;
        self.constraints = 0;
        for chain in &mut self.chains {
            unknowns = chain.factor(stops, unknowns);
            self.constraints += chain.constraints();
        }
        self.unknowns = unknowns;
        self.combination = None;
        self.stacked.clear(unknowns);
        for chain in &self.chains {
            for p in chain.constraint_rows() {
                chain.constraint(p, self.stacked.push_zeros());
            }
        }
    }

    /// The stacked constraints, one after the other.
    fn forms(&self) -> Vec<f64> {
        (0..self.constraints)
            .flat_map(|c| (0..self.unknowns).map(move |row| (row, c)))
            .map(|(row, c)| self.stacked.entry(row, c))
            .collect()
    }

    /// Puts the kept combinations of a rounded linkage's constraints in their place; their number.
    fn combine(&mut self, surplus: RangeInclusive<usize>, within: f64) -> usize {
        let own = self.chains[0].constraints();
        let (combination, kept) =
            Combination::new(self.forms(), self.unknowns, own, surplus, within);
        self.stacked.clear(self.unknowns);
        for form in kept.chunks_exact(self.unknowns) {
            self.stacked.push(form);
        }
        self.combination = Some(combination);
        kept.len() / self.unknowns
    }

    /// −N_iᵀ e_i of all chains, or the kept combinations of them, into the scratch.
    fn residuals(&mut self) {
        self.scratch.clear();
        for chain in &self.chains {
            chain.residuals(&mut self.scratch);
        }
        if let Some(combination) = &self.combination {
            self.scratch = combination.kept(&self.scratch);
        }
    }

    pub(super) fn direction(&self, i: usize) -> &[f64] {
        &self.free[i * self.unknowns..(i + 1) * self.unknowns]
    }
}

/// The constraints, factored.
#[derive(Debug)]
pub struct Factored<'a>(pub(super) &'a mut Tangent);

impl Factored<'_> {
    /// Number of surplus constraints: those that the others imply, or contradict by the misfit.
    pub fn surplus(&self) -> usize {
        self.0.constraints - self.0.stacked.rank()
    }

    /// Number of independent motions, inner freedoms of the chains included.
    #[inline]
    pub fn freedoms(&self) -> usize {
        self.0.unknowns - self.0.stacked.rank()
    }

    /// The largest closure error, and the misfit of a rounded linkage (else 0): by how much its constraints contradict
    /// each other there. The misfit stays when the loops are closed, and is not counted in the closure error.
    #[inline]
    pub fn closure(&self) -> (f64, f64) {
        let Some(combination) = &self.0.combination else {
            return (self.0.closure_error, 0.0);
        };
        let mut residuals = Vec::new();
        for chain in &self.0.chains {
            chain.residuals(&mut residuals);
        }
        let kept = combination.spread(&combination.kept(&residuals));
        let mut rest = residuals.iter().zip(&kept).map(|(all, kept)| kept - all);
        let (mut open, mut misfit) = (0.0, 0.0);
        for chain in &self.0.chains {
            let own: Vec<f64> = rest.by_ref().take(chain.constraints()).collect();
            let twist = chain.combine(&own);
            open = larger(open, closure_error(&(chain.open - twist)));
            misfit = larger(misfit, closure_error(&twist));
        }
        (open, misfit)
    }

    /// The shortest y that closes the loops to first order goes to `correction`, its joint rates to `step`.
    pub fn close(&mut self, correction: &mut Vec<f64>, step: &mut [f64]) {
        let tangent = &mut *self.0;
        tangent.residuals();
        let rank = tangent.stacked.rank();
        correction.clear();
        let independent = &tangent.stacked.order()[..rank];
        correction.extend(independent.iter().map(|&i| tangent.scratch[i]));
        tangent.stacked.solve_rt(correction);
        correction.resize(tangent.unknowns, 0.0);
        tangent.stacked.apply_q(correction);
        step.fill(0.0);
        for chain in &tangent.chains {
            chain.rates(correction, Some(&chain.open), step);
        }
    }

    /// The surplus combinations of constraints of a rounded linkage: one wrench a chain, and by how much the loops
    /// contradict it.
    pub fn contradictions(&self) -> Vec<(Vec<Vector6<f64>>, f64)> {
        let Some(combination) = &self.0.combination else {
            return Vec::new();
        };
        let contradiction = |multipliers: Vec<f64>| {
            let wrenches = self.wrenches(&multipliers);
            let pairs = wrenches.iter().zip(&self.0.chains);
            let misfit = pairs.map(|(w, chain)| w.dot(&chain.open)).sum();
            (wrenches, misfit)
        };
        combination.dropped().map(contradiction).collect()
    }

    /// A basis of the wrench systems that the chains can exert on each other without any pull: one for each surplus
    /// constraint, one wrench a chain, Σ λ_i = 0. The split of [`Free::balance`](super::free::Free::balance) is unique up to these.
    pub fn internal_wrenches(&self) -> Vec<Vec<Vector6<f64>>> {
        let stacked = &self.0.stacked;
        let (rank, order) = (stacked.rank(), stacked.order());
        let mut systems: Vec<_> = (rank..order.len())
            .map(|dependent| {
                // B z = 0 with z = 1 for the dependent constraint and −R11⁻¹ R12 for the others.
                let mut z: Vec<f64> = (0..rank)
                    .map(|row| -stacked.entry(row, dependent))
                    .collect();
                stacked.solve_r(&mut z);
                let mut multipliers = vec![0.0; order.len()];
                for (&c, z) in order.iter().zip(z) {
                    multipliers[c] = z;
                }
                multipliers[order[dependent]] = 1.0;
                match &self.0.combination {
                    Some(combination) => self.wrenches(&combination.spread(&multipliers)),
                    None => self.wrenches(&multipliers),
                }
            })
            .collect();
        // Apart: chained to those above they are one iterator, whose code is 1 kB more of wasm.
        if let Some(combination) = &self.0.combination {
            for multipliers in combination.dropped() {
                systems.push(self.wrenches(&multipliers));
            }
        }
        systems
    }

    /// One wrench a chain, from multipliers of all constraints.
    fn wrenches(&self, multipliers: &[f64]) -> Vec<Vector6<f64>> {
        let mut rest = multipliers;
        let wrench = |chain: &ChainTangent| {
            let (own, others) = rest.split_at(chain.constraints());
            rest = others;
            chain.combine(own)
        };
        self.0.chains.iter().map(wrench).collect()
    }
}
