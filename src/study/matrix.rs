//! The paper's matrix \[A\] at one position, with its singular values.

use crate::math::linalg::svd;
use crate::math::metric::{Metric, MetricKind};
use crate::math::pose;
use crate::model::chain::Chain;
use crate::model::mechanism::Mechanism;
use crate::model::scaled::Scaled;
use crate::solve::paper_matrix::linearise;
use serde::Serialize;

/// Share of the largest singular value below which one counts as zero: the rule of the default
/// planner, with lengths in units of the metric's.
const ZERO: f64 = 1e-9;

/// \[A\] of Eq. 21 at one position, in units of the metric's length.
#[derive(Clone, Debug, Serialize)]
pub struct Matrix {
    /// Row by row.
    pub values: Vec<f64>,
    /// 6 a chain and the 2 conditions of a unit dual quaternion.
    pub rows: usize,
    /// The joint variables and the 8 components of q.
    pub columns: usize,
    /// Joint variables of each chain.
    pub freedoms: Vec<usize>,
    /// Singular values, largest first (Eq. 27).
    pub singular_values: Vec<f64>,
    /// Below it a singular value counts as zero.
    pub threshold: f64,
    /// Singular values above it.
    pub rank: usize,
}

/// \[A\] at these joint values, the workpiece where the first chain puts it, as `metric` measures: in units of its
/// length, and about its point, which for [`MetricKind::Pose`] is the workpiece's own origin.
///
/// # Panics
/// When there is not one value a joint variable.
pub fn matrix(mechanism: &Mechanism, joints: &[f64], metric: &Metric) -> Matrix {
    let about = match metric.kind {
        MetricKind::Pose => mechanism.chains()[0].pose(joints).translation.vector,
        MetricKind::DualQuaternion => metric.origin,
    };
    let scaled = Scaled::about(mechanism, metric.length, &about);
    let theta = scaled.entered(joints);
    let chains = scaled.chains();
    let q = pose::dual_quaternion(&chains[0].pose(&theta), 1.0);
    let rows = linearise(chains, &theta, &q).rows;
    let (m, n) = (rows.len(), rows[0].len());
    let values = rows.concat();
    let mut singular_values = svd(rows).sigma;
    // More equations than unknowns: the surplus ones are no singular values.
    singular_values.truncate(m.min(n));
    let threshold = ZERO * singular_values[0];
    Matrix {
        values,
        rows: m,
        columns: n,
        freedoms: chains.iter().map(Chain::freedoms).collect(),
        rank: singular_values.iter().filter(|s| **s > threshold).count(),
        singular_values,
        threshold,
    }
}
