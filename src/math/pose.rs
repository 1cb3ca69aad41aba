//! Rigid displacements: frames given by coordinates, dual quaternions, and the distance between poses.

use crate::math::norm::{norm, unit};
use nalgebra::{Isometry3, Quaternion, SVector, Translation3, UnitQuaternion, Vector3};

/// A rigid displacement x ↦ R x + d: the place of a frame in another one.
pub type Pose = Isometry3<f64>;

/// A dual quaternion in the paper's layout (q1 q2 q3 q4 | q5 q6 q7 q8): the vector part of the
/// rotation first, its scalar fourth, then the dual part ½ d∘q in the same order (Eq. 16–17).
pub type DualQuaternion = SVector<f64, 8>;

/// A frame as the paper's Tables 5 and 7 give it: lengths, and angles in radians.
///
/// R = Y(longitude) · X(−latitude) · Z(roll); the tables name the angles without the formula.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameCoordinates {
    /// Origin, in the unit of length.
    pub x: f64,
    /// Origin, in the unit of length.
    pub y: f64,
    /// Origin, in the unit of length.
    pub z: f64,
    /// Rotation about the fixed y axis, rad.
    pub longitude: f64,
    /// Rotation about −x, before the longitude, rad.
    pub latitude: f64,
    /// Rotation about z, first of the three, rad.
    pub roll: f64,
}

impl FrameCoordinates {
    /// The pose these coordinates name.
    pub fn pose(&self) -> Pose {
        let turn = |axis: Vector3<f64>, angle: f64| {
            let (s, c) = libm::sincos(0.5 * angle);
            UnitQuaternion::new_unchecked(Quaternion::from_parts(c, axis * s))
        };
        let rotation = turn(Vector3::y(), self.longitude)
            * turn(Vector3::x(), -self.latitude)
            * turn(Vector3::z(), self.roll);
        Pose::from_parts(Translation3::new(self.x, self.y, self.z), rotation)
    }

    /// The coordinates of a pose: latitude in ±π/2, longitude and roll in ±π.
    ///
    /// At a latitude of ±π/2 only the difference of the two other angles counts; the roll is then 0.
    pub fn from_pose(pose: &Pose) -> Self {
        /// cos(latitude) below which longitude and roll no longer tell two axes apart; the error
        /// made by setting the roll to 0 there is of the same size.
        const POLE: f64 = 1e-9;
        let r = pose.rotation.to_rotation_matrix();
        let r = r.matrix();
        // Third column: (sin λ cos β, sin β, cos λ cos β); second row: cos β (sin ρ, cos ρ, ·).
        let cos_latitude = libm::hypot(r[(0, 2)], r[(2, 2)]);
        let (longitude, roll) = if cos_latitude > POLE {
            (
                libm::atan2(r[(0, 2)], r[(2, 2)]),
                libm::atan2(r[(1, 0)], r[(1, 1)]),
            )
        } else {
            (libm::atan2(-r[(2, 0)], r[(0, 0)]), 0.0)
        };
        let d = pose.translation.vector;
        Self {
            x: d.x,
            y: d.y,
            z: d.z,
            longitude,
            latitude: libm::atan2(r[(1, 2)], cos_latitude),
            roll,
        }
    }
}

/// The dual quaternion of a pose, its lengths divided by the characteristic `length` of the metric
/// (1 is the paper's choice).
pub fn dual_quaternion(pose: &Pose, length: f64) -> DualQuaternion {
    let q = pose.rotation.quaternion();
    let dual = Quaternion::from_imag(pose.translation.vector * (0.5 / length)) * q;
    let (q, dual) = (q.coords, dual.coords);
    DualQuaternion::from([q.x, q.y, q.z, q.w, dual.x, dual.y, dual.z, dual.w])
}

/// The pose of a dual quaternion whose real part is not zero; the inverse of [`dual_quaternion`].
///
/// The real part is normalised and only the part of the dual part that is orthogonal to it counts.
pub fn from_dual_quaternion(q: &DualQuaternion, length: f64) -> Pose {
    let real = Quaternion::new(q[3], q[0], q[1], q[2]);
    let dual = Quaternion::new(q[7], q[4], q[5], q[6]);
    // Eq. 17: d = vector part of 2 q_dual ∘ q*.
    let d = (dual * real.conjugate()).imag() * (2.0 * length / real.norm_squared());
    Pose::from_parts(Translation3::from(d), unit(real))
}

/// The twist (v, ω) that carries `from` to `to`: the difference of the origins, and 2 sin(φ/2) times
/// the axis of the remaining rotation.
///
/// To first order this is Eq. 23–24. The paper's skew-symmetric part, sin φ, vanishes at φ = 180°,
/// where the loop is as open as it can be; 2 sin(φ/2) is largest there.
#[inline]
pub fn difference(to: &Pose, from: &Pose) -> nalgebra::Vector6<f64> {
    let v = to.translation.vector - from.translation.vector;
    let r = to.rotation.quaternion() * from.rotation.quaternion().conjugate();
    let w = r.imag() * if r.w < 0.0 { -2.0 } else { 2.0 };
    nalgebra::Vector6::new(v.x, v.y, v.z, w.x, w.y, w.z)
}

/// Distance of the origins, and angle of the rotation between two poses (rad).
pub fn gaps(a: &Pose, b: &Pose) -> (f64, f64) {
    let translation = norm(&(a.translation.vector - b.translation.vector));
    let r = a.rotation.quaternion() * b.rotation.quaternion().conjugate();
    (translation, 2.0 * libm::atan2(norm(&r.imag()), r.w.abs()))
}

/// The mean of the positions and of the quaternions, whose signs are chosen one after another.
pub fn mean(poses: &[Pose]) -> Pose {
    let mut translation = Vector3::zeros();
    let mut sum = Quaternion::new(0.0, 0.0, 0.0, 0.0);
    for pose in poses {
        translation += pose.translation.vector / poses.len() as f64;
        let rotation = *pose.rotation.quaternion();
        let away = rotation.coords.dot(&sum.coords) < 0.0;
        sum += if away { -rotation } else { rotation };
    }
    // With these signs the sum is no shorter than the first one.
    Pose::from_parts(translation.into(), unit(sum))
}
