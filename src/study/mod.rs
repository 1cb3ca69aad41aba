//! Answers about one position: why no closer, the planners' iterations, the paper's matrix.

pub mod iterations;
pub mod matrix;
pub mod why;
