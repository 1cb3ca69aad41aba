//! Mechanisms that are made from the few numbers of their papers: each a file of data with a typed document whose numbers
//! are expressions of its inputs.

pub mod from_type;
pub mod list;
pub mod make;
pub mod maker;
mod repeat;
mod requirements;
