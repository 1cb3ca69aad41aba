//! Many frames: where a motion starts, the branch followed, one configuration moved by hand.

pub mod follow;
pub mod given;
mod inner;
pub mod modes;
mod seeds;
