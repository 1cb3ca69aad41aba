//! Double quaternions: a pose as a pair of unit quaternions.
//!
//! The paper's interpolation (its references 17 to 19) turns a pose (q, d) into the pair (G, H) =
//! (D∘q, D*∘q) with D = exp(d / 2R), interpolates each on its sphere and maps back: D² = G∘H*, so
//! d = R log(G∘H*), and q is the direction of G + H. The paper cites the method without its formulas;
//! this reading reproduces an independent reference to the last digits. Here d is measured from a
//! point of reference that the caller chooses; the paper's is the origin of the fixed frame.

use crate::math::norm::{norm, unit};
use crate::math::pose::Pose;
use nalgebra::{Quaternion, Translation3, UnitQuaternion, Vector3};

/// (G, H) of the rotation q and the position d, in units of which the radius is `radius`.
pub(crate) fn to_double_quaternion(
    rotation: &UnitQuaternion<f64>,
    position: &Vector3<f64>,
    radius: f64,
) -> (Quaternion<f64>, Quaternion<f64>) {
    let d = position / (2.0 * radius);
    let angle = norm(&d);
    let (s, c) = libm::sincos(angle);
    let d = Quaternion::from_parts(c, if angle > 0.0 { d * (s / angle) } else { d });
    let q = rotation.into_inner();
    (d * q, d.conjugate() * q)
}

/// The inverse of [`to_double_quaternion`]: the pose with rotation q and position d.
pub(crate) fn from_double_quaternion(g: Quaternion<f64>, h: Quaternion<f64>, radius: f64) -> Pose {
    let square = g * h.conjugate();
    let sine = norm(&square.imag());
    let angle = libm::atan2(sine, square.w);
    let d = square.imag() * (if sine > 0.0 { angle / sine } else { 1.0 } * radius);
    Pose::from_parts(Translation3::from(d), unit(g + h))
}
