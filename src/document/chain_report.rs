//! A chain as a page reads it: its type, the names and units of its variables, the rows of its table.

use crate::model::chain::Chain;
use crate::model::joint::Moves;
use crate::types::enumerate;
use serde::Serialize;

/// A chain's type and variables.
#[derive(Clone, Debug, Serialize)]
pub struct ChainReport {
    /// The document's name for it.
    pub name: String,
    /// Such as TPR.
    #[serde(rename = "type")]
    pub kind: String,
    /// Degrees of freedom.
    pub freedoms: usize,
    /// Degree of constraint U (Eq. 8).
    pub constraints: usize,
    /// The category of Table 2, such as II.
    pub category: &'static str,
    /// The joint variables, in the order of the columns.
    pub variables: Vec<VariableReport>,
    /// The rows of the table.
    pub rows: Vec<RowReport>,
}

/// A joint variable.
#[derive(Clone, Debug, Serialize)]
pub struct VariableReport {
    /// θ or d with the number of its row, from 1, as the paper's tables print it.
    pub label: String,
    /// `rad` or `length`.
    pub unit: &'static str,
    /// The joint, from 0.
    pub joint: usize,
    /// The row within the chain, from 0.
    pub row: usize,
}

/// A row of a Denavit–Hartenberg table.
#[derive(Clone, Debug, Serialize)]
pub struct RowReport {
    /// The letter of the joint that the row belongs to.
    pub kind: char,
    /// The joint, from 0.
    pub joint: usize,
}

/// A chain in names and units.
pub fn chain(chain: &Chain) -> ChainReport {
    let mut variables = Vec::new();
    let mut rows = Vec::new();
    for (j, joint) in chain.joints().iter().enumerate() {
        let kind = joint.kind();
        for i in 0..joint.rows().len() {
            let row = rows.len();
            let mut variable = |letter: char, unit| {
                let label = format!("{letter}{}", row + 1);
                variables.push(VariableReport {
                    label,
                    unit,
                    joint: j,
                    row,
                });
            };
            let moves = kind.moves(i);
            if moves != Moves::Slides {
                variable('θ', "rad");
            }
            if moves != Moves::Turns {
                variable('d', "length");
            }
            rows.push(RowReport {
                kind: kind.letter(),
                joint: j,
            });
        }
    }
    ChainReport {
        name: chain.name().to_owned(),
        kind: chain.type_name(),
        freedoms: chain.freedoms(),
        constraints: chain.constraints(),
        // A single R or P: the trivial case that Section 4 leaves out of its categories.
        category: enumerate::category_name(chain.constraints()).unwrap_or("V"),
        variables,
        rows,
    }
}
