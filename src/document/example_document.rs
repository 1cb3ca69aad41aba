//! A document to begin with: a linkage of any type, closed at its start.

use crate::document::fault::{Fault, FaultCode, Place, excerpt};
use crate::document::problem::short;
use crate::document::schema::{
    ChainEntry, Document, FrameEntry, JointEntry, KeyFrameEntry, MotionEntry, PlannerEntry, VERSION,
};
use crate::math::pose::{FrameCoordinates, Pose};
use crate::model::chain::{Chain, MAX_FREEDOMS};
use crate::model::joint::JointKind;
use crate::model::mechanism::MAX_CHAINS;
use crate::motion::goal::Interpolation;
use crate::types::example;
use crate::types::notation::{NoType, Why, chains_of, type_name};

/// As many as show a smooth motion between two key frames.
pub(crate) const FRAMES: u32 = 65;

/// A document with a linkage of the type that `text` names, such as 3RPS or RPS+2TS, in metres.
///
/// # Errors
/// Where the text is no type.
pub fn example(text: &str) -> Result<Document, Fault> {
    let kinds = kinds(text)?;
    let example = example::example(&kinds);
    let [begin, end] = &example.key_frames;
    let mut document = Document {
        schema: None,
        version: VERSION,
        name: type_name(&kinds),
        about: String::new(),
        length_unit: "m".into(),
        chains: example.mechanism.chains().iter().map(chain).collect(),
        motion: MotionEntry {
            key_frames: vec![key_frame("begin", begin), key_frame("end", end)],
            #[cfg(feature = "study")]
            drivers: Vec::new(),
            interpolation: Interpolation::default(),
            frames: FRAMES,
            reference: None,
            radius: None,
        },
        planner: PlannerEntry::default(),
    };
    document.set_start(&example.mechanism, &example.start);
    Ok(document)
}

/// The chains of a type.
pub(crate) fn kinds(text: &str) -> Result<Vec<Vec<JointKind>>, Fault> {
    chains_of(text).map_err(|no_type| fault(&no_type))
}

fn fault(no_type: &NoType) -> Fault {
    let NoType { text, why } = no_type;
    let what = format!("\u{201c}{}\u{201d} is no type of linkage", excerpt(text));
    let why = match why {
        Why::Empty => "there is no chain in it".to_owned(),
        Why::Letter(letter) => format!("\u{201c}{letter}\u{201d} stands for no joint"),
        Why::Freedoms(found) => {
            format!(
                "the joints have {found} freedoms together (R and P have 1, C and T 2, S and E 3)"
            )
        }
        Why::Loop(chains) => {
            format!("it names a loop from base to base: its chains to the coupler are {chains}")
        }
        Why::Leg { freedoms, locked } => leg(*freedoms, locked.as_ref()),
        Why::Count => format!("it does not have 1 to {MAX_CHAINS} chains"),
        Why::NoChain => "there is no chain behind the number".to_owned(),
    };
    let accepted = format!(
        "chains of the joints R, P, C, T (or U), S, E with one to {MAX_FREEDOMS} freedoms each, such as 3RPS, 3-PRS or RPS + 2TS, at most {MAX_CHAINS}"
    );
    Fault::new(
        FaultCode::UnknownValue,
        &TYPE,
        &format!("{what}: {why}"),
        &accepted,
    )
}

/// What is said of a leg with so many freedoms.
fn leg(freedoms: usize, locked: Option<&(JointKind, String)>) -> String {
    let free = format!(
        "a leg with {freedoms} freedoms takes none from the workpiece, and can be left out"
    );
    match locked {
        Some((drive, left)) => {
            let drive = if *drive == JointKind::P {
                "slider"
            } else {
                "hinge"
            };
            format!("{free}; with its {drive} locked it is a {left} leg")
        }
        None => free,
    }
}

/// The place of the type in what is asked for.
pub(crate) const TYPE: Place<'static> = Place::WHOLE.field("type");

pub(crate) fn chain(chain: &Chain) -> ChainEntry {
    ChainEntry {
        name: chain.name().to_owned(),
        base: frame(chain.base()),
        joints: chain.joints().iter().map(JointEntry::from).collect(),
        gripper: frame(chain.gripper()),
        start: None,
    }
}

fn frame(pose: &Pose) -> FrameEntry {
    let at = FrameCoordinates::from_pose(pose);
    FrameEntry {
        x: short(at.x),
        y: short(at.y),
        z: short(at.z),
        longitude: short(at.longitude.to_degrees()),
        latitude: short(at.latitude.to_degrees()),
        roll: short(at.roll.to_degrees()),
    }
}

pub(crate) fn key_frame(name: &str, pose: &Pose) -> KeyFrameEntry {
    let FrameEntry {
        x,
        y,
        z,
        longitude,
        latitude,
        roll,
    } = frame(pose);
    KeyFrameEntry {
        name: name.into(),
        x,
        y,
        z,
        longitude,
        latitude,
        roll,
        time: None,
    }
}
