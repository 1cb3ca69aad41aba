//! What holds the workpiece at a position, and what leaves it free: freedoms as screws, the
//! certificate, the gap's free and blocked parts, and each chain's share in holding back.

use crate::math::linalg::{self, PivotedQr};
use crate::math::pose::{self, Pose};
use crate::math::screw::{self, Screw};
use crate::model::chain::Chain;
use crate::model::joint::{Limits, Stop};
use crate::model::mechanism::Mechanism;
use crate::solve::objective::objective;
use crate::solve::paper_matrix;
use crate::solve::tangent::Tangent;
use crate::solve::trust_region::TrustRegion;
use nalgebra::{Matrix6, Vector3, Vector6};
use serde::Serialize;

/// How close to a limit a joint counts as at it, rad or units of the size: what the solver allows.
const LIMIT: f64 = 1e-10;
/// Curvature that counts as flat, as the solver's.
const FLAT: f64 = 1e-8;
/// ‖q − g‖ below which nothing is held back: the solver's bound for a goal that is met.
const REACHED: f64 = 1e-8;
/// Gain per joint motion below which a joint at its limit does not press against it.
const PRESS: f64 = 1e-9;

/// What is known of one closed position and a goal.
#[derive(Clone, Debug, Serialize)]
pub struct Insight {
    /// A basis of the twists that the workpiece can take here, joint limits aside, simplest first.
    pub freedoms: Vec<Screw>,
    /// Of \[A\], lengths in units of the metric's length, largest first.
    pub singular_values: Vec<f64>,
    /// n − rank \[A\]: independent motions, inner freedoms of the chains included.
    pub mobility_rank: usize,
    /// Norm of the objective's gradient along orthonormal free directions.
    pub projected_gradient: f64,
    /// Least second derivative of f per squared motion of twist and joints together, lengths in units
    /// of the mechanism's size; none where nothing can move.
    pub least_curvature: Option<f64>,
    /// From the reached pose to the goal: the difference of the origins, and the rotation vector.
    pub gap: [f64; 6],
    /// The free twist that would bring the pose nearest to the goal in the metric, to first order.
    pub free_part: [f64; 6],
    /// The rest of the gap.
    pub blocked_part: [f64; 6],
    /// How each chain holds the workpiece back.
    pub chains: Vec<Hold>,
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

/// Explains the closed position `joints` with regard to `goal`, in the metric of characteristic length
/// `length`. Joints that the goal's pull presses against a limit count as held there in all but the
/// freedoms.
///
/// # Panics
/// When `joints` does not have one value a joint variable.
pub fn explain(mechanism: &Mechanism, joints: &[f64], goal: &Pose, length: f64) -> Insight {
    // Ranks are decided in units of the size, as everywhere.
    let size = mechanism.size();
    let chains = mechanism.scaled(1.0 / size).chains().to_vec();
    let theta = mechanism.in_unit(joints, size);
    let mut near = *goal;
    near.translation.vector /= size;

    let mut tangent = Tangent::new(&chains);
    tangent.evaluate(&chains, &theta);
    let mut stops = vec![Stop::None; theta.len()];
    tangent.factor(&stops, None, 0);
    tangent.span();
    let mobility_rank = tangent.freedoms();
    let place = *tangent.pose();
    let origin = place.translation.vector * size;
    let freedoms = screw::principal(&twists(&tangent), size, &origin);

    let model = objective(&place, &near, length / size);
    hold_pressed(&mut tangent, &chains, &theta, &model.gradient, &mut stops);
    tangent.span();
    let slope: Vec<f64> = (0..tangent.freedoms())
        .map(|i| tangent.twist(i).dot(&model.gradient))
        .collect();
    let mut region = TrustRegion::new(FLAT);
    let (mut reduced, mut mixed) = (Vec::new(), Vec::new());
    tangent.reduced_hessian(&model.hessian, None, &mut reduced, &mut mixed);
    region.prepare(&tangent, &reduced, &slope);

    let gap = twist_between(&place, &near);
    let here = objective(&place, &place, length / size).hessian;
    let free = nearest_free(&tangent, &here, &model.gradient);
    let in_units = |twist: &Vector6<f64>| -> [f64; 6] {
        let mut twist = *twist;
        twist.fixed_rows_mut::<3>(0).scale_mut(size);
        twist.into()
    };
    let reached = 2.0 * model.value <= REACHED * REACHED;
    Insight {
        freedoms,
        singular_values: singular_values(mechanism, joints, length),
        mobility_rank,
        projected_gradient: slope.iter().map(|x| x * x).sum::<f64>().sqrt(),
        least_curvature: Some(region.least()).filter(|least| least.is_finite()),
        gap: in_units(&gap),
        free_part: in_units(&free),
        blocked_part: in_units(&(gap - free)),
        chains: holds(&tangent, chains.len(), size, length, reached),
    }
}

fn twists(tangent: &Tangent) -> Vec<Vector6<f64>> {
    (0..tangent.freedoms()).map(|i| tangent.twist(i)).collect()
}

/// Factors and balances with those joints held that stand at a limit and that the goal pulls against
/// it: all that stand there, and then let go, one at a time, those that the pull would lead away.
fn hold_pressed(
    tangent: &mut Tangent,
    chains: &[Chain],
    theta: &[f64],
    gradient: &Vector6<f64>,
    stops: &mut [Stop],
) {
    let limits: Vec<Limits> = chains.iter().flat_map(Chain::limits).collect();
    for ((stop, &t), l) in stops.iter_mut().zip(theta).zip(&limits) {
        if t >= l.max - LIMIT {
            *stop = Stop::Max;
        } else if t <= l.min + LIMIT {
            *stop = Stop::Min;
        }
    }
    loop {
        tangent.factor(stops, None, 0);
        tangent.balance(gradient);
        let mut most = (PRESS, None);
        for (joint, stop) in stops.iter().enumerate() {
            let inward = match stop {
                Stop::None => continue,
                Stop::Min => -tangent.torque(joint),
                Stop::Max => tangent.torque(joint),
            };
            if inward > most.0 && limits[joint].max > limits[joint].min {
                most = (inward, Some(joint));
            }
        }
        match most.1 {
            Some(joint) => stops[joint] = Stop::None,
            None => return,
        }
    }
}

/// Origin's way and rotation vector from one pose to another.
fn twist_between(from: &Pose, to: &Pose) -> Vector6<f64> {
    let v = to.translation.vector - from.translation.vector;
    let r = to.rotation.quaternion() * from.rotation.quaternion().conjugate();
    let r = if r.w < 0.0 { -r } else { r };
    let sine = r.imag().norm();
    let w = if sine > 0.0 {
        r.imag() * (2.0 * libm::atan2(sine, r.w) / sine)
    } else {
        Vector3::zeros()
    };
    Vector6::new(v.x, v.y, v.z, w.x, w.y, w.z)
}

/// The free twist that minimises ‖J_q ξ − (g − q)‖: with M = J_qᵀ J_q and the gradient −J_qᵀ (g − q)
/// it is −T (Tᵀ M T)⁻¹ Tᵀ ∂f/∂ξ, and vanishes with the projected gradient.
fn nearest_free(tangent: &Tangent, metric: &Matrix6<f64>, gradient: &Vector6<f64>) -> Vector6<f64> {
    let basis = screw::orthonormal(&twists(tangent));
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

/// The balanced wrenches, the least of their splits, with their shares.
fn holds(tangent: &Tangent, chains: usize, size: f64, length: f64, reached: bool) -> Vec<Hold> {
    // Forces per unit of the size, against moments: in the metric a force counts by its length.
    let weigh = |wrench: &Vector6<f64>| {
        let mut wrench = *wrench;
        wrench.fixed_rows_mut::<3>(0).scale_mut(length / size);
        wrench
    };
    let stack = |wrenches: &[Vector6<f64>]| -> Vec<f64> {
        wrenches.iter().flat_map(|w| weigh(w).data.0[0]).collect()
    };
    let balanced: Vec<Vector6<f64>> = (0..chains).map(|i| *tangent.wrench(i)).collect();
    let mut all = stack(&balanced);
    // The part across all internal systems is the least.
    let mut internal = PivotedQr::default();
    internal.clear(6 * chains);
    for wrenches in tangent.internal_wrenches() {
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
                *x = all[6 * i + k] / if k < 3 { length } else { 1.0 };
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

/// Of \[A\] (Eq. 21) with lengths in units of the metric's length.
fn singular_values(mechanism: &Mechanism, joints: &[f64], length: f64) -> Vec<f64> {
    let mechanism_in_metric = mechanism.scaled(1.0 / length);
    let theta = mechanism.in_unit(joints, length);
    let q = pose::dual_quaternion(&mechanism_in_metric.chains()[0].pose(&theta), 1.0);
    let mut rows = paper_matrix::linearise(&mechanism_in_metric, &theta, &q).rows;
    // The side with fewer vectors: the other would add zeros that are none of [A]'s.
    let columns = rows[0].len();
    if rows.len() > columns {
        rows = (0..columns)
            .map(|j| rows.iter().map(|row| row[j]).collect())
            .collect();
    }
    linalg::svd(rows).sigma
}
