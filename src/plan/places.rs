//! When two positions are the same, and the joint values of one as near to another's as they can be written.
//!
//! Positions are compared by their workpieces and the lines of their joints' axes, of a spherical joint by its centre; of
//! universal joints and sliders it does not matter to which side they point. What is the same so is built in the same way,
//! though the joint values differ: by whole turns; a spherical joint's two sets of angles (φ₁, φ₂, φ₃) and (φ₁ + π, −φ₂, φ₃ + π), which give the same rotation where its inner twists are ±90°; a rod
//! between two universal joints turned round by half a turn; a leg that turns by half a turn about its base and has a slider of
//! negative length.

use crate::math::norm::norm;
use crate::model::chain::Chain;
use crate::model::joint::{JointKind, Limits};
use crate::model::mechanism::Mechanism;
use crate::model::scaled::Scaled;
use crate::plan::one_chain::joined_still;
use nalgebra::Vector3;
use std::f64::consts::{PI, TAU};

/// How far apart links of the same position may be, shares of the size and rad: two minima are known to 1e-6 or better,
/// those in a nearly flat valley to 1e-3.
const SAME: f64 = 1e-3;

/// What tells positions of one linkage apart.
#[derive(Clone, Debug)]
pub struct Places {
    mechanism: Mechanism,
    scaled: Scaled,
    /// Of each spherical joint its first variable, and what its second row adds to the second.
    spherical: Vec<(usize, f64)>,
    /// What is compared of each row's axis.
    axes: Vec<Axis>,
    /// Angles with a limit: there a whole turn more is another position.
    limited: Vec<usize>,
    /// Of each joint whether it is an angle without a limit.
    free: Vec<bool>,
}

/// What is compared of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Axis {
    /// Its line, and to which side it points.
    Line,
    /// Its line: of a universal joint.
    Undirected,
    /// Its direction, or the opposite one: where a slider is, the axes behind it show.
    Direction,
    /// A point: the centre of a spherical joint.
    Point,
    /// Nothing: the other axes of a spherical joint.
    Nothing,
}

/// Joint values of one position written in another way: `sign` times the value plus `offset`, variable by variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Form(Vec<(f64, f64)>);

impl Form {
    /// As they are.
    pub fn same(variables: usize) -> Self {
        Self(vec![(1.0, 0.0); variables])
    }

    /// Writes joint values in this form.
    pub fn apply(&self, theta: &[f64]) -> Vec<f64> {
        let pairs = self.0.iter().zip(theta);
        pairs.map(|((sign, offset), t)| sign * t + offset).collect()
    }

    /// The form that undoes this one.
    pub fn inverse(&self) -> Self {
        let back = |&(sign, offset): &(f64, f64)| (sign, -sign * offset);
        Self(self.0.iter().map(back).collect())
    }

    /// This form of values that are in that form.
    pub fn of(&self, inner: &Self) -> Self {
        let pairs = self.0.iter().zip(&inner.0);
        Self(
            pairs
                .map(|((sign, offset), (s, o))| (sign * s, sign * o + offset))
                .collect(),
        )
    }
}

impl Places {
    /// Of this mechanism, as the solver has it.
    pub fn new(mechanism: &Mechanism, scaled: &Scaled) -> Self {
        let (mut spherical, mut axes) = (Vec::new(), Vec::new());
        let mut variable = 0;
        for joint in mechanism.chains().iter().flat_map(Chain::joints) {
            let kind = joint.kind();
            if kind == JointKind::S {
                spherical.push((variable, joint.rows()[1].theta));
            }
            variable += kind.freedoms();
            axes.extend((0..joint.rows().len()).map(|row| match (kind, row) {
                (JointKind::S, 0) => Axis::Point,
                (JointKind::S, _) => Axis::Nothing,
                (JointKind::P, _) | (JointKind::E, 0 | 1) => Axis::Direction,
                (JointKind::T, _) => Axis::Undirected,
                (JointKind::R | JointKind::C | JointKind::E, _) => Axis::Line,
            }));
        }
        let is_limited =
            |joint: &usize| scaled.turns()[*joint] && scaled.limits()[*joint] != Limits::NONE;
        Self {
            mechanism: mechanism.clone(),
            scaled: scaled.clone(),
            spherical,
            axes,
            limited: (0..scaled.variables()).filter(is_limited).collect(),
            free: (0..scaled.variables())
                .map(|joint| scaled.turns()[joint] && !is_limited(&joint))
                .collect(),
        }
    }

    /// The workpiece of a position, seven numbers (shares of the size, a quaternion), a point and the direction of the axis of
    /// each row, and the angles that have limits.
    pub fn axes(&self, theta: &[f64]) -> Vec<f64> {
        let joints = self.scaled.left(theta);
        let mut frames = Vec::new();
        let mut first = 0;
        for chain in self.mechanism.chains() {
            chain.frames_into(&joints[first..first + chain.freedoms()], &mut frames);
            first += chain.freedoms();
        }
        let workpiece = self.scaled.chains()[0].pose(theta);
        let (d, r) = (workpiece.translation.vector, workpiece.rotation.coords);
        let mut numbers = vec![d.x, d.y, d.z, r.x, r.y, r.z, r.w];
        // Before its joint a row's frame has the axis as z.
        for seat in frames.iter().step_by(2) {
            let seat = self.scaled.enter_pose(seat);
            let (o, z) = (seat.translation.vector, seat.rotation * Vector3::z());
            numbers.extend([o.x, o.y, o.z, z.x, z.y, z.z]);
        }
        numbers.extend(self.limited.iter().map(|&joint| theta[joint]));
        numbers
    }

