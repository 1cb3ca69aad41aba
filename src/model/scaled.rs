//! A mechanism in a unit of length and about a point of its own, and the tolerances that hold there.
//!
//! All lengths inside the solver are shares of the mechanism's size, measured from the base of the first chain: the same
//! linkage in millimetres, in metres or far from the origin is the same to the solver, and one number serves as a bound
//! for lengths and angles.

use crate::math::pose::{self, Pose};
use crate::model::chain::{Chain, ChainState};
use crate::model::joint::Limits;
use crate::model::mechanism::Mechanism;
use nalgebra::{Vector3, Vector6};

/// Largest closure error of a published frame: lengths as shares of the mechanism's size, angles in rad. A double has
/// a relative precision of 1e-16, and a dozen products of rotations lose two or three digits.
pub const CLOSED: f64 = 1e-10;
/// The closure error that the solver asks for: ten times less than what is published.
pub const SOLVED: f64 = 0.1 * CLOSED;
/// How far beyond a limit a joint may stand by rounding of the closing corrections, rad or shares of the size.
pub const LIMIT: f64 = 1e-10;
/// A few units of the last place of 1.
pub const ROUNDING: f64 = 1e-15;

/// When a pose counts as a minimum of the distance to the goal; all of it in units of f, twists and joint motions with
/// lengths as shares of the size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances {
    /// Projected gradient below which a pose is stationary: f is then within about 1e-17 of its minimum.
    pub stationary: f64,
    /// Curvature below which a direction counts as flat: second derivative of f per squared joint motion, above the
    /// rounding of a direction that does not matter at all (an inner freedom).
    pub flat: f64,
    /// f up to which the goal counts as reached: what a stationary gradient leaves, and room.
    pub reached: f64,
    /// What f is known to within near its minimum.
    pub rounding: f64,
}

impl Tolerances {
    /// For a metric with characteristic length `length`, a share of the size. Translations curve f by 1/4L²: where that
    /// is above 1 (a short metric length) the bounds rise with it, since rounding does; where it is below 1 they fall
    /// with it, so that translations still converge, down to 1e-4, where rounding would stop the convergence.
    pub fn new(length: f64) -> Self {
        const STATIONARY: f64 = 1e-9;
        const FLAT: f64 = 1e-8;
        /// ‖q − g‖.
        const REACHED: f64 = 1e-8;
        let curvature = 0.25 / (length * length);
        let scale = curvature.max(1e-4);
        Self {
            stationary: STATIONARY * scale,
            flat: FLAT * scale,
            reached: 0.5 * REACHED * REACHED * curvature.max(1.0),
            rounding: ROUNDING * curvature.max(1.0),
        }
    }
}

/// Chains with lengths in a unit, measured from a point.
#[derive(Clone, Debug)]
pub struct Scaled {
    chains: Vec<Chain>,
    limits: Vec<Limits>,
    turns: Vec<bool>,
    unit: f64,
    origin: Vector3<f64>,
}

impl Scaled {
    /// In units of the mechanism's size, from the base of its first chain. A mechanism without lengths (spherical, or
    /// of sliders only) takes `extent` for its size, the length over which it is to move.
    pub fn new(mechanism: &Mechanism, extent: f64) -> Self {
        let origin = mechanism.chains()[0].base().translation.vector;
        Self::about(mechanism, mechanism.size_or(extent), &origin)
    }

    /// In any unit, from any point.
    pub fn about(mechanism: &Mechanism, unit: f64, origin: &Vector3<f64>) -> Self {
        let chains: Vec<Chain> = mechanism
            .chains()
            .iter()
            .map(|chain| chain.within(unit, origin))
            .collect();
        Self {
            limits: chains.iter().flat_map(Chain::limits).collect(),
            turns: chains.iter().flat_map(Chain::turns).collect(),
            chains,
            unit,
            origin: *origin,
        }
    }

    /// The chains, lengths in the unit.
    pub fn chains(&self) -> &[Chain] {
        &self.chains
    }

    /// The limits of all joint variables, lengths in the unit.
    pub fn limits(&self) -> &[Limits] {
        &self.limits
    }

