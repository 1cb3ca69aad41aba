//! Curves on the sphere of unit quaternions: great circles, Bézier segments, Shoemake's spline.
//!
//! The spline is from Shoemake, Animating rotation with quaternion curves, 1985: cubic Bézier segments,
//! evaluated by de Casteljau's construction with slerp in place of lerp, with inner control points from
//! the neighbours.

use crate::math::norm::{norm, normalized};
use nalgebra::{Quaternion, Vector3};

/// The four control points of a cubic segment on the unit sphere of quaternions.
pub(crate) type Bezier = [Quaternion<f64>; 4];

/// Shoemake's spline through points of the sphere, C¹ in time.
///
/// At an inner point qₙ the curve heads for the point aₙ halfway between the next point and the
/// mirror image of the one before: aₙ is where the steady motion along the mean of both chords
/// would be one mean interval later. The control points lie on that great circle, a third of their
/// own interval before and behind qₙ. At an end of the spline the control point lies halfway between
/// the end and the segment's other control point.
///
/// `resting` says for each segment whether its two ends are one point: the curve stays there, and comes
/// to rest and starts again with no velocity, since the control points beside such a point lie on it.
/// Shoemake's own construction would swing past the point and come back.
pub(crate) fn spline(points: &[Quaternion<f64>], times: &[f64], resting: &[bool]) -> Vec<Bezier> {
    let last = points.len() - 1;
    let mut before = vec![None; points.len()];
    let mut behind = vec![None; points.len()];
    for n in 1..last {
        if resting[n - 1] || resting[n] {
            (before[n], behind[n]) = (Some(points[n]), Some(points[n]));
            continue;
        }
        let (earlier, later) = (times[n] - times[n - 1], times[n + 1] - times[n]);
        let mean = 0.5 * (earlier + later);
        let ahead = bisect(
            slerp(points[n - 1], points[n], 2.0),
            points[n + 1],
            points[n],
        );
        before[n] = Some(slerp(points[n], ahead, -earlier / (3.0 * mean)));
        behind[n] = Some(slerp(points[n], ahead, later / (3.0 * mean)));
    }
    let segment = |n: usize| {
        let (p, q) = (points[n], points[n + 1]);
        let (b, c) = match (behind[n], before[n + 1]) {
            (Some(b), Some(c)) => (b, c),
            (None, Some(c)) => (slerp(p, c, 0.5), c),
            (Some(b), None) => (b, slerp(q, b, 0.5)),
            // Two key frames: a steady motion.
            (None, None) => (slerp(p, q, 1.0 / 3.0), slerp(p, q, 2.0 / 3.0)),
        };
        [p, b, c, q]
    };
    (0..last).map(segment).collect()
}

/// The point halfway between `a` and `b`; between opposite points `otherwise`.
fn bisect(a: Quaternion<f64>, b: Quaternion<f64>, otherwise: Quaternion<f64>) -> Quaternion<f64> {
    let sum = a + b;
    if norm(&sum.coords) < OPPOSITE {
        otherwise
    } else {
        Quaternion::from(normalized(&sum.coords))
    }
}

/// Length of the sum of two unit quaternions below which they count as opposite, so that its
/// direction is rounding only.
const OPPOSITE: f64 = 1e-9;

/// De Casteljau's construction with great circles.
pub(crate) fn de_casteljau([a, b, c, d]: Bezier, u: f64) -> Quaternion<f64> {
    let (ab, bc, cd) = (slerp(a, b, u), slerp(b, c, u), slerp(c, d, u));
    slerp(slerp(ab, bc, u), slerp(bc, cd, u), u)
}

/// The point at `t` on the great circle from `a` (0) to `b` (1), also outside of both. Unlike the
/// usual slerp it never changes a sign: that is decided once, for the key frames.
pub(crate) fn slerp(a: Quaternion<f64>, b: Quaternion<f64>, t: f64) -> Quaternion<f64> {
    let (difference, sum) = (norm(&(b - a).coords), norm(&(b + a).coords));
    if difference == 0.0 {
        return a;
    }
    let angle = 2.0 * libm::atan2(difference, sum);
    let (s, c) = libm::sincos(t * angle);
    // The unit tangent at a towards b; between opposite points any will do, and this one is fixed.
    let across = if sum < OPPOSITE {
        a * Quaternion::from_imag(Vector3::x())
    } else {
        (b - a * a.dot(&b)) / libm::sin(angle)
    };
    Quaternion::from(normalized(&(a * c + across * s).coords))
}
