//! Writes a document's planned motion for other programs: `cargo run --example export -- FORMAT
//! DOCUMENT` prints it as csv, json or mjcf (a MuJoCo model).

use std::process::ExitCode;
use synthetica::export::{Format, write};
use synthetica::fault::Fault;
use synthetica::json;
use synthetica::problem::Problem;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [format, file] = &arguments[..] else {
        eprintln!("usage: export FORMAT DOCUMENT");
        return ExitCode::from(2);
    };
    let text = match std::fs::read_to_string(file) {
        Ok(text) => text,
        Err(error) => {
            eprintln!("{file}: {error}");
            return ExitCode::from(2);
        }
    };
    match export(format, &text) {
        Ok(text) => print!("{text}"),
        Err(fault) => {
            eprintln!("{file}: {fault}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

fn export(format: &str, text: &str) -> Result<String, Fault> {
    let format = Format::named(format)?;
    let document = json::parse(text)?;
    let problem = Problem::new(&document)?;
    let motion = problem.plan();
    Ok(write(format, &document, &problem.mechanism, &motion))
}
