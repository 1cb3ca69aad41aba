//! The document, version 1: its fields, their units and their defaults.

#[cfg(feature = "study")]
use crate::document::driver_schema::DriverEntry;
use crate::math::metric::MetricKind;
use crate::model::joint::JointKind;
use crate::motion::goal::Interpolation;
use crate::plan::settings::{Method, Settings};
#[cfg(feature = "schema")]
use crate::{
    document::bounds::{
        MAX_ABOUT, MAX_ANGLE, MAX_DIMENSION_TOLERANCE, MAX_ITERATIONS, MAX_LENGTH, MAX_NAME,
        MAX_SCHEMA, MAX_TIME, MAX_UNIT, MIN_METRIC_LENGTH,
    },
    model::chain::MAX_FREEDOMS,
    model::mechanism::MAX_CHAINS,
    motion::goal::MAX_FRAMES,
    motion::key_frames::MAX_KEY_FRAMES,
};
use serde::{Deserialize, Serialize};

/// The version of the format that this crate reads and writes.
pub const VERSION: u32 = 1;

/// The name of the JSON Schema, its `$id`. Not an address: the project has no domain of its own, and a
/// name stays true wherever the schema is kept. The number is that of the format.
pub const SCHEMA_ID: &str = "urn:synthetica:document:1";

/// The JSON Schema (draft 2020-12) of a document, generated from the types of this module and
/// widened by what a person may write: see `source::schema`, with the feature of that name.
pub const SCHEMA: &str = include_str!("schema.json");

/// A mechanism, a goal motion and the planner's settings. Angles in degrees, lengths in the
/// document's own unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(
    feature = "schema",
    schemars(
        title = "Synthetica mechanism, version 1",
        extend("$id" = SCHEMA_ID)
    )
)]
#[serde(deny_unknown_fields)]
pub struct Document {
    /// Where an editor finds the schema of this document; kept, and not looked at.
    #[cfg_attr(feature = "schema", schemars(length(max = MAX_SCHEMA)))]
    #[serde(rename = "$schema", default, skip_serializing_if = "Option::is_none")]
    pub schema: Option<String>,
    /// Version of the format: 1.
    #[cfg_attr(feature = "schema", schemars(range(min = VERSION, max = VERSION)))]
    pub version: u32,
    /// Name of the mechanism.
    #[cfg_attr(feature = "schema", schemars(length(max = MAX_NAME)))]
    #[serde(default)]
    pub name: String,
    /// A sentence or two on it.
    #[cfg_attr(feature = "schema", schemars(length(max = MAX_ABOUT)))]
    #[serde(default)]
    pub about: String,
    /// Label of the unit of length, such as m.
    #[cfg_attr(feature = "schema", schemars(length(max = MAX_UNIT)))]
    #[serde(default)]
    pub length_unit: String,
    /// The chains that hold the workpiece.
    #[cfg_attr(feature = "schema", schemars(length(min = 1, max = MAX_CHAINS)))]
    pub chains: Vec<ChainEntry>,
    /// The goal motion.
    pub motion: MotionEntry,
    /// How the closest motion is found.
    #[serde(default)]
    pub planner: PlannerEntry,
}

/// A serial chain from the fixed frame to the workpiece.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ChainEntry {
    /// Name of the chain; without one it is called "chain" and its number.
    #[cfg_attr(feature = "schema", schemars(length(max = MAX_NAME)))]
    #[serde(default)]
    pub name: String,
    /// G, the base of the chain in the fixed frame.
    #[serde(default)]
    pub base: FrameEntry,
    /// The joints from the base on; one to five freedoms together.
    #[cfg_attr(feature = "schema", schemars(length(min = 1, max = MAX_FREEDOMS)))]
    pub joints: Vec<JointEntry>,
    /// H, the workpiece in the frame behind the last joint.
    #[serde(default)]
    pub gripper: FrameEntry,
    /// Joint values, one a freedom, that choose the assembly mode; found where not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<Vec<f64>>,
}

