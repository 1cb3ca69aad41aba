//! Rigid displacements, screws, and small dense linear algebra; knows no linkage.

pub mod cholesky;
pub mod dot;
pub mod gram_schmidt;
pub mod lanczos;
pub mod linalg;
pub mod metric;
pub mod norm;
#[cfg(feature = "study")]
pub mod orientation;
pub mod pose;
pub mod qr;
pub mod random;
pub mod screw;
pub mod sort;
pub mod svd;
pub mod symmetric;
