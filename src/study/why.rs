//! What holds the workpiece at a position, and what leaves it free: freedoms as screws, the
//! certificate, the gap's free and blocked parts, and each chain's share in holding back.

use crate::math::linalg::{self, PivotedQr};
use crate::math::norm::norm;
use crate::math::pose::Pose;
use crate::math::screw::{self, Screw};
use crate::math::sort::sort_few;
use crate::model::joint::Stop;
use crate::model::scaled::Scaled;
use crate::solve::free::{Balanced, Free};
use crate::solve::limits::Holding;
use crate::solve::objective::objective;
use crate::solve::solver::Solver;
use crate::solve::tangent::Tangent;
use crate::solve::trust_region::TrustRegion;
use nalgebra::{Matrix6, Vector3, Vector6};
use serde::Serialize;

/// What is known of one closed position and a goal.
#[derive(Clone, Debug, Serialize)]
pub struct Insight {
    /// A basis of the twists that the workpiece can take here, joint limits aside, simplest first.
    pub freedoms: Vec<Screw>,
    /// Of \[A\], largest first: lengths as shares of the mechanism's size, measured about the workpiece's origin.
    pub singular_values: Vec<f64>,
    /// n − rank \[A\]: independent motions, inner freedoms of the chains included.
    pub mobility_rank: usize,
    /// Norm of the objective's gradient along orthonormal free directions, lengths as shares of the size.
    pub projected_gradient: f64,
    /// What that is at most where a pose is called closest.
    pub stationary: f64,
    /// Least second derivative of f per squared motion of twist and joints together, lengths as shares
    /// of the size; none where nothing can move.
    pub least_curvature: Option<f64>,
    /// What that is at least where a pose is called closest, with the opposite sign.
    pub flat: f64,
    /// From the reached pose to the goal: the difference of the origins, and the rotation vector.
    pub gap: [f64; 6],
    /// The free twist that would bring the pose nearest to the goal in the metric, to first order.
    pub free_part: [f64; 6],
    /// The rest of the gap.
    pub blocked_part: [f64; 6],
    /// How each chain holds the workpiece back.
    pub chains: Vec<Hold>,
    /// The joint variables that the goal's pull presses against a limit.
    pub held: Vec<Held>,
}

/// A joint variable that is held at a limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Held {
    /// Counted through all chains, from 0.
    pub variable: usize,
    /// At its largest value; else at its smallest.
    pub largest: bool,
}

/// A chain's part in holding the workpiece back from the goal.
#[derive(Clone, Debug, Serialize)]
pub struct Hold {
    /// λ_i = N_i μ_i: force, and moment about the workpiece's origin, of the chain on the workpiece;
    /// all of them together balance the goal's pull −∂f/∂ξ. Of the splits that do, the one with the
    /// least Σ |λ_i|² (lengths in units of the metric's): an overconstrained linkage has many.
    pub wrench: [f64; 6],
    /// |λ_i| of Σ |λ_i|; 0 where nothing is held back.
    pub share: f64,
}

/// Explains the closed position `joints` with regard to `goal`. Joints that the goal's pull presses against a limit
/// count as held there in all but the freedoms. `solver` has closed the loops there, and so knows what is surplus.
///
/// # Panics
/// When `joints` does not have one value a joint variable.
pub fn explain(solver: &mut Solver, joints: &[f64], goal: &Pose) -> Insight {
    let tolerances = *solver.tolerances();
    let metric = *solver.metric();
    let (scaled, closer, _) = solver.parts();
    let (theta, near, size) = (
        scaled.entered(joints),
        scaled.enter_pose(goal),
        scaled.unit(),
    );
    let dependence = closer.dependence_anywhere();
    let tangent = closer.tangent();
    tangent.evaluate(scaled.chains(), &theta);
    let place = *tangent.pose();
    let target = metric.target(&near, &place.rotation);
    let model = objective(&place, &target);
    let singular_values = singular_values(tangent);
    let mut holding = Holding::new(scaled.limits());
    let free = tangent.factor(holding.stops(), dependence).free();
    let mobility_rank = free.count();
    let origin = scaled.leave_pose(&place).translation.vector;
    let freedoms = screw::principal(&free.twists(), size, &origin);

    // All joints that stand at a limit, and then let go, one at a time, those that the pull would lead away.
    holding.hold_all_at(&theta);
    let mut held = loop {
        let held = tangent
            .factor(holding.stops(), dependence)
            .free()
            .balance(&model.gradient);
        match holding.releasable(tolerances.stationary, |joint| held.torque(joint)) {
            Some(joint) => {
                holding.set(joint, Stop::None);
            }
            None => {
                break tangent
                    .factor(holding.stops(), dependence)
                    .free()
                    .balance(&model.gradient);
            }
        }
    };
    let mut slope = Vec::new();
    let projected_gradient = held.free().project(&model.gradient, &mut slope);
    let mut region = TrustRegion::new(tolerances.flat);
    let mut reduced = Vec::new();
    held.reduced_hessian(&model.hessian, &mut reduced);
    region.prepare(held.free(), &reduced, &slope);

    let gap = twist_between(&place, &near);
    let here = objective(&place, &metric.target(&place, &place.rotation)).hessian;
    let free_part = nearest_free(held.free(), &here, &model.gradient);
    let in_units = |twist: &Vector6<f64>| -> [f64; 6] {
        let mut twist = *twist;
        twist.fixed_rows_mut::<3>(0).scale_mut(size);
        twist.into()
    };
    let reached = model.value <= tolerances.reached;
    Insight {
        freedoms,
        singular_values,
        mobility_rank,
        projected_gradient,
        stationary: tolerances.stationary,
        least_curvature: Some(region.least()).filter(|least| least.is_finite()),
        flat: tolerances.flat,
        gap: in_units(&gap),
        free_part: in_units(&free_part),
        blocked_part: in_units(&(gap - free_part)),
        chains: holds(held, scaled, metric.length, reached),
        held: at_limits(&holding),
    }
}

