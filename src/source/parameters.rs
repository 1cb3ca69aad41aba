//! Numbers with names, in the order of their document.

use serde::Serialize;
use std::collections::BTreeMap;

/// Most parameters of a document.
pub const MAX_PARAMETERS: usize = 200;
/// Most characters of a parameter's name.
pub const MAX_PARAMETER_NAME: usize = 64;

/// What a parameter is given as.
#[derive(Clone, Debug, PartialEq)]
pub enum ParameterValue {
    /// A number: the parameter is an input.
    Number(f64),
    /// An expression, which may name other parameters.
    Expression(String),
}

/// A parameter with its value.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Parameter {
    /// A letter or `_`, then letters, digits and `_`.
    pub name: String,
    /// A length, an angle in the document's unit, or a share: what it is used as.
    pub value: f64,
    /// Whether it is given as a number, and not as an expression.
    pub input: bool,
}

/// What an expression of a document is.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExpressionValue {
    /// Its place in the document as it was typed: `chains[0].base.x`.
    pub path: String,
    /// A length, a time or a count, or an angle in the document's unit of angles.
    pub value: f64,
}

/// The parameters of a document. The default has none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Parameters {
    list: Vec<Parameter>,
    index: BTreeMap<String, usize>,
}

impl Parameters {
    /// All, in the order in which they are given.
    pub fn list(&self) -> &[Parameter] {
        &self.list
    }

    /// The value of this name.
    pub fn value(&self, name: &str) -> Option<f64> {
        self.position(name).map(|index| self.list[index].value)
    }

    /// The index in [`Parameters::list`].
    pub(super) fn position(&self, name: &str) -> Option<usize> {
        self.index.get(name).copied()
    }

    /// Adds one whose name is not there yet.
    pub(super) fn add(&mut self, name: &str, value: f64, input: bool) {
        self.index.insert(name.to_owned(), self.list.len());
        let name = name.to_owned();
        self.list.push(Parameter { name, value, input });
    }

    /// Gives a value to the one at this index.
    pub(super) fn set(&mut self, index: usize, value: f64) {
        self.list[index].value = value;
    }
}
