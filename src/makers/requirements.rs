//! What a maker's inputs must satisfy together.

use crate::document::fault::{Fault, FaultCode, Place};
use crate::document::number::typed;
use crate::makers::maker::{Input, Kind, Maker, Requirement};
use crate::source::expression::{AngleUnit, ParameterValue, Parameters, evaluate};
use crate::source::scan::words;

/// Parameters as they stand in a document.
pub(crate) type Given = (String, ParameterValue);

/// Checks all; `given` are the parameters of the inputs, `derived` those that follow.
///
/// # Errors
/// The first that is not met, at the input that it is about.
pub(crate) fn check(
    maker: &Maker,
    inputs: &[(&Input, Vec<f64>)],
    given: &[Given],
    derived: &[Given],
    asked: &[(String, String)],
    unit: &str,
) -> Result<(), Fault> {
    for requirement in &maker.requires {
        let used = used(&requirement.positive, derived);
        let all: Vec<Given> = (given.iter().cloned())
            .chain(
                derived
                    .iter()
                    .filter(|(name, _)| used.contains(name))
                    .cloned(),
            )
            .collect();
        // What has no value, such as the root of a negative number, is not positive either.
        let value = Parameters::resolve(&all, AngleUnit::Degrees)
            .ok()
            .and_then(|all| evaluate(&requirement.positive, &all, AngleUnit::Degrees).ok());
        if !value.is_some_and(|value| value > 0.0) {
            return Err(not_met(requirement, &used, inputs, asked, unit));
        }
    }
    Ok(())
}

/// The names in an expression, and those in the expressions of the derived parameters among them.
fn used(expression: &str, derived: &[Given]) -> Vec<String> {
    let mut names: Vec<String> = words(expression).map(|(_, name)| name.to_owned()).collect();
    let mut next = 0;
    while let Some(name) = names.get(next) {
        next += 1;
        let found = derived.iter().find(|(derived, _)| derived == name);
        if let Some((_, ParameterValue::Expression(text))) = found {
            for (_, word) in words(text) {
                if !names.iter().any(|name| name == word) {
                    names.push(word.to_owned());
                }
            }
        }
    }
    names
}

fn not_met(
    requirement: &Requirement,
    used: &[String],
    inputs: &[(&Input, Vec<f64>)],
    asked: &[(String, String)],
    unit: &str,
) -> Fault {
    let about: Vec<_> = (inputs.iter())
        .filter(|(input, _)| input.parameters().iter().any(|name| used.contains(name)))
        .collect();
    let values: Vec<String> = about
        .iter()
        .map(|(input, values)| told(input, values, unit))
        .collect();
    let is_asked = |name: &str| asked.iter().any(|(asked, _)| asked == name);
    let place = about
        .iter()
        .find(|(input, _)| is_asked(&input.name))
        .or(about.first())
        .map_or("type", |(input, _)| input.name.as_str());
    let what = format!("{} with {}", requirement.otherwise, values.join(", "));
    let accepted = format!("sizes for which {} is above 0", requirement.positive);
    Fault::new(
        FaultCode::OutOfRange,
        &Place::WHOLE.field(place),
        &what,
        &accepted,
    )
}

/// Such as: arms 300, 580 mm.
pub(crate) fn told(input: &Input, values: &[f64], unit: &str) -> String {
    let values: Vec<String> = values.iter().map(|&value| typed(value)).collect();
    let unit = match input.is {
        Kind::Length => format!(" {unit}"),
        Kind::Angle => "\u{b0}".to_owned(),
        Kind::Number | Kind::Count | Kind::List => String::new(),
    };
    format!("{} {}{unit}", input.name, values.join(", "))
}
