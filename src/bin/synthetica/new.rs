//! `new`: a document to begin with.

use crate::arguments::{Arguments, New};
use crate::failure::Failure;
use crate::files;
use clap::CommandFactory;
use clap::error::ErrorKind;
use synthetica::Fault;
use synthetica::document::number::typed;
use synthetica::makers::from_type::from_type;
use synthetica::makers::list::list;
use synthetica::makers::maker::{Input, Maker};

/// Prints the document, or the list of makers.
pub fn new(asked: &New) -> Result<(), Failure> {
    let into = asked.into.file();
    match &asked.what {
        Some(what) if !asked.list => match document(what, asked) {
            Ok(text) => files::write(into, &text),
            // What is wrong with it was typed on the command line.
            Err(fault) => Arguments::command()
                .error(ErrorKind::ValueValidation, fault)
                .exit(),
        },
        _ => files::write(into, &listed()),
    }
}

/// The options are written behind the name, as in delta?base=400&unit=mm.
fn document(what: &str, asked: &New) -> Result<String, Fault> {
    let mut text = what.to_owned();
    let unit = asked.unit.as_ref().map(|unit| ("unit", unit));
    let given = asked.inputs.0.iter();
    for (name, value) in given
        .map(|(name, value)| (name.as_str(), value))
        .chain(unit)
    {
        text.push(if text.contains('?') { '&' } else { '?' });
        text.extend([name, "=", value]);
    }
    from_type(&text)
}

/// Every maker with its inputs and their defaults.
fn listed() -> String {
    let blocks: Vec<String> = list().iter().map(block).collect();
    blocks.join("\n")
}

fn block(maker: &Maker) -> String {
    let mut lines = vec![format!("{}: {}", maker.name, maker.title)];
    let options = maker
        .inputs
        .iter()
        .map(|input| (option(input), meaning(input)));
    let unit = (
        format!("--unit {}", maker.unit),
        "unit of the lengths".to_owned(),
    );
    for (option, meaning) in options.chain([unit]) {
        lines.push(format!("  {option:<28} {meaning}"));
    }
    lines.join("\n") + "\n"
}

/// Such as: --arms 300,580.
fn option(input: &Input) -> String {
    let values: Vec<String> = input.value.iter().map(|&value| typed(value)).collect();
    format!("--{} {}", input.name, values.join(","))
}

fn meaning(input: &Input) -> String {
    if input.parts.is_empty() {
        return input.meaning.clone();
    }
    format!("{}: {}", input.parts.join(","), input.meaning)
}
