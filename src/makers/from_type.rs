//! A document by what a person calls the mechanism: a maker with its inputs, delta?base=400, or a type such as 3-RPS.

use crate::document::example_document::{TYPE, example};
use crate::document::fault::{Fault, FaultCode, Place, excerpt};
use crate::document::reader::Node;
use crate::document::text::not_json;
use crate::makers::list::{key, list, named, names};
use crate::makers::make::{make, twice};
use crate::source::nearest::nearest;
use crate::types::notation::{NoType, Why, chains_of};

/// Types that people often name: one of them is proposed for a text that is nearly it.
const OFTEN: [&str; 12] = [
    "3RPS", "3PRS", "3RRS", "3RPR", "3RRR", "3PRR", "3UPU", "3URU", "3PUU", "2TPR", "RS+RS",
    "RP+RR",
];

/// Values of inputs by name, as they were written.
type Given = Vec<(String, String)>;

/// The text of the document that `text` names: a maker with `?` and its inputs, `delta?base=400&arms=300,580&unit=mm`; a
/// type, `3-RPS`; or a maker by its name alone, with the numbers of its paper. A name that is a type too is the type.
///
/// # Errors
/// Where there is no such maker and no such type, or an input is at fault.
pub fn from_type(text: &str) -> Result<String, Fault> {
    if let Some((name, query)) = text.split_once('?') {
        let maker = named(name).ok_or_else(|| no_maker(name))?;
        let (given, unit) = inputs(query)?;
        return make(maker, &given, unit.as_deref());
    }
    match (example(text), named(text)) {
        (Ok(document), _) => Ok(document.text()),
        (Err(_), Some(maker)) => make(maker, &[], None),
        (Err(fault), None) => Err(proposed(text, fault)),
    }
}

/// The text of the document of the maker of this name. `inputs` is an object in JSON: a text, a number or a list of numbers
/// for each input that is not to have its default. Lengths are in `unit`, that of the maker where there is none.
///
/// # Errors
/// Where there is no such maker, `inputs` is no such object, or an input is at fault.
pub fn make_named(name: &str, inputs: &str, unit: Option<&str>) -> Result<String, Fault> {
    const PLACE: Place<'static> = Place::WHOLE.field("inputs");
    const ACCEPTED: &str = "a text, a number or a list of numbers";
    let maker = named(name).ok_or_else(|| no_maker(name))?;
    let inputs: Node = serde_json::from_str(inputs).map_err(|error| not_json(&error))?;
    let Node::Object(fields) = inputs else {
        let accepted = "an object of inputs with their values";
        return Err(inputs.is_not(accepted).fault(&PLACE));
    };
    let number = |node: &Node, place: &Place<'_>| match node {
        Node::Number(number) => Ok(number.to_string()),
        other @ (Node::Null | Node::Bool(_) | Node::Text(_) | Node::List(_) | Node::Object(_)) => {
            Err(other.is_not(ACCEPTED).fault(place))
        }
    };
    let mut given = Given::new();
    for (name, value) in fields {
        let place = Place::WHOLE.field(&name);
        let text = match value {
            Node::Text(text) => text,
            Node::List(items) => {
                let items = items.iter().map(|item| number(item, &place));
                items.collect::<Result<Vec<_>, _>>()?.join(",")
            }
            other @ (Node::Null | Node::Bool(_) | Node::Number(_) | Node::Object(_)) => {
                number(&other, &place)?
            }
        };
        given.push((name, text));
    }
    make(maker, &given, unit)
}

/// The inputs of `base=400&arms=300,580&unit=mm`, and the unit.
fn inputs(query: &str) -> Result<(Given, Option<String>), Fault> {
    let mut given = Vec::new();
    let mut unit = None;
    for part in query
        .split('&')
        .map(str::trim)
        .filter(|part| !part.is_empty())
    {
        let Some((name, value)) = part.split_once('=') else {
            let what = format!(
                "\u{201c}{}\u{201d} gives no value to an input",
                excerpt(part)
            );
            let accepted = "inputs as name=value with & between them, such as base=400&platform=50";
            return Err(Fault::new(FaultCode::Syntax, &TYPE, &what, accepted));
        };
        let (name, value) = (name.trim().to_owned(), value.trim().to_owned());
        if name == "unit" {
            if unit.replace(value).is_some() {
                return Err(twice(&Place::WHOLE.field("unit")));
            }
        } else {
            given.push((name, value));
        }
    }
    Ok((given, unit))
}

/// The fault of a name that no maker has.
fn no_maker(name: &str) -> Fault {
    let what = format!("there is no maker \u{201c}{}\u{201d}", excerpt(name.trim()));
    let what = match close_maker(name) {
        Some(maker) => format!("{what}; \u{201c}{maker}\u{201d} may be meant"),
        None => what,
    };
    let makers: Vec<&str> = list().iter().map(|maker| maker.name.as_str()).collect();
    Fault::new(FaultCode::UnknownValue, &TYPE, &what, &makers.join(", "))
}

/// A fault of a text that is no type, with the maker or the type that may be meant.
fn proposed(text: &str, fault: Fault) -> Fault {
    let understood = |no_type: NoType| matches!(no_type.why, Why::Loop(_) | Why::Leg { .. });
    if chains_of(text).is_err_and(understood) {
        return fault;
    }
    let meant = close_maker(text).or_else(|| {
        let signs = |c: char| c.is_alphanumeric() || c == '+';
        let wanted: String = text.chars().filter(|c| signs(*c)).collect();
        nearest(&wanted, OFTEN.into_iter()).map(str::to_owned)
    });
    match meant {
        None => fault,
        Some(meant) => {
            // Without the name of the place, which the new fault says again.
            let what = fault.what.split_once(": ").map_or("", |(_, what)| what);
            let what = format!("{what}; \u{201c}{meant}\u{201d} may be meant");
            Fault::new(fault.code, &TYPE, &what, &fault.accepted)
        }
    }
}

/// The maker whose name is nearly this.
fn close_maker(text: &str) -> Option<String> {
    let all: Vec<(String, &str)> = (list().iter())
        .flat_map(|maker| names(maker).map(|name| (key(name), maker.name.as_str())))
        .collect();
    let close = nearest(&key(text), all.iter().map(|(key, _)| key.as_str()))?;
    let found = all.iter().find(|(key, _)| key == close);
    found.map(|(_, name)| (*name).to_owned())
}
