//! Closest reachable motions of spatial linkages.

pub mod chain;
pub mod closure;
pub mod dh;
pub mod enumerate;
pub mod gradient;
pub mod joint;
pub mod keyframe;
pub mod linalg;
pub mod mechanism;
pub mod newton;
pub mod objective;
pub mod planner;
pub mod pose;
pub mod tangent;
pub mod trajectory;
pub mod trust_region;
