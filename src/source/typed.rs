//! A document's text as a person typed it, and the plain document that it stands for.

use crate::document::fault::{Fault, Place};
use crate::document::reader::Node;
use crate::document::schema::Document;
use crate::document::text::{document_of, json, layout, node_of};
use crate::math::pose::Pose;
use crate::motion::trajectory::Warning;
use crate::source::parameters::{ExpressionValue, Parameters};
use crate::source::{chains, frames, values};
use serde::Deserialize;

/// The fields of a document.
const FIELDS: [&str; 11] = [
    "$schema",
    "version",
    "name",
    "about",
    "length_unit",
    "angles",
    "parameters",
    "home",
    "chains",
    "motion",
    "planner",
];

/// What was read.
#[derive(Clone, Debug)]
pub struct Typed {
    /// What the planner knows of: numbers, degrees, rows.
    pub document: Document,
    /// What the conversion gives reason to warn of.
    pub notes: Vec<Warning>,
    /// Its parameters with their values.
    pub parameters: Parameters,
    /// The value of each expression in it, but for those of its parameters.
    pub expressions: Vec<ExpressionValue>,
    /// As it was typed; `None` where that is a plain document.
    node: Option<Node>,
    /// Of the same: home and chains with numbers for expressions, in degrees; still by axes and in their conventions.
    numbers: Option<Node>,
}

impl Typed {
    /// Reads a document with expressions, chains by their axes and tables and frames in other conventions.
    ///
    /// # Errors
    /// Where the text is no document of this version, or an expression or an axis is at fault.
    pub fn read(text: &str) -> Result<Self, Fault> {
        let given = node_of(text)?;
        if let Ok(document) = document_of(&given) {
            return Ok(Self {
                document,
                notes: Vec::new(),
                parameters: Parameters::default(),
                expressions: Vec::new(),
                node: None,
                numbers: None,
            });
        }
        given.only(&FIELDS, &Place::WHOLE)?;
        let mut node = given.clone();
        chains::letters(&mut node);
        let (parameters, expressions) = values::evaluate(&mut node)?;
        frames::to_plain(&mut node)?;
        let part = |name: &str| node.field(name).cloned().unwrap_or(Node::Null);
        let numbers = Node::object([("home", part("home")), ("chains", part("chains"))]);
        let notes = chains::to_plain(&mut node)?;
        Ok(Self {
            document: document_of(&node)?,
            notes,
            parameters,
            expressions,
            node: Some(given),
            numbers: Some(numbers),
        })
    }

    /// Is it more than the plain document?
    pub fn is_typed(&self) -> bool {
        self.node.is_some()
    }

    /// Are all chains given by tables whose convention is not named?
    pub(crate) fn names_no_convention(&self) -> bool {
        let chains = self.node.as_ref().and_then(|node| node.field("chains"));
        let chains = chains.map_or(&[][..], Node::items);
        !chains
            .iter()
            .any(|chain| chain.has("convention") || chains::is_by_axes(chain))
    }

    /// Home and chains of a typed document with numbers for expressions, in degrees; chains by axes stay so.
    pub(crate) fn numbers(&self) -> Option<&Node> {
        self.numbers.as_ref()
    }

    /// Are its angles in radians?
    pub(crate) fn in_radians(&self) -> bool {
        self.node.as_ref().is_some_and(is_in_radians)
    }

    /// The home position, if a chain other than `index` is given by its axes.
    pub(crate) fn shared_home(&self, index: usize) -> Option<Pose> {
        let numbers = self.numbers()?;
        let mut chains = numbers.field("chains")?.items().iter().enumerate();
        chains
            .any(|(i, chain)| i != index && chains::is_by_axes(chain))
            .then(|| chains::home(numbers).ok())?
    }

    /// A chain as it was typed.
    pub(crate) fn chain(&self, index: usize) -> Node {
        let typed = self.node.as_ref().and_then(|node| node.field("chains"));
        let chain = typed.and_then(|chains| chains.items().get(index));
        chain.cloned().unwrap_or_else(|| {
            Node::object([("name", Node::Text(self.document.chains[index].name.clone()))])
        })
    }

    /// The document as it was typed, with every default written out.
    ///
    /// # Panics
    /// Never: what was read once is read again.
    pub fn text(&self) -> String {
        match &self.node {
            None => self.document.text(),
            Some(given) => written(&with_defaults(given)),
        }
    }

