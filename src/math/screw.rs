//! A space of twists told by its simplest screws: pure shifts, and the principal screws of the rest.

use crate::math::linalg;
use crate::math::norm::normalized;
use crate::math::sort::sort_few;
use nalgebra::{Matrix3, Vector3, Vector6};
use serde::Serialize;

/// Singular value below which a direction is not in a space, or an axis not in a motion: the
/// closure error of a closed linkage, amplified.
const ZERO: f64 = 1e-8;

/// Entry of a unit vector that is rounding.
const ROUNDING: f64 = 1e-14;

/// A screw in the fixed frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Screw {
    /// (v, ω) of the workpiece's origin; ω or, for a shift, v has unit length.
    pub twist: [f64; 6],
    /// The point of the axis nearest to the workpiece's origin; for a shift the origin itself.
    pub point: [f64; 3],
    /// Unit, along the axis.
    pub direction: [f64; 3],
    /// Length per radian, 0 for a pure turn; none for a pure shift.
    pub pitch: Option<f64>,
}

/// The screws of the space that `twists` span, lengths in units of `size`, of a workpiece whose origin
/// is at `origin`; the screws are in the unit of `origin`.
///
/// Shifts come first, along coordinate axes where the space has them. What is left turns, and is only
/// known up to a shift: of these twists those without a shift's component are taken. On them the
/// pitch ω·v is a quadratic form of the axis ω, and its principal axes give the principal screws of
/// the system (Ball 1900; Hunt 1978, ch. 12): mutually perpendicular, with the extreme pitches among
/// them. They come by growing pitch, pure turns first.
pub fn principal(twists: &[Vector6<f64>], size: f64, origin: &Vector3<f64>) -> Vec<Screw> {
    let basis = orthonormal(twists);
    // Shifts: the combinations of the basis without ω.
    let (mut shifts, mut turns) = (Vec::new(), Vec::new());
    let turning = linalg::svd(columns(basis.iter().map(turn_of)));
    for (sigma, v) in turning.sigma.iter().zip(&turning.v) {
        let twist: Vector6<f64> = basis.iter().zip(v).map(|(t, c)| t * *c).sum();
        if *sigma > ZERO {
            turns.push(twist / *sigma);
        } else {
            shifts.push(shift_of(&twist));
        }
    }
    let shifts = aligned(&shifts);
    let mut screws: Vec<Screw> = shifts
        .iter()
        .map(|v| Screw {
            twist: [v.x, v.y, v.z, 0.0, 0.0, 0.0],
            point: (*origin).into(),
            direction: (*v).into(),
            pitch: None,
        })
        .collect();
    // ω of the turns is orthonormal; v = A ω, without shifts.
    let mut velocity = Matrix3::zeros();
    for twist in &turns {
        let mut v = shift_of(twist);
        for shift in &shifts {
            v -= shift * shift.dot(&v);
        }
        velocity += v * turn_of(twist).transpose();
    }
    let axes = aligned(&turns.iter().map(turn_of).collect::<Vec<_>>());
    let n = axes.len();
    let mut form = vec![0.0; n * n];
    for (i, a) in axes.iter().enumerate() {
        for (j, b) in axes.iter().enumerate() {
            form[i * n + j] = 0.5 * (a.dot(&(velocity * b)) + b.dot(&(velocity * a)));
            // So that equal pitches leave the axes as they are.
            if i != j && form[i * n + j].abs() <= ZERO {
                form[i * n + j] = 0.0;
            }
        }
    }
    let mut vectors = vec![0.0; n * n];
    linalg::symmetric_eigen(&mut form, n, &mut vectors);
    let mut turning: Vec<Screw> = vectors
        .chunks_exact(n.max(1))
        .map(|c| {
            let axis: Vector3<f64> = axes.iter().zip(c).map(|(a, c)| a * *c).sum();
            let axis = upright(normalized(&axis));
            screw(&axis, &(velocity * axis * size), size, origin)
        })
        .collect();
    let pitch = |s: &Screw| s.pitch.unwrap_or(0.0).abs();
    sort_few(&mut turning, |a, b| pitch(a) < pitch(b));
    screws.extend(turning);
    screws
}

/// The screw of the twist (v, ω), ω of unit length.
fn screw(axis: &Vector3<f64>, v: &Vector3<f64>, size: f64, origin: &Vector3<f64>) -> Screw {
    let pitch = axis.dot(v);
    let pitch = if pitch.abs() <= ZERO * size {
        0.0
    } else {
        pitch
    };
    Screw {
        twist: [v.x, v.y, v.z, axis.x, axis.y, axis.z],
        point: (origin + axis.cross(v)).into(),
        direction: (*axis).into(),
        pitch: Some(pitch),
    }
}

/// An orthonormal basis of the space of these twists.
pub fn orthonormal(twists: &[Vector6<f64>]) -> Vec<Vector6<f64>> {
    // Six columns of as many entries as there are twists: their right singular vectors are twists.
    let rows = (0..6).map(|i| twists.iter().map(|t| t[i]).collect());
    let svd = linalg::svd(rows.collect());
    svd.sigma
        .iter()
        .zip(&svd.v)
        .filter(|(sigma, _)| **sigma > ZERO)
        .map(|(_, v)| Vector6::from_column_slice(v))
        .collect()
}

fn columns(vectors: impl Iterator<Item = Vector3<f64>>) -> Vec<Vec<f64>> {
    vectors.map(|v| v.as_slice().to_vec()).collect()
}

fn shift_of(twist: &Vector6<f64>) -> Vector3<f64> {
    twist.fixed_rows::<3>(0).into()
}

fn turn_of(twist: &Vector6<f64>) -> Vector3<f64> {
    twist.fixed_rows::<3>(3).into()
}

/// An orthonormal basis of the space of these orthonormal vectors, along coordinate axes as far as
/// they are in it: the first vector is nearest to an axis, the next is nearest among the rest.
fn aligned(vectors: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    /// An axis must be this much nearer to be preferred to an earlier one: rounding does not choose.
    const NEARER: f64 = 1e-6;
    let mut rest: Matrix3<f64> = vectors.iter().map(|v| v * v.transpose()).sum();
    let mut basis = Vec::new();
    for _ in vectors {
        let nearest = (0..3).reduce(|a, b| {
            if rest[(b, b)] > rest[(a, a)] + NEARER {
                b
            } else {
                a
            }
        });
        let column: Vector3<f64> = rest.column(nearest.unwrap_or(0)).into();
        let axis = upright(normalized(&column));
        rest -= axis * axis.transpose();
        basis.push(axis);
    }
    basis
}

/// The vector or its opposite, whichever has its largest entry positive; entries of rounding are 0.
fn upright(vector: Vector3<f64>) -> Vector3<f64> {
    let largest = vector[vector.iamax()];
    let vector = if largest < 0.0 { -vector } else { vector };
    vector.map(|x| if x.abs() <= ROUNDING { 0.0 } else { x })
}
