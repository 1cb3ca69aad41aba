//! What is wrong with a document, where, and what would be accepted instead.

use serde::Serialize;
use std::fmt;

/// Whether faults have words. Those of the package that a page loads first have none: what it refuses is asked of the
/// whole package, which says what is wrong.
pub(crate) const TOLD: bool = cfg!(any(feature = "study", not(target_arch = "wasm32")));

/// `format!` for the words of a fault, where it has any.
macro_rules! told {
    ($($words:tt)*) => {
        if $crate::document::fault::TOLD { format!($($words)*) } else { String::new() }
    };
}
pub(crate) use told;

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
    /// Joints are driven, and what is asked for needs goals.
    NoGoals,
}

/// A fault of a document: a person can mend it.
#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Fault {
    /// The kind of fault.
    pub code: FaultCode,
    /// A sentence for a person: where, what, and what would be accepted.
    pub message: String,
    /// The first part of the sentence, where and what, without a stop at the end.
    pub what: String,
    /// The JSON path, such as `chains[1].joints[0].rows[0].alpha`; empty for the whole document.
    #[serde(rename = "where")]
    pub place: String,
    /// What would be accepted there.
    pub accepted: String,
    /// Whether null, an empty cell of a page, would be accepted too.
    #[serde(skip_serializing_if = "is_false")]
    pub optional: bool,
    /// The line of the text, from 1, if it could not be read that far.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
    /// The byte of that line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<u32>,
}

#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
impl Fault {
    /// `what` and `accepted` are parts of a sentence without a stop at the end.
    #[cold]
    #[inline(never)]
    pub(crate) fn new(code: FaultCode, place: &Place<'_>, what: &str, accepted: &str) -> Self {
        let what = format!("{place}: {what}");
        Self {
            code,
            message: format!("{what}. Accepted: {accepted}."),
            what,
            place: place.path(),
            accepted: accepted.to_owned(),
            optional: false,
            line: None,
            column: None,
        }
    }

    /// For a value that may be null.
    #[cold]
    #[inline(never)]
    pub(crate) fn or_null(mut self) -> Self {
        self.optional = true;
        self.message.pop();
        self.message += ", or null.";
        self
    }

    /// Adds the line and the column of the text.
    pub(crate) fn at(mut self, line: usize, column: usize) -> Self {
        self.message = format!("Line {line}, column {column}. {}", self.message);
        (self.line, self.column) = (u32::try_from(line).ok(), u32::try_from(column).ok());
        self
    }
}

#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
#[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
fn is_false(value: &bool) -> bool {
    !value
}

#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
impl std::error::Error for Fault {}

/// Something in a document is wrong, or more than this package knows: without words.
#[cfg(all(target_arch = "wasm32", not(feature = "study")))]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault;

#[cfg(all(target_arch = "wasm32", not(feature = "study")))]
impl Fault {
    pub(crate) fn new(_code: FaultCode, _place: &Place<'_>, _what: &str, _accepted: &str) -> Self {
        Self
    }

    pub(crate) fn or_null(self) -> Self {
        self
    }

    pub(crate) fn at(self, _line: usize, _column: usize) -> Self {
        self
    }
}

#[cfg(all(target_arch = "wasm32", not(feature = "study")))]
impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("refused")
    }
}

#[cfg(all(target_arch = "wasm32", not(feature = "study")))]
impl std::error::Error for Fault {}

/// A place in a document: a step from another place. Nothing is put together before there is a fault
/// to tell, so that places cost nothing where all is well.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place<'a> {
    before: Option<&'a Place<'a>>,
    step: Step<'a>,
}

