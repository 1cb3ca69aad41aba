//! Positions outside any motion: the linkage pulled by its workpiece or driven by one of its joints,
//! what holds it there, the planners' iterations and the paper's matrix. Checks what a page hands in, and
//! says in words why a joint stops.

use crate::document::bounds::{
    MAX_ANGLE, MAX_LENGTH, bounded, no_index, out_of_range, wrong_count,
};
use crate::document::fault::{Fault, FaultCode, Place, told};
use crate::document::number::typed;
use crate::document::problem::Problem;
use crate::document::wording::Wording;
use crate::math::norm::{norm, unit};
use crate::math::pose::Pose;
use crate::model::chain::Chain;
use crate::model::scaled::Scaled;
use crate::motion::trajectory::Trajectory;
use crate::plan::configuration::{drive_joint, pull};
use crate::solve::close_start::Start;
use crate::solve::drive::Obstacle;
use crate::study::iterations::{self, Trace};
use crate::study::matrix::{self, Matrix};
use crate::study::why::{self, Insight};
use nalgebra::{Quaternion, Translation3};
use std::ops::RangeInclusive;

/// Lengths of a quaternion that is read as a rotation. One that is not normalised is; beyond a thousandfold it is four
/// numbers of another meaning, and near 0 its direction would be rounding.
pub const QUATERNION_LENGTHS: RangeInclusive<f64> = 1e-3..=1e3;

/// One position of the linkage.
#[derive(Clone, Debug)]
pub struct Posture {
    /// The position as a motion of one frame.
    pub frame: Trajectory,
    /// Of a driven joint: what it got, rad or length.
    pub value: Option<f64>,
    /// Of a driven joint that did not get its value: why, as a sentence.
    pub obstacle: Option<String>,
}

impl Problem {
    /// The closest reachable pose to `goal` (x y z, then a quaternion x y z w, its length within
    /// [`QUATERNION_LENGTHS`]) on the branch of the joint values `joints`, rad or lengths.
    ///
    /// # Errors
    /// When there is not one finite joint value a joint variable, or the goal is no pose.
    pub fn pull(&self, joints: &[f64], goal: &[f64]) -> Result<Posture, Fault> {
        self.check_joints(joints)?;
        let moved = pull(
            &self.mechanism,
            joints,
            &pose(goal)?,
            self.extent(),
            &self.settings,
        );
        Ok(Posture {
            frame: moved.frame,
            value: None,
            obstacle: None,
        })
    }

    /// Drives joint variable `variable`, counted from 0 through all chains, to `value` (rad or
    /// length), while the loops stay closed and the other joints follow at the least rates.
    ///
    /// # Errors
    /// When there is not one finite joint value a joint variable, no such variable, or a value that no
    /// document could hold.
    pub fn drive(&self, joints: &[f64], variable: usize, value: f64) -> Result<Posture, Fault> {
        self.check_joints(joints)?;
        const VALUE: Place<'static> = Place::WHOLE.field("value");
        let turns = self.turns();
        let Some(&turns) = turns.get(variable) else {
            return Err(no_index(&VARIABLE, variable, turns.len()));
        };
        check_value(value, turns, &VALUE)?;
        let moved = drive_joint(
            &self.mechanism,
            joints,
            variable,
            value,
            self.extent(),
            &self.settings,
        );
        let reached = &moved.frame.joints;
        let sentence = |o: &Obstacle| self.sentence(o, variable, reached, value);
        Ok(Posture {
            value: Some(reached[variable]),
            obstacle: moved.obstacle.as_ref().map(sentence),
            frame: moved.frame,
        })
    }

    /// What holds the workpiece at the joint values `joints` against the pull of `goal`, and what
    /// leaves it free.
    ///
    /// # Errors
    /// When there is not one finite joint value a joint variable, the goal is no pose, or the loops
    /// are open.
    pub fn explain(&self, joints: &[f64], goal: &[f64]) -> Result<Insight, Fault> {
        self.check_joints(joints)?;
        let goal = pose(goal)?;
        let mut solver = self.settings.solver(&self.mechanism, self.extent());
        let theta = solver.scaled().entered(joints);
        let error = solver.scaled().closure_error(&theta);
        let mut closed = joints.to_vec();
        // A joint that moves by less closes what is published as closed.
        let moved = match solver.close_start(&mut closed, self.settings.dimension_tolerance) {
            Start::Open { .. } | Start::Rigid { .. } => f64::INFINITY,
            Start::Closed | Start::Rounded => {
                Scaled::largest_motion(&theta, &solver.scaled().entered(&closed)).0
            }
        };
        if !(moved <= NEARLY_CLOSED) {
            let what = told!("the loops are open by {error:.1e}");
            let accepted = "joint values that close them";
            return Err(Fault::new(FaultCode::OutOfRange, &JOINTS, &what, accepted));
        }
        Ok(why::explain(&mut solver, &closed, &goal))
    }

    /// The iterations of both planners towards the goal of `frame`, counted from 0, from the joint
    /// values `joints` of the frame before; from the document's start if there are none.
    ///
    /// # Errors
    /// When there is no such frame, or not one finite joint value a joint variable.
    pub fn trace(&self, frame: usize, joints: &[f64]) -> Result<Trace, Fault> {
        if self.goals.is_empty() {
            let what = "the joints of this motion are driven, and there is no goal to approach";
            let accepted = "a motion with key frames";
            return Err(Fault::new(FaultCode::OutOfRange, &MOTION, what, accepted));
        }
        let Some(goal) = self.goals.get(frame) else {
            return Err(no_index(&FRAMES, frame, self.goals.len()));
        };
        let from = if joints.is_empty() {
            self.find_start()
        } else {
            self.check_joints(joints)?;
            joints.to_vec()
        };
        Ok(iterations::trace(
            &self.mechanism,
            &self.settings,
            self.extent(),
            &goal.pose,
            &from,
        ))
    }

