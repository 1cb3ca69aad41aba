//! A document as a person writes it: expressions, chains by their axes, tables and frames in other conventions. It is
//! turned into a plain document, of which everything else knows, and what was typed is kept.

#[cfg(not(feature = "study"))]
pub mod plain;
pub mod session;

#[cfg(feature = "study")]
mod chains;
#[cfg(feature = "study")]
mod convention;
#[cfg(feature = "study")]
pub mod expression;
#[cfg(feature = "study")]
mod expression_fault;
#[cfg(feature = "study")]
mod frames;
#[cfg(feature = "study")]
mod functions;
#[cfg(feature = "study")]
pub(crate) mod nearest;
#[cfg(feature = "study")]
mod nodes;
#[cfg(feature = "study")]
pub mod overrides;
#[cfg(feature = "study")]
pub mod parameters;
#[cfg(feature = "study")]
pub mod resolve;
#[cfg(feature = "study")]
pub mod rewrite;
#[cfg(feature = "study")]
pub(crate) mod scan;
#[cfg(feature = "schema")]
pub mod schema;
#[cfg(feature = "study")]
mod standard;
#[cfg(feature = "study")]
pub mod typed;
#[cfg(feature = "study")]
mod values;
