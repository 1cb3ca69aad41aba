//! The command `synthetica`: plans, checks, exports and enumerates from a shell.

mod arguments;
mod best;
mod check;
mod enumerate;
mod failure;
mod files;
mod inputs;
mod modes;
mod motion;
mod new;
mod options;
mod planned;
mod progress;

use arguments::{Arguments, Command};
use clap::{CommandFactory, Parser};
use failure::Failure;
use std::process::ExitCode;

fn main() -> ExitCode {
    match run(&Arguments::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.tell();
            failure.code().into()
        }
    }
}

fn run(command: &Command) -> Result<(), Failure> {
    match command {
        Command::Plan(asked) => motion::plan(asked),
        Command::Check(asked) => check::check(asked),
        Command::Best(asked) => best::best(asked),
        Command::Modes(asked) => modes::modes(asked),
        Command::Export(asked) => motion::export(asked),
        Command::Enumerate(asked) => enumerate::enumerate(asked),
        Command::New(asked) => new::new(asked),
        Command::Schema { into } => files::write(into.file(), &schema()),
        Command::Completions { shell } => {
            // Into memory first: the generators panic where the reader of a pipe has gone.
            let mut text = Vec::new();
            let mut command = Arguments::command();
            clap_complete::generate(*shell, &mut command, "synthetica", &mut text);
            files::write(None, &String::from_utf8_lossy(&text))
        }
    }
}

/// The published schema; with the feature that can, anew from the types.
fn schema() -> String {
    #[cfg(feature = "schema")]
    return synthetica::source::schema::schema();
    #[cfg(not(feature = "schema"))]
    return synthetica::document::schema::SCHEMA.to_owned();
}
