//! One serial chain from the base to the workpiece: forward kinematics, joint screws, Jacobian.

use crate::math::norm::{self, norm};
use crate::math::pose::Pose;
use crate::model::dh::{DhRow, x_displacement, z_displacement};
use crate::model::joint::{Joint, Limits, Moves};
use nalgebra::{Matrix3, Translation3, Vector3, Vector6};

/// A chain that constrains its workpiece has at most five freedoms (Section 4, Eq. 8).
pub const MAX_FREEDOMS: usize = 5;

/// A serial chain: base frame G, joints with their links, gripper frame H (Eq. 7).
#[derive(Clone, Debug)]
pub struct Chain {
    name: String,
    base: Pose,
    joints: Vec<Joint>,
    gripper: Pose,
    primitives: Vec<Primitive>,
    base_axes: Matrix3<f64>,
    gripper_axes: Matrix3<f64>,
}

/// Why joints do not make a chain.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the fields are what the variants speak of")]
pub enum ChainFault {
    /// A chain needs a joint.
    NoJoints,
    /// More than [`MAX_FREEDOMS`].
    TooManyFreedoms { found: usize },
    /// A number of the base or gripper frame is not finite.
    NotFinite,
}

/// A row with one variable: X(α, a) · Z(θ, d), where the variable is added to θ or to d.
#[derive(Clone, Copy, Debug)]
struct Primitive {
    row: DhRow,
    sin_alpha: f64,
    cos_alpha: f64,
    turns: bool,
    limits: Limits,
}

/// Where the workpiece is according to one chain, and how each joint variable moves it.
#[derive(Clone, Copy, Debug)]
pub struct ChainState {
    /// The workpiece, Eq. 7.
    pub pose: Pose,
    /// Columns of the Jacobian (Eq. 15), twists (v, ω) of the workpiece's origin per unit of each
    /// variable; those past the chain's freedoms are 0.
    pub jacobian: [Vector6<f64>; MAX_FREEDOMS],
}

impl Default for ChainState {
    fn default() -> Self {
        Self {
            pose: Pose::identity(),
            jacobian: [Vector6::zeros(); MAX_FREEDOMS],
        }
    }
}

impl Chain {
    /// Base frame, joints from the base on, and the workpiece in the last link's frame.
    ///
    /// # Errors
    /// Without joints, with more than five freedoms, or with a frame that is not finite.
    pub fn new(
        name: String,
        base: Pose,
        joints: Vec<Joint>,
        gripper: Pose,
    ) -> Result<Self, ChainFault> {
        let freedoms = joints.iter().map(|j| j.kind().freedoms()).sum();
        if joints.is_empty() {
            return Err(ChainFault::NoJoints);
        }
        if freedoms > MAX_FREEDOMS {
            return Err(ChainFault::TooManyFreedoms { found: freedoms });
        }
        let finite = |p: &Pose| p.to_homogeneous().iter().all(|x| x.is_finite());
        if !finite(&base) || !finite(&gripper) {
            return Err(ChainFault::NotFinite);
        }
        Ok(Self {
            name,
            base,
            primitives: primitives(&joints),
            joints,
            gripper,
            base_axes: *base.rotation.to_rotation_matrix().matrix(),
            gripper_axes: *gripper.rotation.to_rotation_matrix().matrix(),
        })
    }

    /// The name, for messages.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// G, the base frame in the fixed frame.
    pub fn base(&self) -> &Pose {
        &self.base
    }

    /// H, the workpiece in the frame of the last link.
    pub fn gripper(&self) -> &Pose {
        &self.gripper
    }

    /// From the base on.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// Number of joint variables, 1 to 5.
    pub fn freedoms(&self) -> usize {
        self.primitives.len()
    }

    /// Degree of constraint U (Eq. 8).
    pub fn constraints(&self) -> usize {
        6 - self.freedoms()
    }

    /// The joints' letters, such as TPR.
    pub fn type_name(&self) -> String {
        self.joints.iter().map(|j| j.kind().letter()).collect()
    }

