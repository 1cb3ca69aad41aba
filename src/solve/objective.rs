//! The distance to the goal as a function of the workpiece's twist: value, gradient, Hessian.

use crate::math::metric::Target;
use crate::math::pose::Pose;
use nalgebra::{Matrix3, Matrix6, Vector6};

/// Second-order model of f = ½‖q − g‖² (Eq. 29) in the twist ξ = (v, ω) that moves the pose to
/// origin d + v and rotation exp(ω) R.
#[derive(Clone, Copy, Debug)]
pub struct Objective {
    /// f.
    pub value: f64,
    /// ∂f/∂ξ: the wrench (force, moment about the workpiece's origin) with which the goal pulls,
    /// with the opposite sign.
    pub gradient: Vector6<f64>,
    /// ∂²f/∂ξ².
    pub hessian: Matrix6<f64>,
}

/// The model at `pose` towards a target.
///
/// With p = r r_g* the rotation from the goal, d and d_g measured from the target's point, and c = d_g × d,
/// f = 1 − p₀ + w/2 (|d|² + |d_g|²) − w (p₀ d·d_g + p_v·c), w = 1/(4 length²):
/// Eq. 29 multiplied out. Its derivatives follow from p → exp(ω/2) p and d → d + v.
#[inline]
pub fn objective(pose: &Pose, target: &Target) -> Objective {
    let w = 0.25 / (target.length * target.length);
    let (q, g) = (target.measured(pose), &target.goal);
    let (d, dg) = (q.translation.vector, g.translation.vector);
    let p = q.rotation.quaternion() * g.rotation.quaternion().conjugate();
    let c = dg.cross(&d);
    let dot = d.dot(&dg);
    let (p0, pv) = (p.w, p.imag());

    let force = (d - dg * p0 - pv.cross(&dg)) * w;
    let moment = pv * (0.5 + 0.5 * w * dot) - (c * p0 + pv.cross(&c)) * (0.5 * w);

    let dg_cross = dg.cross_matrix();
    let mixed = (dg * pv.transpose() + dg_cross * p0 - dg_cross * pv.cross_matrix()) * (0.5 * w);
    let rotation = Matrix3::from_diagonal_element(0.25 * (p0 + w * (p0 * dot + pv.dot(&c))));
    let mut hessian = Matrix6::zeros();
    hessian.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(w);
    hessian.fixed_view_mut::<3, 3>(0, 3).copy_from(&mixed);
    hessian
        .fixed_view_mut::<3, 3>(3, 0)
        .copy_from(&mixed.transpose());
    hessian.fixed_view_mut::<3, 3>(3, 3).copy_from(&rotation);
    Objective {
        // Not the formula above: it would cancel near the goal.
        value: target.value(pose),
        gradient: Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z),
        hessian,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::metric::{Metric, MetricKind};
    use crate::math::pose::FrameCoordinates;
    use nalgebra::{Quaternion, Translation3, UnitQuaternion, Vector3};

    fn moved(q: &Pose, xi: &Vector6<f64>) -> Pose {
        let omega = Vector3::new(xi[3], xi[4], xi[5]);
        let angle = omega.norm();
        let (s, c) = libm::sincos(0.5 * angle);
        let axis = if angle > 0.0 { omega / angle } else { omega };
        let turn = UnitQuaternion::new_unchecked(Quaternion::from_parts(c, axis * s));
        let d = q.translation.vector + Vector3::new(xi[0], xi[1], xi[2]);
        Pose::from_parts(Translation3::from(d), turn * q.rotation)
    }

    #[test]
    fn derivatives_agree_with_finite_differences() {
        let q = FrameCoordinates {
            x: 0.3,
            y: -0.7,
            z: 1.1,
            longitude: 0.4,
            latitude: -0.6,
            roll: 2.0,
        };
        let g = FrameCoordinates {
            x: -0.2,
            y: 0.5,
            z: 0.8,
            longitude: -0.5,
            latitude: 0.3,
            roll: 1.1,
        };
        let (q, g) = (q.pose(), g.pose());
        let kinds = [MetricKind::Pose, MetricKind::DualQuaternion];
        for (length, kind) in [1.0, 0.4, 3.0]
            .into_iter()
            .flat_map(|length| kinds.map(|kind| (length, kind)))
        {
            let origin = Vector3::new(0.2, -0.1, 0.3);
            let target = Metric {
                kind,
                length,
                origin,
            }
            .target(&g, &q.rotation);
            let at = objective(&q, &target);
            let f = |xi: &Vector6<f64>| objective(&moved(&q, xi), &target).value;
            let h = 1e-4;
            for i in 0..6 {
                let ei = Vector6::ith(i, h);
                let slope = (f(&ei) - f(&-ei)) / (2.0 * h);
                assert!((slope - at.gradient[i]).abs() < 1e-8, "gradient {i}");
                for j in 0..6 {
                    let ej = Vector6::ith(j, h);
                    let bend = (f(&(ei + ej)) - f(&(ei - ej)) - f(&(ej - ei)) + f(&(-ei - ej)))
                        / (4.0 * h * h);
                    assert!((bend - at.hessian[(i, j)]).abs() < 1e-6, "hessian {i} {j}");
                }
            }
        }
    }
}
