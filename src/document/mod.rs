//! The document format: text, schema, checks, faults, and the questions asked of a document.

pub mod bounds;
pub mod defaults;
pub mod fault;
pub mod problem;
pub mod questions;
mod reader;
pub mod report;
pub mod schema;
pub mod session;
pub mod text;
