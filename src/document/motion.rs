//! From the document's motion to goals: key frames in radians, and what their angles leave open.

use crate::document::bounds::{
    MAX_NAME, MAX_TIME, bounded, check_text, length, not_finite, out_of_range, wrong_count,
};
use crate::document::fault::{Fault, FaultCode, Place, told};
use crate::document::number::{rounded_up, typed};
use crate::document::parts::{each, frame, point};
use crate::document::schema::{FrameEntry, KeyFrameEntry, MotionEntry};
use crate::math::pose::gaps;
use crate::motion::goal::{DoubleQuaternions, Goal, GoalMotion, MAX_FRAMES, goal_motion};
use crate::motion::key_frames::{HalfTurn, KeyFrame, KeyFrameFault, MAX_KEY_FRAMES};
use crate::motion::trajectory::{Neighbours, Warning};

const MOTION: Place<'static> = Place::WHOLE.field("motion");

/// The goals of a motion, and what its key frames give reason to warn of.
///
/// # Errors
/// One fault, where there are any.
pub(crate) fn goal_of(motion: &MotionEntry) -> Result<(Vec<Goal>, Vec<Warning>), Fault> {
    let list = MOTION.field("key_frames");
    let key_place = |i: usize| list.named(i, &motion.key_frames[i].name);
    let keys = each(&motion.key_frames, |i, entry| {
        key_frame(entry, &key_place(i))
    })?;
    let radius = motion
        .radius
        .map(|r| length(r, &MOTION.field("radius")))
        .transpose()?;
    let double_quaternions = DoubleQuaternions {
        reference: point(motion.reference.as_deref(), &MOTION.field("reference"))?,
        radius,
    };
    let frames = motion.frames as usize;
    let goal = goal_motion(&keys, motion.interpolation, frames, &double_quaternions);
    let GoalMotion { goals, half_turns } = goal.map_err(|fault| match fault {
        KeyFrameFault::TooFew { found } | KeyFrameFault::TooMany { found } => {
            wrong_count(&list, found, &told!("2 to {MAX_KEY_FRAMES} key frames"))
        }
        KeyFrameFault::NotFinite { key } => not_finite(&key_place(key)),
        KeyFrameFault::TimeMissing { key } => {
            let what = "other key frames have a time and this one has none";
            let accepted = "a time for every key frame, or for none";
            Fault::new(FaultCode::TimeMissing, &key_place(key).field("time"), what, accepted)
        }
        KeyFrameFault::TimeOrder { key, previous, time } => {
            let what = told!("{} is not later than the time before", typed(time));
            let accepted = told!("a time later than {}", typed(previous));
            Fault::new(FaultCode::TimeOrder, &key_place(key).field("time"), &what, &accepted)
        }
        KeyFrameFault::Radius { radius, least } => {
            let accepted = told!(
                "a positive length that is not below {}, half the distance of the farthest key frame from the reference point",
                rounded_up(least)
            );
            out_of_range(&MOTION.field("radius"), typed(radius), &accepted).or_null()
        }
        KeyFrameFault::FrameCount { found } => {
            let accepted = told!("a whole number from 2 to {MAX_FRAMES}");
            out_of_range(&MOTION.field("frames"), found, &accepted)
        }
    })?;
    let notes = notes(&motion.key_frames, &keys, &half_turns);
    Ok((goals, notes))
}

fn key_frame(entry: &KeyFrameEntry, place: &Place<'_>) -> Result<KeyFrame, Fault> {
    check_text(&entry.name, MAX_NAME, &place.field("name"))?;
    let &KeyFrameEntry {
        x,
        y,
        z,
        longitude,
        latitude,
        roll,
        time,
        ..
    } = entry;
    let pose = frame(
        &FrameEntry {
            x,
            y,
            z,
            longitude,
            latitude,
            roll,
        },
        place,
    )?;
    let time = time
        .map(|t| bounded(t, MAX_TIME, "a time", &place.field("time")))
        .transpose()?;
    Ok(KeyFrame {
        name: entry.name.clone(),
        pose,
        time,
    })
}

/// Most notes on key frames: beyond, a person needs to know that there are more, and not which.
const MAX_NOTES: usize = 50;

/// Where the motion between neighbours is not the only one that their angles can mean.
fn notes(entries: &[KeyFrameEntry], keys: &[KeyFrame], half_turns: &[HalfTurn]) -> Vec<Warning> {
    let mut notes = Vec::new();
    let mut half_turns = half_turns.iter().peekable();
    for key in 1..entries.len() {
        let neighbours = || Neighbours {
            key,
            names: [key - 1, key].map(|i| entries[i].name.clone()),
        };
        notes.extend(turn_note(key, entries, keys, neighbours));
        if let Some(half) = half_turns.next_if(|half| half.key == key) {
            notes.push(Warning::HalfTurn {
                neighbours: neighbours(),
                axis: half.axis.into(),
            });
        }
    }
    if notes.len() > MAX_NOTES {
        let count = notes.len() - MAX_NOTES;
        notes.truncate(MAX_NOTES);
        notes.push(Warning::MoreNotes { count });
    }
    notes
}

/// Where the angles of the key frame `key` and of the one before differ by more than the workpiece can
/// turn from one to the other.
///
/// Angles within ±180° only name a rotation: they are what this crate writes for any rotation, and
/// 170° beside −170° is no wish to turn by 340°. Only an angle beyond ±180° says which way round.
fn turn_note(
    key: usize,
    entries: &[KeyFrameEntry],
    keys: &[KeyFrame],
    neighbours: impl Fn() -> Neighbours,
) -> Option<Warning> {
    /// Degrees that are rounding: of an angle of 10⁶ degrees 10⁻¹⁰ is known.
    const ROUNDING: f64 = 1e-9;
    /// Angle of a rotation, rad, that is rounding: of the same angles.
    const SAME: f64 = 1e-9;
    let (before, entry) = (&entries[key - 1], &entries[key]);
    let angles = [
        ("longitude", before.longitude, entry.longitude),
        ("latitude", before.latitude, entry.latitude),
        ("roll", before.roll, entry.roll),
    ];
    let (angle, from, to) = angles
        .into_iter()
        .max_by(|a, b| (a.2 - a.1).abs().total_cmp(&(b.2 - b.1).abs()))?;
    let typed = (to - from).abs();
    let (shift, turn) = gaps(&keys[key - 1].pose, &keys[key].pose);
    if typed > 360.0 - ROUNDING && turn < SAME {
        return Some(Warning::FullTurn {
            neighbours: neighbours(),
            angle: angle.into(),
            typed: typed.to_radians(),
            slides: shift > 0.0,
        });
    }
    let names_a_way = from.abs().max(to.abs()) > 180.0 + ROUNDING;
    (typed > 180.0 + ROUNDING && names_a_way).then(|| Warning::ShortWay {
        neighbours: neighbours(),
        angle: angle.into(),
        typed: typed.to_radians(),
        turn,
    })
}
