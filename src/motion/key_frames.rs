//! Key frames: what is asked of them, and what the interpolations need to know of them.

use crate::math::norm::{norm, normalized};
use crate::math::pose::Pose;
use nalgebra::{UnitQuaternion, Vector3};

/// A tool path, sampled pose by pose, passes; no step of a plan takes more than its share for each of them.
pub const MAX_KEY_FRAMES: usize = 100_000;

/// A pose that the goal motion meets.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyFrame {
    /// For messages; may be empty.
    pub name: String,
    /// The workpiece's frame.
    pub pose: Pose,
    /// When; all key frames have a time or none has.
    pub time: Option<f64>,
}

/// Two neighbouring key frames whose rotations are half a turn apart: both ways are equally long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfTurn {
    /// The later of the two, from 0.
    pub key: usize,
    /// The axis about which the motion turns, by the right-hand rule; a unit vector in the fixed frame.
    pub axis: Vector3<f64>,
}

/// Why there is no motion through the key frames; `key` counts from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum KeyFrameFault {
    /// A motion has at least two key frames.
    TooFew {
        /// How many there are.
        found: usize,
    },
    /// More than [`MAX_KEY_FRAMES`].
    TooMany {
        /// How many there are.
        found: usize,
    },
    /// A number of a key frame, or of the reference point, is not finite or too large to be squared.
    NotFinite {
        /// The key frame.
        key: usize,
    },
    /// A time is missing where others are given.
    TimeMissing {
        /// The key frame without a time.
        key: usize,
    },
    /// A time is not a number later than the one before.
    TimeOrder {
        /// The later key frame.
        key: usize,
        /// The time before.
        previous: f64,
        /// Its own time.
        time: f64,
    },
    /// The radius R is not a positive number of at least `least`.
    Radius {
        /// As given.
        radius: f64,
        /// Half the distance of the farthest key frame from the reference point.
        least: f64,
    },
    /// Frames are 2 to [`crate::motion::goal::MAX_FRAMES`].
    FrameCount {
        /// As given.
        found: usize,
    },
}

/// The given times, checked, or equally spaced ones.
pub(crate) fn times(keys: &[KeyFrame]) -> Result<Vec<f64>, KeyFrameFault> {
    match keys.len() {
        found @ (0 | 1) => return Err(KeyFrameFault::TooFew { found }),
        found if found > MAX_KEY_FRAMES => return Err(KeyFrameFault::TooMany { found }),
        _ => {}
    }
    let last = keys.len() - 1;
    if keys.iter().all(|k| k.time.is_none()) {
        return Ok((0..=last).map(|i| i as f64 / last as f64).collect());
    }
    let mut times: Vec<f64> = Vec::with_capacity(keys.len());
    for (key, k) in keys.iter().enumerate() {
        let time = k.time.ok_or(KeyFrameFault::TimeMissing { key })?;
        let previous = times.last().copied().unwrap_or(f64::NEG_INFINITY);
        // The whole interval must be a number too.
        let interval = time - times.first().copied().unwrap_or(0.0);
        if !(time > previous && interval.is_finite()) {
            return Err(KeyFrameFault::TimeOrder {
                key,
                previous,
                time,
            });
        }
        times.push(time);
    }
    Ok(times)
}

/// The numbers of all key frames are finite, and their positions have a length.
pub(crate) fn check_numbers(keys: &[KeyFrame]) -> Result<(), KeyFrameFault> {
    let unusable = |k: &KeyFrame| {
        let rotation = k.pose.rotation.coords;
        !(norm(&k.pose.translation.vector).is_finite() && rotation.iter().all(|x| x.is_finite()))
    };
    keys.iter()
        .position(unusable)
        .map_or(Ok(()), |key| Err(KeyFrameFault::NotFinite { key }))
}

/// The mean of the positions, measured from the first: no digits are lost far from the origin, and
/// equal positions have exactly that mean.
pub(crate) fn mean_position(keys: &[KeyFrame]) -> Vector3<f64> {
    let first = keys[0].pose.translation.vector;
    let sum: Vector3<f64> = keys.iter().map(|k| k.pose.translation.vector - first).sum();
    first + sum / keys.len() as f64
}

/// The distance of the farthest key frame from the reference point.
pub(crate) fn farthest(keys: &[KeyFrame], reference: &Vector3<f64>) -> Result<f64, KeyFrameFault> {
    let mut farthest: f64 = 0.0;
    for (key, k) in keys.iter().enumerate() {
        let distance = norm(&(k.pose.translation.vector - reference));
        if !distance.is_finite() {
            return Err(KeyFrameFault::NotFinite { key });
        }
        farthest = farthest.max(distance);
    }
    Ok(farthest)
}

/// q and −q are the same rotation: takes the one nearer to the neighbour before, so that the motion
/// turns the short way. Neighbours half a turn apart are listed.
pub(crate) fn on_one_side(keys: &[KeyFrame]) -> (Vec<Pose>, Vec<HalfTurn>) {
    /// At 180° both ways are equally long, and rounding must not choose between them: as long as q·q
    /// is not clearly negative the two signs stay as they are given, to each other. The bound, half of
    /// the missing angle in rad, is far above the rounding of an angle of any number of turns that a
    /// document can have (10⁻¹² rad).
    const TIE: f64 = 1e-9;
    let mut poses: Vec<Pose> = Vec::with_capacity(keys.len());
    let mut half_turns = Vec::new();
    let mut negative = false;
    for (key, k) in keys.iter().enumerate() {
        let given = k.pose.rotation.into_inner();
        if let Some(before) = key.checked_sub(1) {
            let before = keys[before].pose.rotation.into_inner();
            let cosine = before.dot(&given);
            if cosine < -TIE {
                negative = !negative;
            } else if cosine <= TIE {
                let axis = normalized(&(given * before.conjugate()).imag());
                half_turns.push(HalfTurn { key, axis });
            }
        }
        let rotation = if negative { -given } else { given };
        poses.push(Pose::from_parts(
            k.pose.translation,
            UnitQuaternion::new_unchecked(rotation),
        ));
    }
    (poses, half_turns)
}

/// For each segment: are its two key frames the same pose?
pub(crate) fn resting(keys: &[Pose]) -> Vec<bool> {
    /// Share of the key frames' extent, and difference of unit quaternions, that is rounding: an angle
    /// of a thousand turns is known to 10⁻¹² rad.
    const ROUNDING: f64 = 1e-12;
    let position = |k: &Pose| k.translation.vector;
    let extent = keys
        .iter()
        .map(|k| norm(&(position(k) - position(&keys[0]))))
        .fold(0.0, f64::max);
    let same = |k: &[Pose]| {
        norm(&(position(&k[1]) - position(&k[0]))) <= ROUNDING * extent
            && norm(&(k[1].rotation.coords - k[0].rotation.coords)) <= ROUNDING
    };
    keys.windows(2).map(same).collect()
}
