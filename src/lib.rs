//! Closest reachable motions of spatial linkages.

pub mod bounds;
pub mod chain;
pub mod closure;
pub mod defaults;
pub mod dh;
pub mod document;
pub mod enumerate;
pub mod fault;
pub mod gradient;
pub mod joint;
pub mod json;
pub mod keyframe;
pub mod linalg;
pub mod mechanism;
pub mod newton;
pub mod objective;
pub mod planner;
pub mod pose;
pub mod problem;
pub mod report;
mod spline;
pub mod start;
pub mod tangent;
pub mod trajectory;
pub mod trust_region;
#[cfg(target_arch = "wasm32")]
pub mod wasm;
