//! Text to document and back: reading that says what is wrong, writing that a person can read.

use crate::document::fault::{Fault, FaultCode, Place, told};
use crate::document::number::{typed, written};
#[cfg(all(target_arch = "wasm32", not(feature = "study")))]
use crate::document::plain_json;
use crate::document::reader::Node;
use crate::document::refusal::Refusal;
use crate::document::schema::{Document, VERSION};
#[cfg(feature = "study")]
use serde::de::Error;
use serde::{Deserialize, Serialize};

/// Bytes of the longest text that is read at all: 100,000 key frames with names, times and 15 digits a number take 27 MB
/// as documents are written.
pub const MAX_TEXT: usize = 32_000_000;

/// Reads a document; defaults are filled in. What its numbers mean is checked by
/// [`crate::document::problem::Problem::new`].
///
/// # Errors
/// Where the text is no document of this version.
pub fn parse(text: &str) -> Result<Document, Fault> {
    document_of(&node_of(text)?)
}

/// The values of a document's text, of this version.
pub(crate) fn node_of(text: &str) -> Result<Node, Fault> {
    let whole = Place::WHOLE;
    if text.len() > MAX_TEXT {
        let what = told!("{} bytes of text are too many", text.len());
        return Err(Fault::new(
            FaultCode::TextTooLong,
            &whole,
            &what,
            &told!("up to {} bytes", grouped(MAX_TEXT)),
        ));
    }
    // Some editors put a byte-order mark before the text.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim().is_empty() {
        let accepted = "a mechanism document in JSON";
        return Err(Fault::new(
            FaultCode::EmptyText,
            &whole,
            "there is no text",
            accepted,
        ));
    }
    #[cfg(any(feature = "study", not(target_arch = "wasm32")))]
    let node = serde_json::from_str(text).map_err(|error| not_json(&error))?;
    #[cfg(all(target_arch = "wasm32", not(feature = "study")))]
    let node = plain_json::read(text).ok_or(Fault)?;
    check_version(&node)?;
    Ok(node)
}

/// The document of these values.
pub(crate) fn document_of(node: &Node) -> Result<Document, Fault> {
    let refused = |refusal: Refusal| refusal.fault(&Place::WHOLE);
    let mut document = Document::deserialize(node).map_err(refused)?;
    #[cfg(feature = "study")]
    check_motion(node, &document)?;
    for (i, chain) in document.chains.iter_mut().enumerate() {
        if chain.name.is_empty() {
            chain.name = format!("chain {}", i + 1);
        }
    }
    Ok(document)
}

/// A whole number with commas between its thousands.
fn grouped(number: usize) -> String {
    if number < 1000 {
        return number.to_string();
    }
    told!("{},{:03}", grouped(number / 1000), number % 1000)
}

/// The reader's message, and where it stopped.
pub(crate) fn not_json(error: &serde_json::Error) -> Fault {
    let text = error.to_string();
    // "… at line 3 column 7"
    let message = text
        .rsplit_once(" at line ")
        .map_or(text.as_str(), |(message, _)| message);
    let what = told!("this is not JSON, {message}");
    Fault::new(FaultCode::Syntax, &Place::WHOLE, &what, "JSON text")
        .at(error.line(), error.column())
}

/// A document of another version should not be blamed for fields that this one does not know.
fn check_version(node: &Node) -> Result<(), Fault> {
    const PLACE: Place<'static> = Place::WHOLE.field("version");
    if let Some(Node::Number(version)) = node.field("version")
        && (version - f64::from(VERSION)).abs() > 0.0
    {
        let what = told!("this is version {} of the format", typed(*version));
        return Err(Fault::new(
            FaultCode::UnknownVersion,
            &PLACE,
            &what,
            &VERSION.to_string(),
        ));
    }
    // What else may be wrong with it is said where it is read.
    Ok(())
}

