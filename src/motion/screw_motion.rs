//! The steady screw motion from one pose to another (dual-quaternion ScLERP).

use crate::math::norm::{norm, unit};
use crate::math::pose::Pose;
use nalgebra::{Quaternion, Translation3, Vector3};

/// A screw motion: rotation by `angle` about `axis` with the steady body velocity `velocity` of the
/// origin, over one unit of u.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScrewMotion {
    axis: Vector3<f64>,
    angle: f64,
    velocity: Vector3<f64>,
}

impl ScrewMotion {
    /// The one that carries `from` to `to`, measured in `from`: it does not depend on where both are.
    pub(crate) fn between(from: &Pose, to: &Pose) -> Self {
        let moved = from.inv_mul(to);
        let (w, v, d) = (
            moved.rotation.w,
            moved.rotation.imag(),
            moved.translation.vector,
        );
        let sine = norm(&v);
        if sine == 0.0 {
            return Self {
                axis: v,
                angle: 0.0,
                velocity: d,
            };
        }
        let (axis, half) = (v / sine, libm::atan2(sine, w));
        // d = V velocity with V as in `part`; V⁻¹ = 1 − φ/2 [l] + (1 − φ/2 cot φ/2) [l]².
        let across = axis.cross(&d);
        let velocity = d - across * half + axis.cross(&across) * (1.0 - half * w / sine);
        Self {
            axis,
            angle: 2.0 * half,
            velocity,
        }
    }

    /// The displacement after the part `u` of the motion: the exponential of u times the twist.
    pub(crate) fn part(&self, u: f64) -> Pose {
        let angle = u * self.angle;
        let (s, c) = libm::sincos(0.5 * angle);
        let rotation = Quaternion::from_parts(c, self.axis * s);
        let v = self.velocity * u;
        if angle == 0.0 {
            return pose(rotation, v);
        }
        // V = 1 + (1 − cos φ)/φ [l] + (1 − sin φ/φ) [l]², and 1 − cos φ = 2 sin² φ/2.
        let across = self.axis.cross(&v);
        let d = v
            + across * (2.0 * s * s / angle)
            + self.axis.cross(&across) * (1.0 - 2.0 * s * c / angle);
        pose(rotation, d)
    }
}

fn pose(q: Quaternion<f64>, d: Vector3<f64>) -> Pose {
    Pose::from_parts(Translation3::from(d), unit(q))
}
