//! The documents that tests read: the samples, and the random ones of tests/fixtures, one a line with extra fields.
#![allow(dead_code, reason = "every test uses its own part")]

use serde_json::Value;
use synthetica::document::problem::Problem;
use synthetica::document::schema::{Document, FrameEntry};
use synthetica::document::text::parse;
use synthetica::math::pose::{FrameCoordinates, Pose};
use synthetica::model::joint::JointKind;

/// The documents of the page.
pub const SAMPLES: [&str; 8] = [
    include_str!("../../www/mechanisms/2tpr.json"),
    include_str!("../../www/mechanisms/3rps.json"),
    include_str!("../../www/mechanisms/bennett.json"),
    include_str!("../../www/mechanisms/cartesian.json"),
    include_str!("../../www/mechanisms/five-link.json"),
    include_str!("../../www/mechanisms/four-bar.json"),
    include_str!("../../www/mechanisms/scara.json"),
    include_str!("../../www/mechanisms/spacecraft.json"),
];

/// The lines of a file of tests/fixtures.
pub fn lines(set: &str) -> Vec<Value> {
    let path = format!("{}/tests/fixtures/{set}.jsonl", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    text.lines()
        .map(|line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{path}: {error}")))
        .collect()
}

/// The document of a line.
pub fn document(line: &Value) -> Document {
    parse(&line["document"].to_string()).unwrap_or_else(|fault| panic!("{}: {fault}", line["case"]))
}

/// What the planner needs of a document.
pub fn problem(document: &Document) -> Problem {
    Problem::new(document).unwrap_or_else(|fault| panic!("{}: {fault}", document.name))
}

/// The first entry and every `step`th one after it; all of them with a step of 1.
pub fn sample<T>(all: Vec<T>, step: usize) -> Vec<T> {
    all.into_iter().step_by(step).collect()
}

/// Whether a freedom of a joint is a length.
pub fn slides(kind: JointKind, freedom: usize) -> bool {
    match kind {
        JointKind::R | JointKind::T | JointKind::S => false,
        JointKind::P => true,
        JointKind::C => freedom == 1,
        JointKind::E => freedom < 2,
    }
}

/// All lengths of a document times `s`.
pub fn scaled(document: &Document, s: f64) -> Document {
    let mut document = document.clone();
    let frame = |f: &mut FrameEntry| {
        [&mut f.x, &mut f.y, &mut f.z]
            .into_iter()
            .for_each(|x| *x *= s);
    };
    for chain in &mut document.chains {
        frame(&mut chain.base);
        frame(&mut chain.gripper);
        let mut variable = 0;
        for joint in &mut chain.joints {
            for row in &mut joint.rows {
                row.a *= s;
                row.d *= s;
            }
            for freedom in 0..joint.kind.freedoms() {
                if slides(joint.kind, freedom) {
                    if let Some(Some(limits)) =
                        joint.limits.as_mut().map(|limits| limits[freedom].as_mut())
                    {
                        limits.min = limits.min.map(|x| x * s);
                        limits.max = limits.max.map(|x| x * s);
                    }
                    if let Some(start) = &mut chain.start {
                        start[variable] *= s;
                    }
                }
                variable += 1;
            }
        }
    }
    for key in &mut document.motion.key_frames {
        [&mut key.x, &mut key.y, &mut key.z]
            .into_iter()
            .for_each(|x| *x *= s);
    }
    let motion = &mut document.motion;
    motion.radius = motion.radius.map(|x| x * s);
    motion.reference.iter_mut().flatten().for_each(|x| *x *= s);
    let planner = &mut document.planner;
    planner.metric_length = planner.metric_length.map(|x| x * s);
    planner
        .metric_origin
        .iter_mut()
        .flatten()
        .for_each(|x| *x *= s);
    document
}

/// Bases and key frames moved together.
pub fn moved(document: &Document, motion: &Pose) -> Document {
    let mut document = document.clone();
    let pose = |x, y, z, longitude: f64, latitude: f64, roll: f64| {
        let (longitude, latitude, roll) = (
            longitude.to_radians(),
            latitude.to_radians(),
            roll.to_radians(),
        );
        FrameCoordinates::from_pose(
            &(motion
                * FrameCoordinates {
                    x,
                    y,
                    z,
                    longitude,
                    latitude,
                    roll,
                }
                .pose()),
        )
    };
    for chain in &mut document.chains {
        let b = &mut chain.base;
        let at = pose(b.x, b.y, b.z, b.longitude, b.latitude, b.roll);
        (b.x, b.y, b.z) = (at.x, at.y, at.z);
        (b.longitude, b.latitude, b.roll) = (
            at.longitude.to_degrees(),
            at.latitude.to_degrees(),
            at.roll.to_degrees(),
        );
    }
    for k in &mut document.motion.key_frames {
        let at = pose(k.x, k.y, k.z, k.longitude, k.latitude, k.roll);
        (k.x, k.y, k.z) = (at.x, at.y, at.z);
        (k.longitude, k.latitude, k.roll) = (
            at.longitude.to_degrees(),
            at.latitude.to_degrees(),
            at.roll.to_degrees(),
        );
    }
    document
}