/// A joint: its type, its rows of the Denavit–Hartenberg table, its limits.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct JointEntry {
    /// Revolute, prismatic, cylindric, universal, spherical or planar.
    #[serde(rename = "type", with = "JointLetter")]
    #[cfg_attr(feature = "schema", schemars(with = "JointLetter"))]
    pub kind: JointKind,
    /// R, P, C: one row. T: two. S: three. E: three, slider, slider, axis. The rows after the first
    /// have alpha ±90 and a 0; the middle one of an S has d 0, that of an E theta ±90.
    #[cfg_attr(feature = "schema", schemars(length(min = 1, max = 3)))]
    pub rows: Vec<RowEntry>,
    /// One entry a freedom; null for none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub limits: Option<Vec<Option<LimitsEntry>>>,
}

/// The joint types as letters.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(remote = "JointKind")]
enum JointLetter {
    R,
    P,
    C,
    T,
    S,
    E,
}

/// A row of the table: X(alpha, a) · Z(theta, d), the joint's variable added to theta, d or both.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct RowEntry {
    /// Twist of the link about x, degrees.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_ANGLE, max = MAX_ANGLE)))]
    pub alpha: f64,
    /// Length of the link along x.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_LENGTH, max = MAX_LENGTH)))]
    pub a: f64,
    /// Constant rotation about z, degrees.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_ANGLE, max = MAX_ANGLE)))]
    pub theta: f64,
    /// Constant shift along z.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_LENGTH, max = MAX_LENGTH)))]
    pub d: f64,
}

/// The range of a joint variable, degrees or lengths; open where not given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct LimitsEntry {
    /// Smallest value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub min: Option<f64>,
    /// Largest value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max: Option<f64>,
}

/// A frame: origin, and the rotation Y(longitude) · X(−latitude) · Z(roll), degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct FrameEntry {
    /// Origin.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_LENGTH, max = MAX_LENGTH)))]
    pub x: f64,
    /// Origin.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_LENGTH, max = MAX_LENGTH)))]
    pub y: f64,
    /// Origin.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_LENGTH, max = MAX_LENGTH)))]
    pub z: f64,
    /// Rotation about the fixed y axis, degrees.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_ANGLE, max = MAX_ANGLE)))]
    pub longitude: f64,
    /// Rotation about −x, before the longitude, degrees.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_ANGLE, max = MAX_ANGLE)))]
    pub latitude: f64,
    /// Rotation about z, first of the three, degrees.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_ANGLE, max = MAX_ANGLE)))]
    pub roll: f64,
}

/// The motion: key frames and what is between them, or driven joints.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(
    feature = "schema",
    schemars(extend("oneOf" = [{"required": ["key_frames"]}, {"required": ["drivers"]}]))
)]
#[serde(deny_unknown_fields)]
pub struct MotionEntry {
    /// Two or more poses of the workpiece.
    #[cfg_attr(feature = "schema", schemars(length(min = 2, max = MAX_KEY_FRAMES)))]
    #[cfg_attr(
        feature = "study",
        serde(default, skip_serializing_if = "Vec::is_empty")
    )]
    pub key_frames: Vec<KeyFrameEntry>,
    /// In place of key frames: joint variables whose values over time are given. The workpiece's path is then the result.
    #[cfg(feature = "study")]
    #[cfg_attr(feature = "schema", schemars(length(min = 1)))]
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub drivers: Vec<DriverEntry>,
    /// The paper's double-quaternion spline, steady screw motions, or straight lines.
    #[serde(default, with = "InterpolationName")]
    #[cfg_attr(feature = "schema", schemars(with = "InterpolationName"))]
    pub interpolation: Interpolation,
    /// Number of frames, equally spaced in time.
    #[serde(default = "default_frames")]
    #[cfg_attr(feature = "schema", schemars(range(min = 2, max = MAX_FRAMES)))]
    pub frames: u32,
    /// The point x, y, z about which the double quaternions interpolate; null for the mean of the key
    /// frames' positions. The paper's is the origin of the fixed frame.
    #[cfg_attr(
        feature = "schema",
        schemars(length(equal = 3), inner(range(min = -MAX_LENGTH, max = MAX_LENGTH)))
    )]
    #[serde(default)]
    pub reference: Option<Vec<f64>>,
    /// Radius of the double quaternions, large against the workspace; null for 20 times the distance
    /// of the farthest key frame from the reference point.
    #[cfg_attr(feature = "schema", schemars(range(min = 0.0, max = MAX_LENGTH)))]
    #[serde(default)]
    pub radius: Option<f64>,
}

