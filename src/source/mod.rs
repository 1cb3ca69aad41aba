//! What a person may type where a plain document has a number.

pub mod expression;
mod functions;
mod nearest;
pub mod parameters;
pub mod resolve;
mod scan;
