//! One table per kind of name: the closed sets of Cleanup World's words (colours, shapes, …) with their
//! text form, both ways. Invariant: `name` then `parse` is the identity, and a letter is unique in its set.

/// A word that is not in its closed set.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown {kind} `{word}`: use one of {allowed}")]
pub struct UnknownName {
    /// What was looked for, "colour" for one.
    pub kind: &'static str,
    /// The word that was found.
    pub word: String,
    /// The words that are known, separated by commas.
    pub allowed: String,
}

/// Gives an enum its names and letters from one table: `ALL`, `name`, `letter`, `Display`, `FromStr` and
/// the same text in JSON.
macro_rules! named {
    ($ty:ident, $kind:literal, $($variant:ident $name:literal $letter:literal),+ $(,)?) => {
        impl $ty {
            /// Every value, in the order of the table.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// Its word, as in JSON and in logical forms.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name),+ }
            }

            /// A sign of one letter, unique in its set.
            #[must_use]
            pub const fn letter(self) -> char {
                match self { $(Self::$variant => $letter),+ }
            }
        }

        impl std::fmt::Display for $ty {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(self.name())
            }
        }

        impl std::str::FromStr for $ty {
            type Err = $crate::domain::name::UnknownName;

            fn from_str(word: &str) -> Result<Self, Self::Err> {
                Self::ALL.iter().copied().find(|v| v.name() == word).ok_or_else(|| {
                    $crate::domain::name::UnknownName {
                        kind: $kind,
                        word: word.chars().take(40).collect(),
                        allowed: [$($name),+].join(", "),
                    }
                })
            }
        }

        impl serde::Serialize for $ty {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(self.name())
            }
        }

        impl<'de> serde::Deserialize<'de> for $ty {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let word = std::borrow::Cow::<'de, str>::deserialize(deserializer)?;
                word.parse().map_err(serde::de::Error::custom)
            }
        }
    };
}

pub(crate) use named;
