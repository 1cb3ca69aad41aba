//! Rigid displacements, screws, and small dense linear algebra; knows no linkage.

pub mod linalg;
pub mod pose;
pub mod random;
pub mod screw;