    /// Which variables are angles; the others are lengths.
    pub fn turns(&self) -> impl Iterator<Item = bool> + '_ {
        self.primitives.iter().map(|p| p.turns)
    }

    /// The limits of each variable.
    pub fn limits(&self) -> impl Iterator<Item = Limits> + '_ {
        self.primitives.iter().map(|p| p.limits)
    }

    /// The sum of the lengths that the chain is built of, its gripper included.
    pub fn reach(&self) -> f64 {
        let links: f64 = self
            .primitives
            .iter()
            .map(|p| p.row.a.abs() + p.row.d.abs())
            .sum();
        links + norm(&self.gripper.translation.vector)
    }

    /// The same chain with lengths in multiples of `unit` and its base measured from `origin`. For the kinematics
    /// only: [`Chain::joints`] keeps the rows as they were given.
    pub(super) fn within(&self, unit: f64, origin: &Vector3<f64>) -> Self {
        let mut chain = self.clone();
        chain.base.translation.vector = (self.base.translation.vector - origin) / unit;
        chain.gripper.translation.vector /= unit;
        for p in &mut chain.primitives {
            p.row.a /= unit;
            p.row.d /= unit;
            if !p.turns {
                p.limits = Limits {
                    min: p.limits.min / unit,
                    max: p.limits.max / unit,
                };
            }
        }
        chain
    }

    /// Pose of the workpiece and Jacobian at the joint values `theta` (rad or lengths).
    ///
    /// # Panics
    /// When `theta` is shorter than [`Chain::freedoms`].
    #[inline]
    pub fn evaluate(&self, theta: &[f64], state: &mut ChainState) {
        // The frame after each row: axes x, y, z and origin o.
        let mut x: Vector3<f64> = self.base_axes.column(0).into();
        let mut y: Vector3<f64> = self.base_axes.column(1).into();
        let mut z: Vector3<f64> = self.base_axes.column(2).into();
        let mut o = self.base.translation.vector;
        let rows = || self.primitives.iter().zip(theta);
        for ((p, &variable), column) in rows().zip(&mut state.jacobian) {
            o += x * p.row.a;
            (y, z) = (
                y * p.cos_alpha + z * p.sin_alpha,
                z * p.cos_alpha - y * p.sin_alpha,
            );
            // The joint's axis, and a point of it.
            *column = Vector6::new(o.x, o.y, o.z, z.x, z.y, z.z);
            let (angle, shift) = if p.turns {
                (p.row.theta + variable, p.row.d)
            } else {
                (p.row.theta, p.row.d + variable)
            };
            let (s, c) = libm::sincos(angle);
            (x, y) = (x * c + y * s, y * c - x * s);
            o += z * shift;
        }
        let link = Matrix3::from_columns(&[x, y, z]);
        let d = o + link * self.gripper.translation.vector;
        let rotation = norm::from_matrix(&(link * self.gripper_axes));
        state.pose = Pose::from_parts(Translation3::from(d), rotation);
        // Eq. 15: (S × (d − C), S) for a revolute joint, (S, 0) for a prismatic one.
        for ((p, _), column) in rows().zip(&mut state.jacobian) {
            let c = Vector3::new(column[0], column[1], column[2]);
            let s = Vector3::new(column[3], column[4], column[5]);
            *column = if p.turns {
                let v = s.cross(&(d - c));
                Vector6::new(v.x, v.y, v.z, s.x, s.y, s.z)
            } else {
                Vector6::new(s.x, s.y, s.z, 0.0, 0.0, 0.0)
            };
        }
    }

    /// How the workpiece moves with the numbers of each row at the joint values `theta`: its twist per unit of α, a, θ
    /// and d. For a C, whose two variables share a row, there is a second row of no link.
    ///
    /// # Panics
    /// When `theta` is shorter than [`Chain::freedoms`].
    pub fn row_twists(&self, theta: &[f64]) -> Vec<[Vector6<f64>; 4]> {
        let end = self.pose(theta).translation.vector;
        let turn = |axis: &Vector3<f64>, o: &Vector3<f64>| {
            let v = axis.cross(&(end - o));
            Vector6::new(v.x, v.y, v.z, axis.x, axis.y, axis.z)
        };
        let shift = |axis: &Vector3<f64>| Vector6::new(axis.x, axis.y, axis.z, 0.0, 0.0, 0.0);
        let mut frame = self.base;
        let rows = self.primitives.iter().zip(theta).map(|(p, &variable)| {
            let before = (frame.rotation * Vector3::x(), frame.translation.vector);
            let (angle, offset) = if p.turns {
                (p.row.theta + variable, p.row.d)
            } else {
                (p.row.theta, p.row.d + variable)
            };
            let seat = frame * x_displacement(p.row.alpha, p.row.a);
            frame = seat * z_displacement(angle, offset);
            let (z, o) = (seat.rotation * Vector3::z(), seat.translation.vector);
            [
                turn(&before.0, &before.1),
                shift(&before.0),
                turn(&z, &o),
                shift(&z),
            ]
        });
        rows.collect()
    }

    /// Pose of the workpiece at the joint values `theta`.
    ///
    /// # Panics
    /// When `theta` is shorter than [`Chain::freedoms`].
    pub fn pose(&self, theta: &[f64]) -> Pose {
        let mut state = ChainState::default();
        self.evaluate(theta, &mut state);
        state.pose
    }

    /// For drawing: each table row's frame before its joint, after X(α, a), and behind it, after
    /// Z(θ, d), both in the fixed frame.
    ///
    /// # Panics
    /// When `theta` is shorter than [`Chain::freedoms`].
    pub fn frames(&self, theta: &[f64]) -> Vec<(Pose, Pose)> {
        let mut frames = Vec::new();
        self.frames_into(theta, &mut frames);
        frames.chunks_exact(2).map(|of| (of[0], of[1])).collect()
    }

    /// The same, appended one after the other.
    ///
    /// # Panics
    /// When `theta` is shorter than [`Chain::freedoms`].
    pub fn frames_into(&self, theta: &[f64], frames: &mut Vec<Pose>) {
        let mut variables = theta.iter();
        let mut next = || *variables.next().expect("one value a freedom");
        let mut frame = self.base;
        for joint in &self.joints {
            for (i, row) in joint.rows().iter().enumerate() {
                let (angle, shift) = match joint.kind().moves(i) {
                    Moves::Turns => (next(), 0.0),
                    Moves::Slides => (0.0, next()),
                    Moves::Both => (next(), next()),
                };
                let seat = frame * x_displacement(row.alpha, row.a);
                frame = seat * z_displacement(row.theta + angle, row.d + shift);
                frames.push(seat);
                frames.push(frame);
            }
        }
    }
}

/// The rows with one variable each; a C turns first and then slides along the same axis.
fn primitives(joints: &[Joint]) -> Vec<Primitive> {
    let mut list = Vec::new();
    for joint in joints {
        for (i, &row) in joint.rows().iter().enumerate() {
            let (sin_alpha, cos_alpha) = libm::sincos(row.alpha);
            let limits = joint.limits()[i];
            let moves = joint.kind().moves(i);
            list.push(Primitive {
                row,
                sin_alpha,
                cos_alpha,
                turns: moves != Moves::Slides,
                limits,
            });
            if moves == Moves::Both {
                list.push(Primitive {
                    row: DhRow::default(),
                    sin_alpha: 0.0,
                    cos_alpha: 1.0,
                    turns: false,
                    limits: joint.limits()[1],
                });
            }
        }
    }
    list
}
