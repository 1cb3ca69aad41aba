//! A plain document's text: what the smaller package reads.

use crate::document::fault::Fault;
use crate::document::schema::Document;
use crate::document::text;
use crate::motion::trajectory::Warning;

/// What was read.
#[derive(Clone, Debug)]
pub struct Plain {
    /// The document.
    pub document: Document,
    /// None.
    pub notes: [Warning; 0],
}

impl Plain {
    /// Reads a plain document.
    ///
    /// # Errors
    /// Where the text is none of this version.
    pub fn read(text: &str) -> Result<Self, Fault> {
        let document = text::parse(text)?;
        let notes = [];
        Ok(Self { document, notes })
    }

    /// The document with every default written out.
    pub fn text(&self) -> String {
        self.document.text()
    }

    /// The same with these start values, chain by chain.
    pub fn text_with_start(&self, start: Vec<Vec<f64>>) -> String {
        let mut document = self.document.clone();
        for (chain, values) in document.chains.iter_mut().zip(start) {
            chain.start = Some(values);
        }
        document.text()
    }
}
