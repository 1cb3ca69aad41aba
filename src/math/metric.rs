//! The distance between two poses, in two forms.
//!
//! Both are f = ½‖q − g‖² of unit dual quaternions (Eq. 29), lengths divided by a characteristic length L. They differ in
//! the point about which the translations are measured: with d the origin of a pose from there, the dual part is ½ d∘q.
//! Measured about the goal's own origin f is ½(‖q_r − g_r‖² + ‖d − d_g‖² / 4L²), rotation and translation apart, and no
//! choice of the fixed frame changes it. About a far origin a small rotation counts like a large translation.

use crate::math::pose::{Pose, dual_quaternion};
use nalgebra::{UnitQuaternion, Vector3};

/// About which point translations are measured, and which of the two quaternions of a rotation is taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum MetricKind {
    /// About the goal's origin; at every pose the quaternion that is nearer to the goal's.
    #[default]
    Pose,
    /// About a given point, as the paper measures about the fixed frame's origin; the quaternions of goal and pose that
    /// are nearer to that of the pose before.
    DualQuaternion,
}

impl MetricKind {
    /// All, the default first.
    pub const ALL: [Self; 2] = [Self::Pose, Self::DualQuaternion];
}

/// A metric on poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metric {
    /// Its form.
    pub kind: MetricKind,
    /// The characteristic length L: a translation by it weighs about as much as a rotation by 1 rad.
    pub length: f64,
    /// The point about which [`MetricKind::DualQuaternion`] measures; not used by the other.
    pub origin: Vector3<f64>,
}

impl Default for Metric {
    /// About the goal's origin, with the length 1.
    fn default() -> Self {
        Self {
            kind: MetricKind::Pose,
            ..Self::PAPER
        }
    }
}

impl Metric {
    /// The paper's: about the fixed frame's origin, with the length 1.
    pub const PAPER: Self = Self {
        kind: MetricKind::DualQuaternion,
        length: 1.0,
        origin: Vector3::new(0.0, 0.0, 0.0),
    };

    /// The same metric for positions measured in another unit and from another point.
    pub fn within(&self, unit: f64, origin: &Vector3<f64>) -> Self {
        Self {
            kind: self.kind,
            length: self.length / unit,
            origin: (self.origin - origin) / unit,
        }
    }

    /// The goal with what this metric fixes for one frame; `before` is the rotation of the pose before.
    pub fn target(&self, goal: &Pose, before: &UnitQuaternion<f64>) -> Target {
        let about = match self.kind {
            MetricKind::Pose => goal.translation.vector,
            MetricKind::DualQuaternion => self.origin,
        };
        let mut shifted = *goal;
        shifted.translation.vector -= about;
        shifted.rotation = nearer(&shifted.rotation, before);
        Target {
            kind: self.kind,
            length: self.length,
            about,
            goal: shifted,
            before: *before,
        }
    }

    /// f of one pose against a goal, of which the nearer rotation is taken.
    pub fn value(&self, pose: &Pose, goal: &Pose) -> f64 {
        self.target(goal, &pose.rotation).value(pose)
    }
}

/// A goal with all that [`Metric`] fixes for one frame.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// The metric's form.
    pub kind: MetricKind,
    /// The metric's characteristic length.
    pub length: f64,
    /// The point about which translations are measured.
    pub about: Vector3<f64>,
    /// The goal, measured from there, with the sign of its quaternion that is nearer to `before`.
    pub goal: Pose,
    /// The rotation of the pose before.
    before: UnitQuaternion<f64>,
}

impl Target {
    /// The pose measured from `about`, with the sign of its quaternion that belongs to the goal's.
    #[inline]
    pub fn measured(&self, pose: &Pose) -> Pose {
        let mut pose = *pose;
        pose.translation.vector -= self.about;
        let reference = match self.kind {
            MetricKind::Pose => &self.goal.rotation,
            MetricKind::DualQuaternion => &self.before,
        };
        pose.rotation = nearer(&pose.rotation, reference);
        pose
    }

    /// Goes on from a pose that was reached: the next is measured with the quaternion's sign that is continuous with it.
    pub fn follow(&mut self, pose: &Pose) {
        self.before = nearer(&pose.rotation, &self.before);
    }

    /// f at a pose.
    pub fn value(&self, pose: &Pose) -> f64 {
        let q = dual_quaternion(&self.measured(pose), self.length);
        let g = dual_quaternion(&self.goal, self.length);
        0.5 * (q - g).norm_squared()
    }
}

/// `q` or −`q`, the same rotation, whichever is nearer to `reference`.
#[inline]
pub fn nearer(q: &UnitQuaternion<f64>, reference: &UnitQuaternion<f64>) -> UnitQuaternion<f64> {
    if q.coords.dot(&reference.coords) < 0.0 {
        UnitQuaternion::new_unchecked(-q.into_inner())
    } else {
        *q
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::pose::FrameCoordinates;

    fn pose(x: f64, roll: f64) -> Pose {
        FrameCoordinates {
            x,
            y: 0.4,
            roll,
            ..FrameCoordinates::default()
        }
        .pose()
    }

    /// f = ½(‖q_r − g_r‖² + ‖d − d_g‖²/4L²).
    #[test]
    fn pose_metric_is_rotation_and_translation_apart() {
        let metric = Metric {
            kind: MetricKind::Pose,
            length: 2.0,
            origin: Vector3::zeros(),
        };
        let (q, g) = (pose(3.0, 0.8), pose(-2.0, 0.2));
        let expected = 1.0 - libm::cos(0.3) + 0.5 * 25.0 / (4.0 * 4.0);
        assert!((metric.value(&q, &g) - expected).abs() < 1e-14);
        let shift = Pose::translation(1e3, -2e3, 5e2);
        assert!((metric.value(&(shift * q), &(shift * g)) - expected).abs() < 1e-11);
    }

    /// A slider that crosses the origin towards a goal on the other side is not compared with the goal's mirror image.
    #[test]
    fn the_sign_is_taken_by_the_rotation() {
        let (here, far) = (pose(-100.0, 0.0), pose(100.0, 0.1));
        let near = pose(90.0, 0.0);
        let f = |pose: &Pose| Metric::PAPER.value(pose, &far);
        assert!(f(&near) < f(&here));
    }

    /// Beyond half a turn the dual-quaternion form keeps the side on which the frame began, also where the workpiece
    /// itself turns by more than half a turn.
    #[test]
    fn a_frame_keeps_its_side() {
        let goal = pose(1.0, 3.0);
        let mut target = Metric::PAPER.target(&goal, &pose(1.0, 0.0).rotation);
        let mut last = target.value(&pose(1.0, 0.0));
        for step in 1..40 {
            let here = pose(1.0, -0.1 * f64::from(step));
            let value = target.value(&here);
            assert!(value > last || step > 33, "{step}");
            assert!((value - last).abs() < 0.1, "{step}: {last} to {value}");
            target.follow(&here);
            last = value;
        }
        let pose_metric = Metric {
            kind: MetricKind::Pose,
            ..Metric::PAPER
        };
        let target = pose_metric.target(&goal, &pose(1.0, 0.0).rotation);
        assert!(target.value(&pose(1.0, -0.2)) < target.value(&pose(1.0, -0.1)) + 0.01);
    }
}
