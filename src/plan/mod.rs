//! Many frames: where a motion starts, the branch followed, one configuration moved by hand.

#[cfg(feature = "study")]
pub mod assemblies;
#[cfg(feature = "study")]
pub mod best;
#[cfg(feature = "study")]
mod between;
#[cfg(feature = "study")]
mod branches;
#[cfg(feature = "study")]
mod building;
#[cfg(feature = "study")]
mod calm;
#[cfg(feature = "study")]
pub mod calm_form;
#[cfg(feature = "study")]
mod candidates;
pub mod configuration;
#[cfg(feature = "study")]
mod configurations;
#[cfg(feature = "study")]
pub mod driven;
#[cfg(feature = "study")]
pub mod driven_start;
pub mod elsewhere;
pub mod follow;
#[cfg(feature = "study")]
pub mod found;
pub mod given;
pub mod leaps;
pub mod modes;
mod one_chain;
#[cfg(feature = "study")]
pub mod path;
#[cfg(feature = "study")]
pub mod places;
pub mod planning;
pub mod predict;
#[cfg(feature = "study")]
mod reach;
pub mod record;
#[cfg(feature = "study")]
mod roads;
#[cfg(feature = "study")]
mod route;
mod seeds;
pub mod settings;
#[cfg(feature = "study")]
mod starts;
#[cfg(feature = "study")]
mod task;
#[cfg(feature = "study")]
mod tracks;
#[cfg(feature = "study")]
pub mod unseen;
pub mod walk;
