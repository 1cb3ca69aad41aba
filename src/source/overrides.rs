//! A document's text with one number or word of it changed: a parameter by its name, anything by its path.

use crate::document::fault::{Fault, FaultCode, Place, excerpt};
use crate::document::reader::Node;
use crate::document::schema::KeyFrameEntry;
use crate::document::text::{json, layout, node_of, not_json};
use crate::source::frames::PLAIN;
use crate::source::nearest::nearest;
use crate::source::typed::{Typed, is_in_radians};

/// A step of a path.
enum Key<'a> {
    Field(&'a str),
    Item(usize),
}

/// The text with `value` at `place`: the name of a parameter, or a path such as `chains[0].base.x` or `chains.0.base.x`.
/// The value is a number, a word, an expression, or JSON. Whether it fits there is found out when the text is opened.
///
/// # Errors
/// Where the text is no JSON, or the document has no such place.
pub fn set(text: &str, place: &str, value: &str) -> Result<String, Fault> {
    let place = place.trim();
    let keys = keys(place).ok_or_else(|| no_path(place))?;
    let value = value_of(value.trim());
    let mut node = node_of(text)?;
    // As in the page's address, a parameter goes before a field of the document that has its name.
    if let [Key::Field(name)] = keys[..]
        && let Some(parameter) = node
            .field_mut("parameters")
            .and_then(|all| all.field_mut(name))
    {
        *parameter = value;
        return Ok(layout(&json(&node)));
    }
    if find(&mut node, &keys).is_none() {
        // It may be one that the text leaves to its default.
        node = node_of(&Typed::read(text)?.text())?;
    }
    match find(&mut node, &keys) {
        Some(found) => *found = value,
        None => return Err(no_place(&mut node, place, &keys)),
    }
    Ok(layout(&json(&node)))
}

/// The text with these key frames, whose angles are in degrees, in place of its own or of its drivers.
///
/// # Errors
/// Where the text is no JSON.
pub fn set_key_frames(text: &str, key_frames: &[KeyFrameEntry]) -> Result<String, Fault> {
    let mut node = node_of(text)?;
    let list = json(&key_frames);
    let mut list: Node = serde_json::from_str(&list).map_err(|error| not_json(&error))?;
    if is_in_radians(&node) {
        for entry in list.items_mut() {
            for name in &PLAIN[3..] {
                if let Some(Node::Number(angle)) = entry.field_mut(name) {
                    *angle = angle.to_radians();
                }
            }
        }
    }
    if !node.has("motion") {
        node.set("motion", Node::object([]));
    }
    if let Some(motion) = node.field_mut("motion") {
        motion.take("drivers");
        motion.set("key_frames", list);
    }
    Ok(layout(&json(&node)))
}

/// `place=value` or `place:value`, as the command and the page's address take it, taken apart.
///
/// # Errors
/// Where there is no value.
pub fn change(text: &str) -> Result<(&str, &str), Fault> {
    text.split_once(['=', ':']).ok_or_else(|| no_path(text))
}

/// The steps of a path; `None` where the text is none.
fn keys(path: &str) -> Option<Vec<Key<'_>>> {
    let mut keys = Vec::new();
    for part in path.split('.') {
        let (name, mut rest) = part.split_at(part.find('[').unwrap_or(part.len()));
        let word = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        match name.parse() {
            Ok(index) if !keys.is_empty() => keys.push(Key::Item(index)),
            _ if word => keys.push(Key::Field(name)),
            _ => return None,
        }
        while !rest.is_empty() {
            let (index, after) = rest.strip_prefix('[')?.split_once(']')?;
            keys.push(Key::Item(index.parse().ok()?));
            rest = after;
        }
    }
    Some(keys)
}

/// Numbers, true, false, null and whole JSON are themselves, anything else is a text.
fn value_of(text: &str) -> Node {
    let plain = text.replace('\u{2212}', "-");
    serde_json::from_str(&plain).unwrap_or_else(|_| Node::Text(text.to_owned()))
}

