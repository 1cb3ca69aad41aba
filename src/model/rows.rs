//! The Denavit–Hartenberg rows of axes that are given one after another: the common normals of neighbours.

use crate::math::norm::{self, norm, normalized};
use crate::math::pose::Pose;
use crate::model::dh::{DhRow, x_displacement, z_displacement};
use nalgebra::{Matrix3, Translation3, Vector3};
use std::f64::consts::{FRAC_PI_2, PI};

/// Angle between neighbouring axes, rad, below which they are parallel: their common normal, whose foot is the more
/// distant the smaller the angle, would lose as many digits as there are zeros in the angle.
pub const PARALLEL: f64 = 1e-6;

/// Rounding: of an angle in rad, of a length as a share of the chain's extent. A double has 1e-16; directions come from
/// some sines, products and a normalisation.
const ROUNDING: f64 = 1e-14;

/// The first axis of a joint is within less than [`PARALLEL`] of parallel to the last axis of the joint before, and was
/// made parallel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearlyParallel {
    /// The later joint, counted from 0: it was turned, about its point.
    pub joint: usize,
    /// By which angle, rad.
    pub angle: f64,
}

/// The unit vector at right angles to the unit vector `axis` that is next to `v`, which is not nearly parallel to it.
pub fn square(v: &Vector3<f64>, axis: &Vector3<f64>) -> Vector3<f64> {
    let v = normalized(v);
    normalized(&(v - axis * axis.dot(&v)))
}

/// The unit vector at right angles to the unit vector `axis` that is next to the x axis; next to y, for an axis near x.
pub fn aside(axis: &Vector3<f64>) -> Vector3<f64> {
    let near_x = axis.x.abs() > 0.9;
    square(&if near_x { Vector3::y() } else { Vector3::x() }, axis)
}

/// A table that is being built. Each row is fitted to the frame that the rows before it make, with all that was rounded
/// in them, so that errors do not add up along the chain.
pub struct Rows {
    /// The frame before the first row, on the first axis at its point.
    pub base: Pose,
    /// The rows; θ and d of the last one are 0.
    pub rows: Vec<DhRow>,
    /// The frame after the last row.
    pub end: Pose,
    /// Where an axis was turned.
    pub nearly_parallel: Vec<NearlyParallel>,
    /// Length that is rounding of the points' coordinates.
    coarse: f64,
    extent: f64,
    /// How far the frames' origins were away: more than the points, where neighbours are nearly parallel.
    farthest: f64,
}

/// The common normal of an axis and the next one.
struct Normal {
    /// Unit.
    direction: Vector3<f64>,
    /// The axes meet, or are the same.
    meets: bool,
    /// Lengths below which are rounding.
    rounding: f64,
}

impl Rows {
    /// No rows yet. Points will be measured from `origin`; the most distant one is `extent` away from it.
    pub fn new(origin: &Vector3<f64>, extent: f64) -> Self {
        Self {
            base: Pose::identity(),
            rows: Vec::new(),
            end: Pose::identity(),
            nearly_parallel: Vec::new(),
            coarse: 2.0 * f64::EPSILON * (origin.amax() + extent),
            extent,
            farthest: 0.0,
        }
    }

    /// The axis of the last row, unit.
    pub fn last_axis(&self) -> Option<Vector3<f64>> {
        (!self.rows.is_empty()).then(|| self.end.rotation * Vector3::z())
    }

    /// The first row of `joint`, of the unit axis `s` through `point`.
    pub fn add(&mut self, joint: usize, point: &Vector3<f64>, s: &Vector3<f64>) {
        let Some(z) = self.last_axis() else {
            self.base = frame(&aside(s), s, point);
            self.end = self.base;
            self.rows.push(DhRow::default());
            return;
        };
        let between = point - self.end.translation.vector;
        let across = z.cross(s);
        let angle = libm::atan2(norm(&across), z.dot(s).abs());
        let parallel = angle < PARALLEL;
        let normal = if parallel {
            self.between_parallels(&z, &between)
        } else {
            self.across(&z, &across, &between)
        };
        let theta = self.theta(&normal.direction);
        let [x, y, z] = axes(&(self.end * z_displacement(theta, 0.0)));
        let a = if normal.meets { 0.0 } else { between.dot(&x) };
        let (alpha, d) = if parallel {
            if angle > ROUNDING {
                self.nearly_parallel.push(NearlyParallel { joint, angle });
            }
            (if z.dot(s) < 0.0 { PI } else { 0.0 }, 0.0)
        } else {
            // The shift with which the axis of exactly this α passes the point.
            let alpha = snapped(libm::atan2(-s.dot(&y), s.dot(&z)));
            let (sin, cos) = libm::sincos(alpha);
            let d = between.dot(&z) + between.dot(&y) * cos / sin;
            (alpha, unless_rounding(d, normal.rounding))
        };
        self.push(theta, d, alpha, a);
    }