    /// Which joint variables are angles.
    pub fn turns(&self) -> &[bool] {
        &self.turns
    }

    /// Number of joint variables.
    pub fn variables(&self) -> usize {
        self.turns.len()
    }

    /// The unit of length, in the mechanism's own.
    pub fn unit(&self) -> f64 {
        self.unit
    }

    /// The point from which positions are measured, in the mechanism's own unit.
    pub fn origin(&self) -> &Vector3<f64> {
        &self.origin
    }

    /// Joint values of the mechanism, into this unit.
    pub fn enter(&self, joints: &[f64], theta: &mut [f64]) {
        for ((t, &x), &turns) in theta.iter_mut().zip(joints).zip(&self.turns) {
            *t = if turns { x } else { x / self.unit };
        }
    }

    /// Joint values in this unit, back into the mechanism's.
    pub fn leave(&self, theta: &[f64], joints: &mut [f64]) {
        for ((x, &t), &turns) in joints.iter_mut().zip(theta).zip(&self.turns) {
            *x = if turns { t } else { t * self.unit };
        }
    }

    /// Rounds joint values in this unit to such as [`Scaled::leave`] and [`Scaled::enter`] bring back to the last digit.
    pub fn round(&self, theta: &mut [f64]) {
        for (t, &turns) in theta.iter_mut().zip(&self.turns) {
            if !turns {
                *t = *t * self.unit / self.unit;
            }
        }
    }

    /// [`Scaled::enter`] into a new vector.
    pub fn entered(&self, joints: &[f64]) -> Vec<f64> {
        let mut theta = vec![0.0; joints.len()];
        self.enter(joints, &mut theta);
        theta
    }

    /// [`Scaled::leave`] into a new vector.
    pub fn left(&self, theta: &[f64]) -> Vec<f64> {
        let mut joints = vec![0.0; theta.len()];
        self.leave(theta, &mut joints);
        joints
    }

    /// A pose of the mechanism's fixed frame, in this unit and from this point.
    pub fn enter_pose(&self, pose: &Pose) -> Pose {
        let mut near = *pose;
        near.translation.vector = (pose.translation.vector - self.origin) / self.unit;
        near
    }

    /// The inverse of [`Scaled::enter_pose`].
    pub fn leave_pose(&self, near: &Pose) -> Pose {
        let mut pose = *near;
        pose.translation.vector = near.translation.vector * self.unit + self.origin;
        pose
    }

    /// The largest joint motion between two sets of joint values in this unit (rad or units), and its variable; NaN is
    /// the largest of all.
    pub fn largest_motion(from: &[f64], to: &[f64]) -> (f64, usize) {
        let moves = from.iter().zip(to).map(|(a, b)| (a - b).abs()).enumerate();
        moves.fold((0.0, 0), |most, (joint, moved)| {
            if moved <= most.0 || most.0.is_nan() {
                most
            } else {
                (moved, joint)
            }
        })
    }

    /// The largest closure error at these joint values, of any chain against the first.
    pub fn closure_error(&self, theta: &[f64]) -> f64 {
        let mut first = 0;
        let mut states = self.chains.iter().map(|chain| {
            let mut state = ChainState::default();
            chain.evaluate(&theta[first..], &mut state);
            first += chain.freedoms();
            state.pose
        });
        let leader = states.next().unwrap_or_default();
        states.fold(0.0, |worst, pose| {
            larger(worst, closure_error(&pose::difference(&leader, &pose)))
        })
    }
}

/// The closure error of a loop that is open by this twist: the larger of its length (shares of the size) and its angle
/// (rad).
#[inline]
pub fn closure_error(twist: &Vector6<f64>) -> f64 {
    let square =
        |i: usize| twist[i] * twist[i] + twist[i + 1] * twist[i + 1] + twist[i + 2] * twist[i + 2];
    larger(square(0), square(3)).sqrt()
}

/// The larger of two; NaN if either is, so that it never passes for closed.
#[inline]
pub fn larger(a: f64, b: f64) -> f64 {
    if b <= a || a.is_nan() { a } else { b }
}
