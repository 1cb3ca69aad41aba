//! The linkage: joints as Denavit–Hartenberg rows, serial chains, the chains that hold one workpiece.

#[cfg(feature = "study")]
pub mod by_axes;
pub mod chain;
pub mod dh;
pub mod joint;
pub mod mechanism;
#[cfg(feature = "study")]
pub mod rows;
pub mod scaled;
