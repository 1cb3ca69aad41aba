//! What is wrong with a document, where, and what would be accepted instead.

use serde::Serialize;
use std::fmt;

/// The kinds of faults: what a page may decide by. In JSON in kebab-case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FaultCode {
    /// There is no text.
    EmptyText,
    /// The text is longer than any document needs.
    TextTooLong,
    /// The text is not JSON.
    Syntax,
    /// The document is of another version.
    UnknownVersion,
    /// A field that must be there is not.
    MissingField,
    /// A field that does not exist, or not here.
    UnknownField,
    /// A field that is there twice.
    DuplicateField,
    /// A text where a number is wanted, and the like.
    WrongType,
    /// A word that is none of those to choose from.
    UnknownValue,
    /// A number too large, too small, or none at all.
    OutOfRange,
    /// Too few or too many of something.
    WrongCount,
    /// A text that is too long.
    NameTooLong,
    /// An inner row of a T, S or E that would make it another joint.
    InnerRow,
    /// A lower limit above the upper one.
    LimitOrder,
    /// Some key frames have a time, this one has not.
    TimeMissing,
    /// A time that is not later than the one before.
    TimeOrder,
}

/// A fault of a document: a person can mend it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Fault {
    /// The kind of fault.
    pub code: FaultCode,
    /// A sentence for a person: where, what, and what would be accepted.
    pub message: String,
    /// The JSON path, such as `chains[1].joints[0].rows[0].alpha`; empty for the whole document.
    #[serde(rename = "where")]
    pub place: String,
    /// What would be accepted there.
    pub accepted: String,
    /// The line of the text, from 1, if it could not be read that far.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<usize>,
    /// The byte of that line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<usize>,
}

impl Fault {
    /// `what` and `accepted` are parts of a sentence without a stop at the end.
    pub(crate) fn new(code: FaultCode, place: &Place, what: &str, accepted: &str) -> Self {
        Self {
            code,
            message: format!("{place}: {what}. Accepted: {accepted}."),
            place: place.path.clone(),
            accepted: accepted.to_owned(),
            line: None,
            column: None,
        }
    }

    /// Adds the line and the column of the text.
    pub(crate) fn at(mut self, line: usize, column: usize) -> Self {
        self.message = format!("Line {line}, column {column}. {}", self.message);
        (self.line, self.column) = (Some(line), Some(column));
        self
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Fault {}

/// A place in a document, as a JSON path and in words: `chains[1].base.x`, and chain 2, base frame, x.
#[derive(Clone, Debug, Default)]
pub(crate) struct Place {
    path: String,
    words: Vec<String>,
}

impl Place {
    /// The field of this name.
    pub(crate) fn field(&self, name: &str) -> Self {
        let mut place = self.clone();
        let dot = if self.path.is_empty() { "" } else { "." };
        place.path = format!("{}{dot}{}", self.path, excerpt(name));
        place.words.push(match name {
            "base" | "gripper" => format!("{name} frame"),
            _ => excerpt(name).replace('_', " "),
        });
        place
    }

    /// The entry `index`, from 0, of the list that this place is.
    pub(crate) fn item(&self, index: usize) -> Self {
        let mut place = self.clone();
        place.path = format!("{}[{index}]", self.path);
        let number = index + 1;
        let word = place.words.pop().unwrap_or_default();
        place.words.push(match word.as_str() {
            "chains" => format!("chain {number}"),
            "joints" => format!("joint {number}"),
            "rows" => format!("row {number}"),
            "limits" => format!("limits of freedom {number}"),
            "start" => format!("start value {number}"),
            "key frames" => format!("key frame {number}"),
            _ => format!("{word}, entry {number}"),
        });
        // It is clear that key frames belong to the motion.
        place.words.retain(|word| word != "motion");
        place
    }

    /// Adds what the person calls the thing.
    pub(crate) fn called(mut self, name: &str) -> Self {
        if let Some(word) = self
            .words
            .last_mut()
            .filter(|word| !name.is_empty() && *word != name)
        {
            *word = format!("{word} \u{201c}{}\u{201d}", excerpt(name));
        }
        self
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = self.words.join(", ");
        match words.chars().next() {
            Some(first) => write!(f, "{}{}", first.to_uppercase(), &words[first.len_utf8()..]),
            None => f.write_str("The document"),
        }
    }
}

/// The beginning of a text that a person wrote, short enough for a message.
pub(crate) fn excerpt(text: &str) -> String {
    const LONGEST: usize = 80;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_read_as_paths_and_as_words() {
        let chain = Place::default().field("chains").item(1);
        let row = chain
            .clone()
            .called("left \u{e4}rm")
            .field("joints")
            .item(0)
            .field("rows")
            .item(2);
        assert_eq!(row.field("alpha").path, "chains[1].joints[0].rows[2].alpha");
        assert_eq!(
            row.field("alpha").to_string(),
            "Chain 2 \u{201c}left \u{e4}rm\u{201d}, joint 1, row 3, alpha"
        );
        assert_eq!(
            chain.called("chain 2").field("base").field("x").to_string(),
            "Chain 2, base frame, x"
        );
        let key = Place::default()
            .field("motion")
            .field("key_frames")
            .item(0)
            .called("lift");
        assert_eq!(
            key.field("time").to_string(),
            "Key frame 1 \u{201c}lift\u{201d}, time"
        );
        assert_eq!(
            Place::default().field("motion").field("frames").to_string(),
            "Motion, frames"
        );
        assert_eq!(Place::default().to_string(), "The document");
        assert_eq!(excerpt(&"\u{e4}".repeat(500)).chars().count(), 81);
    }
}
