//! What deserves a look in a motion, as sentences for a person.

use crate::document::fault::excerpt;
use crate::document::number::{readable, typed};
use crate::document::wording::Wording;
#[cfg(feature = "study")]
use crate::motion::trajectory::DriveEnd;
use crate::motion::trajectory::{Neighbours, Suspect, Warning};
use serde::Serialize;

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

/// The warning that a sound mechanism may have: that of every overconstrained one.
pub fn mobility_differs(count: isize, rank: usize) -> WarningReport {
    let minus = if count < 0 { "−" } else { "" };
    let size = count.unsigned_abs();
    let plural = if count == 1 { "" } else { "s" };
    WarningReport {
        code: "mobility-differs",
        message: format!(
            "Counting joints gives {minus}{size} degree{plural} of freedom, the rank of the loop equations {rank}: some constraints repeat each other, or the start is a singular position."
        ),
        first: None,
        last: None,
    }
}

/// A warning of a motion, in words.
pub fn warning(warning: &Warning, wording: &Wording<'_>) -> WarningReport {
    let say = |code, message, frames: Option<(usize, usize)>| WarningReport {
        code,
        message,
        first: frames.map(|f| f.0),
        last: frames.map(|f| f.1),
    };
    match *warning {
        Warning::StartMoved { moved, variable } => say(
            "start-moved",
            format!(
                "The start did not close the loops; joints were moved, most of all {} by {}.",
                wording.variable(variable),
                wording.amount(variable, moved)
            ),
            None,
        ),
        Warning::StartOutsideLimits { variable, value, limit } => say(
            "start-outside-limits",
            format!(
                "The start of {}, {}, is {} value, {}: it is moved there.",
                wording.variable(variable),
                wording.amount(variable, value),
                if value < limit { "below its smallest" } else { "above its largest" },
                wording.amount(variable, limit)
            ),
            None,
        ),
        #[cfg(feature = "study")]
        Warning::NearlyParallel { chain, joint, angle } => say(
            "nearly-parallel",
            format!(
                "{}: the axis of joint {} is within {}\u{b0} of the axis before, and is taken as parallel to it. Give directions with more digits, or exactly parallel ones.",
                wording.chain(chain),
                joint + 1,
                readable(angle.to_degrees())
            ),
            None,
        ),
        #[cfg(feature = "study")]
        Warning::StandardTable => say(
            "standard-table",
            "Read as standard tables (Z\u{b7}X) these rows fit the start and the first key frame; as modified ones (X\u{b7}Z), as they are read, they do not. Switch the convention of the chains to standard.".to_owned(),
            None,
        ),
        Warning::StartOpen { error } => say(
            "start-open",
            format!(
                "The loops cannot be closed from this start: they are open by {} of the mechanism's size, or rad. Give other start values, wider limits or other dimensions.",
                readable(error)
            ),
            None,
        ),
        Warning::StartRigid { error, leap } => say(
            "start-rigid",
            start_rigid(error, leap),
            None,
        ),
        Warning::RoundedDimensions { misfit, tolerance, suspect } => say(
            "rounded-dimensions",
            rounded_dimensions(misfit, tolerance, suspect.as_ref(), wording),
            None,
        ),
        Warning::RoundedUnknown => say(
            "rounded-unknown",
            "The dimensions of this linkage agree only to some decimals. The gradient planner takes them as they are, and finds no closed position; the Newton planner allows for it."
                .to_owned(),
            None,
        ),
        Warning::BranchJump { first, time, moved, variable } => say(
            "branch-jump",
            format!(
                "The linkage leaps between frames {} and {}, at time {}: {} moves by {} at once. From there on the motion is on another branch.",
                first + 1,
                first + 2,
                readable(time),
                wording.variable(variable),
                wording.amount(variable, moved)
            ),
            Some((first, first + 1)),
        ),
        Warning::MetricLength { given, proposed } => say(
            "metric-length",
            format!(
                "The metric's length is {}, and the linkage, or its motion where it has no lengths, measures about {}: rotations weigh {} against translations. A length of {} would be usual: it is taken where the field is empty, or null in a file.",
                wording.length(given),
                wording.length(proposed),
                if given < proposed { "next to nothing" } else { "almost everything" },
                wording.length(proposed)
            ),
            None,
        ),
        Warning::NearSingular {
            first,
            last,
            smallest,
            bound,
        } => say(
            "near-singular",
            format!(
                "{} the linkage is near a singular position: the smallest singular value falls to {}, below {}.",
                in_frames(first, last),
                readable(smallest),
                readable(bound)
            ),
            Some((first, last)),
        ),
        Warning::MobilityDiffers { count, rank } => mobility_differs(count, rank),
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
            ref angle,
            typed,
            slides,
        } => say(
            "full-turn",
            full_turn(neighbours, angle, typed, slides),
            None,
        ),
        Warning::ShortWay {
            ref neighbours,
            ref angle,
            typed,
            turn,
        } => say("short-way", short_way(neighbours, angle, typed, turn), None),
        Warning::MoreNotes { count } => say(
            "more-notes",
            format!("{count} more warnings of key frames like these are left out."),
            None,
        ),
        #[cfg(feature = "study")]
        Warning::DriveEnds { first, last, time, ref why, ref driven } => say(
            "drive-ends",
            drive_ends((first, last), time, why, driven, wording),
            Some((first, last)),
        ),
        #[cfg(feature = "study")]
        Warning::DriverDependent { variable } => say(
            "driver-dependent",
            format!(
                "{} is not driven: the drivers before it leave it no freedom. Frames count as reached only where they lead to its values as well.",
                wording.variable(variable)
            ),
            None,
        ),
        #[cfg(feature = "study")]
        Warning::UndrivenFreedoms { count } => say(
            "undriven-freedoms",
            format!(
                "{count} {} of the linkage {} not driven: joints that the drivers leave free move as little as they can from frame to frame.",
                if count == 1 { "freedom" } else { "freedoms" },
                if count == 1 { "is" } else { "are" }
            ),
            None,
        ),
        #[cfg(feature = "study")]
        Warning::BranchChosen { frame, ref driven } => say(
            "branch-chosen",
            format!(
                "On the way to frame {}, with {}, the linkage can go on in several ways; the one with the least motion of the joints was taken. Start values a little way off choose another.",
                frame + 1,
                values(driven, wording)
            ),
            Some((frame, frame)),
        ),
        Warning::Runaway { first, last, searched, elsewhere } => say(
            "runaway",
            format!(
                "{} the distance keeps falling while a slider runs away: no closest pose was found on this branch. {}{}Limits for the sliders would help.",
                in_frames(first, last),
                match searched {
                    0 => "Other positions were not tried, since each search takes long. ".to_owned(),
                    all if all == last + 1 - first => String::new(),
                    some => format!("Other positions were tried at {some} of them only, since each search takes long. "),
                },
                if elsewhere { "Another assembly, to which no motion was found, comes closer. " } else { "" }
            ),
            Some((first, last)),
        ),
    }
}

