//! From the document's drivers to joint variables over time: numbers counted from 1 to variables, degrees to radians,
//! and what is wrong with them.

use crate::document::bounds::{MAX_TIME, bounded, joint_value, out_of_range, wrong_count};
use crate::document::driver_schema::{DriverEntry, DriverValueEntry};
use crate::document::fault::{Fault, FaultCode, Place};
use crate::document::number::typed;
use crate::document::parts::each;
use crate::document::schema::MotionEntry;
use crate::document::wording::Wording;
use crate::model::chain::Chain;
use crate::model::mechanism::Mechanism;
use crate::motion::drivers::{Driver, Schedule};
use crate::motion::goal::MAX_FRAMES;
use crate::motion::key_frames::MAX_KEY_FRAMES;

const MOTION: Place<'static> = Place::WHOLE.field("motion");
const DRIVERS: Place<'static> = MOTION.field("drivers");

/// What drives the joints of this mechanism; none where the motion has key frames.
///
/// # Errors
/// One fault, where there are any.
pub(crate) fn schedule_of(
    motion: &MotionEntry,
    mechanism: &Mechanism,
) -> Result<Option<Schedule>, Fault> {
    if motion.drivers.is_empty() {
        return Ok(None);
    }
    if !motion.key_frames.is_empty() {
        let what = "the motion has key frames and drivers";
        let accepted = "key frames, or drivers in their place";
        return Err(Fault::new(
            FaultCode::UnknownField,
            &DRIVERS,
            what,
            accepted,
        ));
    }
    let frames = motion.frames as usize;
    if !(2..=MAX_FRAMES).contains(&frames) {
        let accepted = format!("a whole number from 2 to {MAX_FRAMES}");
        return Err(out_of_range(&MOTION.field("frames"), frames, &accepted));
    }
    let drivers = each(&motion.drivers, |i, entry| {
        driver(entry, mechanism, &DRIVERS.item(i))
    })?;
    for (i, own) in drivers.iter().enumerate() {
        let same = |other: &Driver| other.variable == own.variable;
        if let Some(before) = drivers[..i].iter().position(same) {
            let wording = Wording {
                mechanism,
                unit: "",
            };
            let what = format!(
                "{} is driven by driver {} already",
                wording.variable(own.variable),
                before + 1
            );
            let accepted = "a joint variable that no other driver drives";
            let place = DRIVERS.item(i);
            return Err(Fault::new(FaultCode::WrongCount, &place, &what, accepted));
        }
    }
    Ok(Some(Schedule { drivers, frames }))
}

fn driver(entry: &DriverEntry, mechanism: &Mechanism, place: &Place<'_>) -> Result<Driver, Fault> {
    let wording = Wording {
        mechanism,
        unit: "",
    };
    let chains = mechanism.chains();
    let chain = counted(entry.chain, chains.len(), &place.field("chain"), || {
        let many = if chains.len() == 1 { "chain" } else { "chains" };
        format!("the linkage has {} {many}", chains.len())
    })?;
    let joints = chains[chain].joints();
    let joint = counted(entry.joint, joints.len(), &place.field("joint"), || {
        let many = if joints.len() == 1 { "joint" } else { "joints" };
        format!("{} has {} {many}", wording.chain(chain), joints.len())
    })?;
    let kind = joints[joint].kind();
    let freedoms = kind.freedoms();
    let freedom = counted(entry.freedom, freedoms, &place.field("freedom"), || {
        let many = if freedoms == 1 { "freedom" } else { "freedoms" };
        format!("a joint of type {} has {freedoms} {many}", kind.letter())
    })?;
    let before: usize = chains[..chain].iter().map(Chain::freedoms).sum();
    let inside: usize = joints[..joint].iter().map(|j| j.kind().freedoms()).sum();
    let turns = chains[chain].turns().nth(inside + freedom) == Some(true);
    let list = place.field("values");
    if !(2..=MAX_KEY_FRAMES).contains(&entry.values.len()) {
        let accepted = format!("2 to {MAX_KEY_FRAMES} times and values");
        return Err(wrong_count(&list, entry.values.len(), &accepted));
    }
    let values = each(&entry.values, |i, entry| {
        let place = list.item(i);
        let DriverValueEntry { time, value } = *entry;
        let time = bounded(time, MAX_TIME, "a time", &place.field("time"))?;
        let value = joint_value(value, turns, &place.field("value"))?;
        Ok((time, value))
    })?;
    for (i, pair) in values.windows(2).enumerate() {
        let (previous, time) = (pair[0].0, pair[1].0);
        if !(time > previous) {
            let place = list.item(i + 1);
            let what = format!("{} is not later than the time before", typed(time));
            let accepted = format!("a time later than {}", typed(previous));
            let place = place.field("time");
            return Err(Fault::new(FaultCode::TimeOrder, &place, &what, &accepted));
        }
    }
    Ok(Driver {
        variable: before + inside + freedom,
        values,
        ramp: entry.ramp,
    })
}

/// An index from a number that counts from 1; `there` says how many there are.
fn counted(
    number: u32,
    count: usize,
    place: &Place<'_>,
    there: impl Fn() -> String,
) -> Result<usize, Fault> {
    let index = (number as usize).checked_sub(1).filter(|i| *i < count);
    index.ok_or_else(|| {
        let accepted = if count == 1 {
            format!("1: {}", there())
        } else {
            format!("a whole number from 1 to {count}: {}", there())
        };
        out_of_range(place, number, &accepted)
    })
}
