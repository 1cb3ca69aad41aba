//! Why the command ends early, in a line on standard error and as an exit code.

use std::io::{self, Write};
use synthetica::document::fault::Fault;

/// A document is at fault, or `check` found a frame that is not certified.
pub const AT_FAULT: u8 = 1;
/// A file could not be read or written. clap gives the same code to a bad command line: as with grep and
/// diff, 1 is an answer, 2 is none.
pub const NO_ANSWER: u8 = 2;

/// What ends the command early.
pub enum Failure {
    /// A document is at fault.
    Fault { file: String, fault: Box<Fault> },
    /// What is wrong has been said; this code is left.
    Said(u8),
    /// A file could not be read or written.
    File { file: String, error: io::Error },
    /// The reader of a pipe has seen enough.
    ReaderGone,
}

impl Failure {
    /// What could not be done with this file.
    pub fn file(file: &str, error: io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            return Self::ReaderGone;
        }
        Self::File {
            file: file.to_owned(),
            error,
        }
    }

    /// As the shell is told.
    pub fn code(&self) -> u8 {
        match self {
            Self::Fault { .. } => AT_FAULT,
            Self::Said(code) => *code,
            Self::File { .. } => NO_ANSWER,
            Self::ReaderGone => 0,
        }
    }

    /// As the person is told.
    pub fn tell(&self) {
        match self {
            Self::Fault { file, fault } => tell(&format!("{file}: {fault}")),
            Self::File { file, error } => tell(&format!("{file}: {error}")),
            Self::Said(_) | Self::ReaderGone => {}
        }
    }
}

/// The answer of a question about this file's document.
pub fn at_fault<T>(file: &str, answer: Result<T, Fault>) -> Result<T, Failure> {
    answer.map_err(|fault| Failure::Fault {
        file: file.to_owned(),
        fault: Box::new(fault),
    })
}

/// A line on standard error; it does not matter whether anybody reads it.
pub fn tell(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}
