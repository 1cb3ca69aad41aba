//! The paper's planner: projected gradient steps with the null space of [A], Eq. 27–31 and Fig. 3.
//!
//! Kept as the reference for [`crate::newton`] and for teaching. It converges linearly: several
//! hundred iterations a frame where the goal is off the workspace.

use crate::closure::linearise;
use crate::linalg::{Svd, svd};
use crate::mechanism::Mechanism;
use crate::pose::{self, DualQuaternion, Pose};

/// Length |a| of the projected gradient (Eq. 31) at which the iteration stops. The distance f is
/// then within about its square, 1e-14, of the minimum; Newton's 1e-9 would take twice as long.
pub const STATIONARY: f64 = 1e-7;
/// Largest entry of the residual at which Eq. 28 stops.
const CLOSED: f64 = 1e-13;
/// Residual that rounding may leave where it no longer falls.
const ROUNDING: f64 = 1e-11;
/// Corrections by Eq. 28 after one gradient step; quadratic convergence needs three or four.
const CORRECTIONS: usize = 12;
/// Singular values below this share of the largest are zero: rounding amplified a thousandfold.
const ZERO: f64 = 1e-10;

/// One turn of the loop in Fig. 3, after its corrections.
#[derive(Clone, Debug)]
pub struct Iteration<'a> {
    /// Joint values, lengths in units of the metric's length.
    pub joints: &'a [f64],
    /// The workpiece q.
    pub q: &'a DualQuaternion,
    /// ½‖q − g‖².
    pub metric: f64,
    /// |a| of Eq. 31.
    pub projected_gradient: f64,
    /// Largest entry of E.
    pub residual: f64,
    /// Singular values of [A], largest first.
    pub singular_values: &'a [f64],
}

/// How the iteration ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Descent {
    /// The projected gradient fell below [`STATIONARY`].
    pub converged: bool,
    /// Its last value.
    pub projected_gradient: f64,
    /// Gradient steps taken.
    pub iterations: usize,
}

/// Moves `joints`, which must close the loops, to the closest pose to `goal` as Fig. 3 does, and
/// shows every iteration to `observe`. Lengths are in units of the metric's characteristic length.
///
/// The one addition to the paper: a step after which the loops do not close, or the distance grew,
/// is halved.
pub fn descend(
    mechanism: &Mechanism,
    goal: &Pose,
    joints: &mut [f64],
    max_iterations: usize,
    observe: &mut dyn FnMut(&Iteration<'_>),
) -> Descent {
    let n = joints.len();
    let start = pose::dual_quaternion(&mechanism.chains()[0].pose(joints), 1.0);
    let mut r: Vec<f64> = joints.iter().chain(start.iter()).copied().collect();
    let g = pose::dual_quaternion(goal, 1.0);
    let mut descent = Descent {
        converged: false,
        projected_gradient: f64::INFINITY,
        iterations: 0,
    };
    let mut share = 1.0;
    loop {
        let a = Factored::at(mechanism, &r);
        let rank = a.rank();
        let q = workpiece(&r);
        // Eq. 30–31: [W][W]ᵀ (g − q) is what the row space of [A] leaves of it.
        let toward = pose::nearer_sign(&q, g) - q;
        let mut step: Vec<f64> = std::iter::repeat_n(0.0, n)
            .chain(toward.iter().copied())
            .collect();
        for u in &a.svd.u[..rank] {
            let along = dot(u, &step);
            step.iter_mut().zip(u).for_each(|(s, u)| *s -= along * u);
        }
        let metric = 0.5 * toward.norm_squared();
        descent.projected_gradient = dot(&step, &step).sqrt();
        observe(&Iteration {
            joints: &r[..n],
            q: &q,
            metric,
            projected_gradient: descent.projected_gradient,
            residual: a.residual(),
            singular_values: &a.svd.sigma,
        });
        descent.converged = descent.projected_gradient <= STATIONARY;
        if descent.converged || descent.iterations >= max_iterations {
            break;
        }
        descent.iterations += 1;
        let next = loop {
            let mut next: Vec<f64> = r.iter().zip(&step).map(|(r, s)| r + share * s).collect();
            if close(mechanism, &mut next, rank) {
                let q = workpiece(&next);
                let after = 0.5 * (pose::nearer_sign(&q, g) - q).norm_squared();
                // At rounding level a fall cannot be told from a rise.
                if after <= metric + 1e-15 {
                    break Some(next);
                }
            }
            share *= 0.5;
            if share * descent.projected_gradient < STATIONARY * STATIONARY {
                break None;
            }
        };
        let Some(next) = next else { break };
        r = next;
        share = (2.0 * share).min(1.0);
    }
    joints.copy_from_slice(&r[..n]);
    descent
}

/// Eq. 28 with the sign that converges, r ← r − [A]⁺ E, until the loops are closed; `rank` is the
/// rank of [A] where they are.
fn close(mechanism: &Mechanism, r: &mut [f64], rank: usize) -> bool {
    let mut last = f64::INFINITY;
    for _ in 0..CORRECTIONS {
        let a = Factored::at(mechanism, r);
        let residual = a.residual();
        if residual <= CLOSED {
            return true;
        }
        // Written so that NaN ends it.
        if !(residual < last) {
            return last <= ROUNDING;
        }
        last = residual;
        for i in 0..rank.min(a.svd.sigma.len()) {
            let x = dot(&a.svd.v[i], &a.error) / a.svd.sigma[i];
            r.iter_mut().zip(&a.svd.u[i]).for_each(|(r, u)| *r -= x * u);
        }
    }
    last <= ROUNDING
}

/// [A]ᵀ = U Σ Vᵀ, so that U spans the row space of [A] in r, and E.
struct Factored {
    svd: Svd,
    error: Vec<f64>,
}

impl Factored {
    fn at(mechanism: &Mechanism, r: &[f64]) -> Self {
        let linear = linearise(mechanism, &r[..r.len() - 8], &workpiece(r));
        Self {
            svd: svd(linear.rows),
            error: linear.residual,
        }
    }

    fn rank(&self) -> usize {
        self.svd
            .sigma
            .iter()
            .take_while(|s| **s > ZERO * self.svd.sigma[0])
            .count()
    }

    fn residual(&self) -> f64 {
        self.error
            .iter()
            .fold(0.0, |m: f64, e| if e.abs() <= m { m } else { e.abs() })
    }
}

/// q, the last eight entries of r.
fn workpiece(r: &[f64]) -> DualQuaternion {
    DualQuaternion::from_column_slice(&r[r.len() - 8..])
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
