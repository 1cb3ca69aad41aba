//! Numbers, lengths and joint variables in words.

use crate::document::chain_report::chain;
use crate::document::fault::excerpt;
use crate::document::number::readable;
#[cfg(feature = "study")]
use crate::document::number::typed;
use crate::model::chain::Chain;
use crate::model::mechanism::Mechanism;
use crate::motion::trajectory::{Dimension, Suspect};

/// How a document's mechanism is spoken of.
#[derive(Clone, Copy, Debug)]
pub struct Wording<'a> {
    /// The mechanism.
    pub mechanism: &'a Mechanism,
    /// The label of the unit of length; may be empty.
    pub unit: &'a str,
}

impl Wording<'_> {
    /// Such as “θ₂ of chain 1”; variables count from 0 through all chains.
    pub fn variable(&self, variable: usize) -> String {
        let mut first = 0;
        for (i, own) in self.mechanism.chains().iter().enumerate() {
            if let Some(own_variable) = chain(own).variables.get(variable - first) {
                let label: String = own_variable.label.chars().map(subscript).collect();
                return format!("{label} of {}", self.chain(i));
            }
            first += own.freedoms();
        }
        String::new()
    }

    /// The chain's name, or its number.
    pub fn chain(&self, chain: usize) -> String {
        let name = self.mechanism.chains()[chain].name();
        if name.is_empty() {
            format!("chain {}", chain + 1)
        } else {
            excerpt(name)
        }
    }

    /// A value of a joint variable, rad or a length, with its unit.
    pub fn amount(&self, variable: usize, value: f64) -> String {
        let mut turns = self.mechanism.chains().iter().flat_map(Chain::turns);
        if turns.nth(variable).unwrap_or(false) {
            format!("{}°", readable(value.to_degrees()))
        } else {
            self.length(value)
        }
    }

    /// The same with nine digits, for a place that was searched for.
    #[cfg(feature = "study")]
    pub fn precise(&self, variable: usize, value: f64) -> String {
        let mut turns = self.mechanism.chains().iter().flat_map(Chain::turns);
        if turns.nth(variable).unwrap_or(false) {
            format!("{}°", typed(rounded(value.to_degrees())))
        } else {
            let value = typed(rounded(value));
            let space = if self.unit.is_empty() { "" } else { " " };
            format!("{value}{space}{}", self.unit)
        }
    }

    /// A length with its unit.
    pub fn length(&self, value: f64) -> String {
        if self.unit.is_empty() {
            readable(value)
        } else {
            format!("{} {}", readable(value), self.unit)
        }
    }

    /// Such as: the twist α of row 2 of chain 1, by 0.0002° more.
    pub fn suspect(&self, suspect: &Suspect) -> String {
        let what = match suspect.dimension {
            Dimension::Twist => "the twist α",
            Dimension::Length => "the link length a",
            Dimension::Angle => "the angle θ",
            Dimension::Offset => "the offset d",
        };
        let amount = match suspect.dimension {
            Dimension::Twist | Dimension::Angle => {
                format!("{}°", readable(suspect.change.abs().to_degrees()))
            }
            Dimension::Length | Dimension::Offset => self.length(suspect.change.abs()),
        };
        let side = if suspect.change < 0.0 { "less" } else { "more" };
        let (row, chain) = (suspect.row + 1, self.chain(suspect.chain));
        format!("{what} of row {row} of {chain}, by {amount} {side}")
    }
}

/// To nine digits.
#[cfg(feature = "study")]
fn rounded(value: f64) -> f64 {
    format!("{value:.8e}").parse().unwrap_or(value)
}

fn subscript(c: char) -> char {
    c.to_digit(10)
        .and_then(|digit| char::from_u32('₀' as u32 + digit))
        .unwrap_or(c)
}
