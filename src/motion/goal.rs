//! Key frames and the goal motion that passes through them.
//!
//! The paper's interpolation (its references 17 to 19) turns a pose (q, d) into a double quaternion,
//! the pair of unit quaternions (G, H) = (D∘q, D*∘q) with D = exp(d / 2R), interpolates each on its
//! sphere and maps back: D² = G∘H*, so d = R log(G∘H*), and q is the direction of G + H. The spline
//! on a sphere is Shoemake's (Animating rotation with quaternion curves, 1985): cubic Bézier
//! segments, evaluated by de Casteljau's construction with slerp in place of lerp, with inner
//! control points from the neighbours. The paper cites the method without its formulas; this reading
//! reproduces an independent reference to the last digits.

use crate::math::pose::Pose;
use crate::motion::quaternion_spline::{Bezier, de_casteljau, slerp, spline};
use nalgebra::{Quaternion, Translation3, UnitQuaternion, Vector3};

/// More key frames than a person places by hand; a sampled curve of a thousand poses still passes.
pub const MAX_KEY_FRAMES: usize = 1_000;

/// More frames than three minutes at 60 a second need; keeps a plan from taking for ever.
pub const MAX_FRAMES: usize = 10_000;

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
    /// A number is not finite, or too large to be squared.
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
    /// The radius R is no number of at least `least`.
    Radius {
        /// As given.
        radius: f64,
        /// The distance of the farthest key frame from the fixed frame.
        least: f64,
    },
    /// Frames are 2 to [`MAX_FRAMES`].
    FrameCount {
        /// As given.
        found: usize,
    },
}

/// The goal motion at `frames` times, equally spaced from the first key frame to the last. A key
/// frame whose time falls on a frame is met, the first and the last exactly (up to the sign of the
/// quaternion, which is kept continuous).
///
/// # Errors
/// When the key frames, the radius or the number of frames is unfit; see [`KeyFrameFault`].
pub fn goal_motion(
    keys: &[KeyFrame],
    how: Interpolation,
    frames: usize,
    radius: Option<f64>,
) -> Result<Vec<Goal>, KeyFrameFault> {
    if !(2..=MAX_FRAMES).contains(&frames) {
        return Err(KeyFrameFault::FrameCount { found: frames });
    }
    let curve = Curve::new(keys, how, radius)?;
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
    Ok((0..frames).map(goal).collect())
}

/// The goal motion as a function of time.
#[derive(Clone, Debug)]
pub struct Curve {
    times: Vec<f64>,
    /// The key frames, each quaternion on the side of the one before.
    keys: Vec<Pose>,
    segments: Segments,
}

/// What each interpolation prepares for the segment behind each key frame but the last.
#[derive(Clone, Debug)]
enum Segments {
    Bezier {
        radius: f64,
        controls: Vec<[Bezier; 2]>,
    },
    Sclerp(Vec<Screw>),
    Straight,
}

impl Curve {
    /// Through the key frames, in their order. Without times they are equally spaced from 0 to 1.
    ///
    /// `radius` is the R of the double quaternions, which only [`Interpolation::Bezier`] uses; `None`
    /// is [`default_radius`].
    ///
    /// # Errors
    /// When the key frames or the radius are unfit; see [`KeyFrameFault`].
    pub fn new(
        keys: &[KeyFrame],
        how: Interpolation,
        radius: Option<f64>,
    ) -> Result<Self, KeyFrameFault> {
        let times = times(keys)?;
        let farthest = farthest(keys)?;
        let radius = radius.unwrap_or_else(|| default_radius(farthest));
        // Also refuses NaN.
        if !(radius.is_finite() && radius > 0.0 && radius >= farthest) {
            return Err(KeyFrameFault::Radius {
                radius,
                least: farthest,
            });
        }
        let keys = on_one_side(keys);
        let segments = match how {
            Interpolation::Bezier => Segments::Bezier {
                radius,
                controls: controls(&keys, &times, radius),
            },
            Interpolation::Sclerp => Segments::Sclerp(
                keys.windows(2)
                    .map(|k| Screw::between(&k[0], &k[1]))
                    .collect(),
            ),
            Interpolation::Straight => Segments::Straight,
        };
        Ok(Self {
            times,
            keys,
            segments,
        })
    }

    /// The times of the first and the last key frame.
    pub fn interval(&self) -> (f64, f64) {
        (self.times[0], self.times[self.times.len() - 1])
    }

    /// The pose at a time; the nearer end's outside of the interval.
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
            Segments::Bezier { radius, controls } => {
                let [g, h] = controls[i].map(|segment| de_casteljau(segment, u));
                from_double_quaternion(g, h, *radius)
            }
            Segments::Sclerp(screws) => from * screws[i].part(u),
            Segments::Straight => {
                let d = from.translation.vector.lerp(&to.translation.vector, u);
                pose(slerp(*from.rotation, *to.rotation, u), d)
            }
        }
    }
}

/// The radius R for key frames up to `farthest` from the fixed frame: 20 times that, or 1 if all of
/// them lie at its origin, where any does.
///
/// R must be large against the workspace, since double quaternions bend the motion by about (d / R)²:
/// on the key frames of `tests/golden`, in units of the distance, the spline is 3·10⁻³ away from its
/// limit for R → ∞ at twice the distance, 3·10⁻⁵ at 20 times. And it must not be larger than needed:
/// d is R times a difference of unit quaternions, whose last digits are lost, about 3·10⁻¹⁶ R. At 20
/// times the distance that is rounding; at 10⁸ times it is 3·10⁻⁸.
pub fn default_radius(farthest: f64) -> f64 {
    if farthest > 0.0 { 20.0 * farthest } else { 1.0 }
}

