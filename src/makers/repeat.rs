//! Parts of a document that are written several times: an object in a list with `"repeat": 3`.

use crate::document::reader::Node;
use crate::makers::maker::{Input, Kind};

/// How often a part may be repeated: the chains of a mechanism at most, and more than any list of legs.
const MOST: f64 = 24.0;

/// Writes each object with `repeat` as often as that says, in its place. In its texts `{i}` is 0, 1, 2 and so on, or the
/// entry of the list that `repeat` names; `{n}` is one more, and `{count}` how many there are.
///
/// # Panics
/// If `repeat` is no count and no input's name, which is a fault of the maker's file.
pub(crate) fn repeat(node: &mut Node, inputs: &[(&Input, Vec<f64>)]) {
    match node {
        Node::List(items) => {
            for mut item in std::mem::take(items) {
                let Some(times) = item.take("repeat") else {
                    items.push(item);
                    continue;
                };
                let entries = entries(&times, inputs);
                for &entry in &entries {
                    let mut copy = item.clone();
                    write(&mut copy, entry, entries.len());
                    items.push(copy);
                }
            }
            items.iter_mut().for_each(|item| repeat(item, inputs));
        }
        Node::Object(fields) => {
            for (_, value) in fields {
                repeat(value, inputs);
            }
        }
        Node::Null | Node::Bool(_) | Node::Number(_) | Node::Text(_) => {}
    }
}

/// What `{i}` is, one after the other.
fn entries(times: &Node, inputs: &[(&Input, Vec<f64>)]) -> Vec<f64> {
    let count = match times {
        Node::Number(count) => *count,
        Node::Text(name) => {
            let named = inputs.iter().find(|(input, _)| input.name == *name);
            let (input, values) = named.expect("the name of an input");
            if input.is == Kind::List {
                return values.clone();
            }
            values[0]
        }
        Node::Null | Node::Bool(_) | Node::List(_) | Node::Object(_) => {
            panic!("a part is repeated a number of times, or for each entry of a list")
        }
    };
    assert!((0.0..=MOST).contains(&count), "repeated {count} times");
    let mut entries = Vec::new();
    while (entries.len() as f64) < count {
        entries.push(entries.len() as f64);
    }
    entries
}

fn write(node: &mut Node, entry: f64, count: usize) {
    match node {
        Node::Text(text) if text.contains('{') => {
            *text = (text.replace("{i}", &entry.to_string()))
                .replace("{n}", &(entry + 1.0).to_string())
                .replace("{count}", &count.to_string());
        }
        Node::List(items) => items.iter_mut().for_each(|item| write(item, entry, count)),
        Node::Object(fields) => {
            for (_, value) in fields {
                write(value, entry, count);
            }
        }
        Node::Null | Node::Bool(_) | Node::Number(_) | Node::Text(_) => {}
    }
}
