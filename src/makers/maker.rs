//! What a maker is: the inputs of a mechanism with the numbers of their paper, what they must satisfy, and the document.

use crate::document::reader::Node;
use serde::{Deserialize, Deserializer, Serialize};

/// A mechanism that is made from a few numbers.
#[derive(Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Maker {
    /// A short word or name, such as delta or 3-rps.
    pub name: String,
    /// Other names.
    #[serde(default)]
    pub also: Vec<String>,
    /// What people call it, such as Delta robot with rotary arms.
    pub title: String,
    /// The group of the gallery in which it is shown.
    pub group: String,
    /// Where its default numbers are from: author, title, year, page or table.
    pub source: String,
    /// What it is, what to look at, and what was modelled how.
    pub about: String,
    /// The unit of its default lengths.
    pub unit: String,
    /// The workpiece's and the chains' freedoms by the rank of the loop equations at the home position.
    pub mobility: usize,
    /// The numbers that are asked for.
    pub inputs: Vec<Input>,
    /// What the inputs must satisfy together.
    #[serde(default)]
    pub requires: Vec<Requirement>,
    /// A typed document; its parameters are those derived from the inputs.
    #[serde(skip_serializing)]
    pub(crate) document: Node,
}

/// A number that is asked for, or several that belong together.
#[derive(Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Input {
    /// The name of the option, and of the parameter where there is one only.
    pub name: String,
    /// The names of the parameters where there are several, which are given with commas between them.
    #[serde(default)]
    pub parts: Vec<String>,
    /// The default: one number for each parameter, or the entries of a list.
    #[serde(deserialize_with = "numbers")]
    pub value: Vec<f64>,
    /// What kind of number it is.
    pub is: Kind,
    /// Whether a length may be 0 or negative.
    #[serde(default)]
    pub signed: bool,
    /// The smallest and the largest value; of a list, of its entries.
    #[serde(default)]
    pub range: Option<[f64; 2]>,
    /// What it measures.
    pub meaning: String,
}

/// The kinds of inputs. In JSON in lower case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// In the unit of length; above 0 where it is not signed.
    Length,
    /// In degrees.
    Angle,
    /// A number without a unit, such as a ratio.
    Number,
    /// A whole number.
    Count,
    /// Different whole numbers, such as the legs that are locked; no parameter.
    List,
}

/// What the inputs must satisfy together.
#[derive(Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Requirement {
    /// An expression of inputs and derived parameters whose value must be above 0.
    pub positive: String,
    /// What is wrong where it is not: a part of a sentence without a stop at the end.
    #[serde(rename = "else")]
    pub otherwise: String,
}

impl Input {
    /// The names of its parameters; none of a list.
    pub fn parameters(&self) -> &[String] {
        match self.is {
            Kind::List => &[],
            Kind::Length | Kind::Angle | Kind::Number | Kind::Count if self.parts.is_empty() => {
                std::slice::from_ref(&self.name)
            }
            Kind::Length | Kind::Angle | Kind::Number | Kind::Count => &self.parts,
        }
    }
}

/// A number or a list of numbers.
fn numbers<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<f64>, D::Error> {
    let number = |node: &Node| match node {
        Node::Number(number) => Ok(*number),
        Node::Null | Node::Bool(_) | Node::Text(_) | Node::List(_) | Node::Object(_) => {
            Err(serde::de::Error::custom("the default is no number"))
        }
    };
    match Node::deserialize(deserializer)? {
        Node::List(items) => items.iter().map(number).collect(),
        other
        @ (Node::Null | Node::Bool(_) | Node::Number(_) | Node::Text(_) | Node::Object(_)) => {
            Ok(vec![number(&other)?])
        }
    }
}
