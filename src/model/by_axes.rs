//! A chain given by the axes of its joints in one position becomes base, Denavit–Hartenberg rows and gripper; and the
//! way back.

use crate::math::norm::{norm, normalized};
use crate::math::pose::Pose;
use crate::model::chain::{Chain, ChainFault, MAX_FREEDOMS};
use crate::model::joint::{Joint, JointFault, JointKind, Limits};
use crate::model::rows::{NearlyParallel, PARALLEL, Rows, aside, square};
use nalgebra::{Translation3, Vector3};
use std::f64::consts::FRAC_PI_2;

/// How far the two directions of a joint may be from a right angle, rad: what is left of 90° when directions have
/// seven digits. Within it the second direction is turned to the right angle.
pub const RIGHT_ANGLE: f64 = 1e-6;

/// A joint by its place at the home position, in the fixed frame. Directions are of any length but 0.
///
/// | kind | `point` | `axis` | `second` |
/// |---|---|---|---|
/// | R, C | on the axis | the axis | – |
/// | P | optional: only its drawing depends on it | the slider | – |
/// | T | where both axes meet | the axis next to the base | the other axis |
/// | S | the centre | optional: its first axis | optional, with `axis`: its second axis |
/// | E | optional: on the axis about which it turns | normal of the plane | optional: the first slider |
///
/// An optional point that is missing is the one of the joint before, else of the joint after, else the workpiece's
/// origin. The third axis of an S is first × second; the second slider of an E is normal × first. Where no second
/// direction is given, the first slider of an E is along the fixed frame's x axis (y, for a normal near x), as far as its
/// plane allows, and the axes of an S are chosen for short rows.
#[derive(Clone, Debug, PartialEq)]
pub struct JointAxis {
    /// The kind.
    pub kind: JointKind,
    /// A point of the joint.
    pub point: Option<Vector3<f64>>,
    /// The direction of its axis.
    pub axis: Option<Vector3<f64>>,
    /// The direction of its second axis, or of the first slider of an E.
    pub second: Option<Vector3<f64>>,
    /// One entry a freedom, counted from the home position; or none at all.
    pub limits: Vec<Limits>,
}

/// A chain that was given by its axes.
#[derive(Clone, Debug)]
pub struct ByAxes {
    /// At joint values 0 its workpiece is at home.
    pub chain: Chain,
    /// Where directions were changed, in the order of the joints.
    pub nearly_parallel: Vec<NearlyParallel>,
}

/// A field of [`JointAxis`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "named as in JointAxis")]
pub enum AxesField {
    Point,
    Axis,
    Second,
}

/// Why axes do not make a chain; joints count from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the fields are what the variants speak of")]
pub enum AxesFault {
    /// A joint of this kind needs the field.
    Missing { joint: usize, field: AxesField },
    /// A joint of this kind has no use for the field.
    Unneeded { joint: usize, field: AxesField },
    /// A coordinate is not a finite number.
    NotFinite { joint: usize, field: AxesField },
    /// A direction of length 0.
    ZeroDirection { joint: usize, field: AxesField },
    /// The two directions of a joint are `angle` apart, rad, and not 90° within [`RIGHT_ANGLE`].
    NotRight { joint: usize, angle: f64 },
    /// The limits, or numbers so large that the rows are not finite.
    Joint { joint: usize, fault: JointFault },
    /// The number of joints or freedoms, or the home position.
    Chain(ChainFault),
}

