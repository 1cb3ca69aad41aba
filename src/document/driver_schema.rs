//! The drivers of a motion as a document has them: their fields, units and defaults.

use crate::motion::drivers::Ramp;
#[cfg(feature = "schema")]
use crate::{
    document::bounds::MAX_TIME, model::chain::MAX_FREEDOMS, model::mechanism::MAX_CHAINS,
    motion::key_frames::MAX_KEY_FRAMES,
};
use serde::{Deserialize, Serialize};

/// A driven joint variable. Chain, joint and freedom are counted from 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct DriverEntry {
    /// The chain.
    #[cfg_attr(feature = "schema", schemars(range(min = 1, max = MAX_CHAINS)))]
    pub chain: u32,
    /// The joint of that chain.
    #[cfg_attr(feature = "schema", schemars(range(min = 1, max = MAX_FREEDOMS)))]
    pub joint: u32,
    /// The freedom of that joint: of a C the turn is 1 and the shift 2.
    #[cfg_attr(feature = "schema", schemars(range(min = 1, max = 3)))]
    #[serde(default = "first_freedom")]
    pub freedom: u32,
    /// Two or more values, at times that increase; before the first and after the last the joint rests.
    #[cfg_attr(feature = "schema", schemars(length(min = 2, max = MAX_KEY_FRAMES)))]
    pub values: Vec<DriverValueEntry>,
    /// Between two values: at constant speed, or smoothly from rest to rest.
    #[serde(default, with = "RampName")]
    #[cfg_attr(feature = "schema", schemars(with = "RampName"))]
    pub ramp: Ramp,
}

fn first_freedom() -> u32 {
    1
}

/// The value of a driven joint variable at a time.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct DriverValueEntry {
    /// When.
    #[cfg_attr(feature = "schema", schemars(range(min = -MAX_TIME, max = MAX_TIME)))]
    pub time: f64,
    /// The value of the joint variable itself, degrees or a length: as in `start`, and beyond one turn where it goes on.
    pub value: f64,
}

/// The ramps by name.
#[derive(Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(remote = "Ramp", rename_all = "lowercase")]
enum RampName {
    Linear,
    Smooth,
}
