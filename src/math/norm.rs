//! Lengths of vectors and quaternions by the processor's square root. nalgebra's `norm` and what is built on it use the
//! crate `libm`'s, which is the same to the last digit, but in WebAssembly made of integer arithmetic: a tenth of a plan.

use nalgebra::{Matrix3, Quaternion, SVector, UnitQuaternion};

/// The length of a vector.
#[inline]
pub fn norm<const N: usize>(v: &SVector<f64, N>) -> f64 {
    v.norm_squared().sqrt()
}

/// The vector of length 1 in its direction.
#[inline]
pub fn normalized<const N: usize>(v: &SVector<f64, N>) -> SVector<f64, N> {
    v / norm(v)
}

/// The rotation of a quaternion of any length but 0.
#[inline]
pub fn unit(q: Quaternion<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::new_unchecked(Quaternion::from(normalized(&q.coords)))
}

/// The rotation whose matrix this is.
#[inline]
pub fn from_matrix(m: &Matrix3<f64>) -> UnitQuaternion<f64> {
    let (x, y, z) = (m[(0, 0)], m[(1, 1)], m[(2, 2)]);
    let trace = x + y + z;
    // Four times the part that is divided by, of those that are far from 0.
    let four = |square: f64| square.sqrt() * 2.0;
    let sum = |i, j| m[(i, j)] + m[(j, i)];
    let difference = |i, j| m[(i, j)] - m[(j, i)];
    let q = if trace > 0.0 {
        let n = four(trace + 1.0);
        let (i, j, k) = (difference(2, 1), difference(0, 2), difference(1, 0));
        Quaternion::new(0.25 * n, i / n, j / n, k / n)
    } else if x > y && x > z {
        let n = four(1.0 + x - y - z);
        let (w, j, k) = (difference(2, 1), sum(0, 1), sum(0, 2));
        Quaternion::new(w / n, 0.25 * n, j / n, k / n)
    } else if y > z {
        let n = four(1.0 + y - x - z);
        let (w, i, k) = (difference(0, 2), sum(0, 1), sum(1, 2));
        Quaternion::new(w / n, i / n, 0.25 * n, k / n)
    } else {
        let n = four(1.0 + z - x - y);
        let (w, i, j) = (difference(1, 0), sum(0, 2), sum(1, 2));
        Quaternion::new(w / n, i / n, j / n, 0.25 * n)
    };
    UnitQuaternion::new_unchecked(q)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Rotation3, Vector3, Vector4};

    /// To the last digit what nalgebra says.
    #[test]
    fn it_is_the_same_as_nalgebra() {
        let mut seen = [0; 4];
        for k in 0..2000_u32 {
            let part = |n: u32| libm::sin(f64::from(k * 4 + n) * 1.618) * f64::from(1 + n * k % 5);
            let v = Vector4::new(part(0), part(1), part(2), part(3));
            let (theirs, direction) = (v.norm(), v.normalize());
            assert_eq!(norm(&v).to_bits(), theirs.to_bits());
            assert_eq!(normalized(&v), direction);
            let rotation = UnitQuaternion::from_quaternion(Quaternion::from(v));
            assert_eq!(unit(Quaternion::from(v)), rotation);
            let matrix = rotation.to_rotation_matrix().into_inner();
            let theirs =
                UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(matrix));
            let ours = from_matrix(&matrix);
            assert_eq!(
                ours.coords.map(f64::to_bits),
                theirs.coords.map(f64::to_bits)
            );
            let largest = Vector3::new(matrix[(0, 0)], matrix[(1, 1)], matrix[(2, 2)]).imax();
            seen[if matrix.trace() > 0.0 { 3 } else { largest }] += 1;
        }
        assert!(seen.iter().all(|&cases| cases > 20), "{seen:?}");
    }
}
