//! Text to document and back: reading that says what is wrong, writing that a person can read.

use crate::document::{
    ChainEntry, Document, FrameEntry, JointEntry, KeyFrameEntry, LimitsEntry, MotionEntry,
    PlannerEntry, RowEntry, UNKNOWN_VERSION, VERSION,
};
use crate::fault::{Fault, FaultCode, Place, excerpt};
use serde::de::{Deserialize, Deserializer, Visitor};
use serde::ser::{Serialize, Serializer};
use serde_path_to_error::Segment;

/// Bytes of the longest text that is read at all: ten times what 500 key frames with names take.
pub const MAX_TEXT: usize = 1_000_000;

/// Reads a document; defaults are filled in. What its numbers mean is checked by
/// [`crate::problem::Problem::new`].
///
/// # Errors
/// Where the text is no document of this version.
pub fn parse(text: &str) -> Result<Document, Fault> {
    let whole = Place::WHOLE;
    if text.len() > MAX_TEXT {
        let what = format!("{} bytes of text are too many", text.len());
        return Err(Fault::new(
            FaultCode::TextTooLong,
            &whole,
            &what,
            "up to 1,000,000 bytes",
        ));
    }
    // Some editors put a byte-order mark before the text.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim().is_empty() {
        let what = "there is no text";
        return Err(Fault::new(
            FaultCode::EmptyText,
            &whole,
            what,
            "a mechanism document in JSON",
        ));
    }
    let mut reader = serde_json::Deserializer::from_str(text);
    let mut document: Document = serde_path_to_error::deserialize(&mut reader)
        .map_err(|e| fault(&mut e.path().iter(), &whole, e.inner()))?;
    reader.end().map_err(|e| explain(&e, &whole))?;
    for (i, chain) in document.chains.iter_mut().enumerate() {
        if chain.name.is_empty() {
            chain.name = format!("chain {}", i + 1);
        }
    }
    Ok(document)
}

/// The fault at the place where the reader stopped: the rest of its path from `place` on.
fn fault(
    path: &mut dyn Iterator<Item = &Segment>,
    place: &Place<'_>,
    error: &serde_json::Error,
) -> Fault {
    match path.next() {
        Some(Segment::Seq { index }) => fault(path, &place.item(*index), error),
        Some(Segment::Map { key }) => fault(path, &place.field(key), error),
        Some(Segment::Enum { .. } | Segment::Unknown) => fault(path, place, error),
        None => explain(error, place),
    }
}

/// The fault that serde's message tells of.
fn explain(error: &serde_json::Error, place: &Place<'_>) -> Fault {
    let text = error.to_string();
    // "… at line 3 column 7"
    let message = text.rsplit_once(" at line ").map_or(text.as_str(), |(message, _)| message);
    let fault = translate(message, place);
    if error.line() > 0 { fault.at(error.line(), error.column()) } else { fault }
}

/// Puts serde's message, the only form in which it tells what it met, into the words of a [`Fault`].
/// The tests hold every case against the real messages.
fn translate(message: &str, place: &Place<'_>) -> Fault {
    const KINDS: [&str; 7] = [
        UNKNOWN_VERSION,
        "unknown field ",
        "unknown variant ",
        "duplicate field ",
        "missing field ",
        "invalid type: ",
        "invalid value: ",
    ];
    let (found, expected) = message.rsplit_once(", expected ").unwrap_or((message, ""));
    let kind = KINDS
        .into_iter()
        .find(|kind| found.starts_with(kind))
        .unwrap_or(message);
    let value = found.strip_prefix(kind).unwrap_or_default();
    let word = excerpt(value.trim_matches('`'));
    let (code, what, accepted) = match kind {
        UNKNOWN_VERSION => (
            FaultCode::UnknownVersion,
            format!("this is version {word} of the format"),
            VERSION.to_string(),
        ),
        "unknown field " => (
            FaultCode::UnknownField,
            format!("there is no field \u{201c}{word}\u{201d} here"),
            one_of(expected),
        ),
        "unknown variant " => (
            FaultCode::UnknownValue,
            format!("\u{201c}{word}\u{201d} is unknown"),
            one_of(expected),
        ),
        "duplicate field " => (
            FaultCode::DuplicateField,
            format!("there are two fields \u{201c}{word}\u{201d}"),
            format!("{word} once"),
        ),
        "missing field " => {
            return Fault::new(
                FaultCode::MissingField,
                &place.field(&word),
                "this is missing",
                describe(&word),
            );
        }
        "invalid type: " => (
            FaultCode::WrongType,
            format!("this is {}", found_value(value)),
            expected_type(expected).into(),
        ),
        "invalid value: " => (
            FaultCode::OutOfRange,
            format!("this is {}", found_value(value)),
            expected_type(expected).into(),
        ),
        "number out of range" => (
            FaultCode::OutOfRange,
            "a number is out of range".into(),
            "numbers up to 1000000".into(),
        ),
        _ => (
            FaultCode::Syntax,
            format!("this is not JSON, {}", excerpt(message)),
            "JSON text".into(),
        ),
    };
    Fault::new(code, place, &what, &accepted)
}

