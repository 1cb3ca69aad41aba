//! The bindings to JavaScript: text in, copied columns and small objects out, no arithmetic.

#[cfg(feature = "study")]
mod searches;
pub mod wasm;
#[cfg(feature = "study")]
pub mod wasm_best;
#[cfg(feature = "study")]
pub mod wasm_study;
