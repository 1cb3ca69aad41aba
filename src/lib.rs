//! Closest reachable motions of spatial linkages.

pub mod chain;
pub mod dh;
pub mod enumerate;
pub mod joint;
pub mod linalg;
pub mod mechanism;
pub mod pose;
