//! One frame: the linkage to first and second order, loops closed, the closest pose found.

mod chain_tangent;
pub mod close;
pub mod close_start;
pub mod dependent;
mod direct;
pub mod drive;
pub mod free;
pub mod gradient;
mod guarded;
pub mod limits;
mod loop_factor;
mod loop_normal;
pub mod newton;
mod newton_step;
pub mod objective;
pub mod paper_matrix;
pub mod singular_values;
#[cfg(feature = "study")]
pub mod slopes;
pub mod solver;
#[cfg(feature = "study")]
pub mod steer;
pub mod suspect;
pub mod tangent;
pub mod trust_region;
