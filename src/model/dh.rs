//! Denavit–Hartenberg rows: the one convention, and the transform of a row.

use crate::math::pose::Pose;
use nalgebra::{Quaternion, Translation3, UnitQuaternion, Vector3};

/// One row (α, a, θ, d) of a table such as Table 4: it contributes X(α, a) · Z(θ, d), the link
/// *before* the joint and then the joint. The joint's variable is added to θ, to d, or to both.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DhRow {
    /// Twist of the link about x, rad.
    pub alpha: f64,
    /// Length of the link along x.
    pub a: f64,
    /// Rotation about z, rad; the offset of a revolute joint.
    pub theta: f64,
    /// Shift along z; the offset of a prismatic joint.
    pub d: f64,
}

/// Z(θ, d), the screw displacement about z.
pub fn z_displacement(theta: f64, d: f64) -> Pose {
    screw_displacement(Vector3::z(), theta, d)
}

/// X(α, a), the screw displacement about x.
pub fn x_displacement(alpha: f64, a: f64) -> Pose {
    screw_displacement(Vector3::x(), alpha, a)
}

fn screw_displacement(axis: Vector3<f64>, angle: f64, shift: f64) -> Pose {
    let (s, c) = libm::sincos(0.5 * angle);
    let rotation = UnitQuaternion::new_unchecked(Quaternion::from_parts(c, axis * s));
    Pose::from_parts(Translation3::from(axis * shift), rotation)
}
