//! Rotations as other programs write them: unit quaternions, matrices, and three angles about axes in a named order.

use crate::math::linalg::svd;
use crate::math::norm::{self, norm, unit};
use nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};

/// How far a quaternion's length or a matrix's stretch may be from 1: numbers with three decimals still pass.
pub const UNIT_TOLERANCE: f64 = 1e-3;

/// The orders of [`from_angles`] about fixed axes; in upper case about moving ones.
pub const ORDERS: [&str; 12] = [
    "xyz", "xzy", "yxz", "yzx", "zxy", "zyx", "xyx", "xzx", "yxy", "yzy", "zxz", "zyz",
];

/// A rotation that was read, and how far its numbers were from one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orientation {
    /// The nearest rotation.
    pub rotation: UnitQuaternion<f64>,
    /// Of a quaternion the distance of its length from 1, of a matrix the most by which it stretches a unit vector.
    pub error: f64,
}

/// Why numbers are no rotation.
#[derive(Clone, Debug, PartialEq)]
pub enum NotRotation {
    /// One of the numbers is infinite, or not a number.
    NotFinite,
    /// A quaternion of this length.
    QuaternionLength(f64),
    /// A matrix that stretches a unit vector by as much.
    MatrixStretch(f64),
    /// A matrix that mirrors: its determinant is negative.
    Mirror,
    /// An order that is none of the 24.
    Order(String),
}

impl NotRotation {
    /// What is wrong.
    pub fn what(&self) -> String {
        match self {
            Self::NotFinite => "a number is not finite".to_owned(),
            Self::QuaternionLength(length) => {
                format!("the quaternion has the length {}", short(*length))
            }
            Self::MatrixStretch(error) => format!(
                "the matrix is no rotation: it changes the length of a direction by {}",
                short(*error)
            ),
            Self::Mirror => "the matrix mirrors: its determinant is negative".to_owned(),
            Self::Order(order) => {
                let excerpt: String = order.chars().take(20).collect();
                format!("\u{201c}{excerpt}\u{201d} is no order of three axes")
            }
        }
    }

    /// What would be accepted.
    pub fn accepted(&self) -> String {
        match self {
            Self::NotFinite => "finite numbers".to_owned(),
            Self::QuaternionLength(_) => {
                format!("a quaternion whose length is 1 to {UNIT_TOLERANCE}")
            }
            Self::MatrixStretch(_) | Self::Mirror => format!(
                "a matrix with orthogonal rows of length 1 to {UNIT_TOLERANCE}, right-handed"
            ),
            Self::Order(_) => format!(
                "one of {}; in lower case about fixed axes, in upper case about moving ones",
                ORDERS.join(", ")
            ),
        }
    }
}

/// Four digits; powers of ten where they are shorter.
fn short(x: f64) -> String {
    if x == 0.0 {
        "0".to_owned()
    } else if (1e-3..1e4).contains(&x.abs()) {
        format!("{x:.4}")
    } else {
        format!("{x:.3e}")
    }
}

/// The rotation of a quaternion, scalar first.
///
/// # Errors
/// When its length is farther from 1 than [`UNIT_TOLERANCE`].
pub fn from_quaternion_wxyz([w, x, y, z]: [f64; 4]) -> Result<Orientation, NotRotation> {
    let quaternion = Quaternion::new(w, x, y, z);
    // The largest first: no square overflows.
    let largest = quaternion.coords.amax();
    if ![w, x, y, z].iter().all(|part| part.is_finite()) {
        return Err(NotRotation::NotFinite);
    }
    let length = if largest > 0.0 {
        largest * norm(&(quaternion.coords / largest))
    } else {
        0.0
    };
    let error = (length - 1.0).abs();
    if error > UNIT_TOLERANCE {
        return Err(NotRotation::QuaternionLength(length));
    }
    Ok(Orientation {
        rotation: unit(quaternion),
        error,
    })
}

/// The rotation of a quaternion, scalar last.
///
/// # Errors
/// As [`from_quaternion_wxyz`].
pub fn from_quaternion_xyzw([x, y, z, w]: [f64; 4]) -> Result<Orientation, NotRotation> {
    from_quaternion_wxyz([w, x, y, z])
}