    /// \[A\] of Eq. 21 at the joint values `joints`, with its singular values.
    ///
    /// # Errors
    /// When there is not one finite joint value a joint variable.
    pub fn matrix(&self, joints: &[f64]) -> Result<Matrix, Fault> {
        self.check_joints(joints)?;
        let metric = self.settings.metric_for(&self.mechanism, self.extent());
        Ok(matrix::matrix(&self.mechanism, joints, &metric))
    }

    /// How the mechanism is spoken of.
    pub fn wording(&self) -> Wording<'_> {
        Wording {
            mechanism: &self.mechanism,
            unit: &self.length_unit,
        }
    }

    fn turns(&self) -> Vec<bool> {
        self.mechanism
            .chains()
            .iter()
            .flat_map(Chain::turns)
            .collect()
    }

    pub(crate) fn check_joints(&self, joints: &[f64]) -> Result<(), Fault> {
        let turns = self.turns();
        if joints.len() != turns.len() {
            let accepted = told!("{}, one for each joint variable", turns.len());
            return Err(wrong_count(&JOINTS, joints.len(), &accepted));
        }
        for (i, (&value, turns)) in joints.iter().zip(turns).enumerate() {
            check_value(value, turns, &JOINTS.item(i))?;
        }
        Ok(())
    }

    /// Why the driven joint is not at `asked` in the reached position `joints`.
    fn sentence(&self, obstacle: &Obstacle, variable: usize, joints: &[f64], asked: f64) -> String {
        let wording = self.wording();
        let name = wording.variable(variable);
        let got = joints[variable];
        let value = wording.amount(variable, got);
        match obstacle {
            Obstacle::OwnLimit => format!("{name} ends at its own limit of {value}."),
            Obstacle::Limits(held) => {
                let limits: Vec<String> = held
                    .iter()
                    .map(|&joint| {
                        let name = wording.variable(joint);
                        let limit = wording.amount(joint, joints[joint]);
                        if self.has_limit(joint, joints[joint]) {
                            format!("{name} is at its limit of {limit}")
                        } else {
                            format!("{name} runs away and has come to {limit}")
                        }
                    })
                    .collect();
                format!("{name} stops at {value}: {}.", limits.join(" and "))
            }
            Obstacle::DeadPoint => {
                let side = if asked > got { "above" } else { "below" };
                format!("The loops cannot close with {name} {side} {value}.")
            }
            Obstacle::Immobile => {
                format!("{name} stays at {value}: nothing of the linkage can move.")
            }
            Obstacle::TooFar => {
                format!(
                    "{name} has come to {value}, as far as one drive goes. Drive it on from here."
                )
            }
            Obstacle::Open => format!(
                "{name} stays at {value}: the loops are open and do not close near these joint values."
            ),
        }
    }

    /// Has the document a limit near this value, and not only the drive?
    fn has_limit(&self, variable: usize, value: f64) -> bool {
        let mut limits = self.mechanism.chains().iter().flat_map(Chain::limits);
        let turns = self.turns()[variable];
        let scale = if turns {
            1.0
        } else {
            self.mechanism.size_or(self.extent())
        };
        let near = |limit: f64| (limit - value).abs() <= 1e-6 * (scale + value.abs());
        limits
            .nth(variable)
            .is_some_and(|l| near(l.min) || near(l.max))
    }
}

const JOINTS: Place<'static> = Place::WHOLE.field("joints");
const MOTION: Place<'static> = Place::WHOLE.field("motion");
/// The place of a frame that does not exist.
pub(crate) const FRAMES: Place<'static> = MOTION.field("frames");
/// The place of a joint variable that does not exist.
pub(crate) const VARIABLE: Place<'static> = Place::WHOLE.field("variable");

/// Joint motion, rad or sizes, that closes loops which count as closed: near a singular position a closure error of
/// 1e-10 takes the root of it.
const NEARLY_CLOSED: f64 = 1e-5;

/// A joint value within what a document may hold.
fn check_value(value: f64, turns: bool, place: &Place<'_>) -> Result<(), Fault> {
    if turns {
        bounded(value, MAX_ANGLE.to_radians(), "an angle in radians", place)
    } else {
        bounded(value, MAX_LENGTH, "a length", place)
    }
    .map(drop)
}

/// Seven numbers as a pose.
fn pose(numbers: &[f64]) -> Result<Pose, Fault> {
    const GOAL: Place<'static> = Place::WHOLE.field("goal");
    let &[x, y, z, qx, qy, qz, qw] = numbers else {
        let accepted = "7: x y z, then the rotation's quaternion x y z w";
        return Err(wrong_count(&GOAL, numbers.len(), accepted));
    };
    for (i, value) in [x, y, z].into_iter().enumerate() {
        bounded(value, MAX_LENGTH, "a length", &GOAL.item(i))?;
    }
    let rotation = Quaternion::new(qw, qx, qy, qz);
    let norm = norm(&rotation.coords);
    // Also refuses NaN.
    if !QUATERNION_LENGTHS.contains(&norm) {
        let (least, most) = QUATERNION_LENGTHS.into_inner();
        let accepted = told!(
            "a quaternion of a length from {} to {}",
            typed(least),
            typed(most)
        );
        return Err(out_of_range(&GOAL, typed(norm), &accepted));
    }
    let rotation = unit(rotation);
    Ok(Pose::from_parts(Translation3::new(x, y, z), rotation))
}
