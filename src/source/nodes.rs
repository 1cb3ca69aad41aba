//! JSON values changed in place, and written again.

use crate::document::bounds::wrong_count;
use crate::document::fault::{Fault, Place};
use crate::document::reader::Node;
use crate::document::refusal::Refusal;
use serde::ser::{Serialize, SerializeMap, Serializer};

impl Node {
    /// The value of an object's field.
    pub(crate) fn field_mut(&mut self, name: &str) -> Option<&mut Self> {
        let fields = self.fields_mut();
        let mut named = fields.iter_mut().filter(|(n, _)| n == name);
        named.next().map(|(_, value)| value)
    }

    /// Takes a field out.
    pub(crate) fn take(&mut self, name: &str) -> Option<Self> {
        let Self::Object(fields) = self else {
            return None;
        };
        let at = fields.iter().position(|(n, _)| n == name)?;
        Some(fields.remove(at).1)
    }

    /// Sets a field.
    pub(crate) fn set(&mut self, name: &str, value: Self) {
        if let Some(old) = self.field_mut(name) {
            *old = value;
        } else if let Self::Object(fields) = self {
            fields.push((name.to_owned(), value));
        }
    }

    /// An object's fields; none of another value.
    pub(crate) fn fields_mut(&mut self) -> &mut [(String, Self)] {
        match self {
            Self::Object(fields) => fields,
            Self::Null | Self::Bool(_) | Self::Number(_) | Self::Text(_) | Self::List(_) => &mut [],
        }
    }

    /// The entries of a list; none of another value.
    pub(crate) fn items_mut(&mut self) -> &mut [Self] {
        match self {
            Self::List(items) => items,
            Self::Null | Self::Bool(_) | Self::Number(_) | Self::Text(_) | Self::Object(_) => {
                &mut []
            }
        }
    }

    /// The same.
    pub(crate) fn items(&self) -> &[Self] {
        match self {
            Self::List(items) => items,
            Self::Null | Self::Bool(_) | Self::Number(_) | Self::Text(_) | Self::Object(_) => &[],
        }
    }

    /// Is there such a field, and is it not null?
    pub(crate) fn has(&self, name: &str) -> bool {
        self.field(name)
            .is_some_and(|value| !matches!(value, Self::Null))
    }

    /// A text.
    pub(crate) fn as_text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            Self::Null | Self::Bool(_) | Self::Number(_) | Self::List(_) | Self::Object(_) => None,
        }
    }

    /// What the person calls it; empty where it has no name.
    pub(crate) fn name(&self) -> &str {
        self.field("name")
            .and_then(Self::as_text)
            .unwrap_or_default()
    }

    /// An object of these fields.
    pub(crate) fn object<const N: usize>(fields: [(&str, Self); N]) -> Self {
        Self::Object(fields.map(|(name, value)| (name.to_owned(), value)).into())
    }

    /// So many numbers.
    pub(crate) fn numbers<const N: usize>(
        &self,
        place: &Place<'_>,
        accepted: &str,
    ) -> Result<[f64; N], Fault> {
        let list = match self {
            Self::List(list) => list,
            Self::Null | Self::Bool(_) | Self::Number(_) | Self::Text(_) | Self::Object(_) => {
                return Err(self.is_not(accepted).fault(place));
            }
        };
        if list.len() != N {
            return Err(wrong_count(place, list.len(), accepted));
        }
        let mut numbers = [0.0; N];
        for (i, (number, item)) in numbers.iter_mut().zip(list).enumerate() {
            *number = match item {
                Self::Number(value) => *value,
                other @ (Self::Null
                | Self::Bool(_)
                | Self::Text(_)
                | Self::List(_)
                | Self::Object(_)) => {
                    return Err(other.is_not("a number").fault(&place.item(i)));
                }
            };
        }
        Ok(numbers)
    }

    /// Refuses a field that is none of these.
    pub(crate) fn only(&self, known: &[&str], place: &Place<'_>) -> Result<(), Fault> {
        let Self::Object(fields) = self else {
            // What is no object is refused where it is read.
            return Ok(());
        };
        match fields.iter().find(|(n, _)| !known.contains(&n.as_str())) {
            Some((name, _)) => Err(unknown(name, known, place)),
            None => Ok(()),
        }
    }
}

fn unknown(name: &str, known: &[&str], place: &Place<'_>) -> Fault {
    Refusal::unknown(name, known).fault(&place.field(name))
}

impl Serialize for Node {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Null => serializer.serialize_none(),
            Self::Bool(value) => serializer.serialize_bool(*value),
            // Counts are written as doubles too, which have no point then.
            Self::Number(value) => serializer.serialize_f64(*value),
            Self::Text(text) => serializer.serialize_str(text),
            Self::List(list) => serializer.collect_seq(list),
            Self::Object(fields) => {
                let mut map = serializer.serialize_map(Some(fields.len()))?;
                for (name, value) in fields {
                    map.serialize_entry(name, value)?;
                }
                map.end()
            }
        }
    }
}
