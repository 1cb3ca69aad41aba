//! Many frames: where a motion starts, the branch followed, one configuration moved by hand.

pub mod configuration;
#[cfg(feature = "study")]
pub mod driven;
#[cfg(feature = "study")]
pub mod driven_start;
pub mod elsewhere;
pub mod follow;
pub mod given;
pub mod leaps;
pub mod modes;
mod one_chain;
pub mod planning;
pub mod predict;
pub mod record;
mod seeds;
pub mod settings;
