//! Linkages as documents with few digits, and documents as short texts.

use serde_json::{Map, Value, json};
use synthetica::chain::Chain;
use synthetica::dh::DhRow;
use synthetica::document::{
    ChainEntry, Document, FrameEntry, JointEntry, KeyFrameEntry, MotionEntry, PlannerEntry,
    RowEntry, VERSION,
};
use synthetica::joint::Joint;
use synthetica::keyframe::Interpolation;
use synthetica::mechanism::Mechanism;
use synthetica::pose::{FrameCoordinates, Pose};

/// All digits, where decimals are asked for.
pub const EXACT: i32 = 0;

/// The linkage with numbers of so many decimals, standing still at its origin.
pub fn document(mechanism: &Mechanism, start: &[f64], decimals: i32) -> Document {
    let number = |x: f64| rounded(x, decimals);
    let row = |row: &DhRow| RowEntry {
        alpha: number(row.alpha.to_degrees()),
        a: number(row.a),
        theta: number(row.theta.to_degrees()),
        d: number(row.d),
    };
    let joint = |joint: &Joint| JointEntry {
        kind: joint.kind(),
        rows: joint.rows().iter().map(row).collect(),
        limits: None,
    };
    let chain = |(chain, values): (&Chain, &[f64])| ChainEntry {
        name: String::new(),
        base: frame(chain.base(), decimals),
        joints: chain.joints().iter().map(joint).collect(),
        gripper: frame(chain.gripper(), decimals),
        start: Some(
            (chain.turns().zip(values))
                .map(|(turns, &x)| number(if turns { x.to_degrees() } else { x }))
                .collect(),
        ),
    };
    Document {
        schema: None,
        version: VERSION,
        name: String::new(),
        about: String::new(),
        length_unit: String::new(),
        chains: mechanism.split(start).map(chain).collect(),
        motion: MotionEntry {
            key_frames: vec![KeyFrameEntry::default(); 2],
            interpolation: Interpolation::default(),
            frames: 33,
            radius: None,
        },
        planner: PlannerEntry::default(),
    }
}

/// The frame with numbers of so many decimals.
pub fn frame(pose: &Pose, decimals: i32) -> FrameEntry {
    let at = FrameCoordinates::from_pose(pose);
    FrameEntry {
        x: rounded(at.x, decimals),
        y: rounded(at.y, decimals),
        z: rounded(at.z, decimals),
        longitude: rounded(at.longitude.to_degrees(), decimals),
        latitude: rounded(at.latitude.to_degrees(), decimals),
        roll: rounded(at.roll.to_degrees(), decimals),
    }
}

/// The same as a key frame.
pub fn key(pose: &Pose, decimals: i32) -> KeyFrameEntry {
    let FrameEntry {
        x,
        y,
        z,
        longitude,
        latitude,
        roll,
    } = frame(pose, decimals);
    KeyFrameEntry {
        x,
        y,
        z,
        longitude,
        latitude,
        roll,
        ..KeyFrameEntry::default()
    }
}

/// The number with so many decimals.
pub fn rounded(x: f64, decimals: i32) -> f64 {
    if decimals == EXACT {
        return x;
    }
    let scale = (0..decimals).fold(1.0, |scale, _| 10.0 * scale);
    (x * scale).round() / scale
}

/// Without the fields that have their defaults, and 1 for 1.0.
pub fn compact(value: Value) -> Value {
    let default = |key: &str, value: &Value| {
        let words = ["", "bezier", "newton"];
        let said = value.as_str().is_some_and(|word| words.contains(&word));
        let empty = value.as_object().is_some_and(Map::is_empty);
        said || empty
            || value.is_null()
            || value.as_f64() == Some(0.0)
            || (key == "frames" && value == 33)
    };
    match value {
        Value::Object(fields) => (fields.into_iter())
            .map(|(key, value)| (key, compact(value)))
            .filter(|(key, value)| !default(key, value))
            .collect(),
        Value::Array(items) => items.into_iter().map(compact).collect(),
        Value::Number(number) => match number.as_f64() {
            #[expect(clippy::cast_possible_truncation, reason = "a whole number below 1e9")]
            Some(x) if x.fract() == 0.0 && x.abs() < 1e9 => json!(x as i64),
            _ => Value::Number(number),
        },
        Value::Null | Value::Bool(_) | Value::String(_) => value,
    }
}
