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
mod spline;
pub mod tangent;
pub mod trajectory;
pub mod trust_region;