/// The rotation nearest to a matrix, given by its rows; its columns are the directions of the turned axes.
///
/// # Errors
/// When the matrix mirrors, or stretches a direction by more than [`UNIT_TOLERANCE`].
pub fn from_matrix(rows: [[f64; 3]; 3]) -> Result<Orientation, NotRotation> {
    if !rows.as_flattened().iter().all(|entry| entry.is_finite()) {
        return Err(NotRotation::NotFinite);
    }
    // Entries of a rotation are at most 1: beyond 2 nothing below can overflow, or pass.
    let largest = rows
        .as_flattened()
        .iter()
        .fold(0.0_f64, |most, entry| most.max(entry.abs()));
    if largest > 2.0 {
        return Err(NotRotation::MatrixStretch(largest - 1.0));
    }
    let matrix = Matrix3::from_fn(|i, j| rows[i][j]);
    let columns = (0..3).map(|j| matrix.column(j).iter().copied().collect());
    let factors = svd(columns.collect());
    let error = factors
        .sigma
        .iter()
        .fold(0.0_f64, |most, sigma| most.max((sigma - 1.0).abs()));
    if error > UNIT_TOLERANCE {
        return Err(NotRotation::MatrixStretch(error));
    }
    if matrix.determinant() < 0.0 {
        return Err(NotRotation::Mirror);
    }
    // The orthogonal factor of the polar decomposition, U Vᵀ.
    let nearest = Matrix3::from_fn(|i, j| (0..3).map(|k| factors.u[k][i] * factors.v[k][j]).sum());
    let rotation = norm::from_matrix(&nearest);
    Ok(Orientation { rotation, error })
}