/// Key frames may be missing only where there are drivers.
#[cfg(feature = "study")]
fn check_motion(node: &Node, document: &Document) -> Result<(), Fault> {
    const MOTION: Place<'static> = Place::WHOLE.field("motion");
    let motion = node.field("motion");
    if document.motion.drivers.is_empty() && motion.is_some_and(|m| m.field("key_frames").is_none())
    {
        return Err(Refusal::missing_field("key_frames").fault(&MOTION));
    }
    Ok(())
}

impl Document {
    /// The document as JSON with all its fields; what fits stays on one line, and numbers have up to
    /// 15 digits. What was read from such a text is written as the same text again.
    ///
    /// # Panics
    /// Never: the document holds nothing that JSON cannot.
    pub fn text(&self) -> String {
        layout(&json(self))
    }
}

/// Numbers as documents have them.
struct Written;

/// Compact JSON of plain data.
///
/// # Panics
/// For a map whose keys are no texts.
pub(crate) fn json(value: &impl Serialize) -> String {
    let mut writer = serde_json::Serializer::with_formatter(Vec::new(), Written);
    value
        .serialize(&mut writer)
        .expect("plain data becomes JSON");
    String::from_utf8(writer.into_inner()).expect("JSON is text")
}

impl serde_json::ser::Formatter for Written {
    fn write_f64<W: ?Sized + std::io::Write>(
        &mut self,
        out: &mut W,
        x: f64,
    ) -> std::io::Result<()> {
        out.write_all(written(x).as_bytes())
    }
}

/// Breaks compact JSON into lines.
pub(crate) fn layout(json: &str) -> String {
    /// Columns that a joint of two rows fits.
    const WIDTH: usize = 140;
    let mut out = String::with_capacity(2 * json.len());
    let mut indent = 0;
    // Inside an object or list that fits its line: how deep.
    let mut inline = 0;
    let mut rest = json;
    while let Some(first) = rest.chars().next() {
        let (token, after) = rest.split_at(token_length(rest));
        match first {
            '{' | '[' => {
                let column = out.len() - out.rfind('\n').map_or(0, |n| n + 1);
                out.push(first);
                if inline > 0 || fits(rest, WIDTH.saturating_sub(column)) {
                    inline += 1;
                } else {
                    indent += 1;
                    new_line(&mut out, indent);
                }
            }
            '}' | ']' => {
                if inline > 0 {
                    inline -= 1;
                } else {
                    indent -= 1;
                    new_line(&mut out, indent);
                }
                out.push(first);
            }
            ',' if inline > 0 => out.push_str(", "),
            ',' => {
                out.push(',');
                new_line(&mut out, indent);
            }
            ':' => out.push_str(": "),
            _ => out.push_str(token),
        }
        rest = after;
    }
    out.push('\n');
    out
}

fn new_line(out: &mut String, indent: usize) {
    out.push('\n');
    out.extend(std::iter::repeat_n("  ", indent));
}

/// Bytes of the first token of compact JSON: a bracket, a comma, a colon, a string, or a word.
fn token_length(json: &str) -> usize {
    let bytes = json.as_bytes();
    match bytes[0] {
        b'"' => {
            let mut end = 1;
            while bytes[end] != b'"' {
                end += if bytes[end] == b'\\' { 2 } else { 1 };
            }
            end + 1
        }
        b'{' | b'}' | b'[' | b']' | b',' | b':' => 1,
        _ => json.find([',', '}', ']']).unwrap_or(json.len()),
    }
}

/// Does the object or list that begins here fit into so many columns?
fn fits(json: &str, columns: usize) -> bool {
    let (mut width, mut depth, mut rest) = (0, 0, json);
    while width <= columns {
        let (token, after) = rest.split_at(token_length(rest));
        width += token.len();
        match token {
            "{" | "[" => depth += 1,
            "}" | "]" => depth -= 1,
            "," | ":" => width += 1,
            _ => {}
        }
        if depth == 0 {
            return width <= columns;
        }
        rest = after;
    }
    false
}
