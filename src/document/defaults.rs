//! What a page starts from: one of everything that can be added to a document.

use crate::document::schema::{
    ChainEntry, Document, FrameEntry, JointEntry, KeyFrameEntry, MotionEntry, PlannerEntry,
    VERSION, default_frames,
};
use crate::model::joint::{Joint, JointKind};
use crate::motion::goal::Interpolation;
use serde::Serialize;
use std::collections::BTreeMap;

/// Parts of documents with their default values.
#[derive(Clone, Debug, Serialize)]
pub struct Defaults {
    /// A small document that plans, as text.
    pub document: String,
    /// A joint of each type, by its letter.
    pub joints: BTreeMap<char, JointEntry>,
    /// A frame.
    pub frame: FrameEntry,
    /// A key frame.
    pub key_frame: KeyFrameEntry,
    /// A chain.
    pub chain: ChainEntry,
    /// A motion.
    pub motion: MotionEntry,
    /// Settings.
    pub planner: PlannerEntry,
}

/// The defaults of the format.
pub fn defaults() -> Defaults {
    let joint = |kind| JointEntry::from(&Joint::standard(kind));
    // The paper's RPS leg (Table 6): it takes one freedom and reaches any place, so that it closes
    // with most linkages.
    let mut slider = joint(JointKind::P);
    slider.rows[0].alpha = 90.0;
    let chain = ChainEntry {
        name: String::new(),
        base: FrameEntry::default(),
        joints: vec![joint(JointKind::R), slider, joint(JointKind::S)],
        gripper: FrameEntry::default(),
        start: None,
    };
    // An arm that turns and tilts; the workpiece at its end, one unit along x.
    let arm = ChainEntry {
        name: "chain 1".into(),
        joints: vec![joint(JointKind::T)],
        gripper: FrameEntry {
            x: 1.0,
            ..FrameEntry::default()
        },
        ..chain.clone()
    };
    let key_frame = KeyFrameEntry {
        x: 1.0,
        ..KeyFrameEntry::default()
    };
    let turned = KeyFrameEntry {
        x: 0.0,
        y: 1.0,
        z: 0.5,
        roll: 90.0,
        ..KeyFrameEntry::default()
    };
    let motion = MotionEntry {
        key_frames: vec![key_frame.clone(), turned],
        #[cfg(feature = "study")]
        drivers: Vec::new(),
        interpolation: Interpolation::default(),
        frames: default_frames(),
        reference: None,
        radius: None,
    };
    let document = Document {
        schema: None,
        version: VERSION,
        name: "new mechanism".into(),
        about: String::new(),
        length_unit: String::new(),
        chains: vec![arm],
        motion: motion.clone(),
        planner: PlannerEntry::default(),
    };
    Defaults {
        document: document.text(),
        joints: JointKind::ALL
            .map(|kind| (kind.letter(), joint(kind)))
            .into(),
        frame: FrameEntry::default(),
        key_frame: KeyFrameEntry::default(),
        chain,
        motion,
        planner: PlannerEntry::default(),
    }
}