#[derive(Clone, Copy, Debug)]
enum Step<'a> {
    Whole,
    Field(&'a str),
    /// An entry of a list, from 0, and what the person calls it.
    Item(usize, &'a str),
}

impl<'a> Place<'a> {
    /// The whole document.
    pub(crate) const WHOLE: Self = Self {
        before: None,
        step: Step::Whole,
    };

    /// The field of this name.
    pub(crate) const fn field(&'a self, name: &'a str) -> Self {
        Self {
            before: Some(self),
            step: Step::Field(name),
        }
    }

    /// The entry `index`, from 0, of the list that this place is.
    pub(crate) const fn item(&'a self, index: usize) -> Self {
        self.named(index, "")
    }

    /// An entry that the person has given a name, which may be empty.
    pub(crate) const fn named(&'a self, index: usize, name: &'a str) -> Self {
        Self {
            before: Some(self),
            step: Step::Item(index, name),
        }
    }

    /// The JSON path: `chains[1].base.x`.
    #[cfg(any(feature = "study", not(target_arch = "wasm32")))]
    pub(crate) fn path(&self) -> String {
        let mut path = self.before.map_or_else(String::new, Place::path);
        match self.step {
            Step::Whole => {}
            Step::Field(name) => {
                if !path.is_empty() {
                    path.push('.');
                }
                path += &excerpt(name);
            }
            Step::Item(index, _) => path += &format!("[{index}]"),
        }
        path
    }

    /// In words, from the outside in: chain 2, base frame, x.
    fn words(&self) -> Vec<String> {
        let mut words = self.before.map_or_else(Vec::new, Place::words);
        match self.step {
            Step::Whole => {}
            // The name is the person's own: “base” is no frame here.
            #[cfg(feature = "study")]
            Step::Field(name) if words == ["parameters"] => {
                words = vec![format!("parameter \u{201c}{}\u{201d}", excerpt(name))];
            }
            // Those of a chain; a parameter or an input may be called base too.
            Step::Field(name @ ("base" | "gripper")) if !words.is_empty() => {
                words.push(format!("{name} frame"));
            }
            Step::Field(name) => words.push(excerpt(name).replace('_', " ")),
            Step::Item(index, name) => {
                let number = index + 1;
                let list = words.pop().unwrap_or_default();
                let word = match list.as_str() {
                    "chains" => format!("chain {number}"),
                    "joints" => format!("joint {number}"),
                    "rows" => format!("row {number}"),
                    "limits" => format!("limits of freedom {number}"),
                    "start" => format!("start value {number}"),
                    "key frames" => format!("key frame {number}"),
                    #[cfg(feature = "study")]
                    "drivers" => format!("driver {number}"),
                    #[cfg(feature = "study")]
                    "values" => format!("value {number}"),
                    _ => format!("{list}, entry {number}"),
                };
                // It is clear that key frames belong to the motion.
                if list == "key frames" {
                    words.retain(|word| word != "motion");
                }
                let called = if name == word { "" } else { name };
                words.push(match called {
                    "" => word,
                    name => format!("{word} \u{201c}{}\u{201d}", excerpt(name)),
                });
            }
        }
        words
    }
}

impl fmt::Display for Place<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut words = self.words().join(", ");
        if words.is_empty() {
            words = "the document".to_owned();
        }
        if let Some(first) = words.get_mut(..1) {
            first.make_ascii_uppercase();
        }
        f.write_str(&words)
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
        let chains = Place::WHOLE.field("chains");
        let chain = chains.named(1, "left \u{e4}rm");
        let (joints, alpha) = (chain.field("joints"), "alpha");
        let joint = joints.item(0);
        let rows = joint.field("rows");
        let row = rows.item(2);
        assert_eq!(row.field(alpha).path(), "chains[1].joints[0].rows[2].alpha");
        let words = "Chain 2 \u{201c}left \u{e4}rm\u{201d}, joint 1, row 3, alpha";
        assert_eq!(row.field(alpha).to_string(), words);
        let (chain, motion) = (chains.named(1, "chain 2"), Place::WHOLE.field("motion"));
        assert_eq!(
            chain.field("base").field("x").to_string(),
            "Chain 2, base frame, x"
        );
        let keys = motion.field("key_frames");
        let key = keys.named(0, "lift");
        assert_eq!(
            key.field("time").to_string(),
            "Key frame 1 \u{201c}lift\u{201d}, time"
        );
        assert_eq!(motion.field("frames").to_string(), "Motion, frames");
        assert_eq!(
            (Place::WHOLE.to_string(), Place::WHOLE.path()),
            ("The document".into(), String::new())
        );
        assert_eq!(excerpt(&"\u{e4}".repeat(500)).chars().count(), 81);
    }
}
