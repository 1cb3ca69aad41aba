//! The document format: text, schema, checks, faults, and the questions asked of a document.

#[cfg(feature = "study")]
pub mod best_report;
pub mod bounds;
pub mod chain_report;
pub mod comparison;
pub mod defaults;
#[cfg(feature = "study")]
pub mod driver_schema;
#[cfg(feature = "study")]
mod drivers;
pub mod example_document;
pub mod fault;
pub mod make;
#[cfg(feature = "study")]
pub mod modes_report;
mod motion;
pub mod number;
pub(crate) mod parts;
#[cfg(any(test, all(target_arch = "wasm32", not(feature = "study"))))]
pub(crate) mod plain_json;
mod planner;
pub mod problem;
pub mod questions;
pub(crate) mod reader;
pub(crate) mod refusal;
pub mod report;
pub mod schema;
pub mod text;
pub mod warnings;
pub mod wording;
