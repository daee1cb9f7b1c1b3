//! An object of JSON as it stands, and lists in it, with limits that hold while they are read: what is too much is gone
//! over and not kept.

use super::limits::MAX_COLUMNS;
use serde::de::{Deserialize, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::value::RawValue;
use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

/// The keys of an object, each with its value as it stands.
#[derive(Default)]
pub(super) struct Fields<'a> {
    /// One more than [`MAX_COLUMNS`] at most.
    pub(super) all: BTreeMap<String, &'a RawValue>,
}

/// A list of which one more than `MOST` is kept at most.
pub(super) struct Few<T, const MOST: usize>(pub(super) Vec<T>);

impl Fields<'_> {
    /// Whether there are more than any row has.
    pub(super) fn are_too_many(&self) -> bool {
        self.all.len() > MAX_COLUMNS
    }
}

impl<'de: 'a, 'a> Deserialize<'de> for Fields<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(Keys(PhantomData))
    }
}

struct Keys<'a>(PhantomData<&'a ()>);

impl<'de: 'a, 'a> Visitor<'de> for Keys<'a> {
    type Value = Fields<'a>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Fields<'a>, A::Error> {
        let mut fields = Fields::default();
        while !fields.are_too_many() {
            let Some((key, value)) = entries.next_entry::<String, &'de RawValue>()? else {
                return Ok(fields);
            };
            fields.all.insert(key, value);
        }
        while entries.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
        Ok(fields)
    }
}

impl<'de, T: Deserialize<'de>, const MOST: usize> Deserialize<'de> for Few<T, MOST> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(Items(PhantomData))
    }
}

struct Items<T, const MOST: usize>(PhantomData<T>);

impl<'de, T: Deserialize<'de>, const MOST: usize> Visitor<'de> for Items<T, MOST> {
    type Value = Few<T, MOST>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Few<T, MOST>, A::Error> {
        let mut few = Vec::new();
        while few.len() <= MOST {
            let Some(item) = items.next_element()? else { return Ok(Few(few)) };
            few.push(item);
        }
        while items.next_element::<IgnoredAny>()?.is_some() {}
        Ok(Few(few))
    }
}