/// The chain with these joints, from the base on, whose workpiece is at `home` when all joint variables are 0.
///
/// Every axis has the given direction within 1e-12 rad and passes its given point within 1e-12/sin(φ) of the extent of
/// the points, with φ the smallest angle up to there between neighbouring axes that are not parallel, but for the
/// rounding of the points' coordinates themselves. Joints in [`ByAxes::nearly_parallel`] are where they were
/// given as well, their directions are off by the angle that it says; joints after them are not.
///
/// Numbers of the rows that are rounding are exactly 0, ±90° or 180°. The base is on the first axis, at its point.
///
/// # Errors
/// See [`AxesFault`]; the first joint with a fault is told, one of points and directions before one of limits.
pub fn chain_by_axes(name: String, joints: &[JointAxis], home: &Pose) -> Result<ByAxes, AxesFault> {
    let freedoms = joints.iter().map(|j| j.kind.freedoms()).sum();
    if joints.is_empty() {
        return Err(AxesFault::Chain(ChainFault::NoJoints));
    }
    if freedoms > MAX_FREEDOMS {
        return Err(AxesFault::Chain(ChainFault::TooManyFreedoms {
            found: freedoms,
        }));
    }
    if !home.to_homogeneous().iter().all(|x| x.is_finite()) {
        return Err(AxesFault::Chain(ChainFault::NotFinite));
    }
    let (places, origin) = places(joints, home)?;
    let extent = places.iter().map(|p| norm(&p.point)).fold(0.0, f64::max);
    let mut table = Rows::new(&origin, extent);
    for (joint, place) in places.iter().enumerate() {
        let axes = place.axes(table.last_axis(), places.get(joint + 1));
        for (row, axis) in axes.iter().enumerate() {
            if row == 0 {
                table.add(joint, &place.point, axis);
            } else {
                table.add_inner(&place.point, axis, row == 2);
            }
        }
    }
    let home = Pose::from_parts(
        Translation3::from(home.translation.vector - origin),
        home.rotation,
    );
    let gripper = table.end.inverse() * home;
    let mut base = table.base;
    base.translation.vector += origin;
    let mut rows = table.rows.into_iter();
    let made = joints.iter().enumerate().map(|(joint, given)| {
        let own = rows.by_ref().take(given.kind.row_count()).collect();
        Joint::new(given.kind, own, given.limits.clone())
            .map_err(|fault| AxesFault::Joint { joint, fault })
    });
    let made = made.collect::<Result<_, _>>()?;
    Ok(ByAxes {
        chain: Chain::new(name, base, made, gripper).map_err(AxesFault::Chain)?,
        nearly_parallel: table.nearly_parallel,
    })
}

/// The axes of a chain at the joint values `theta` (rad or lengths), in the fixed frame, with its limits counted from
/// there. Coordinates that are rounding are 0.
///
/// With the pose at `theta` for home, [`chain_by_axes`] makes of them the same linkage, its variables counted from
/// `theta`; but for the joints of [`other_variables`].
///
/// # Panics
/// When `theta` is shorter than [`Chain::freedoms`].
pub fn axes_of(chain: &Chain, theta: &[f64]) -> Vec<JointAxis> {
    let lines = lines(chain, theta);
    let points = lines.iter().flatten().map(|(point, _)| point.amax());
    let largest = points.fold(0.0, f64::max);
    let mut variables = theta.iter();
    let joints = chain.joints().iter().zip(&lines).map(|(joint, own)| {
        let (first, second) = match joint.kind() {
            JointKind::R | JointKind::P | JointKind::C => (own[0].1, None),
            JointKind::T | JointKind::S => (own[0].1, Some(own[1].1)),
            JointKind::E => (own[2].1, Some(own[0].1)),
        };
        let limits = joint.limits().iter().zip(variables.by_ref());
        JointAxis {
            kind: joint.kind(),
            point: own.last().map(|(point, _)| clean(point, largest)),
            axis: Some(normalized(&clean(&first, 1.0))),
            second: second.map(|second| normalized(&clean(&second, 1.0))),
            limits: limits
                .map(|(l, value)| Limits {
                    min: l.min - value,
                    max: l.max - value,
                })
                .collect(),
        }
    });
    joints.collect()
}

/// The joints, counted from 0, whose variables [`axes_of`] cannot keep: an S whose third axis is not first × second at
/// the joint values `theta`, and an E whose second slider is not normal × first.
///
/// # Panics
/// When `theta` is shorter than [`Chain::freedoms`].
pub fn other_variables(chain: &Chain, theta: &[f64]) -> Vec<usize> {
    let lines = lines(chain, theta);
    let other = lines.iter().enumerate().filter(|(_, own)| match own[..] {
        [(_, first), (_, second), (_, third)] => {
            norm(&(first.cross(&second) - third)) > RIGHT_ANGLE
        }
        _ => false,
    });
    other.map(|(joint, _)| joint).collect()
}

/// Point and direction of the axis of each row, joint by joint.
fn lines(chain: &Chain, theta: &[f64]) -> Vec<Vec<(Vector3<f64>, Vector3<f64>)>> {
    let mut frames = chain.frames(theta).into_iter();
    let of_joint = chain.joints().iter().map(|joint| {
        let own = frames.by_ref().take(joint.rows().len());
        own.map(|(seat, _)| (seat.translation.vector, seat.rotation * Vector3::z()))
            .collect()
    });
    of_joint.collect()
}

/// Without coordinates that are rounding, where `size` is not.
fn clean(v: &Vector3<f64>, size: f64) -> Vector3<f64> {
    v.map(|x| if x.abs() <= 1e-15 * size { 0.0 } else { x })
}

