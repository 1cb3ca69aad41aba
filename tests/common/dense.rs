//! The paper's [A] as a dense matrix, in the unit and about the point of the published singular values.

use synthetica::math::linalg::svd;
use synthetica::math::pose::dual_quaternion;
use synthetica::model::mechanism::Mechanism;
use synthetica::model::scaled::Scaled;
use synthetica::solve::paper_matrix::linearise;

/// Singular values of [A], largest first: lengths as shares of the mechanism's size, measured about the workpiece's
/// origin.
pub fn singular_values(mechanism: &Mechanism, joints: &[f64]) -> Vec<f64> {
    let origin = mechanism.chains()[0].pose(joints).translation.vector;
    singular_values_about(mechanism, mechanism.size_or(1.0), &origin, joints)
}

/// The same in any unit, about any point.
pub fn singular_values_about(
    mechanism: &Mechanism,
    unit: f64,
    origin: &nalgebra::Vector3<f64>,
    joints: &[f64],
) -> Vec<f64> {
    let scaled = Scaled::about(mechanism, unit, origin);
    let theta = scaled.entered(joints);
    let q = dual_quaternion(&scaled.chains()[0].pose(&theta), 1.0);
    svd(linearise(scaled.chains(), &theta, &q).rows).sigma
}
