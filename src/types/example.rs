//! A linkage of any type, such as 3RPS or RPS+2TS: chains of those joints around a workpiece, closed at its start, with a
//! goal motion from there.
//!
//! The links are chosen by a few rules of thumb; what closes the loops is the gripper frame, H = (G K(θ))⁻¹ D, which can
//! be had for every chain.

use crate::document::fault::{Fault, FaultCode, Place, excerpt};
use crate::document::problem::{Problem, short};
use crate::document::schema::{
    ChainEntry, Document, FrameEntry, JointEntry, KeyFrameEntry, MotionEntry, PlannerEntry, VERSION,
};
use crate::math::pose::{FrameCoordinates, Pose};
use crate::model::chain::MAX_FREEDOMS;
use crate::model::joint::{Joint, JointKind};
use crate::model::mechanism::MAX_CHAINS;
use crate::motion::goal::Interpolation;
use crate::types::enumerate::letters;
use nalgebra::Vector3;

/// Length of a link; the bases stand on a circle of radius 1.
const LINK: f64 = 0.7;
/// How far the workpiece is above the ends of the chains.
const RISE: f64 = 0.25;
const FRAMES: u32 = 65;

/// The chains that a type names: counts and joint letters from base to workpiece, with + or blanks between.
///
/// # Errors
/// Where the text is no type.
pub fn chains_of(text: &str) -> Result<Vec<Vec<JointKind>>, Fault> {
    let mut chains = Vec::new();
    for term in text
        .split(|c: char| c == '+' || c.is_whitespace())
        .filter(|term| !term.is_empty())
    {
        let joints = term.trim_start_matches(|c: char| c.is_ascii_digit());
        let count = &term[..term.len() - joints.len()];
        let count = if count.is_empty() {
            Some(1)
        } else {
            count.parse().ok()
        };
        let kinds: Option<Vec<JointKind>> = joints
            .chars()
            .map(|c| {
                JointKind::ALL
                    .into_iter()
                    .find(|kind| kind.letter() == c.to_ascii_uppercase())
            })
            .collect();
        let kinds = kinds.filter(|kinds| {
            (1..=MAX_FREEDOMS).contains(&kinds.iter().map(|kind| kind.freedoms()).sum())
        });
        let (Some(count @ 1..=MAX_CHAINS), Some(kinds)) = (count, kinds) else {
            return Err(no_type(term));
        };
        chains.extend(std::iter::repeat_n(kinds, count));
    }
    if (1..=MAX_CHAINS).contains(&chains.len()) {
        Ok(chains)
    } else {
        Err(no_type(text))
    }
}

fn no_type(text: &str) -> Fault {
    let what = format!("\u{201c}{}\u{201d} is no type of linkage", excerpt(text));
    let accepted = format!(
        "chains of the joints R, P, C, T, S, E with one to {MAX_FREEDOMS} freedoms each, such as 3RPS or RPS+2TS, at most {MAX_CHAINS}"
    );
    Fault::new(
        FaultCode::UnknownValue,
        &Place::WHOLE.field("type"),
        &what,
        &accepted,
    )
}

/// A linkage of this type, see [`chains_of`].
///
/// # Errors
/// Where the text is no type.
pub fn assemble(text: &str) -> Result<Document, Fault> {
    let kinds = chains_of(text)?;
    let many = kinds.len();
    let mut document = Document {
        schema: None,
        version: VERSION,
        name: text.trim().to_uppercase(),
        about: String::new(),
        length_unit: "m".into(),
        chains: kinds
            .iter()
            .enumerate()
            .map(|(i, joints)| chain(joints, i, many))
            .collect(),
        motion: MotionEntry {
            key_frames: vec![KeyFrameEntry::default(); 2],
            interpolation: Interpolation::default(),
            frames: FRAMES,
            reference: None,
            radius: None,
        },
        planner: PlannerEntry::default(),
    };
    let mechanism = Problem::new(&document)?.mechanism;
    let starts: Vec<f64> = kinds.iter().flat_map(|joints| start(joints)).collect();
    let ends: Vec<Pose> = mechanism
        .split(&starts)
        .map(|(chain, values)| chain.pose(values))
        .collect();
    let middle = ends
        .iter()
        .map(|end| end.translation.vector)
        .sum::<Vector3<f64>>()
        / many as f64;
    let begin = Pose::translation(middle.x, middle.y, middle.z + RISE);
    document.set_start(&mechanism, &starts);
    for (chain, end) in document.chains.iter_mut().zip(&ends) {
        chain.gripper = entry(&(end.inverse() * begin));
    }
    let FrameEntry { x, y, z, .. } = entry(&begin);
    let here = KeyFrameEntry {
        name: "begin".into(),
        x,
        y,
        z,
        ..KeyFrameEntry::default()
    };
    let there = KeyFrameEntry {
        name: "end".into(),
        x: short(x + 0.2),
        y: short(y + 0.1),
        z: short(z + 0.15),
        latitude: 12.0,
        roll: 20.0,
        ..KeyFrameEntry::default()
    };
    document.motion.key_frames = vec![here, there];
    Ok(document)
}

