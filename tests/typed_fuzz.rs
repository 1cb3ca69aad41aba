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
        {"type": "S", "rows": [{"alpha": "q"}, {"alpha": "-q"}, {"alpha": 0.1, "a": 5, "d": "l/3"}]}],
      "gripper": {"z": 7, "matrix": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}, "start": [0.1, "q/9", -0.2, 0.3, 0.1, 0]},
    {"joints": [{"type": "C", "rows": [{"theta": "q"}]}, {"type": "E", "rows": [{}, {"alpha": "q", "theta": "q"}, {"alpha": "q"}]}]}],
  "motion": {"key_frames": [{"x": "l", "roll_pitch_yaw": [0.1, "q/5", 0.3], "order": "ZYX", "time": 0},
      {"x": 250, "quaternion_xyzw": [0, 0, 0, 1], "time": "2+1"}],
    "frames": "4+5", "radius": "l/7", "reference": [0, "r", 1]},
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
    let Ok(mut value) = serde_json::from_str::<Value>(text) else {
        return fault.code == FaultCode::Syntax || fault.place.is_empty();
    };
    let mut steps = Vec::new();
    for part in fault.place.split('.').filter(|part| !part.is_empty()) {
        let (name, indices) = part.split_once('[').unwrap_or((part, ""));
        steps.push(name.to_owned());
        steps.extend(
            indices
                .split(['[', ']'])
                .filter(|index| !index.is_empty())
                .map(str::to_owned),
        );
    }
    let last = steps.pop();
    for step in &steps {
        let next = match step.parse::<usize>() {
            Ok(index) => value.get_mut(index),
            Err(_) => value.get_mut(step.as_str()),
        };
        let Some(next) = next else {
            return false;
        };
        value = next.take();
    }
    match last.map(|last| last.parse::<usize>()) {
        Some(Ok(index)) => value.get(index).is_some(),
        Some(Err(_)) => value.is_object(),
        None => !value.is_object() || fault.code == FaultCode::DuplicateField,
    }
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
    for round in 0..6_000 {
        let mut text = texts[round % texts.len()].clone();
        for _ in 0..=random(3) {
            let found = tokens(&text);
            if found.is_empty() {
                break;
            }
            let (start, end) = found[random(found.len())];
            let (from, to) = found[random(found.len())];
            match random(8) {
                // A token of the text itself, nothing, a sign less, or something else in a token's place.
                0 => text.replace_range(start..end, &text[from..to].to_owned()),
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
    assert!(accepted > 300 && refused > 1_000, "{accepted} {refused}");
}