    /// The same with these start values, chain by chain.
    ///
    /// # Panics
    /// Never: what was read once is read again.
    pub fn text_with_start(&self, start: Vec<Vec<f64>>) -> String {
        let mut node = match &self.node {
            Some(given) => given.clone(),
            None => node_of(&self.document.text()).expect("its own text"),
        };
        let in_radians = self.in_radians();
        let entries = self.document.chains.iter();
        let turns = entries.map(|chain| chain.joints.iter().flat_map(|joint| joint.kind.turning()));
        let chains = node
            .field_mut("chains")
            .map_or(&mut [][..], Node::items_mut);
        for ((chain, values), turns) in chains.iter_mut().zip(start).zip(turns) {
            let values = values.into_iter().zip(turns).map(|(value, turns)| {
                Node::Number(if turns && in_radians {
                    value.to_radians()
                } else {
                    value
                })
            });
            chain.set("start", Node::List(values.collect()));
        }
        written(&with_defaults(&node))
    }
}

/// Are the angles of this document, which may be any, in radians?
pub(crate) fn is_in_radians(document: &Node) -> bool {
    document.field("angles").and_then(Node::as_text) == Some("radians")
}

fn written(node: &Node) -> String {
    layout(&json(node))
}

/// A typed document with what it leaves out; what it gives in another way is not added.
fn with_defaults(given: &Node) -> Node {
    let mut shape = given.clone();
    chains::letters(&mut shape);
    let mut typed = shape.clone();
    for name in ["angles", "parameters", "home"] {
        shape.take(name);
    }
    bare(&mut shape, "");
    let document = Document::deserialize(&shape).expect("the shape of a document that was read");
    let defaults = node_of(&json(&document)).expect("its own text");
    for (i, chain) in typed
        .field_mut("chains")
        .map_or(&mut [][..], Node::items_mut)
        .iter_mut()
        .enumerate()
    {
        if chain.name().is_empty() {
            chain.set("name", Node::Text(format!("chain {}", i + 1)));
        }
    }
    over(defaults, typed)
}

/// A document of the same shape with numbers for expressions, and without what only typed documents have.
fn bare(node: &mut Node, field: &str) {
    match node {
        Node::Text(_) if values::NUMBERS.contains(&field) => *node = Node::Number(1.0),
        Node::List(items) => items.iter_mut().for_each(|item| bare(item, field)),
        Node::Object(fields) => {
            if fields
                .iter()
                .any(|(name, _)| chains::AXES.contains(&name.as_str()))
            {
                fields.push(("rows".to_owned(), Node::List(Vec::new())));
            }
            fields.retain(|(name, _)| {
                let name = name.as_str();
                !(frames::OTHER.contains(&name)
                    || chains::AXES.contains(&name)
                    || name == "convention")
            });
            fields
                .iter_mut()
                .for_each(|(name, value)| bare(value, name));
        }
        Node::Null | Node::Bool(_) | Node::Number(_) | Node::Text(_) => {}
    }
}

/// Defaults with what was typed over them, in the order of the defaults.
fn over(defaults: Node, typed: Node) -> Node {
    match (defaults, typed) {
        (Node::Object(defaults), Node::Object(mut typed)) => {
            let there = |name: &str| typed.iter().any(|(n, _)| n == name);
            let rotated = frames::OTHER.iter().any(|name| there(name));
            let axes = |joint: &Node| chains::AXES.iter().any(|name| joint.has(name));
            let joint_by_axes = chains::AXES.iter().any(|name| there(name));
            let chain_by_axes = typed
                .iter()
                .any(|(name, value)| name == "joints" && value.items().iter().any(axes));
            let hidden = |name: &str| {
                (rotated && frames::PLAIN[3..].contains(&name))
                    || (joint_by_axes && name == "rows")
                    || (chain_by_axes && ["base", "gripper"].contains(&name))
            };
            let mut fields = Vec::new();
            for (name, value) in defaults {
                let own = typed.iter().position(|(n, _)| *n == name);
                match own.map(|at| typed.remove(at).1) {
                    Some(own) => fields.push((name, over(value, own))),
                    None if hidden(&name) => {}
                    None => fields.push((name, value)),
                }
            }
            // What only typed documents have stands before the long lists.
            let at = fields
                .iter()
                .position(|(_, value)| matches!(value, Node::List(_)))
                .unwrap_or(fields.len());
            fields.splice(at..at, typed);
            Node::Object(fields)
        }
        (Node::List(defaults), Node::List(typed)) if defaults.len() == typed.len() => Node::List(
            defaults
                .into_iter()
                .zip(typed)
                .map(|(d, t)| over(d, t))
                .collect(),
        ),
        (_, typed) => typed,
    }
}
