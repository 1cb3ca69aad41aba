//! One frame: the linkage to first and second order, loops closed, the closest pose found.

pub mod drive;
pub mod gradient;
pub mod newton;
pub mod objective;
pub mod paper_matrix;
pub mod tangent;
pub mod trust_region;
