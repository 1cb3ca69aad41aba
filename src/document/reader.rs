//! A JSON value as it stands in a text, and how serde's derived readers take it.
//!
//! serde_json can read into the document's types directly, but then it tells a fault only as English
//! text without its place, takes a list for an object, and is twice the size for a page to load.

use crate::document::fault::{FaultCode, excerpt, told};
use crate::document::number::written;
use crate::document::refusal::{Refusal, one_of};
use serde::de::value::StrDeserializer;
use serde::de::{
    Deserialize, DeserializeSeed, Deserializer, EnumAccess, Error, IntoDeserializer, MapAccess,
    SeqAccess, VariantAccess, Visitor,
};
use std::fmt;

/// A JSON value.
#[derive(Clone, Debug)]
pub(crate) enum Node {
    Null,
    Bool(bool),
    Number(f64),
    Text(String),
    List(Vec<Node>),
    /// In the text's order; a name that is there twice is twice here.
    Object(Vec<(String, Node)>),
}

impl Node {
    /// The value of an object's field.
    pub(crate) fn field(&self, name: &str) -> Option<&Self> {
        match self {
            Self::Object(fields) => fields
                .iter()
                .find(|(n, _)| n == name)
                .map(|(_, value)| value),
            Self::Null | Self::Bool(_) | Self::Number(_) | Self::Text(_) | Self::List(_) => None,
        }
    }

    /// As a person would call it.
    fn describe(&self) -> String {
        match self {
            Self::Null => "null".to_owned(),
            Self::Bool(value) => value.to_string(),
            Self::Number(value) => told!("the number {}", written(*value)),
            Self::Text(text) => told!("the text \u{201c}{}\u{201d}", excerpt(text)),
            Self::List(_) => "a list".to_owned(),
            Self::Object(_) => "an object".to_owned(),
        }
    }

    pub(crate) fn is_not(&self, accepted: &str) -> Refusal {
        Refusal::new(
            FaultCode::WrongType,
            told!("this is {}", self.describe()),
            accepted,
        )
    }
}

impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Any;

        impl<'de> Visitor<'de> for Any {
            type Value = Node;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a JSON value")
            }

            fn visit_unit<E>(self) -> Result<Node, E> {
                Ok(Node::Null)
            }

            fn visit_bool<E>(self, value: bool) -> Result<Node, E> {
                Ok(Node::Bool(value))
            }

            fn visit_u64<E>(self, value: u64) -> Result<Node, E> {
                Ok(Node::Number(value as f64))
            }

            fn visit_i64<E>(self, value: i64) -> Result<Node, E> {
                Ok(Node::Number(value as f64))
            }

            fn visit_f64<E>(self, value: f64) -> Result<Node, E> {
                Ok(Node::Number(value))
            }

            fn visit_str<E>(self, text: &str) -> Result<Node, E> {
                Ok(Node::Text(text.to_owned()))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut entries: A) -> Result<Node, A::Error> {
                let mut list = Vec::new();
                while let Some(entry) = entries.next_element()? {
                    list.push(entry);
                }
                Ok(Node::List(list))
            }

            fn visit_map<A: MapAccess<'de>>(self, mut fields: A) -> Result<Node, A::Error> {
                let mut object = Vec::new();
                while let Some(field) = fields.next_entry()? {
                    object.push(field);
                }
                Ok(Node::Object(object))
            }
        }

        deserializer.deserialize_any(Any)
    }
}