    /// A row within a joint: its unit axis `s` is at right angles to the one before it, and meets it in `point`. With
    /// `bound`, it is at right angles to the one before that, too, and meets it in the same point.
    pub fn add_inner(&mut self, point: &Vector3<f64>, s: &Vector3<f64>, bound: bool) {
        let [x, y, z] = axes(&self.end);
        let direction = nearer(square(&z.cross(s), &z), &x, &y);
        let mut theta = self.theta(&direction);
        if bound {
            theta = FRAC_PI_2.copysign(theta);
        }
        let y = self.end.rotation * (z_displacement(theta, 0.0).rotation * Vector3::y());
        let alpha = FRAC_PI_2.copysign(-s.dot(&y));
        let d = if bound {
            0.0
        } else {
            let d = (point - self.end.translation.vector).dot(&z);
            unless_rounding(d, self.rounding(1.0))
        };
        self.push(theta, d, alpha, 0.0);
    }

    /// θ and d of the last row, and the link to the next one.
    fn push(&mut self, theta: f64, d: f64, alpha: f64, a: f64) {
        if let Some(last) = self.rows.last_mut() {
            (last.theta, last.d) = (theta, d);
        }
        let foot = self.end * z_displacement(theta, d);
        self.end = foot * x_displacement(alpha, a);
        for frame in [&foot, &self.end] {
            self.farthest = self.farthest.max(norm(&frame.translation.vector));
        }
        self.rows.push(DhRow {
            alpha,
            a,
            ..DhRow::default()
        });
    }

    /// The angle about the last axis from the frame's x axis to this direction.
    fn theta(&self, direction: &Vector3<f64>) -> f64 {
        let [x, y, _] = axes(&self.end);
        snapped(libm::atan2(direction.dot(&y), direction.dot(&x)))
    }

    /// Lengths below which are rounding, where the angle between two axes has this sine: of the points' coordinates, of
    /// the common normal's direction, and of the frames' origins.
    fn rounding(&self, sine: f64) -> f64 {
        self.coarse + ROUNDING * (self.extent / sine + self.farthest)
    }

    /// Through the frame's origin, so that d = 0; for the same axis again along x, so that θ = 0.
    fn between_parallels(&self, z: &Vector3<f64>, between: &Vector3<f64>) -> Normal {
        let lateral = between - z * z.dot(between);
        let rounding = self.rounding(1.0);
        let meets = norm(&lateral) <= rounding;
        Normal {
            direction: if meets {
                self.end.rotation * Vector3::x()
            } else {
                square(&lateral, z)
            },
            meets,
            rounding,
        }
    }

    /// From axis to axis, so that a > 0; for axes that meet the sense with the smaller θ.
    fn across(&self, z: &Vector3<f64>, across: &Vector3<f64>, between: &Vector3<f64>) -> Normal {
        let rounding = self.rounding(norm(across));
        let direction = square(across, z);
        let a = between.dot(&direction);
        let meets = a.abs() <= rounding;
        let [x, y, _] = axes(&self.end);
        Normal {
            direction: if meets {
                nearer(direction, &x, &y)
            } else {
                direction * a.signum()
            },
            meets,
            rounding,
        }
    }
}

/// The sense of a direction across z with which its angle from x is above −90° and up to 90°.
fn nearer(direction: Vector3<f64>, x: &Vector3<f64>, y: &Vector3<f64>) -> Vector3<f64> {
    let along = direction.dot(x);
    let sense = if along.abs() > ROUNDING {
        along
    } else {
        direction.dot(y)
    };
    direction * sense.signum()
}

fn unless_rounding(length: f64, rounding: f64) -> f64 {
    if length.abs() <= rounding {
        0.0
    } else {
        length
    }
}

/// An angle within ±180°, exact where it is a right angle but for rounding.
fn snapped(angle: f64) -> f64 {
    let near = |exact: f64| (angle.abs() - exact).abs() <= ROUNDING;
    if near(0.0) {
        0.0
    } else if near(FRAC_PI_2) {
        FRAC_PI_2.copysign(angle)
    } else if near(PI) {
        PI
    } else {
        angle
    }
}

fn axes(pose: &Pose) -> [Vector3<f64>; 3] {
    [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| pose.rotation * axis)
}

fn frame(x: &Vector3<f64>, z: &Vector3<f64>, o: &Vector3<f64>) -> Pose {
    let axes = Matrix3::from_columns(&[*x, z.cross(x), *z]);
    let rotation = norm::from_matrix(&axes);
    Pose::from_parts(Translation3::from(*o), rotation)
}
