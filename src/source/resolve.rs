//! Parameters that are given as expressions of each other, in any order.

use crate::document::fault::excerpt;
use crate::document::number::typed;
use crate::source::expression::{ExpressionFault, evaluate, is_too_long};
use crate::source::functions::{AngleUnit, Function};
use crate::source::parameters::{MAX_PARAMETER_NAME, MAX_PARAMETERS, ParameterValue, Parameters};
use crate::source::scan::{name_end, words};

/// Most names of a circle in a message.
const MOST_TOLD: usize = 8;

/// The index of a parameter and what is wrong with it.
pub type ParameterFault = (usize, ExpressionFault);

impl Parameters {
    /// The parameters with these names, which may be given in any order, with the angles of their expressions in `unit`.
    ///
    /// # Errors
    ///
    /// If there are too many, if a name is none or is there twice, if a number is not finite, if an expression is none or
    /// has no finite value, or if parameters are given by each other in a circle. The fault of a name, of a number and of
    /// the count has no column.
    pub fn resolve(
        given: &[(String, ParameterValue)],
        unit: AngleUnit,
    ) -> Result<Self, ParameterFault> {
        let mut parameters = Self::default();
        for (index, (name, value)) in given.iter().enumerate() {
            let fault = match *value {
                _ if index == MAX_PARAMETERS => Some((
                    format!("there are more than {MAX_PARAMETERS} parameters"),
                    format!("at most {MAX_PARAMETERS}"),
                )),
                ParameterValue::Number(number) if !number.is_finite() => Some((
                    format!("{} is not a finite number", typed(number)),
                    "a number below 1.8e308".to_owned(),
                )),
                ParameterValue::Number(_) | ParameterValue::Expression(_) => {
                    parameters.refused(name, unit)
                }
            };
            if let Some((what, accepted)) = fault {
                let column = None;
                let fault = ExpressionFault {
                    what,
                    accepted,
                    column,
                };
                return Err((index, fault));
            }
            match *value {
                ParameterValue::Number(number) => parameters.add(name, number + 0.0, true),
                // Its value comes when those that it names have theirs.
                ParameterValue::Expression(_) => parameters.add(name, f64::NAN, false),
            }
        }
        let uses = given.iter().map(|(_, value)| parameters.used(value));
        for index in order(&uses.collect::<Vec<_>>()).map_err(|circle| circular(given, &circle))? {
            if let ParameterValue::Expression(text) = &given[index].1 {
                let value = evaluate(text, &parameters, unit).map_err(|fault| (index, fault))?;
                parameters.set(index, value);
            }
        }
        Ok(parameters)
    }

    /// What is wrong with a name, and what is accepted.
    fn refused(&self, name: &str, unit: AngleUnit) -> Option<(String, String)> {
        let quoted = excerpt(name);
        let taken = if Function::named(name).is_some() {
            "function"
        } else if name == "pi" {
            "constant"
        } else if unit.factor(name).is_some() {
            "unit"
        } else {
            ""
        };
        if name.chars().nth(MAX_PARAMETER_NAME).is_some() {
            let what = format!("the name “{quoted}” has more than {MAX_PARAMETER_NAME} characters");
            Some((what, format!("at most {MAX_PARAMETER_NAME} characters")))
        } else if name.is_empty() || name_end(name, 0) < name.len() {
            let accepted = "a letter or _, then letters, digits and _: base_2".to_owned();
            Some((format!("“{quoted}” is no name of a parameter"), accepted))
        } else if !taken.is_empty() {
            let accepted = "a name that expressions do not use otherwise".to_owned();
            Some((format!("“{name}” is the name of a {taken}"), accepted))
        } else if self.position(name).is_some() {
            let accepted = "each name once".to_owned();
            Some((format!("there is already a parameter “{name}”"), accepted))
        } else {
            None
        }
    }

    /// The indices of the parameters that a value names. A text that is too long is told as such and not read.
    fn used(&self, value: &ParameterValue) -> Vec<usize> {
        match value {
            ParameterValue::Expression(text) if !is_too_long(text) => words(text)
                .filter_map(|(_, name)| self.position(name))
                .collect(),
            ParameterValue::Expression(_) | ParameterValue::Number(_) => Vec::new(),
        }
    }
}

/// An order in which each comes after those that it uses.
///
/// # Errors
///
/// A circle, each using the next and the last the first, if there is one.
fn order(uses: &[Vec<usize>]) -> Result<Vec<usize>, Vec<usize>> {
    let mut order = Vec::new();
    let mut seen = vec![false; uses.len()];
    let mut done = vec![false; uses.len()];
    for first in 0..uses.len() {
        // Those that are being looked at, each used by the one before, and how many of its uses are done. A list, for 200
        // calls within each other could be too many for a browser's stack.
        let mut open: Vec<(usize, usize)> = Vec::new();
        let mut next = Some(first).filter(|&first| !seen[first]);
        loop {
            if let Some(index) = next {
                seen[index] = true;
                open.push((index, 0));
            }
            let Some((index, count)) = open.last_mut() else {
                break;
            };
            next = None;
            if let Some(&used) = uses[*index].get(*count) {
                *count += 1;
                if !seen[used] {
                    next = Some(used);
                } else if !done[used] {
                    let circle = open.iter().map(|(index, _)| *index);
                    return Err(circle.skip_while(|&index| index != used).collect());
                }
            } else {
                done[*index] = true;
                order.push(*index);
                open.pop();
            }
        }
    }
    Ok(order)
}

/// The fault of a circle, at the first of its parameters in the order in which they are given.
fn circular(given: &[(String, ParameterValue)], circle: &[usize]) -> ParameterFault {
    let start = (0..circle.len()).min_by_key(|&at| circle[at]).unwrap_or(0);
    let turned = |step: usize| circle[(start + step) % circle.len()];
    let name = |step: usize| given[turned(step)].0.as_str();
    let column = match &given[turned(0)].1 {
        ParameterValue::Number(_) => None,
        ParameterValue::Expression(text) => words(text)
            .find(|(_, word)| *word == name(1))
            .map(|(at, _)| text[..at].chars().count() + 1),
    };
    let mut names: Vec<_> = (0..=circle.len())
        .map(|step| format!("“{}”", name(step)))
        .collect();
    if names.len() > MOST_TOLD {
        names.drain(MOST_TOLD - 2..names.len() - 1);
        names.insert(MOST_TOLD - 2, "…".to_owned());
    }
    let what = if circle.len() == 1 {
        format!("“{}” is given by itself", name(0))
    } else {
        format!(
            "parameters are given by each other in a circle: {}",
            names.join(", by ")
        )
    };
    let accepted = "an expression of parameters that do not depend on this one".to_owned();
    (
        turned(0),
        ExpressionFault {
            what,
            accepted,
            column,
        },
    )
}