fn at_limits(holding: &Holding) -> Vec<Held> {
    let held = holding.held().into_iter();
    held.map(|variable| Held {
        variable,
        largest: holding.stops()[variable] == Stop::Max,
    })
    .collect()
}

/// Origin's way and rotation vector from one pose to another.
fn twist_between(from: &Pose, to: &Pose) -> Vector6<f64> {
    let v = to.translation.vector - from.translation.vector;
    let r = to.rotation.quaternion() * from.rotation.quaternion().conjugate();
    let r = if r.w < 0.0 { -r } else { r };
    let sine = norm(&r.imag());
    let w = if sine > 0.0 {
        r.imag() * (2.0 * libm::atan2(sine, r.w) / sine)
    } else {
        Vector3::zeros()
    };
    Vector6::new(v.x, v.y, v.z, w.x, w.y, w.z)
}

/// The free twist that minimises ‖J_q ξ − (g − q)‖: with M = J_qᵀ J_q and the gradient −J_qᵀ (g − q)
/// it is −T (Tᵀ M T)⁻¹ Tᵀ ∂f/∂ξ, and vanishes with the projected gradient.
fn nearest_free(free: &Free<'_>, metric: &Matrix6<f64>, gradient: &Vector6<f64>) -> Vector6<f64> {
    let basis = screw::orthonormal(&free.twists());
    let n = basis.len();
    let mut reduced = vec![0.0; n * n];
    for (i, a) in basis.iter().enumerate() {
        for (j, b) in basis.iter().enumerate().skip(i) {
            reduced[i * n + j] = a.dot(&(metric * b));
        }
    }
    let mut x: Vec<f64> = basis.iter().map(|t| -t.dot(gradient)).collect();
    if !linalg::cholesky(&mut reduced, n, n, 0.0) {
        return Vector6::zeros();
    }
    linalg::solve_lower(&reduced, n, n, &mut x);
    linalg::solve_lower_transposed(&reduced, n, n, &mut x);
    basis.iter().zip(x).map(|(t, x)| t * x).sum()
}

/// The balanced wrenches, the least of their splits, with their shares. `length` is the metric's as a share of the size.
fn holds(held: Balanced<'_>, scaled: &Scaled, length: f64, reached: bool) -> Vec<Hold> {
    let chains = scaled.chains().len();
    // Forces per unit of the size, against moments: in the metric a force counts by its length.
    let weigh = |wrench: &Vector6<f64>| {
        let mut wrench = *wrench;
        wrench.fixed_rows_mut::<3>(0).scale_mut(length);
        wrench
    };
    let stack = |wrenches: &[Vector6<f64>]| -> Vec<f64> {
        wrenches.iter().flat_map(|w| weigh(w).data.0[0]).collect()
    };
    let balanced: Vec<Vector6<f64>> = (0..chains).map(|i| *held.wrench(i)).collect();
    let mut all = stack(&balanced);
    // The part across all internal systems is the least.
    let mut internal = PivotedQr::default();
    internal.clear(6 * chains);
    for wrenches in held.internal_wrenches() {
        internal.push(&stack(&wrenches));
    }
    internal.factor(0.0, usize::MAX);
    internal.apply_qt(&mut all);
    all[..internal.rank()].fill(0.0);
    internal.apply_q(&mut all);
    let norms: Vec<f64> = all
        .chunks_exact(6)
        .map(|w| w.iter().map(|x| x * x).sum::<f64>().sqrt())
        .collect();
    let sum: f64 = norms.iter().sum();
    norms
        .iter()
        .enumerate()
        .map(|(i, norm)| {
            let mut wrench = [0.0; 6];
            for (k, x) in wrench.iter_mut().enumerate() {
                *x = all[6 * i + k] / if k < 3 { length * scaled.unit() } else { 1.0 };
            }
            let share = if reached || !(sum > 0.0) {
                0.0
            } else {
                norm / sum
            };
            Hold { wrench, share }
        })
        .collect()
}

/// Of \[A\] (Eq. 21) at the last evaluation, with d = 0: 2 and 1 of the conditions on q, and those of the loops with
/// 2 times the twist in place of \[J_E\]; see [`SingularValues`](crate::solve::singular_values::SingularValues).
fn singular_values(tangent: &Tangent) -> Vec<f64> {
    let jacobians: Vec<_> = tangent.jacobians().collect();
    let variables: usize = jacobians.iter().map(|j| j.len()).sum();
    let mut rows = Vec::new();
    let mut first = 0;
    for jacobian in &jacobians {
        for i in 0..6 {
            let mut row = vec![0.0; variables + 6];
            for (j, column) in jacobian.iter().enumerate() {
                row[first + j] = column[i];
            }
            row[variables + i] = -2.0;
            rows.push(row);
        }
        first += jacobian.len();
    }
    // The side with fewer vectors: the other would add zeros that are none of [A]'s.
    let columns = variables + 6;
    if rows.len() > columns {
        rows = (0..columns)
            .map(|j| rows.iter().map(|row| row[j]).collect())
            .collect();
    }
    let mut sigma = linalg::svd(rows).sigma;
    sigma.extend([2.0, 1.0]);
    sort_few(&mut sigma, |a, b| a > b);
    sigma
}