/// As many as the paper's figures have; two key frames with one between fall on frames.
pub(crate) fn default_frames() -> u32 {
    33
}

/// The interpolations by name.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(remote = "Interpolation", rename_all = "lowercase")]
enum InterpolationName {
    Bezier,
    Sclerp,
    Straight,
}

/// A pose of the workpiece that the goal motion meets; see the frame of a chain.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct KeyFrameEntry {
    /// Name of the key frame.
    #[cfg_attr(feature = "schema", schemars(length(max = MAX_NAME)))]
    pub name: String,
    /// Origin.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_LENGTH, max = MAX_LENGTH)))]
    pub x: f64,
    /// Origin.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_LENGTH, max = MAX_LENGTH)))]
    pub y: f64,
    /// Origin.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_LENGTH, max = MAX_LENGTH)))]
    pub z: f64,
    /// Rotation about the fixed y axis, degrees.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_ANGLE, max = MAX_ANGLE)))]
    pub longitude: f64,
    /// Rotation about −x, before the longitude, degrees.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_ANGLE, max = MAX_ANGLE)))]
    pub latitude: f64,
    /// Rotation about z, first of the three, degrees.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_ANGLE, max = MAX_ANGLE)))]
    pub roll: f64,
    /// When; all key frames have a time or none has.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_TIME, max = MAX_TIME)))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub time: Option<f64>,
}

/// The planner's settings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct PlannerEntry {
    /// Newton's method, or the paper's projected gradient.
    #[serde(with = "MethodName")]
    #[cfg_attr(feature = "schema", schemars(with = "MethodName"))]
    pub method: Method,
    /// How the distance between two poses is measured: `pose` about the goal's origin, `dual-quaternion` about
    /// `metric_origin`, as in the paper.
    #[serde(with = "MetricName")]
    #[cfg_attr(feature = "schema", schemars(with = "MetricName"))]
    pub metric: MetricKind,
    /// A translation by this length weighs as much as a rotation by 1 rad; the paper's is 1. Null for a length of the
    /// mechanism: its longest chain or the span of its bases; for a mechanism without lengths the extent of the motion.
    #[cfg_attr(feature = "schema", schemars(range(min = MIN_METRIC_LENGTH, max = MAX_LENGTH)))]
    pub metric_length: Option<f64>,
    /// The point, x y z in the fixed frame, about which the metric `dual-quaternion` measures; null for the fixed
    /// frame's origin.
    #[cfg_attr(feature = "schema", schemars(length(equal = 3), inner(range(min = -MAX_LENGTH, max = MAX_LENGTH))))]
    pub metric_origin: Option<Vec<f64>>,
    /// How far the dimensions of an overconstrained linkage may contradict each other and still count as rounded, as a
    /// share of the mechanism's size and in rad; 0 for exact dimensions only.
    #[cfg_attr(feature = "schema", schemars(range(min = 0.0, max = MAX_DIMENSION_TOLERANCE)))]
    pub dimension_tolerance: f64,
    /// Iterations a frame may take; null for the method's own limit.
    #[cfg_attr(feature = "schema", schemars(range(min = 1, max = MAX_ITERATIONS)))]
    pub max_iterations: Option<u32>,
}

/// The planners by name.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(remote = "Method", rename_all = "lowercase")]
enum MethodName {
    Newton,
    Gradient,
}

/// The metrics by name.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(remote = "MetricKind", rename_all = "kebab-case")]
enum MetricName {
    Pose,
    DualQuaternion,
}

impl Default for PlannerEntry {
    fn default() -> Self {
        let Settings {
            method,
            metric,
            metric_length,
            metric_origin,
            dimension_tolerance,
            max_iterations,
        } = Settings::default();
        let max_iterations = max_iterations.and_then(|most| u32::try_from(most).ok());
        Self {
            method,
            metric,
            metric_length,
            metric_origin: metric_origin.map(|point| point.as_slice().to_vec()),
            dimension_tolerance,
            max_iterations,
        }
    }
}
