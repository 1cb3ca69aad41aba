//! A document made by a maker from the inputs that a person gave.

use crate::document::bounds::{MAX_LENGTH, out_of_range};
use crate::document::fault::{Fault, FaultCode, Place, excerpt};
use crate::document::number::typed;
use crate::document::reader::Node;
use crate::document::refusal::one_of;
use crate::document::text::json;
use crate::makers::maker::{Input, Kind, Maker};
use crate::makers::repeat::repeat;
use crate::makers::requirements::{Given, check};
use crate::source::expression::ParameterValue;
use crate::source::nearest::nearest;
use crate::source::session::Session;

/// Units of length and how many micrometres each has.
pub const UNITS: [(&str, f64); 6] = [
    ("m", 1e6),
    ("cm", 1e4),
    ("mm", 1e3),
    ("\u{b5}m", 1.0),
    ("um", 1.0),
    ("in", 25_400.0),
];

/// The text of the typed document of this maker with these inputs, by name; those that are not given are the maker's,
/// converted to `unit`. Lengths are in `unit`, that of the maker where there is none.
///
/// # Errors
/// At the name of an input that there is not, is given twice, has no such value, or does not fit the others; at `unit`.
///
/// # Panics
/// If the maker's file is at fault, which the tests find out.
pub fn make(
    maker: &Maker,
    given: &[(String, String)],
    unit: Option<&str>,
) -> Result<String, Fault> {
    let (unit, factor) = conversion(maker, unit)?;
    all_known(maker, given)?;
    let values = |input: &Input| match given.iter().find(|(name, _)| *name == input.name) {
        Some((_, text)) => read(input, text),
        None if input.is == Kind::Length => {
            Ok(input.value.iter().map(|&value| factor(value)).collect())
        }
        None => Ok(input.value.clone()),
    };
    let inputs = maker.inputs.iter().map(|input| Ok((input, values(input)?)));
    let inputs: Vec<(&Input, Vec<f64>)> = inputs.collect::<Result<_, Fault>>()?;

    let parameters: Vec<Given> = (inputs.iter())
        .flat_map(|(input, values)| input.parameters().iter().zip(values))
        .map(|(name, &value)| (name.clone(), ParameterValue::Number(value)))
        .collect();
    let mut document = maker.document.clone();
    let derived = derived(document.take("parameters"));
    check(maker, &inputs, &parameters, &derived, given, unit)?;

    repeat(&mut document, &inputs);
    document.set("version", Node::Number(1.0));
    if !document.has("name") {
        document.set("name", Node::Text(maker.title.clone()));
    }
    document.set(
        "about",
        Node::Text(format!("{} Source: {}", maker.about, maker.source)),
    );
    document.set("length_unit", Node::Text(unit.to_owned()));
    let all = parameters.into_iter().chain(derived).map(|(name, value)| {
        let value = match value {
            ParameterValue::Number(number) => Node::Number(number),
            ParameterValue::Expression(text) => Node::Text(text),
        };
        (name, value)
    });
    document.set("parameters", Node::Object(all.collect()));
    match Session::open(&json(&document)) {
        Ok(session) => Ok(session.text()),
        Err(fault) => Err(at_inputs(&fault, given)),
    }
}

/// The fault of a made document, at the first input that was given: the document is not what the person typed.
fn at_inputs(fault: &Fault, given: &[(String, String)]) -> Fault {
    let name = given.first().map_or("type", |(name, _)| name.as_str());
    let what = format!(
        "with these numbers the mechanism is at fault; {}",
        fault.what
    );
    let accepted = format!("numbers with which this is {}", fault.accepted);
    Fault::new(fault.code, &Place::WHOLE.field(name), &what, &accepted)
}

/// The unit of the made document, and how a length of the maker's is converted.
fn conversion<'a>(
    maker: &'a Maker,
    unit: Option<&'a str>,
) -> Result<(&'a str, impl Fn(f64) -> f64), Fault> {
    let size = |unit: &str| {
        UNITS
            .iter()
            .find(|(name, _)| *name == unit)
            .map(|(_, size)| *size)
    };
    let own = size(&maker.unit).expect("a unit of length");
    let unit = unit.map_or(maker.unit.as_str(), str::trim);
    let Some(wanted) = size(unit) else {
        let what = format!("\u{201c}{}\u{201d} is no unit of length", excerpt(unit));
        let place = Place::WHOLE.field("unit");
        let accepted = one_of(&UNITS.map(|(name, _)| name));
        return Err(Fault::new(
            FaultCode::UnknownValue,
            &place,
            &what,
            &accepted,
        ));
    };
    Ok((unit, move |length: f64| length * own / wanted))
}