    /// Whether two positions, given by [`Places::axes`], are the same.
    pub fn are_same(&self, a: &[f64], b: &[f64]) -> bool {
        Self::same_workpiece(a, b) && self.are_axes_same(a, b)
    }

    /// Whether the axes of two positions are.
    pub fn are_axes_same(&self, a: &[f64], b: &[f64]) -> bool {
        let end = 7 + 6 * self.axes.len();
        let mut angles = a[end..].iter().zip(&b[end..]);
        let pairs = a[7..end].chunks_exact(6).zip(b[7..end].chunks_exact(6));
        angles.all(|(a, b)| (a - b).abs() <= SAME)
            && pairs.zip(&self.axes).all(|((a, b), axis)| {
                let part = |numbers: &[f64], at: usize| {
                    Vector3::new(numbers[at], numbers[at + 1], numbers[at + 2])
                };
                let off = part(a, 0) - part(b, 0);
                let (za, zb) = (part(a, 3), part(b, 3));
                let parallel = norm(&za.cross(&zb)) <= SAME;
                match axis {
                    Axis::Nothing => true,
                    Axis::Point => norm(&off) <= SAME,
                    Axis::Direction => parallel,
                    Axis::Undirected => parallel && norm(&off.cross(&za)) <= SAME,
                    Axis::Line => parallel && za.dot(&zb) > 0.0 && norm(&off.cross(&za)) <= SAME,
                }
            })
    }

    /// Whether two positions are the same, or every chain can go from the one to the other while the workpiece stands still:
    /// inner freedoms give one pose many axes.
    pub fn are_joined_still(&self, from: &[f64], a: &[f64], to: &[f64], b: &[f64]) -> bool {
        if !Self::same_workpiece(a, b) {
            return false;
        }
        if self.are_axes_same(a, b) {
            return true;
        }
        let to = self.form_near(from, to).apply(to);
        let mut first = 0;
        self.scaled.chains().iter().all(|chain| {
            let own = first..first + chain.freedoms();
            first = own.end;
            joined_still(chain, &from[own.clone()], &to[own])
        })
    }

    /// Whether the workpiece is at the same place.
    fn same_workpiece(a: &[f64], b: &[f64]) -> bool {
        let square: f64 = (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum();
        let dot: f64 = (3..7).map(|i| a[i] * b[i]).sum();
        // 1 − |cos(φ/2)| = φ²/8.
        square <= SAME * SAME && 1.0 - dot.abs() <= SAME * SAME / 8.0
    }

    /// How to write the joint values `theta` so that they are nearest to `reference`. Angles with limits stay as they are.
    pub fn form_near(&self, reference: &[f64], theta: &[f64]) -> Form {
        let mut form = Form::same(theta.len());
        let is_free = |joint: usize| self.free[joint];
        for joint in (0..theta.len()).filter(|joint| is_free(*joint)) {
            form.0[joint] = turned(reference[joint], theta[joint], (1.0, 0.0));
        }
        for &(first, offset) in &self.spherical {
            if !(first..first + 3).all(is_free) {
                continue;
            }
            let own = first..first + 3;
            let nearest = nearest_angles(&reference[own.clone()], &theta[own.clone()], offset);
            form.0[own].copy_from_slice(&nearest);
        }
        form
    }
}

impl Places {
    /// The joints' motions from one position to another as [`Places::form_near`] writes it, each as `count` counts it, added up;
    /// from `most` on it is not added on.
    pub fn apart(
        &self,
        from: &[f64],
        to: &[f64],
        most: f64,
        count: impl Fn(usize, f64) -> f64,
    ) -> f64 {
        let mut spherical = self.spherical.iter().peekable();
        let (mut sum, mut joint) = (0.0, 0);
        while joint < from.len() && sum < most {
            let own = spherical.next_if(|(first, _)| *first == joint);
            let own = own.filter(|_| self.free[joint..joint + 3].iter().all(|free| *free));
            if let Some(&(first, offset)) = own {
                let own = first..first + 3;
                let form = nearest_angles(&from[own.clone()], &to[own], offset);
                for form in form {
                    sum += count(joint, moved(from[joint], to[joint], form));
                    joint += 1;
                }
                continue;
            }
            let form = if self.free[joint] {
                turned(from[joint], to[joint], (1.0, 0.0))
            } else {
                (1.0, 0.0)
            };
            sum += count(joint, moved(from[joint], to[joint], form));
            joint += 1;
        }
        sum
    }
}

/// Which of a spherical joint's two sets of angles is nearest to `reference`; `offset` is what its second row adds.
fn nearest_angles(reference: &[f64], theta: &[f64], offset: f64) -> [(f64, f64); 3] {
    let form = |forms: [(f64, f64); 3]| [0, 1, 2].map(|k| turned(reference[k], theta[k], forms[k]));
    let far = |forms: &[(f64, f64); 3]| -> f64 {
        let moves = [0, 1, 2].map(|k| moved(reference[k], theta[k], forms[k]));
        moves.iter().map(|m| m * m).sum()
    };
    let plain = form([(1.0, 0.0); 3]);
    let twin = form([(1.0, PI), (-1.0, -2.0 * offset), (1.0, PI)]);
    if far(&twin) < far(&plain) {
        twin
    } else {
        plain
    }
}

/// How far a value is from `reference` as the form writes it.
fn moved(reference: f64, theta: f64, (sign, offset): (f64, f64)) -> f64 {
    (reference - (sign * theta + offset)).abs()
}

/// A form with the whole turns that bring the value nearest to `reference`.
fn turned(reference: f64, theta: f64, (sign, offset): (f64, f64)) -> (f64, f64) {
    let turns = libm::round((reference - sign * theta - offset) / TAU) * TAU;
    (sign, offset + turns)
}
