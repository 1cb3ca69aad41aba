//! The random documents of tests/fixtures: one a line, with extra fields.
#![allow(dead_code, reason = "every test uses its own part")]

use serde_json::Value;
use synthetica::document::problem::Problem;
use synthetica::document::schema::Document;
use synthetica::document::text::parse;

/// The lines of a file of tests/fixtures.
pub fn lines(set: &str) -> Vec<Value> {
    let path = format!("{}/tests/fixtures/{set}.jsonl", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    text.lines()
        .map(|line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{path}: {error}")))
        .collect()
}

/// The document of a line.
pub fn document(line: &Value) -> Document {
    parse(&line["document"].to_string()).unwrap_or_else(|fault| panic!("{}: {fault}", line["case"]))
}

/// What the planner needs of a document.
pub fn problem(document: &Document) -> Problem {
    Problem::new(document).unwrap_or_else(|fault| panic!("{}: {fault}", document.name))
}

/// The first entry and every `step`th one after it; all of them with a step of 1.
pub fn sample<T>(all: Vec<T>, step: usize) -> Vec<T> {
    all.into_iter().step_by(step).collect()
}
