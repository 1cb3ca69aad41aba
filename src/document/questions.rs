//! Positions outside any motion: the linkage pulled by its workpiece or driven by one of its joints,
//! and what holds it there. Checks what a page hands in, and says in words why a joint stops.

use crate::document::bounds::{MAX_ANGLE, MAX_LENGTH, bounded, out_of_range, wrong_count};
use crate::document::fault::{Fault, FaultCode, Place, excerpt};
use crate::document::problem::Problem;
use crate::document::report;
use crate::math::pose::Pose;
use crate::model::chain::Chain;
use crate::motion::trajectory::Trajectory;
use crate::plan::follow::{drive_joint, pull};
use crate::solve::drive::Obstacle;
use crate::solve::paper_matrix;
use crate::study::why::{self, Insight};
use nalgebra::{Quaternion, Translation3, UnitQuaternion};

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
    /// The closest reachable pose to `goal` (x y z, then a quaternion x y z w of any length but 0) on
    /// the branch of the joint values `joints`, rad or lengths.
    ///
    /// # Errors
    /// When there is not one finite joint value a joint variable, or the goal is no pose.
    pub fn pull(&self, joints: &[f64], goal: &[f64]) -> Result<Posture, Fault> {
        self.check_joints(joints)?;
        let moved = pull(&self.mechanism, joints, &pose(goal)?, &self.settings);
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
        const VARIABLE: Place<'static> = Place::WHOLE.field("variable");
        const VALUE: Place<'static> = Place::WHOLE.field("value");
        let turns = self.turns();
        let Some(&turns) = turns.get(variable) else {
            let accepted = format!("0 to {}", turns.len() - 1);
            return Err(out_of_range(&VARIABLE, variable, &accepted));
        };
        check_value(value, turns, &VALUE)?;
        let moved = drive_joint(&self.mechanism, joints, variable, value, &self.settings);
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
        let mechanism = &self.mechanism;
        let opening = paper_matrix::opening(mechanism, joints, &mechanism.chains()[0].pose(joints));
        if !(opening <= paper_matrix::closed(mechanism.size())) {
            let what = format!("the loops are open by {opening:.1e}");
            let accepted = "joint values that close them";
            return Err(Fault::new(FaultCode::OutOfRange, &JOINTS, &what, accepted));
        }
        let length = self.settings.metric_length;
        Ok(why::explain(mechanism, joints, &goal, length))
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
            let accepted = format!("{}, one for each joint variable", turns.len());
            return Err(wrong_count(&JOINTS, joints.len(), &accepted));
        }
        for (i, (&value, turns)) in joints.iter().zip(turns).enumerate() {
            check_value(value, turns, &JOINTS.item(i))?;
        }
        Ok(())
    }

    /// Why the driven joint is not at `asked` in the reached position `joints`.
    fn sentence(&self, obstacle: &Obstacle, variable: usize, joints: &[f64], asked: f64) -> String {
        let name = self.variable_name(variable);
        let got = joints[variable];
        let value = self.shown(variable, got);
        match obstacle {
            Obstacle::OwnLimit => format!("{name} ends at its own limit of {value}."),
            Obstacle::Limits(held) => {
                let limits: Vec<String> = held
                    .iter()
                    .map(|&joint| {
                        let name = self.variable_name(joint);
                        let limit = self.shown(joint, joints[joint]);
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
        let near = |limit: f64| (limit - value).abs() <= 1e-6 * (1.0 + value.abs());
        limits
            .nth(variable)
            .is_some_and(|l| near(l.min) || near(l.max))
    }

    /// Such as “θ₂ of chain 1”.
    fn variable_name(&self, variable: usize) -> String {
        let mut first = 0;
        for (i, chain) in self.mechanism.chains().iter().enumerate() {
            if let Some(own) = report::chain(chain).variables.get(variable - first) {
                let label: String = own.label.chars().map(subscript).collect();
                let number = format!("chain {}", i + 1);
                let name = Some(chain.name()).filter(|name| !name.is_empty());
                let name = name.map_or(number, excerpt);
                return format!("{label} of {name}");
            }
            first += chain.freedoms();
        }
        String::new()
    }

    /// A joint value with its unit.
    fn shown(&self, variable: usize, value: f64) -> String {
        let text = if self.turns()[variable] {
            format!("{:.1}°", value.to_degrees())
        } else {
            format!("{value:.4} {}", self.length_unit)
        };
        // The page's minus sign, and none before a zero.
        let text = text.trim_end();
        match text.strip_prefix('-') {
            Some(rest) if rest.contains(|c: char| ('1'..='9').contains(&c)) => format!("−{rest}"),
            Some(rest) => rest.to_owned(),
            None => text.to_owned(),
        }
    }
}

fn subscript(c: char) -> char {
    c.to_digit(10)
        .and_then(|digit| char::from_u32('₀' as u32 + digit))
        .unwrap_or(c)
}

const JOINTS: Place<'static> = Place::WHOLE.field("joints");

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
    let norm = rotation.norm();
    // Also refuses NaN.
    if !(1e-3..=1e3).contains(&norm) {
        let accepted = "a quaternion of a length near 1";
        return Err(out_of_range(&GOAL, norm, accepted));
    }
    let rotation = UnitQuaternion::from_quaternion(rotation);
    Ok(Pose::from_parts(Translation3::new(x, y, z), rotation))
}
