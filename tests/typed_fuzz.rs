//! Mutilated documents with expressions, chains by their axes, drivers, radians and standard tables: an answer or a
//! fault at a place that was typed, never a panic.

use serde_json::Value;
use synthetica::document::fault::{Fault, FaultCode};
use synthetica::makers::from_type::from_type;
use synthetica::{Session, source::typed::Typed};

/// A standard table with joints of two and three rows, in radians, frames in all forms, expressions in all kinds of fields.
const TABLES: &str = r#"{"version": 1, "name": "all", "angles": "radians", "length_unit": "mm",
  "parameters": {"l": "2*r", "r": 150, "q": "pi/2"},
  "chains": [
    {"name": "arm", "convention": "standard", "base": {"x": "l", "quaternion_wxyz": ["cos(q/2)", 0, 0, "sin(q/2)"]},
      "joints": [{"type": "R", "rows": [{"alpha": "-q", "a": "r", "theta": 0.2, "d": 10}], "limits": [{"min": -2, "max": "q"}]},
        {"type": "u", "rows": [{"alpha": "q"}, {"a": "l", "alpha": 0.3}]},
        {"type": "P", "rows": [{"theta": 1}], "limits": [{"max": "r"}]}],
      "gripper": {"z": 7, "matrix": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}, "start": [0.1, "q/9", -0.2, 0.3]},
    {"convention": "standard", "joints": [{"type": "p", "rows": [{"a": 7}]},
      {"type": "S", "rows": [{"alpha": "q"}, {"alpha": "-q"}, {"alpha": 0.1, "a": 5, "d": "l/3"}]}]},
    {"joints": [{"type": "C", "rows": [{"theta": "q"}]}, {"type": "E", "rows": [{}, {"alpha": "q", "theta": "q"}, {"alpha": "q"}]}]}],
  "motion": {"key_frames": [{"x": "l", "roll_pitch_yaw": [0.1, "q/5", 0.3], "order": "ZYX", "time": 0},
      {"x": 250, "quaternion_xyzw": [0, 0, 0, 1], "time": "2+1"}],
    "frames": "4+5", "radius": "l*7", "reference": [0, "r", 1]},
  "planner": {"metric_length": "r+1", "dimension_tolerance": "1/1000", "max_iterations": 50}}"#;

fn texts() -> Vec<String> {
    let made = |name| from_type(name).unwrap_or_else(|fault| panic!("{fault}"));
    let mut texts = vec![TABLES.to_owned(), made("delta?unit=m"), made("four-bar?")];
    texts.push(made("four-bar?").replacen(
        "\"length_unit\"",
        "\"angles\": \"radians\", \"length_unit\"",
        1,
    ));
    texts
}

const PIECES: [&str; 40] = [
    "null",
    "true",
    "[]",
    "{}",
    "0",
    "-1",
    "9",
    "1e12",
    "1e300",
    "-1e-320",
    "1e999",
    "90",
    "\"\"",
    "\"(\"",
    "\"1/0\"",
    "\"sqrt(-1)\"",
    "\"1e300*1e300\"",
    "\"pi/2\"",
    "\"1.2 rad\"",
    "\"r\"",
    "\"base\"",
    "\"crank*2\"",
    "\"\u{e4}\"",
    "\"u\"",
    "\"P\"",
    "\"S\"",
    "\"E\"",
    "\"C\"",
    "\"rows\"",
    "\"axis\"",
    "\"second\"",
    "\"point\"",
    "\"limits\"",
    "\"standard\"",
    "\"modified\"",
    "\"radians\"",
    "\"home\"",
    "\"smooth\"",
    "[1, 0, 0]",
    "[0, \"1e-9\", 1]",
];

/// Where the tokens of a JSON text are: texts, numbers and words, but for the signs between them.
fn tokens(text: &str) -> Vec<(usize, usize)> {
    let bytes = text.as_bytes();
    let (mut found, mut at) = (Vec::new(), 0);
    while at < bytes.len() {
        let start = at;
        at += 1;
        match bytes[start] {
            b'"' => {
                while at < bytes.len() && bytes[at] != b'"' {
                    at += 1;
                }
                at = (at + 1).min(bytes.len());
                found.push((start, at));
            }
            byte if byte.is_ascii_alphanumeric() || byte == b'-' => {
                while at < bytes.len() && !b",]} \n:".contains(&bytes[at]) {
                    at += 1;
                }
                found.push((start, at));
            }
            _ => {}
        }
    }
    found
}