/// The given times, checked, or equally spaced ones.
fn times(keys: &[KeyFrame]) -> Result<Vec<f64>, KeyFrameFault> {
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

/// The distance of the farthest key frame from the origin of the fixed frame.
fn farthest(keys: &[KeyFrame]) -> Result<f64, KeyFrameFault> {
    let mut farthest: f64 = 0.0;
    for (key, k) in keys.iter().enumerate() {
        let distance = k.pose.translation.vector.norm();
        if !(distance.is_finite() && k.pose.rotation.coords.iter().all(|x| x.is_finite())) {
            return Err(KeyFrameFault::NotFinite { key });
        }
        farthest = farthest.max(distance);
    }
    Ok(farthest)
}

/// q and −q are the same rotation: takes the one nearer to the neighbour before, so that the motion
/// turns the short way.
fn on_one_side(keys: &[KeyFrame]) -> Vec<Pose> {
    /// At 180° both ways are equally long, and rounding must not choose between them: as long as q·q
    /// is not clearly negative the signs stay as they are given.
    const TIE: f64 = 1e-9;
    let mut poses: Vec<Pose> = Vec::with_capacity(keys.len());
    for k in keys {
        let mut pose = k.pose;
        if poses
            .last()
            .is_some_and(|p| p.rotation.coords.dot(&pose.rotation.coords) < -TIE)
        {
            pose.rotation = UnitQuaternion::new_unchecked(-pose.rotation.into_inner());
        }
        poses.push(pose);
    }
    poses
}

/// The control points of both splines for each segment.
fn controls(keys: &[Pose], times: &[f64], radius: f64) -> Vec<[Bezier; 2]> {
    let (g, h): (Vec<_>, Vec<_>) = keys.iter().map(|k| double_quaternion(k, radius)).unzip();
    let pair = |(g, h)| [g, h];
    spline(&g, times)
        .into_iter()
        .zip(spline(&h, times))
        .map(pair)
        .collect()
}

/// (G, H) = (D∘q, D*∘q) with D = exp(d / 2R).
fn double_quaternion(pose: &Pose, radius: f64) -> (Quaternion<f64>, Quaternion<f64>) {
    let d = pose.translation.vector / (2.0 * radius);
    let angle = d.norm();
    let (s, c) = libm::sincos(angle);
    let d = Quaternion::from_parts(c, if angle > 0.0 { d * (s / angle) } else { d });
    let q = pose.rotation.into_inner();
    (d * q, d.conjugate() * q)
}

/// The inverse of [`double_quaternion`].
fn from_double_quaternion(g: Quaternion<f64>, h: Quaternion<f64>, radius: f64) -> Pose {
    let square = g * h.conjugate();
    let sine = square.imag().norm();
    let angle = libm::atan2(sine, square.w);
    let d = square.imag() * (if sine > 0.0 { angle / sine } else { 1.0 } * radius);
    pose(g + h, d)
}

/// A screw motion: rotation by `angle` about `axis` with the steady body velocity `velocity` of the
/// origin, over one unit of u.
#[derive(Clone, Copy, Debug)]
struct Screw {
    axis: Vector3<f64>,
    angle: f64,
    velocity: Vector3<f64>,
}

impl Screw {
    /// The one that carries `from` to `to`, measured in `from`.
    fn between(from: &Pose, to: &Pose) -> Self {
        let moved = from.inv_mul(to);
        let (w, v, d) = (
            moved.rotation.w,
            moved.rotation.imag(),
            moved.translation.vector,
        );
        let sine = v.norm();
        if sine == 0.0 {
            return Self {
                axis: v,
                angle: 0.0,
                velocity: d,
            };
        }
        let (axis, half) = (v / sine, libm::atan2(sine, w));
        // d = V velocity with V as in `part`; V⁻¹ = 1 − φ/2 [l] + (1 − φ/2 cot φ/2) [l]².
        let across = axis.cross(&d);
        let velocity = d - across * half + axis.cross(&across) * (1.0 - half * w / sine);
        Self {
            axis,
            angle: 2.0 * half,
            velocity,
        }
    }

    /// The displacement after the part `u` of the motion: the exponential of u times the twist.
    fn part(&self, u: f64) -> Pose {
        let angle = u * self.angle;
        let (s, c) = libm::sincos(0.5 * angle);
        let rotation = Quaternion::from_parts(c, self.axis * s);
        let v = self.velocity * u;
        if angle == 0.0 {
            return pose(rotation, v);
        }
        // V = 1 + (1 − cos φ)/φ [l] + (1 − sin φ/φ) [l]², and 1 − cos φ = 2 sin² φ/2.
        let across = self.axis.cross(&v);
        let d = v
            + across * (2.0 * s * s / angle)
            + self.axis.cross(&across) * (1.0 - 2.0 * s * c / angle);
        pose(rotation, d)
    }
}

fn pose(q: Quaternion<f64>, d: Vector3<f64>) -> Pose {
    Pose::from_parts(Translation3::from(d), UnitQuaternion::new_normalize(q))
}
