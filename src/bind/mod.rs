//! The bindings to JavaScript: text in, copied columns and small objects out, no arithmetic.

pub mod wasm;
#[cfg(feature = "study")]
pub mod wasm_study;