/// The fault is at a value of the text, or at a field that could be beside those there are.
fn is_typed(text: &str, fault: &Fault) -> bool {
    let Ok(value) = serde_json::from_str::<Value>(text) else {
        return fault.code == FaultCode::Syntax || fault.code == FaultCode::DuplicateField;
    };
    let (mut value, mut rest) = (&value, fault.place.as_str());
    while !rest.is_empty() {
        let next = match value {
            Value::Object(fields) => {
                let name = rest.strip_prefix('.').unwrap_or(rest);
                // Names may have points and brackets in them: the longest that fits.
                let fits = |(key, _): &(&String, &Value)| {
                    let end = name.strip_prefix(key.as_str());
                    end.is_some_and(|end| end.is_empty() || end.starts_with(['.', '[']))
                };
                let found = fields.iter().filter(fits).max_by_key(|(key, _)| key.len());
                let Some((key, value)) = found else {
                    // Of a long name of a field that there is not only the beginning is told.
                    return !name.contains(['.', '[']) || name.ends_with('\u{2026}');
                };
                (value, &name[key.len()..])
            }
            Value::Array(items) => {
                let index = rest.strip_prefix('[').and_then(|rest| rest.split_once(']'));
                let found = index.and_then(|(index, rest)| {
                    Some((items.get(index.parse::<usize>().ok()?)?, rest))
                });
                let Some(found) = found else {
                    return false;
                };
                found
            }
            Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => return false,
        };
        (value, rest) = next;
    }
    // A field without a name has the place of what it is in.
    !fault.place.is_empty()
        || !value.is_object()
        || matches!(
            fault.code,
            FaultCode::UnknownField | FaultCode::DuplicateField
        )
}

#[test]
fn mutilated_typed_documents_have_an_answer_or_a_fault_at_a_typed_place() {
    let texts = texts();
    for text in &texts {
        let open = Session::open(text).unwrap_or_else(|fault| panic!("{fault}"));
        assert!(open.typed().is_typed());
    }
    let mut state = 11_u64;
    let mut random = |below: usize| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        usize::try_from((state >> 33) % below as u64).expect("below")
    };
    let (mut accepted, mut refused) = (0, 0);
    for round in 0..4_000 {
        let mut text = texts[round % texts.len()].clone();
        for _ in 0..=random(2) {
            let mut found = tokens(&text);
            if random(4) > 0 {
                // Values rather than names of fields.
                found.retain(|&(_, end)| !text[end..].starts_with(':'));
            }
            if found.is_empty() {
                break;
            }
            let (start, end) = found[random(found.len())];
            let (from, to) = found[random(found.len())];
            let other = text[from..to].to_owned();
            match random(8) {
                // A token of the text itself, nothing, a sign less, or something else in a token's place.
                0 => text.replace_range(start..end, &other),
                1 => text.replace_range(start..end, ""),
                2 if text.is_char_boundary(end + 1) => text.replace_range(start..end + 1, ""),
                _ => text.replace_range(start..end, PIECES[random(PIECES.len())]),
            }
        }
        let fault = match Session::open(&text) {
            Ok(open) => {
                accepted += 1;
                let normal = open.text();
                let again = Typed::read(&normal).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
                assert_eq!(again.text(), normal, "{text}");
                continue;
            }
            Err(fault) => fault,
        };
        refused += 1;
        assert!(
            !fault.accepted.is_empty() && fault.message.len() < 1_000,
            "{fault}\n{text}"
        );
        assert!(is_typed(&text, &fault), "{}: {fault}\n{text}", fault.place);
    }
    // The mutations are mild enough to get past the reader, and strong enough to be refused.
    assert!(accepted > 200 && refused > 1_000, "{accepted} {refused}");
}
