//! A planned motion as a page reads it: names, units and sentences.

use crate::document::fault::excerpt;
use crate::document::problem::start_values;
use crate::model::chain::Chain;
use crate::model::joint::Moves;
use crate::model::mechanism::Mechanism;
use crate::motion::trajectory::{Neighbours, Status, Trajectory, Warning};
use crate::types::enumerate;
use serde::Serialize;

/// What is said about a motion beside its columns of numbers.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Names of the status codes.
    pub statuses: Vec<&'static str>,
    /// The chains, in the document's order.
    pub chains: Vec<ChainReport>,
    /// Mobility by Eq. 10.
    pub mobility_count: isize,
    /// n − rank \[A\] at the start.
    pub mobility_rank: usize,
    /// What deserves a look.
    pub warnings: Vec<WarningReport>,
    /// Joint values from which the motion was planned, degrees or lengths, chain by chain.
    pub start: Vec<Vec<f64>>,
}

/// A chain's type and variables.
#[derive(Clone, Debug, Serialize)]
pub struct ChainReport {
    /// The document's name for it.
    pub name: String,
    /// Such as TPR.
    #[serde(rename = "type")]
    pub kind: String,
    /// Degrees of freedom.
    pub freedoms: usize,
    /// Degree of constraint U (Eq. 8).
    pub constraints: usize,
    /// The category of Table 2, such as II.
    pub category: &'static str,
    /// The joint variables, in the order of the columns.
    pub variables: Vec<VariableReport>,
    /// The rows of the table.
    pub rows: Vec<RowReport>,
}

/// A joint variable.
#[derive(Clone, Debug, Serialize)]
pub struct VariableReport {
    /// θ or d with the number of its row, from 1, as the paper's tables print it.
    pub label: String,
    /// `rad` or `length`.
    pub unit: &'static str,
    /// The joint, from 0.
    pub joint: usize,
    /// The row within the chain, from 0.
    pub row: usize,
}

/// A row of a Denavit–Hartenberg table.
#[derive(Clone, Debug, Serialize)]
pub struct RowReport {
    /// The letter of the joint that the row belongs to.
    pub kind: char,
    /// The joint, from 0.
    pub joint: usize,
}

/// A warning in words, with the frames that it is about, from 0.
#[derive(Clone, Debug, Serialize)]
pub struct WarningReport {
    /// In kebab-case.
    pub code: &'static str,
    /// A sentence for a person. Frames count from 1 in it.
    pub message: String,
    /// First frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first: Option<usize>,
    /// Last frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub last: Option<usize>,
}

impl Report {
    /// The report of a motion of this mechanism.
    pub fn new(mechanism: &Mechanism, trajectory: &Trajectory) -> Self {
        Self {
            statuses: Status::ALL.map(Status::name).to_vec(),
            chains: mechanism.chains().iter().map(chain).collect(),
            mobility_count: trajectory.mobility_count,
            mobility_rank: trajectory.mobility_rank,
            warnings: trajectory.warnings.iter().map(warning).collect(),
            start: start_values(mechanism, &trajectory.start),
        }
    }
}

/// A chain in names and units.
pub fn chain(chain: &Chain) -> ChainReport {
    let mut variables = Vec::new();
    let mut rows = Vec::new();
    for (j, joint) in chain.joints().iter().enumerate() {
        let kind = joint.kind();
        for i in 0..joint.rows().len() {
            let row = rows.len();
            let mut variable = |letter: char, unit| {
                let label = format!("{letter}{}", row + 1);
                variables.push(VariableReport {
                    label,
                    unit,
                    joint: j,
                    row,
                });
            };
            let moves = kind.moves(i);
            if moves != Moves::Slides {
                variable('θ', "rad");
            }
            if moves != Moves::Turns {
                variable('d', "length");
            }
            rows.push(RowReport {
                kind: kind.letter(),
                joint: j,
            });
        }
    }
    ChainReport {
        name: chain.name().to_owned(),
        kind: chain.type_name(),
        freedoms: chain.freedoms(),
        constraints: chain.constraints(),
        // A single R or P: the trivial case that Section 4 leaves out of its categories.
        category: enumerate::category_name(chain.constraints()).unwrap_or("V"),
        variables,
        rows,
    }
}

