//! Expressions become numbers, and radians degrees.

use crate::document::fault::{Fault, FaultCode, Place, excerpt};
use crate::document::reader::Node;
use crate::model::joint::JointKind;
use crate::source::expression::{
    AngleUnit, ExpressionFault, ParameterValue, Parameters, evaluate as value_of,
};
use crate::source::parameters::ExpressionValue;

/// The fields that hold a number, or lists of numbers.
pub(crate) const NUMBERS: [&str; 32] = [
    "x",
    "y",
    "z",
    "longitude",
    "latitude",
    "roll",
    "quaternion_wxyz",
    "quaternion_xyzw",
    "matrix",
    "roll_pitch_yaw",
    "alpha",
    "a",
    "theta",
    "d",
    "min",
    "max",
    "start",
    "point",
    "axis",
    "second",
    "time",
    "value",
    "chain",
    "joint",
    "freedom",
    "frames",
    "reference",
    "radius",
    "metric_length",
    "metric_origin",
    "dimension_tolerance",
    "max_iterations",
];

/// Those of the fields whose number may be null; the time of a driver's value may not.
const OPTIONAL: [&str; 6] = [
    ".min",
    ".max",
    ".time",
    ".radius",
    ".metric_length",
    ".max_iterations",
];

/// What `angles` may say.
const UNITS: [(&str, AngleUnit); 2] = [
    ("degrees", AngleUnit::Degrees),
    ("radians", AngleUnit::Radians),
];

/// A document's texts with numbers in place of expressions, angles in degrees; its parameters are
/// taken out. Answers with the parameters, and the value of each expression.
///
/// # Errors
/// Where an expression has no value.
pub(crate) fn evaluate(node: &mut Node) -> Result<(Parameters, Vec<ExpressionValue>), Fault> {
    let unit = unit(node)?;
    let parameters = parameters(node, unit)?;
    let mut expressions = Vec::new();
    let mut read = |text: &str, place: &Place<'_>| {
        let value = value_of(text, &parameters, unit);
        let value = value.map_err(|fault| {
            if is_word(text, &parameters) {
                let accepted = "a number, or an expression such as 2*pi";
                return Node::Text(text.to_owned()).is_not(accepted).fault(place);
            }
            told(&fault, Some(text), place)
        });
        let value = value.map_err(|fault| {
            let path = &fault.place;
            let optional = OPTIONAL.iter().any(|name| path.ends_with(name));
            if optional && !path.contains("drivers") {
                fault.or_null()
            } else {
                fault
            }
        })?;
        let path = place.path();
        expressions.push(ExpressionValue { path, value });
        Ok(value)
    };
    for (name, value) in node.fields_mut() {
        let place = Place::WHOLE.field(name);
        numbers(value, name, &place, &mut read)?;
    }
    if unit == AngleUnit::Radians {
        to_degrees(node);
    }
    Ok((parameters, expressions))
}

fn unit(node: &mut Node) -> Result<AngleUnit, Fault> {
    let Some(given) = node.take("angles") else {
        return Ok(AngleUnit::Degrees);
    };
    let found = UNITS.iter().find(|(name, _)| given.as_text() == Some(name));
    found.map(|(_, unit)| *unit).ok_or_else(|| {
        let accepted = "degrees or radians";
        given.is_not(accepted).fault(&Place::WHOLE.field("angles"))
    })
}

fn parameters(node: &mut Node, unit: AngleUnit) -> Result<Parameters, Fault> {
    const PLACE: Place<'static> = Place::WHOLE.field("parameters");
    const ACCEPTED: &str = "a number or an expression in quotes";
    let fields = match node.take("parameters") {
        None | Some(Node::Null) => Vec::new(),
        Some(Node::Object(fields)) => fields,
        Some(other) => {
            let accepted = "an object of names with numbers or expressions";
            return Err(other.is_not(accepted).fault(&PLACE));
        }
    };
    let mut given = Vec::with_capacity(fields.len());
    for (name, value) in fields {
        let value = match value {
            Node::Number(value) => ParameterValue::Number(value),
            Node::Text(text) => ParameterValue::Expression(text),
            other @ (Node::Null | Node::Bool(_) | Node::List(_) | Node::Object(_)) => {
                return Err(other.is_not(ACCEPTED).fault(&PLACE.field(&name)));
            }
        };
        given.push((name, value));
    }
    Parameters::resolve(&given, unit)
        .map_err(|(index, fault)| told(&fault, None, &PLACE.field(&given[index].0)))
}

/// Is it text in a document without parameters, and nothing of an expression?
fn is_word(text: &str, parameters: &Parameters) -> bool {
    parameters.list().is_empty() && !text.contains(['+', '*', '/', '^', '(', ')'])
}

