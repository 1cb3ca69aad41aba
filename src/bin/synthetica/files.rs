//! Where documents come from and where the output goes: files, or `-` for the standard streams.

use crate::failure::{Failure, tell};
use std::fs::{self, File};
use std::io::{self, BufWriter, IsTerminal, Read, Write};
use std::path::Path;
use synthetica::document::fault::{Fault, FaultCode};

/// The file as messages call it.
pub fn name(file: &Path) -> String {
    if is_standard(file) {
        "standard input".to_owned()
    } else {
        file.display().to_string()
    }
}

/// What a file has to be: its name in messages, and what is accepted.
pub struct Kind {
    name: &'static str,
    accepted: &'static str,
}

/// A document.
pub const DOCUMENT: Kind = Kind {
    name: "document",
    accepted: "JSON text in UTF-8",
};
/// A table of key frames.
pub const TABLE: Kind = Kind {
    name: "table",
    accepted: "text in UTF-8",
};

/// The text of a file.
pub fn read(file: &Path, kind: &Kind) -> Result<String, Failure> {
    let bytes = if is_standard(file) {
        if io::stdin().is_terminal() {
            tell(&format!(
                "synthetica: reads a {} from the terminal, up to Ctrl-D",
                kind.name
            ));
        }
        let mut bytes = Vec::new();
        io::stdin().read_to_end(&mut bytes).map(|_| bytes)
    } else {
        fs::read(file)
    };
    let bytes = bytes.map_err(|error| Failure::file(&name(file), error))?;
    String::from_utf8(bytes).map_err(|error| Failure::Fault {
        file: name(file),
        fault: Box::new(not_text(error.utf8_error().valid_up_to(), kind)),
    })
}

fn not_text(byte: usize, kind: &Kind) -> Fault {
    let Kind { name, accepted } = kind;
    let what = format!("The {name}: byte {byte} is no text");
    Fault {
        code: FaultCode::Syntax,
        message: format!("{what}. Accepted: {accepted}."),
        what,
        place: String::new(),
        accepted: (*accepted).to_owned(),
        optional: false,
        line: None,
        column: None,
    }
}

/// Writes a text whole; the file is opened only now, so that what stood there stays where nothing comes.
pub fn write(file: Option<&Path>, text: &str) -> Result<(), Failure> {
    let mut out = Out::new(file)?;
    out.write(text)?;
    out.flush()
}

/// Where the output goes, written to in pieces.
pub struct Out {
    name: String,
    terminal: bool,
    sink: Box<dyn Write>,
}

impl Out {
    /// Into this file; to standard output without one.
    pub fn new(file: Option<&Path>) -> Result<Self, Failure> {
        match file.filter(|file| !is_standard(file)) {
            None => Ok(Self {
                name: "standard output".to_owned(),
                terminal: io::stdout().is_terminal(),
                sink: Box::new(BufWriter::new(io::stdout().lock())),
            }),
            Some(file) => {
                let name = file.display().to_string();
                let opened = File::create(file).map_err(|error| Failure::file(&name, error))?;
                let sink = Box::new(BufWriter::new(opened));
                Ok(Self {
                    name,
                    terminal: false,
                    sink,
                })
            }
        }
    }

    /// Does a person see it come?
    pub fn is_terminal(&self) -> bool {
        self.terminal
    }

    /// Writes a text, as it is.
    pub fn write(&mut self, text: &str) -> Result<(), Failure> {
        let written = self.sink.write_all(text.as_bytes());
        written.map_err(|error| Failure::file(&self.name, error))
    }

    /// Writes what is still held back.
    pub fn flush(&mut self) -> Result<(), Failure> {
        let written = self.sink.flush();
        written.map_err(|error| Failure::file(&self.name, error))
    }
}

/// Is it a standard stream?
pub fn is_standard(file: &Path) -> bool {
    file.as_os_str() == "-"
}