fn warning(warning: &Warning) -> WarningReport {
    let say = |code, message, frames: Option<(usize, usize)>| WarningReport {
        code,
        message,
        first: frames.map(|f| f.0),
        last: frames.map(|f| f.1),
    };
    match *warning {
        Warning::StartMoved { moved } => say(
            "start-moved",
            format!(
                "The start did not close the loops; joints were moved by up to {moved:.3} (rad or lengths)."
            ),
            None,
        ),
        Warning::StartOpen { opening } => say(
            "start-open",
            format!(
                "The loops cannot be closed from this start: {opening:.3} (rad or lengths) stay open. Give other start values or dimensions."
            ),
            None,
        ),
        Warning::BranchJump { first, moved } => say(
            "branch-jump",
            format!(
                "Between frames {} and {} a joint moves by {moved:.2} (rad or lengths): the linkage jumps to another branch.",
                first + 1,
                first + 2
            ),
            Some((first, first + 1)),
        ),
        Warning::NearSingular {
            first,
            last,
            smallest,
        } => say(
            "near-singular",
            format!(
                "Near a singular position in frames {} to {}: the smallest singular value falls to {smallest:.1e}.",
                first + 1,
                last + 1
            ),
            Some((first, last)),
        ),
        Warning::MobilityDiffers { count, rank } => say(
            "mobility-differs",
            format!(
                "Counting joints gives {count} degrees of freedom, the rank of the loop equations {rank}: some constraints repeat each other, or the start is a singular position."
            ),
            None,
        ),
        Warning::LimitsUnknown => say(
            "limits-unknown",
            "The gradient planner knows no joint limits; frames beyond one count as stalled. \
             The Newton planner keeps them."
                .to_owned(),
            None,
        ),
        Warning::HalfTurn {
            ref neighbours,
            axis,
        } => say("half-turn", half_turn(neighbours, axis), None),
        Warning::FullTurn {
            ref neighbours,
            angle,
            typed,
            slides,
        } => say(
            "full-turn",
            full_turn(neighbours, angle, typed, slides),
            None,
        ),
        Warning::ShortWay {
            ref neighbours,
            angle,
            typed,
            turn,
        } => say("short-way", short_way(neighbours, angle, typed, turn), None),
        Warning::Runaway { frame } => say(
            "runaway",
            format!(
                "At frame {} the distance keeps falling while a slider runs away: there is no closest pose. Limits for the sliders would help.",
                frame + 1
            ),
            Some((frame, frame)),
        ),
    }
}

fn half_turn(neighbours: &Neighbours, axis: [f64; 3]) -> String {
    // Adding 0 makes 0 of −0.
    let [x, y, z] = axis.map(|x| (x * 1e3).round() / 1e3 + 0.0);
    format!(
        "From {} the workpiece turns by 180°, and both ways are equally long. It turns about the direction ({x}, {y}, {z}) of the fixed frame, by the right-hand rule. A key frame between the two chooses the other way.",
        from_to(neighbours)
    )
}

fn full_turn(neighbours: &Neighbours, angle: &str, typed: f64, slides: bool) -> String {
    let typed = degrees(typed);
    let what = if slides {
        "does not turn"
    } else {
        "stands still"
    };
    format!(
        "From {} the {angle} differs by {typed}°, which is the same rotation: the workpiece {what} between them. {MORE_KEY_FRAMES}",
        from_to(neighbours)
    )
}

fn short_way(neighbours: &Neighbours, angle: &str, typed: f64, turn: f64) -> String {
    let (typed, turn) = (degrees(typed), degrees(turn));
    format!(
        "From {} the {angle} differs by {typed}°, and the workpiece turns the short way, by {turn}°. {MORE_KEY_FRAMES}",
        from_to(neighbours)
    )
}

const MORE_KEY_FRAMES: &str =
    "To turn it all the way, add key frames between them, each less than 180° from the one before.";

/// Such as: key frame 1 “begin” to key frame 2.
fn from_to(neighbours: &Neighbours) -> String {
    let [before, own] = &neighbours.names;
    let called = |number: usize, name: &str| {
        let mut words = format!("key frame {number}");
        if !name.is_empty() {
            words += &format!(" \u{201c}{}\u{201d}", excerpt(name));
        }
        words
    };
    let key = neighbours.key;
    format!("{} to {}", called(key, before), called(key + 1, own))
}

/// Radians in degrees, rounded to a thousandth.
fn degrees(angle: f64) -> f64 {
    (angle.to_degrees() * 1e3).round() / 1e3
}