/// The few shapes that the document's types ask for.
impl<'de> Deserializer<'de> for &'de Node {
    type Error = Refusal;

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refusal> {
        let Node::Number(value) = self else {
            return Err(self.is_not("a number"));
        };
        visitor.visit_f64(*value)
    }

    fn deserialize_u32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refusal> {
        let Node::Number(value) = self else {
            return Err(self.is_not(WHOLE));
        };
        visitor.visit_u32(whole(*value)?)
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refusal> {
        let Node::Bool(value) = self else {
            return Err(self.is_not("true or false"));
        };
        visitor.visit_bool(*value)
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refusal> {
        let Node::Text(text) = self else {
            return Err(self.is_not("a text in quotes"));
        };
        visitor.visit_str(text)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refusal> {
        if matches!(self, Node::Null) {
            visitor.visit_none()
        } else {
            visitor.visit_some(self).map_err(Refusal::or_null)
        }
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Refusal> {
        let Node::List(list) = self else {
            return Err(self.is_not("a list"));
        };
        visitor.visit_seq(Entries { list, next: 0 })
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Refusal> {
        let Node::Object(fields) = self else {
            return Err(self.is_not("an object in braces"));
        };
        visitor.visit_map(Fields { fields, next: 0 })
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        words: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Refusal> {
        let Node::Text(word) = self else {
            return Err(self.is_not(&one_of(words)));
        };
        visitor.visit_enum(Word(word))
    }

    fn deserialize_any<V: Visitor<'de>>(self, _visitor: V) -> Result<V::Value, Refusal> {
        Err(self.is_not("another value"))
    }

    serde::forward_to_deserialize_any! {
        i8 i16 i32 i64 i128 u8 u16 u64 u128 f32 char str bytes byte_buf unit unit_struct
        newtype_struct tuple tuple_struct map identifier ignored_any
    }
}

const WHOLE: &str = "a whole number, 0 or more";

fn whole(value: f64) -> Result<u32, Refusal> {
    if value.fract() != 0.0 {
        return Err(Node::Number(value).is_not(WHOLE));
    }
    if !(0.0..=f64::from(u32::MAX)).contains(&value) {
        return Err(Refusal::new(
            FaultCode::OutOfRange,
            told!("{} is out of range", written(value)),
            WHOLE,
        ));
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a whole number in the range of u32"
    )]
    Ok(value as u32)
}

struct Entries<'de> {
    list: &'de [Node],
    next: usize,
}

impl<'de> SeqAccess<'de> for Entries<'de> {
    type Error = Refusal;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Refusal> {
        let index = self.next;
        let Some(entry) = self.list.get(index) else {
            return Ok(None);
        };
        self.next += 1;
        seed.deserialize(entry)
            .map(Some)
            .map_err(|refusal| refusal.in_item(index))
    }
}

struct Fields<'de> {
    fields: &'de [(String, Node)],
    /// The field whose name is read next; its value follows.
    next: usize,
}

impl<'de> MapAccess<'de> for Fields<'de> {
    type Error = Refusal;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, Refusal> {
        let Some((name, _)) = self.fields.get(self.next) else {
            return Ok(None);
        };
        let name = name.as_str();
        let key: StrDeserializer<'_, Refusal> = name.into_deserializer();
        seed.deserialize(key)
            .map(Some)
            .map_err(|refusal| refusal.in_field(name))
    }

    // Once a type, and not once a field: 1 kB less of the package.
    #[inline(never)]
    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Refusal> {
        let (name, value) = &self.fields[self.next];
        self.next += 1;
        seed.deserialize(value)
            .map_err(|refusal| refusal.in_field(name))
    }
}

/// A word of a closed set.
struct Word<'de>(&'de str);

impl<'de> EnumAccess<'de> for Word<'de> {
    type Error = Refusal;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, Self), Refusal> {
        let word: StrDeserializer<'_, Refusal> = self.0.into_deserializer();
        Ok((seed.deserialize(word)?, self))
    }
}

impl<'de> VariantAccess<'de> for Word<'de> {
    type Error = Refusal;

    fn unit_variant(self) -> Result<(), Refusal> {
        Ok(())
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, _seed: T) -> Result<T::Value, Refusal> {
        Err(Refusal::custom("a word holds no value"))
    }

    fn tuple_variant<V: Visitor<'de>>(self, _len: usize, _visitor: V) -> Result<V::Value, Refusal> {
        Err(Refusal::custom("a word holds no values"))
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        _fields: &'static [&'static str],
        _visitor: V,
    ) -> Result<V::Value, Refusal> {
        Err(Refusal::custom("a word holds no fields"))
    }
}