/// "one of `a`, `b`" or "`a` or `b`", without the quotes.
fn one_of(expected: &str) -> String {
    let words = expected
        .trim_start_matches("one of ")
        .replace('`', "")
        .replace(" or ", ", ");
    if words.is_empty() {
        "no field".to_owned()
    } else {
        format!("one of {words}")
    }
}

/// What a field that must be there holds.
fn describe(field: &str) -> &'static str {
    match field {
        "version" => "1",
        "chains" => "a list of chains",
        "joints" => "a list of joints",
        "type" => "one of R, P, C, T, S, E",
        "rows" => "a list of the joint's rows",
        "motion" => "an object with key_frames",
        "key_frames" => "a list of two or more key frames",
        _ => "the field",
    }
}

/// serde's words for what it found, as a person would say: integer `3`, string "a", sequence.
fn found_value(value: &str) -> String {
    let (kind, shown) = value.split_once(' ').unwrap_or((value, ""));
    match kind {
        "integer" | "floating" => format!(
            "the number {}",
            shown.trim_start_matches("point ").trim_matches('`')
        ),
        "boolean" => shown.trim_matches('`').to_owned(),
        "string" => format!("the text {}", excerpt(shown)),
        "sequence" => "a list".to_owned(),
        "map" => "an object".to_owned(),
        _ => excerpt(value),
    }
}

/// serde's names of Rust's types, as a person would say.
fn expected_type(expected: &str) -> &str {
    match expected {
        "f64" => "a number",
        "u32" => "a whole number, 0 or more",
        "a sequence" => "a list",
        "a string" => "a text in quotes",
        other if other.starts_with("struct ") => "an object in braces",
        other => other,
    }
}

/// serde's derived readers also take a list with the fields' values in order; a document does not.
struct AsObject<D>(D);

impl<'de, D: Deserializer<'de>> Deserializer<'de> for AsObject<D> {
    type Error = D::Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, D::Error> {
        self.0.deserialize_map(visitor)
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit
        unit_struct newtype_struct seq tuple tuple_struct map struct enum identifier ignored_any
    }
}

/// The derived reader behind [`AsObject`], and the derived writer as it is.
macro_rules! objects {
    ($($entry:ty),*) => {$(
        impl<'de> Deserialize<'de> for $entry {
            #[inline(never)]
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                <$entry>::deserialize(AsObject(deserializer))
            }
        }

        impl Serialize for $entry {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                <$entry>::serialize(self, serializer)
            }
        }
    )*};
}

objects!(
    Document,
    ChainEntry,
    JointEntry,
    RowEntry,
    LimitsEntry,
    FrameEntry,
    MotionEntry,
    KeyFrameEntry,
    PlannerEntry
);

impl Document {
    /// The document as JSON with all its fields; what fits stays on one line, and numbers have up to
    /// 15 digits. What was read from such a text is written as the same text again.
    ///
    /// # Panics
    /// Never: the document holds nothing that JSON cannot.
    pub fn text(&self) -> String {
        let mut writer = serde_json::Serializer::with_formatter(Vec::new(), ShortNumbers);
        self.serialize(&mut writer).expect("plain data becomes JSON");
        layout(&String::from_utf8(writer.into_inner()).expect("JSON is text"))
    }
}

/// Compact JSON with short numbers: 1 and not 1.0, 45 and not 44.99999999999999.
///
/// They have the 15 digits that a double always keeps. serde_json's quick reader may miss the last
/// bit of a longer number, and with 15 digits a normalised document still stays as it is; its exact
/// reader would add 13 kB to what a page loads.
struct ShortNumbers;

impl serde_json::ser::Formatter for ShortNumbers {
    fn write_f64<W: ?Sized + std::io::Write>(&mut self, out: &mut W, x: f64) -> std::io::Result<()> {
        if x == 0.0 {
            return out.write_all(b"0");
        }
        let scientific = format!("{x:.14e}");
        let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
        let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
        let places = mantissa.split_once('.').map_or(0, |(_, places)| places.len());
        match exponent.parse::<isize>() {
            Ok(exponent @ -6..15) => {
                let places = places.saturating_add_signed(-exponent);
                write!(out, "{x:.places$}")
            }
            _ => write!(out, "{mantissa}e{exponent}"),
        }
    }
}

/// Breaks compact JSON into lines.
fn layout(json: &str) -> String {
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
