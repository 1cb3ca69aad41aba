//! One frame: the linkage to first and second order, loops closed, the closest pose found.

pub mod drive;
pub mod gradient;
pub mod loop_factor;
pub mod newton;
pub mod objective;
pub mod paper_matrix;
pub mod singular_values;
pub mod tangent;
pub mod trust_region;