/// A chain with its base on the circle, its first axis along the circle so that it swings towards the middle; a slider
/// that comes first stands upright.
fn chain(kinds: &[JointKind], index: usize, many: usize) -> ChainEntry {
    let around = 360.0 * index as f64 / many as f64;
    let (sine, cosine) = libm::sincos(around.to_radians());
    // x inwards, and y upwards or z upwards: X(±90°) of the frame that is turned about the vertical.
    let upright = FrameCoordinates {
        roll: (around + 180.0).to_radians(),
        ..FrameCoordinates::default()
    };
    let tilt = if kinds[0] == JointKind::P {
        0.0
    } else {
        -90.0_f64
    };
    let tilted = FrameCoordinates {
        latitude: tilt.to_radians(),
        ..FrameCoordinates::default()
    };
    let place = Pose::translation(cosine, sine, 0.0);
    ChainEntry {
        name: format!("{} {}", letters(kinds), index + 1),
        base: entry(&(place * upright.pose() * tilted.pose())),
        joints: joints(kinds),
        gripper: FrameEntry::default(),
        start: None,
    }
}

/// The joints with links before them: turning axes follow each other in parallel pairs, so that legs bend like knees;
/// a slider goes square to the axis before it, and the axis behind it is parallel to that again.
fn joints(kinds: &[JointKind]) -> Vec<JointEntry> {
    let mut parallel = 0;
    let mut before = None;
    let mut entries = Vec::new();
    for &kind in kinds {
        let mut entry = JointEntry::from(&Joint::standard(kind));
        let (alpha, a) = match (before, kind) {
            (None, _) => (0.0, 0.0),
            (Some(_), JointKind::P) => (90.0, 0.0),
            (Some(JointKind::P), JointKind::R | JointKind::C | JointKind::E) => (-90.0, 0.0),
            (Some(JointKind::P), _) => (0.0, 0.0),
            // A third parallel axis would add nothing that the plane of the two has not.
            (Some(_), _) if parallel >= 2 => (90.0, LINK),
            (Some(_), _) => (0.0, LINK),
        };
        parallel = match kind {
            JointKind::R | JointKind::C => {
                if alpha == 0.0 {
                    parallel + 1
                } else {
                    1
                }
            }
            JointKind::P => parallel,
            JointKind::T | JointKind::S | JointKind::E => 0,
        };
        entry.rows[0].alpha = alpha;
        entry.rows[0].a = a;
        entries.push(entry);
        before = Some(kind);
    }
    entries
}

/// Joint values at the start, rad or lengths: a leg that leans inwards with its knee bent, no axes in line.
fn start(kinds: &[JointKind]) -> Vec<f64> {
    let mut turned = false;
    let mut values = Vec::new();
    for kind in kinds {
        let first = if turned { -50.0_f64 } else { 70.0 };
        match kind {
            JointKind::R => values.push(first.to_radians()),
            JointKind::P => values.push(0.9),
            JointKind::C => values.extend([first.to_radians(), 0.1]),
            JointKind::T => values.extend([first.to_radians(), 25_f64.to_radians()]),
            JointKind::S => values.extend([20.0, 50.0, -30.0].map(f64::to_radians)),
            JointKind::E => values.extend([0.2, 0.3, 30_f64.to_radians()]),
        }
        turned |= *kind != JointKind::P;
    }
    values
}

fn entry(pose: &Pose) -> FrameEntry {
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
