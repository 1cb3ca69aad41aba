//! The goal motion through the key frames.
//!
//! The default is the paper's interpolation: each pose becomes a double quaternion, a pair of unit
//! quaternions (see `double_quaternion`), and each of the two follows Shoemake's spline on its sphere
//! (see `quaternion_spline`). Steady screw motions and straight lines can be chosen instead.

use crate::math::norm::unit;
use crate::math::pose::Pose;
use crate::motion::double_quaternion::{from_double_quaternion, to_double_quaternion};
use crate::motion::key_frames::{
    HalfTurn, KeyFrame, KeyFrameFault, check_numbers, farthest, mean_position, on_one_side,
    resting, times,
};
use crate::motion::quaternion_spline::{Bezier, de_casteljau, slerp, spline};
use crate::motion::screw_motion::ScrewMotion;
use nalgebra::{Translation3, Vector3};

/// A frame for each interval of [`MAX_KEY_FRAMES`](crate::motion::key_frames::MAX_KEY_FRAMES) and one more, so that every
/// key frame can fall on a frame; half an hour at 60 a second.
pub const MAX_FRAMES: usize = 100_001;

/// How the motion goes from one key frame to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// The paper's double-quaternion spline, with a continuous velocity.
    #[default]
    Bezier,
    /// A steady screw motion between neighbours (dual-quaternion ScLERP).
    Sclerp,
    /// The origin goes straight while the rotation turns steadily about a fixed axis.
    Straight,
}

/// One frame of the goal motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// In the key frames' unit of time; from 0 to 1 where they have none.
    pub time: f64,
    /// Where the workpiece should be.
    pub pose: Pose,
}

/// The frame of reference of the double quaternions, which only [`Interpolation::Bezier`] uses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoubleQuaternions {
    /// The point about which poses are interpolated, in the unit of length; `None` for the mean of the
    /// key frames' positions. The mean moves with the key frames, so that with it the motion does not
    /// depend on the choice of the fixed frame.
    pub reference: Option<Vector3<f64>>,
    /// R, in the unit of length; `None` for [`default_radius`].
    pub radius: Option<f64>,
}

/// The goal motion, frame by frame, and what deserves to be told about it.
#[derive(Clone, Debug, PartialEq)]
pub struct GoalMotion {
    /// One a frame.
    pub goals: Vec<Goal>,
    /// Where the way round was chosen between two that are equally long.
    pub half_turns: Vec<HalfTurn>,
}

/// The goal motion at `frames` times, equally spaced from the first key frame to the last. A key
/// frame whose time falls on a frame is met, the first and the last exactly (up to the sign of the
/// quaternion, which is kept continuous).
///
/// # Errors
/// When the key frames, the radius or the number of frames cannot be used; see [`KeyFrameFault`].
pub fn goal_motion(
    keys: &[KeyFrame],
    how: Interpolation,
    frames: usize,
    double_quaternions: &DoubleQuaternions,
) -> Result<GoalMotion, KeyFrameFault> {
    if !(2..=MAX_FRAMES).contains(&frames) {
        return Err(KeyFrameFault::FrameCount { found: frames });
    }
    let curve = Curve::new(keys, how, double_quaternions)?;
    let (first, last) = curve.interval();
    let goal = |i: usize| {
        let time = if i + 1 == frames {
            last
        } else {
            first + (last - first) * (i as f64 / (frames - 1) as f64)
        };
        Goal {
            time,
            pose: curve.pose(time),
        }
    };
    Ok(GoalMotion {
        goals: (0..frames).map(goal).collect(),
        half_turns: curve.half_turns,
    })
}

/// The goal motion as a function of time.
#[derive(Clone, Debug)]
pub struct Curve {
    times: Vec<f64>,
    /// The key frames, each quaternion on the side of the one before.
    keys: Vec<Pose>,
    half_turns: Vec<HalfTurn>,
    segments: Segments,
}

/// What each interpolation prepares for the segment behind each key frame but the last.
#[derive(Clone, Debug)]
enum Segments {
    Bezier {
        reference: Vector3<f64>,
        /// 0 where all key frames are at the reference point: with any other, rounding would move the goal away from it.
        radius: f64,
        controls: Vec<[Bezier; 2]>,
    },
    Sclerp(Vec<ScrewMotion>),
    Straight,
}