/// The parameters that follow from the inputs.
fn derived(parameters: Option<Node>) -> Vec<Given> {
    let Some(Node::Object(fields)) = parameters else {
        return Vec::new();
    };
    let value = |value| match value {
        Node::Text(text) => ParameterValue::Expression(text),
        Node::Number(number) => ParameterValue::Number(number),
        Node::Null | Node::Bool(_) | Node::List(_) | Node::Object(_) => {
            panic!("a parameter of a maker is an expression")
        }
    };
    fields
        .into_iter()
        .map(|(name, given)| (name, value(given)))
        .collect()
}

fn all_known(maker: &Maker, given: &[(String, String)]) -> Result<(), Fault> {
    let names: Vec<&str> = maker
        .inputs
        .iter()
        .map(|input| input.name.as_str())
        .collect();
    for (i, (name, _)) in given.iter().enumerate() {
        let place = Place::WHOLE.field(name);
        if !names.contains(&name.as_str()) {
            let meant = nearest(name, names.iter().copied());
            let meant = meant.map_or_else(String::new, |meant| {
                format!("; \u{201c}{meant}\u{201d} may be meant")
            });
            let what = format!("{} has no such input{meant}", maker.name);
            let accepted = format!("{}, unit", names.join(", "));
            return Err(Fault::new(
                FaultCode::UnknownField,
                &place,
                &what,
                &accepted,
            ));
        }
        if given[..i].iter().any(|(before, _)| before == name) {
            return Err(twice(&place));
        }
    }
    Ok(())
}

/// The fault of an input that is given more than once.
pub(crate) fn twice(place: &Place<'_>) -> Fault {
    let what = "this is given twice";
    Fault::new(FaultCode::DuplicateField, place, what, "each input once")
}

/// The numbers that a text gives to an input.
fn read(input: &Input, text: &str) -> Result<Vec<f64>, Fault> {
    let place = Place::WHOLE.field(&input.name);
    let accepted = accepted(input);
    let mut values = Vec::new();
    let parts = text.split(',').map(str::trim);
    for part in parts.flat_map(|part| spread(input.is, part)) {
        let number = part.replace('\u{2212}', "-").parse::<f64>().ok();
        // What Rust takes for a number too, but is none: inf, nan.
        let Some(number) = number.filter(|number| number.is_finite()) else {
            let what = format!("\u{201c}{}\u{201d} is no number", excerpt(&part));
            return Err(Fault::new(FaultCode::WrongType, &place, &what, &accepted));
        };
        let whole = matches!(input.is, Kind::Count | Kind::List);
        let unfit = (input.is == Kind::Length && !input.signed && number <= 0.0)
            || (whole && number.fract() != 0.0)
            || input
                .range
                .is_some_and(|[least, most]| !(least..=most).contains(&number))
            || (input.is == Kind::List && values.contains(&number));
        if unfit {
            return Err(out_of_range(&place, typed(number), &accepted));
        }
        if input.is == Kind::Length && number.abs() > MAX_LENGTH {
            let accepted = format!("lengths of at most {}", typed(MAX_LENGTH));
            return Err(out_of_range(&place, typed(number), &accepted));
        }
        values.push(number + 0.0);
    }
    let count = input.parameters().len();
    if input.is != Kind::List && values.len() != count {
        let what = match values.len() {
            1 => "this is one number".to_owned(),
            many => format!("these are {many} numbers"),
        };
        return Err(Fault::new(FaultCode::WrongCount, &place, &what, &accepted));
    }
    Ok(values)
}

/// Of a list, the entries that a range stands for: 1-3 for 1, 2, 3.
fn spread(kind: Kind, part: &str) -> Vec<String> {
    let ends = part.split_once(['-', '\u{2013}']);
    let ends = ends.and_then(|(first, last)| {
        let (first, last) = (first.trim().parse::<u8>(), last.trim().parse::<u8>());
        Some(first.ok()?..=last.ok()?)
    });
    match ends {
        Some(range) if kind == Kind::List && !range.is_empty() => {
            range.map(|entry| entry.to_string()).collect()
        }
        _ => vec![part.to_owned()],
    }
}

/// What an input takes, such as: two lengths above 0 with a comma between them (upper, lower).
fn accepted(input: &Input) -> String {
    let (one, many) = match input.is {
        Kind::Length => ("a length", "lengths"),
        Kind::Angle => ("an angle in degrees", "angles in degrees"),
        Kind::Number => ("a number", "numbers"),
        Kind::Count => ("a whole number", "whole numbers"),
        Kind::List => ("", "different whole numbers"),
    };
    let range = match input.range {
        Some([least, most]) => format!(" from {} to {}", typed(least), typed(most)),
        None if input.is == Kind::Length && !input.signed => " above 0".to_owned(),
        None => String::new(),
    };
    let between = "with commas between them";
    match input.parts.len() {
        _ if input.is == Kind::List => {
            format!("{many}{range}, {between}, or a range such as 1-3")
        }
        0 => format!("{one}{range}"),
        count => format!(
            "{count} {many}{range}, {between}: {}",
            input.parts.join(",")
        ),
    }
}
