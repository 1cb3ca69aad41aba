//! What is wrong with an expression or a parameter, and at which character.

use std::fmt;

/// Why a text is no expression, or has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExpressionFault {
    /// What is wrong; a part of a sentence without a stop at the end.
    pub what: String,
    /// What would be accepted there; likewise.
    pub accepted: String,
    /// The character of the text, from 1, where it is wrong; one past the last where something is missing at the end. None
    /// where it is not the text but the name, the number or the count of parameters.
    pub column: Option<usize>,
}

impl fmt::Display for ExpressionFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, accepted, .. } = self;
        if let Some(column) = self.column {
            write!(f, "character {column}: ")?;
        }
        write!(f, "{what}. Accepted: {accepted}.")
    }
}

impl std::error::Error for ExpressionFault {}