fn find<'a>(node: &'a mut Node, keys: &[Key<'_>]) -> Option<&'a mut Node> {
    keys.iter().try_fold(node, |node, key| match key {
        Key::Field(name) => node.field_mut(name),
        Key::Item(index) => node.items_mut().get_mut(*index),
    })
}

fn no_path(text: &str) -> Fault {
    let what = format!(
        "\u{201c}{}\u{201d} is no change of a document",
        excerpt(text)
    );
    let accepted = "a parameter or a place and its value, such as base=400 or chains[0].base.x=1.2";
    Fault::new(
        FaultCode::Syntax,
        &Place::WHOLE.field("set"),
        &what,
        accepted,
    )
}

/// The fault of a path whose first steps, or none, the document has.
fn no_place(node: &mut Node, place: &str, keys: &[Key<'_>]) -> Fault {
    let names = |node: &mut Node| -> Vec<String> {
        node.fields_mut()
            .iter()
            .map(|(name, _)| name.clone())
            .collect()
    };
    let parameters = node.field_mut("parameters").map(names).unwrap_or_default();
    let known = (1..keys.len())
        .rev()
        .find(|&count| find(node, &keys[..count]).is_some());
    let known = known.unwrap_or(0);
    let mut holder = find(node, &keys[..known]);
    let entries = holder.as_ref().map_or(0, |holder| holder.items().len());
    let mut offered = holder
        .as_mut()
        .map(|holder| names(holder))
        .unwrap_or_default();
    if known == 0 {
        offered.splice(..0, parameters);
    }
    let close = match keys[known] {
        Key::Field(name) => nearest(name, offered.iter().map(String::as_str)),
        Key::Item(_) => None,
    };
    let meant = close.map_or_else(String::new, |close| {
        format!("; \u{201c}{close}\u{201d} may be meant")
    });
    let accepted = if entries > 0 {
        format!("an entry from 0 to {}", entries - 1)
    } else if offered.is_empty() {
        "a place that the document has".to_owned()
    } else {
        format!("one of {}", offered.join(", "))
    };
    let what = format!("the document has no such place{meant}");
    Fault::new(
        FaultCode::UnknownField,
        &Place::WHOLE.field(place),
        &what,
        &accepted,
    )
}

#[cfg(test)]
mod tests {
    use super::{change, set, set_key_frames};
    use crate::source::typed::Typed;

    const TEXT: &str = r#"{"version": 1, "parameters": {"base": 2, "half": "base/2"}, "chains": [{"base": {"x": "half"},
        "joints": [{"type": "S", "rows": [{}, {"alpha": 90}, {"alpha": -90}]}]}],
        "motion": {"key_frames": [{"x": "half"}, {"x": 1, "roll": 10}]}}"#;

    fn x(text: &str) -> f64 {
        Typed::read(text).expect("a document").document.chains[0]
            .base
            .x
    }

    #[test]
    fn parameters_and_places_are_set() {
        assert!((x(TEXT) - 1.0).abs() < 1e-15);
        for (place, value, expected) in [
            ("base", "5", 2.5),
            (" base ", " 2*4 ", 4.0),
            ("half", "7", 7.0),
            ("parameters.half", "base", 2.0),
            ("chains[0].base.x", "\u{2212}1.5", -1.5),
            ("chains.0.base.x", "base*3", 6.0),
            ("chains[0].base.y", "1", 1.0),
        ] {
            let found = x(&set(TEXT, place, value).expect(place));
            assert!((found - expected).abs() < 1e-15, "{place}: {found}");
        }
        // A parameter goes before a field of its name.
        let clash = TEXT.replace("\"base\": 2", "\"base\": 2, \"name\": 3");
        let text = set(&clash, "name", "8").expect("a parameter");
        let typed = Typed::read(&text).expect("a document");
        assert_eq!(typed.parameters.value("name"), Some(8.0));
        let read = |text: &str| Typed::read(text).expect("a document").document;
        assert_eq!(
            read(&set(TEXT, "motion.frames", "9").expect("a default"))
                .motion
                .frames,
            9
        );
        assert_eq!(
            read(&set(TEXT, "name", "a word").expect("a name")).name,
            "a word"
        );
        assert_eq!(change("a.b=c:d"), Ok(("a.b", "c:d")));
        assert_eq!(change("a[0]:c=d"), Ok(("a[0]", "c=d")));
    }

    #[test]
    fn key_frames_are_in_the_documents_unit_and_take_the_place_of_drivers() {
        let motion = TEXT.find("\"motion\"").expect("a motion");
        let driven = format!(
            "{}\"angles\": \"radians\", \"motion\": {{\"drivers\": [], \"frames\": 5}}}}",
            &TEXT[..motion]
        )
        .replace("\"alpha\": 90", "\"alpha\": \"90 deg\"")
        .replace("\"alpha\": -90", "\"alpha\": \"-90 deg\"");
        let key_frames = Typed::read(TEXT)
            .expect("a document")
            .document
            .motion
            .key_frames;
        for text in [TEXT, &driven] {
            let text = set_key_frames(text, &key_frames).expect("a document");
            let found = Typed::read(&text).expect("a document").document.motion;
            assert!((found.key_frames[1].roll - 10.0).abs() < 1e-12, "{text}");
            assert!(
                found.drivers.is_empty() && !text.contains("drivers"),
                "{text}"
            );
        }
    }

    #[test]
    fn places_that_are_none_are_told() {
        for (place, at, part) in [
            ("bsae", "bsae", "\u{201c}base\u{201d} may be meant"),
            ("width", "width", "Accepted: one of base, half, "),
            (
                "chains[1].base.x",
                "chains[1].base.x",
                "Accepted: an entry from 0 to 0.",
            ),
            (
                "chains[0].bose.x",
                "chains[0].bose.x",
                "\u{201c}base\u{201d} may be meant",
            ),
            (
                "chains[0].name.x",
                "chains[0].name.x",
                "a place that the document has",
            ),
            ("", "set", "is no change"),
            ("chains[", "set", "is no change"),
            ("chains[x]", "set", "is no change"),
            ("0.x", "0.x", "no such place"),
            ("a..b", "set", "is no change"),
        ] {
            let fault = set(TEXT, place, "1").expect_err(place);
            assert_eq!(fault.place, at, "{fault}");
            assert!(fault.message.contains(part), "{fault}");
        }
        assert!(change("base").is_err());
        assert!(set("{", "a", "1").is_err());
    }
}