#[cfg(feature = "study")]
fn drive_ends(
    (first, last): (usize, usize),
    time: f64,
    why: &DriveEnd,
    driven: &[(usize, f64)],
    wording: &Wording<'_>,
) -> String {
    let names = |variables: &[usize]| {
        let names: Vec<String> = variables.iter().map(|&v| wording.variable(v)).collect();
        names.join(", ")
    };
    let reason = match why {
        DriveEnd::OwnLimit(own) => format!("the limit of {} itself is met", names(own)),
        DriveEnd::Limits(held) => format!(
            "{} {} at a limit",
            names(held),
            if held.len() == 1 { "is" } else { "are" }
        ),
        DriveEnd::DeadPoint => {
            "a dead point is met, beyond which the loops do not close".to_owned()
        }
        DriveEnd::Immobile => "nothing of the linkage can move".to_owned(),
        DriveEnd::TooFar => "the way is longer than one frame goes".to_owned(),
    };
    format!(
        "{} the drivers cannot be followed: {reason}. At time {} the linkage stays at {}.",
        in_frames(first, last),
        readable(time),
        values(driven, wording)
    )
}

/// Such as: θ₁ of crank at 97.1808°. With the digits that tell where a dead point is.
#[cfg(feature = "study")]
fn values(driven: &[(usize, f64)], wording: &Wording<'_>) -> String {
    let one = |&(variable, value): &(usize, f64)| {
        format!(
            "{} at {}",
            wording.variable(variable),
            wording.precise(variable, value)
        )
    };
    let all: Vec<String> = driven.iter().map(one).collect();
    all.join(", ")
}

fn start_rigid(error: f64, leap: Option<f64>) -> String {
    let nearest = match leap {
        Some(leap) => format!(
            "the nearest position found where they close is a joint motion of {} rad, or sizes, away",
            readable(leap)
        ),
        None => "no position was found where they close".to_owned(),
    };
    format!(
        "The dimensions do not fit together: at the given start the loops are open by {} of the mechanism's size, or rad, and {nearest}. With these dimensions the linkage is rigid, or the start belongs to another one.",
        readable(error)
    )
}

fn rounded_dimensions(
    misfit: f64,
    tolerance: f64,
    suspect: Option<&Suspect>,
    wording: &Wording<'_>,
) -> String {
    let size = wording.mechanism.size_or(1.0);
    let mut text = format!(
        "The loops of this linkage have more conditions than it needs, and its dimensions agree only to {} ({} of its size, or rad): they look rounded. The loops are closed as well as they can be, in the sense of least squares, and frames are certified for that.",
        wording.length(misfit * size),
        readable(misfit)
    );
    if misfit > tolerance {
        text += &format!(
            " The tolerance of dimensions is {}: where they disagree by more, frames count as open.",
            readable(tolerance)
        );
    }
    if let Some(suspect) = suspect {
        text += &format!(
            " The smallest change that explains most of it: {}.",
            wording.suspect(suspect)
        );
    }
    text
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

/// Frames count from 1 for a reader.
fn in_frames(first: usize, last: usize) -> String {
    if first == last {
        format!("At frame {}", first + 1)
    } else {
        format!("In frames {} to {}", first + 1, last + 1)
    }
}

/// Radians in degrees, to a thousandth, or to four digits where that is 0.
fn degrees(angle: f64) -> String {
    let thousandths = (angle.to_degrees() * 1e3).round();
    if thousandths.abs() > 0.0 {
        typed(thousandths / 1e3)
    } else {
        readable(angle.to_degrees())
    }
}