/// A joint that was checked: a point, measured from the chain's first point, and unit directions.
struct Place {
    kind: JointKind,
    point: Vector3<f64>,
    axis: Option<Vector3<f64>>,
    second: Option<Vector3<f64>>,
}

impl Place {
    /// The directions of its rows, unit and mutually perpendicular; `before` is the axis before it.
    fn axes(&self, before: Option<Vector3<f64>>, next: Option<&Self>) -> Vec<Vector3<f64>> {
        match (self.kind, self.axis, self.second) {
            (JointKind::E, Some(normal), second) => {
                let first = second.unwrap_or_else(|| aside(&normal));
                vec![first, normal.cross(&first), normal]
            }
            (JointKind::S, Some(first), Some(second)) => {
                vec![first, second, first.cross(&second)]
            }
            (JointKind::S, first, _) => {
                // The first axis parallel to the one before, the last one to the one after it, as far as can be.
                let after = next.and_then(|n| n.axis.or_else(|| unit(&(n.point - self.point))));
                let first = first
                    .or(before)
                    .or(after.map(|after| aside(&after)))
                    .unwrap_or_else(Vector3::z);
                let third = after
                    .map(|after| after - first * first.dot(&after))
                    .filter(|across| norm(across) > PARALLEL)
                    .map_or_else(|| aside(&first), |across| square(&across, &first));
                vec![first, third.cross(&first), third]
            }
            (_, axis, second) => axis.into_iter().chain(second).collect(),
        }
    }
}

/// The joints checked, and the point from which they are measured.
fn places(joints: &[JointAxis], home: &Pose) -> Result<(Vec<Place>, Vector3<f64>), AxesFault> {
    let mut origin = home.translation.vector;
    if let Some(point) = joints.iter().find_map(|j| j.point) {
        origin = point;
    }
    // Leading joints without a point have the first one there is, which is the origin.
    let mut point = Vector3::zeros();
    let mut places = Vec::new();
    for (joint, given) in joints.iter().enumerate() {
        if let Some(own) = checked(joint, given, given.point, AxesField::Point)? {
            point = own - origin;
        }
        let axis = direction(joint, given, given.axis, AxesField::Axis)?;
        let mut second = direction(joint, given, given.second, AxesField::Second)?;
        if let (Some(axis), Some(second)) = (&axis, &mut second) {
            let angle = libm::atan2(norm(&axis.cross(second)), axis.dot(second));
            if (angle - FRAC_PI_2).abs() > RIGHT_ANGLE {
                return Err(AxesFault::NotRight { joint, angle });
            }
            *second = square(second, axis);
        }
        places.push(Place {
            kind: given.kind,
            point,
            axis,
            second,
        });
    }
    Ok((places, origin))
}

/// A field, if it is there as far as the kind needs it, and finite.
fn checked(
    joint: usize,
    given: &JointAxis,
    value: Option<Vector3<f64>>,
    field: AxesField,
) -> Result<Option<Vector3<f64>>, AxesFault> {
    let kind = given.kind;
    let (needed, of_use) = match field {
        AxesField::Point => (!matches!(kind, JointKind::P | JointKind::E), true),
        // A second direction is one beside a first one.
        AxesField::Axis => (kind != JointKind::S || given.second.is_some(), true),
        AxesField::Second => (
            kind == JointKind::T,
            matches!(kind, JointKind::T | JointKind::S | JointKind::E),
        ),
    };
    match value {
        None if needed => Err(AxesFault::Missing { joint, field }),
        Some(_) if !of_use => Err(AxesFault::Unneeded { joint, field }),
        Some(v) if !v.iter().all(|x| x.is_finite()) => Err(AxesFault::NotFinite { joint, field }),
        value => Ok(value),
    }
}

fn direction(
    joint: usize,
    given: &JointAxis,
    value: Option<Vector3<f64>>,
    field: AxesField,
) -> Result<Option<Vector3<f64>>, AxesFault> {
    let Some(value) = checked(joint, given, value, field)? else {
        return Ok(None);
    };
    let unit = unit(&value).ok_or(AxesFault::ZeroDirection { joint, field })?;
    Ok(Some(unit))
}

/// The direction of a vector of any length but 0.
fn unit(v: &Vector3<f64>) -> Option<Vector3<f64>> {
    let largest = v.amax();
    // Squares of very large or small numbers would not be finite, or 0.
    (largest > 0.0).then(|| normalized(&(v / largest)))
}
