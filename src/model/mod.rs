//! The linkage: joints as Denavit–Hartenberg rows, serial chains, the chains that hold one workpiece.

pub mod chain;
pub mod dh;
pub mod joint;
pub mod mechanism;
pub mod scaled;