/// The rotation by three angles in rad, in the order that they are given, about the axes that `order` names: in lower
/// case about fixed axes, one after the other ("xyz" is the roll, pitch and yaw of URDF), in upper case about axes that
/// turn along ("ZYX" with the angles reversed is the same). These are the conventions of
/// `scipy.spatial.transform.Rotation.from_euler`.
///
/// # Errors
/// When the order is none of [`ORDERS`] in lower or in upper case, or an angle is not finite.
pub fn from_angles(angles: [f64; 3], order: &str) -> Result<UnitQuaternion<f64>, NotRotation> {
    let lower = order.to_ascii_lowercase();
    let moving = order.bytes().all(|letter| letter.is_ascii_uppercase());
    if !ORDERS.contains(&lower.as_str()) || !(moving || order == lower) {
        return Err(NotRotation::Order(order.to_owned()));
    }
    if !angles.iter().all(|angle| angle.is_finite()) {
        return Err(NotRotation::NotFinite);
    }
    let turns = lower.bytes().zip(angles).map(|(letter, angle)| {
        let axis = match letter {
            b'x' => Vector3::x(),
            b'y' => Vector3::y(),
            _ => Vector3::z(),
        };
        let (s, c) = libm::sincos(0.5 * angle);
        UnitQuaternion::new_unchecked(Quaternion::from_parts(c, axis * s))
    });
    Ok(turns.fold(UnitQuaternion::identity(), |before, turn| {
        if moving { before * turn } else { turn * before }
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    fn near(a: &UnitQuaternion<f64>, b: [f64; 4]) -> bool {
        let b = Quaternion::new(b[0], b[1], b[2], b[3]);
        (a.coords - b.coords)
            .norm()
            .min((a.coords + b.coords).norm())
            < 1e-12
    }

    /// scipy's definition, with the three turns written out as matrices.
    #[test]
    fn all_orders_are_products_of_turns_about_fixed_or_moving_axes() {
        let angles: [f64; 3] = [0.1, -0.7, 2.3];
        let matrix = |letter: u8, angle: f64| {
            let (s, c) = libm::sincos(angle);
            match letter {
                b'x' => Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c),
                b'y' => Matrix3::new(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c),
                _ => Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0),
            }
        };
        for order in ORDERS {
            let [a, b, c] = [0, 1, 2].map(|i| matrix(order.as_bytes()[i], angles[i]));
            for (order, expected) in [
                (order.to_owned(), c * b * a),
                (order.to_uppercase(), a * b * c),
            ] {
                let found = from_angles(angles, &order).unwrap().to_rotation_matrix();
                assert!((found.matrix() - expected).norm() < 1e-14, "{order}");
            }
        }
        // URDF's roll 90°, then yaw 90°: x goes to y, y to z.
        let urdf = from_angles([FRAC_PI_2, 0.0, FRAC_PI_2], "xyz").unwrap();
        assert!(near(&urdf, [0.5, 0.5, 0.5, 0.5]));
    }

    #[test]
    fn orders_that_are_none_are_refused() {
        for order in ["", "xy", "xxy", "xYz", "XYz", "xyzz", "abc", "zyy", "äöü"] {
            let refusal = from_angles([0.0; 3], order).unwrap_err();
            assert_eq!(refusal, NotRotation::Order(order.to_owned()));
            assert!(refusal.accepted().contains("zyz"));
        }
        assert_eq!(
            from_angles([f64::NAN, 0.0, 0.0], "xyz"),
            Err(NotRotation::NotFinite)
        );
    }

    #[test]
    fn quaternions_are_normalised_where_they_are_nearly_of_length_1() {
        let both = [
            from_quaternion_wxyz([0.5005, 0.5, 0.5, 0.5]),
            from_quaternion_xyzw([0.5, 0.5, 0.5, 0.5005]),
        ];
        for read in both {
            let read = read.unwrap();
            assert!((read.rotation.norm() - 1.0).abs() < 1e-15);
            assert!((read.error - 2.5e-4).abs() < 1e-6);
            assert!(read.rotation.w > read.rotation.i);
        }
        let long = from_quaternion_wxyz([0.0, 1.0, 1.0, 0.0]).unwrap_err();
        assert_eq!(long.what(), "the quaternion has the length 1.4142");
        assert_eq!(
            from_quaternion_wxyz([0.0; 4]),
            Err(NotRotation::QuaternionLength(0.0))
        );
        assert!(matches!(
            from_quaternion_wxyz([1e200, 1e200, 0.0, 0.0]),
            Err(NotRotation::QuaternionLength(length)) if length.is_finite()
        ));
        assert_eq!(
            from_quaternion_wxyz([f64::INFINITY, 0.0, 0.0, 0.0]),
            Err(NotRotation::NotFinite)
        );
    }

    #[test]
    fn a_matrix_gives_the_nearest_rotation() {
        let exact = from_matrix([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).unwrap();
        assert!(near(&exact.rotation, [0.5, 0.5, 0.5, 0.5]));
        assert!(exact.error < 1e-15);
        // A symmetric stretch by 5e-4 along x: the polar decomposition takes it away.
        let stretched =
            from_matrix([[0.0, 0.0, 1.0], [1.0005, 0.0, 0.0], [0.0, 1.0, 0.0]]).unwrap();
        assert!(near(&stretched.rotation, [0.5, 0.5, 0.5, 0.5]));
        assert!((stretched.error - 5e-4).abs() < 1e-12);
        let half = from_matrix([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]]).unwrap();
        assert!(near(&half.rotation, [0.0, 1.0, 0.0, 0.0]));
    }

    #[test]
    fn what_is_no_rotation_is_told() {
        let mirror = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
        assert_eq!(from_matrix(mirror), Err(NotRotation::Mirror));
        assert_eq!(
            from_matrix([[0.0; 3]; 3]),
            Err(NotRotation::MatrixStretch(1.0))
        );
        assert!(matches!(
            from_matrix([[1e200; 3]; 3]),
            Err(NotRotation::MatrixStretch(_))
        ));
        let sheared = [[1.0, 0.1, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert!(
            matches!(from_matrix(sheared), Err(NotRotation::MatrixStretch(e)) if (0.04..0.06).contains(&e))
        );
        assert_eq!(from_matrix([[f64::NAN; 3]; 3]), Err(NotRotation::NotFinite));
    }
}