/// Puts a value in the place of each expression below.
fn numbers(
    node: &mut Node,
    field: &str,
    place: &Place<'_>,
    read: &mut dyn FnMut(&str, &Place<'_>) -> Result<f64, Fault>,
) -> Result<(), Fault> {
    match node {
        Node::Text(text) if NUMBERS.contains(&field) => {
            let number = read(text, place)?;
            *node = Node::Number(number);
        }
        Node::List(items) => {
            for (i, item) in items.iter_mut().enumerate() {
                let name = item.name().to_owned();
                numbers(item, field, &place.named(i, &name), read)?;
            }
        }
        Node::Object(fields) => {
            for (name, item) in fields {
                numbers(item, name, &place.field(name), read)?;
            }
        }
        Node::Null | Node::Bool(_) | Node::Number(_) | Node::Text(_) => {}
    }
    Ok(())
}

fn told(fault: &ExpressionFault, text: Option<&str>, place: &Place<'_>) -> Fault {
    let what = match text {
        Some(text) => format!("in \u{201c}{}\u{201d} {}", excerpt(text), fault.what),
        None => fault.what.clone(),
    };
    Fault::new(FaultCode::WrongType, place, &what, &fault.accepted)
}

/// Angles from radians to degrees.
fn to_degrees(document: &mut Node) {
    if let Some(home) = document.field_mut("home") {
        angles(home, FRAME);
    }
    let mut kinds = Vec::new();
    for chain in document
        .field_mut("chains")
        .map_or(&mut [][..], Node::items_mut)
    {
        kinds.push(chain_to_degrees(chain));
    }
    let Some(motion) = document.field_mut("motion") else {
        return;
    };
    for key in motion
        .field_mut("key_frames")
        .map_or(&mut [][..], Node::items_mut)
    {
        angles(key, FRAME);
    }
    for driver in motion
        .field_mut("drivers")
        .map_or(&mut [][..], Node::items_mut)
    {
        // Counted from 1; what is no such joint is refused where drivers are read.
        let index = |name: &str| match driver.field(name) {
            Some(Node::Number(number)) => (1.0..1e3).contains(number).then(|| whole(*number) - 1),
            _ => None,
        };
        let joints = index("chain").and_then(|chain| kinds.get(chain));
        let kind = index("joint").and_then(|joint| *joints?.get(joint)?);
        let freedom = index("freedom").unwrap_or(0);
        if kind.is_some_and(|kind| kind.turns(freedom)) {
            for value in driver
                .field_mut("values")
                .map_or(&mut [][..], Node::items_mut)
            {
                angles(value, &["value"]);
            }
        }
    }
}

const FRAME: &[&str] = &["longitude", "latitude", "roll", "roll_pitch_yaw"];

/// Of a chain; answers with the kinds of its joints.
fn chain_to_degrees(chain: &mut Node) -> Vec<Option<JointKind>> {
    for name in ["base", "gripper"] {
        if let Some(frame) = chain.field_mut(name) {
            angles(frame, FRAME);
        }
    }
    let mut kinds = Vec::new();
    for joint in chain
        .field_mut("joints")
        .map_or(&mut [][..], Node::items_mut)
    {
        let kind = kind(joint);
        kinds.push(kind);
        for row in joint.field_mut("rows").map_or(&mut [][..], Node::items_mut) {
            angles(row, &["alpha", "theta"]);
        }
        let limits = joint
            .field_mut("limits")
            .map_or(&mut [][..], Node::items_mut);
        for (freedom, limits) in limits.iter_mut().enumerate() {
            if kind.is_some_and(|kind| kind.turns(freedom)) {
                angles(limits, &["min", "max"]);
            }
        }
    }
    let turns = kinds.iter().flatten().flat_map(|kind| kind.turning());
    let start = chain
        .field_mut("start")
        .map_or(&mut [][..], Node::items_mut);
    for (value, turns) in start.iter_mut().zip(turns) {
        if turns {
            degrees(value);
        }
    }
    kinds
}

/// The kind that a joint's letter names; U is a T.
pub(crate) fn kind(joint: &Node) -> Option<JointKind> {
    let letter = joint.field("type")?.as_text()?;
    let mut letters = letter.chars();
    let letter = letters.next().filter(|_| letters.next().is_none())?;
    match letter {
        'U' | 'u' => Some(JointKind::T),
        _ => JointKind::named(letter),
    }
}

fn angles(object: &mut Node, names: &[&str]) {
    for name in names {
        if let Some(value) = object.field_mut(name) {
            degrees(value);
            value.items_mut().iter_mut().for_each(degrees);
        }
    }
}

fn degrees(value: &mut Node) {
    if let Node::Number(number) = value {
        *number = number.to_degrees();
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a number from 1 to 1000"
)]
fn whole(number: f64) -> usize {
    number as usize
}

#[cfg(test)]
mod tests {
    use super::NUMBERS;
    use crate::document::schema::SCHEMA;
    use serde_json::Value;
    use std::collections::BTreeSet;

    /// The fields whose schema takes a number and a text, or lists of those.
    fn numbers<'a>(schema: &'a Value, field: &'a str, found: &mut BTreeSet<&'a str>) {
        if let Some(kinds) = schema["type"].as_array()
            && kinds.iter().any(|kind| kind == "string")
            && kinds
                .iter()
                .any(|kind| kind == "number" || kind == "integer")
        {
            found.insert(field);
        }
        for (name, part) in schema["properties"].as_object().into_iter().flatten() {
            numbers(part, name, found);
        }
        for part in schema["$defs"].as_object().into_iter().flatten() {
            numbers(part.1, part.0, found);
        }
        if schema["items"].is_object() {
            numbers(&schema["items"], field, found);
        }
    }

    #[test]
    fn the_schema_takes_expressions_where_they_are_read() {
        let schema: Value = serde_json::from_str(SCHEMA).expect("JSON");
        let mut found = BTreeSet::new();
        numbers(&schema, "", &mut found);
        assert_eq!(found, NUMBERS.into());
    }
}
