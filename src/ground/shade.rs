//! Shades: names of colours that no thing of Cleanup World has, as measures of how much a thing's own colour is like
//! them. The table is data (`assets/lexicon/shades.txt`), whole numbers that are the same on every machine.

use crate::domain::Color;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A shade a line: its name and, best first, the colours that it is like, `colour:likeness`; `#` begins a comment.
const TABLE: &str = include_str!("../../assets/lexicon/shades.txt");

/// A shade: its line of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Shade(&'static str);

impl Shade {
    /// All of them, in the order of their names.
    pub fn all() -> impl Iterator<Item = Shade> {
        TABLE.lines().filter(|line| !line.starts_with('#')).map(Shade)
    }

    /// The shade of a name.
    pub fn named(name: &str) -> Option<Shade> {
        Shade::all().find(|shade| shade.name() == name)
    }

    /// Its name, one word of letters.
    pub fn name(self) -> &'static str {
        self.0.split(' ').next().unwrap_or_default()
    }

    /// The colours that it is like, best first, and how much, of 1000.
    pub fn colors(self) -> impl Iterator<Item = (Color, i64)> {
        let color = |field: &str| {
            let (name, likeness) = field.split_once(':')?;
            Some((name.parse().ok()?, likeness.parse().ok()?))
        };
        self.0.split(' ').skip(1).filter_map(color)
    }

    /// How much a colour is like it, of 1000: 0 where no one would take one for the other.
    pub fn likeness(self, color: Color) -> i64 {
        self.colors().find(|(own, _)| *own == color).map_or(0, |(_, likeness)| likeness)
    }
}

impl Serialize for Shade {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl<'de> Deserialize<'de> for Shade {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        Shade::named(&name).ok_or_else(|| serde::de::Error::custom(format!("no shade {name:?}")))
    }
}
