//! Small dense linear algebra under one name.
//!
//! nalgebra's SVD returns wrong values on about one in a thousand to twenty thousand matrices of
//! the kind met here (its issue 1172), most often rank-deficient ones, and lacks the null space;
//! its factorisations also allocate. Matrices are slices, one column after the other.

pub use crate::math::cholesky::{cholesky, solve_lower, solve_lower_transposed};
pub use crate::math::dot::dot;
pub use crate::math::qr::PivotedQr;
pub use crate::math::svd::{Svd, SvdFactors, svd};
pub use crate::math::symmetric::symmetric_eigen;
