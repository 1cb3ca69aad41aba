//! Why a value does not fit a document, and the way to it: serde's error as a fault with its place.

#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
use crate::document::fault::excerpt;
use crate::document::fault::{Fault, FaultCode, Place, told};
use serde::de::Error;
use std::fmt;

/// Why a derived reader does not take a value, and the way to it from there outwards.
#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
#[derive(Debug)]
pub(crate) struct Refusal {
    code: FaultCode,
    what: String,
    accepted: String,
    optional: bool,
    way: Vec<Step>,
}

#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
#[derive(Debug)]
enum Step {
    Field(String),
    Item(usize),
}

#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
impl Refusal {
    #[cold]
    #[inline(never)]
    pub(super) fn new(code: FaultCode, what: String, accepted: &str) -> Self {
        Self {
            code,
            what,
            accepted: accepted.to_owned(),
            optional: false,
            way: Vec::new(),
        }
    }

    #[cold]
    #[inline(never)]
    pub(super) fn in_field(mut self, name: &str) -> Self {
        self.way.push(Step::Field(name.to_owned()));
        self
    }

    #[cold]
    #[inline(never)]
    pub(super) fn in_item(mut self, index: usize) -> Self {
        self.way.push(Step::Item(index));
        self
    }

    /// For a field that is none of those known.
    pub(crate) fn unknown(name: &str, known: &[&str]) -> Self {
        let what = format!("there is no field \u{201c}{}\u{201d} here", excerpt(name));
        Self::new(FaultCode::UnknownField, what, &one_of(known))
    }

    /// For a value that may be null: what is refused is the value itself.
    #[cold]
    #[inline(never)]
    pub(super) fn or_null(mut self) -> Self {
        self.optional |= self.way.is_empty();
        self
    }

    /// The fault, in a value at `place`.
    pub(crate) fn fault(mut self, place: &Place<'_>) -> Fault {
        match self.way.pop() {
            Some(Step::Field(name)) => self.fault(&place.field(&name)),
            Some(Step::Item(index)) => self.fault(&place.item(index)),
            None => {
                let fault = Fault::new(self.code, place, &self.what, &self.accepted);
                if self.optional {
                    fault.or_null()
                } else {
                    fault
                }
            }
        }
    }
}

#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.what)
    }
}

#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
impl std::error::Error for Refusal {}

/// What the derived readers say.
#[cfg(any(feature = "study", not(target_arch = "wasm32")))]
impl Error for Refusal {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self::new(FaultCode::WrongType, message.to_string(), "another value")
    }

    fn unknown_field(name: &str, known: &'static [&'static str]) -> Self {
        Self::unknown(name, known)
    }

    fn missing_field(name: &'static str) -> Self {
        let accepted = match name {
            "version" => "1",
            "chains" => "a list of chains",
            "joints" => "a list of joints",
            "type" => "one of R, P, C, T, S, E",
            "rows" => "a list of the joint's rows",
            #[cfg(not(feature = "study"))]
            "motion" => "an object with key_frames",
            #[cfg(feature = "study")]
            "motion" => "an object with key_frames, or with drivers",
            #[cfg(not(feature = "study"))]
            "key_frames" => "a list of two or more key frames",
            #[cfg(feature = "study")]
            "key_frames" => "a list of two or more key frames, or drivers in their place",
            #[cfg(feature = "study")]
            "chain" | "joint" => "a whole number, counted from 1",
            #[cfg(feature = "study")]
            "values" => "a list of two or more times and values",
            #[cfg(feature = "study")]
            "time" | "value" => "a number",
            _ => "a value",
        };
        Self::new(
            FaultCode::MissingField,
            "this is missing".to_owned(),
            accepted,
        )
        .in_field(name)
    }

    fn duplicate_field(name: &'static str) -> Self {
        let what = format!("there are two fields \u{201c}{name}\u{201d}");
        Self::new(FaultCode::DuplicateField, what, &format!("{name} once"))
    }

    fn unknown_variant(word: &str, known: &'static [&'static str]) -> Self {
        let what = format!("\u{201c}{}\u{201d} is unknown", excerpt(word));
        Self::new(FaultCode::UnknownValue, what, &one_of(known))
    }
}

/// A value that a derived reader does not take: without words.
#[cfg(all(target_arch = "wasm32", not(feature = "study")))]
#[derive(Clone, Copy, Debug)]
pub(crate) struct Refusal;

#[cfg(all(target_arch = "wasm32", not(feature = "study")))]
impl Refusal {
    pub(super) fn new(_code: FaultCode, _what: String, _accepted: &str) -> Self {
        Self
    }

    pub(super) fn in_field(self, _name: &str) -> Self {
        self
    }

    pub(super) fn in_item(self, _index: usize) -> Self {
        self
    }

    pub(super) fn or_null(self) -> Self {
        self
    }

    pub(crate) fn fault(self, _place: &Place<'_>) -> Fault {
        Fault
    }
}

#[cfg(all(target_arch = "wasm32", not(feature = "study")))]
impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("refused")
    }
}

#[cfg(all(target_arch = "wasm32", not(feature = "study")))]
impl std::error::Error for Refusal {}

#[cfg(all(target_arch = "wasm32", not(feature = "study")))]
impl Error for Refusal {
    fn custom<T: fmt::Display>(_message: T) -> Self {
        Self
    }

    fn unknown_field(_name: &str, _known: &'static [&'static str]) -> Self {
        Self
    }

    fn missing_field(_name: &'static str) -> Self {
        Self
    }

    fn duplicate_field(_name: &'static str) -> Self {
        Self
    }

    fn unknown_variant(_word: &str, _known: &'static [&'static str]) -> Self {
        Self
    }
}

pub(crate) fn one_of(words: &[&str]) -> String {
    told!("one of {}", words.join(", "))
}