impl Curve {
    /// Through the key frames, in their order. Without times they are equally spaced from 0 to 1.
    ///
    /// Between neighbours that are the same pose the motion stands still, and with
    /// [`Interpolation::Bezier`] it comes to rest there.
    ///
    /// # Errors
    /// When the key frames or the radius cannot be used; see [`KeyFrameFault`].
    pub fn new(
        keys: &[KeyFrame],
        how: Interpolation,
        double_quaternions: &DoubleQuaternions,
    ) -> Result<Self, KeyFrameFault> {
        /// The least radius, in units of the farthest key frame's distance from the reference point.
        /// The way back from double quaternions is unique for distances below πR, and a spline needs
        /// room beyond its key frames. A radius that is no shorter than the key frames' distances from
        /// the fixed frame is accepted wherever their mean lies: the distances from that are at most
        /// twice as long.
        const LEAST_RADIUS: f64 = 0.5;
        let times = times(keys)?;
        check_numbers(keys)?;
        let reference = double_quaternions
            .reference
            .unwrap_or_else(|| mean_position(keys));
        let farthest = farthest(keys, &reference)?;
        let radius = double_quaternions
            .radius
            .unwrap_or_else(|| default_radius(farthest));
        let least = LEAST_RADIUS * farthest;
        // Also refuses NaN.
        if !(radius.is_finite() && radius > 0.0 && radius >= least) {
            return Err(KeyFrameFault::Radius { radius, least });
        }
        let (keys, half_turns) = on_one_side(keys);
        let segments = match how {
            Interpolation::Bezier => Segments::Bezier {
                reference,
                radius: if farthest > 0.0 { radius } else { 0.0 },
                controls: controls(&keys, &times, &reference, radius),
            },
            Interpolation::Sclerp => Segments::Sclerp(
                keys.windows(2)
                    .map(|k| ScrewMotion::between(&k[0], &k[1]))
                    .collect(),
            ),
            Interpolation::Straight => Segments::Straight,
        };
        Ok(Self {
            times,
            keys,
            half_turns,
            segments,
        })
    }

    /// The times of the first and the last key frame.
    pub fn interval(&self) -> (f64, f64) {
        (self.times[0], self.times[self.times.len() - 1])
    }

    /// The pose at a time; the nearer end's outside of the interval.
    ///
    /// All arithmetic is on differences of positions, which are small wherever the fixed frame is.
    pub fn pose(&self, time: f64) -> Pose {
        let last = self.times.len() - 2;
        let i = self
            .times
            .partition_point(|&t| t <= time)
            .saturating_sub(1)
            .min(last);
        let u = (time - self.times[i]) / (self.times[i + 1] - self.times[i]);
        if u <= 0.0 {
            return self.keys[i];
        }
        if u >= 1.0 {
            return self.keys[i + 1];
        }
        let (from, to) = (&self.keys[i], &self.keys[i + 1]);
        match &self.segments {
            Segments::Bezier {
                reference,
                radius,
                controls,
            } => {
                let [g, h] = controls[i].map(|segment| de_casteljau(segment, u));
                let mut pose = from_double_quaternion(g, h, *radius);
                pose.translation.vector += reference;
                pose
            }
            Segments::Sclerp(screws) => from * screws[i].part(u),
            Segments::Straight => {
                let (start, end) = (from.translation.vector, to.translation.vector);
                Pose::from_parts(
                    Translation3::from(start + (end - start) * u),
                    unit(slerp(*from.rotation, *to.rotation, u)),
                )
            }
        }
    }
}

/// The radius R for key frames up to `farthest` from the reference point: 20 times that, or 1 if all
/// of them lie there, where any does.
///
/// R must be large against the workspace, since double quaternions bend the motion by about (d / R)²:
/// on the key frames of `tests/golden`, in units of the distance, the spline is 3·10⁻³ away from its
/// limit for R → ∞ at twice the distance, 3·10⁻⁵ at 20 times. And it must not be larger than needed:
/// d is R times a difference of unit quaternions, whose last digits are lost, about 3·10⁻¹⁶ R. At 20
/// times the distance that is rounding; at 10⁸ times it is 3·10⁻⁸.
pub fn default_radius(farthest: f64) -> f64 {
    if farthest > 0.0 { 20.0 * farthest } else { 1.0 }
}

/// The control points of both splines for each segment.
fn controls(
    keys: &[Pose],
    times: &[f64],
    reference: &Vector3<f64>,
    radius: f64,
) -> Vec<[Bezier; 2]> {
    let (g, h): (Vec<_>, Vec<_>) = keys
        .iter()
        .map(|k| {
            let from_reference = k.translation.vector - reference;
            to_double_quaternion(&k.rotation, &from_reference, radius)
        })
        .unzip();
    let resting = resting(keys);
    let pair = |(g, h)| [g, h];
    spline(&g, times, &resting)
        .into_iter()
        .zip(spline(&h, times, &resting))
        .map(pair)
        .collect()
}
