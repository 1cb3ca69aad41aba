//! Many frames: where a motion starts, the branch followed, one configuration moved by hand.

pub mod configuration;
#[cfg(feature = "study")]
pub mod driven;
pub mod elsewhere;
pub mod follow;
pub mod given;
pub mod leaps;
pub mod modes;
mod one_chain;
#[cfg(feature = "study")]
pub mod planning;
pub mod record;
mod seeds;
pub mod settings;

#[cfg(not(feature = "study"))]
pub use follow::Planning;
#[cfg(feature = "study")]
pub use planning::Planning;
