//! A signature: the constants that a language may speak of, each with its type. Text form: `name:type` a line,
//! `#` begins a comment.

use super::ty::{TyId, Types};
use indexmap::IndexMap;

/// Constants and their types, in the order of the text. A name has one type.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Signature {
    constants: IndexMap<String, String>,
}

/// What is wrong with a signature's text.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {reason}")]
pub struct SignatureError {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong there.
    pub reason: &'static str,
}

impl Signature {
    /// Reads a signature.
    ///
    /// # Errors
    /// With the line that is not `name:type`, or names a constant again.
    pub fn read(text: &str) -> Result<Self, SignatureError> {
        let mut types = Types::default();
        let mut signature = Signature::default();
        for (line, content) in (1..).zip(text.lines()) {
            let content = content.split('#').next().unwrap_or("").trim();
            if content.is_empty() {
                continue;
            }
            let error = |reason| SignatureError { line, reason };
            let (name, ty) = content.split_once(':').ok_or(error("a constant is name:type"))?;
            let ty = types.read(ty).ok_or(error("what follows the colon is not a type"))?;
            let again = signature.constants.insert(name.to_owned(), types.print(ty));
            if again.is_some() {
                return Err(error("this name has a type already"));
            }
        }
        Ok(signature)
    }

    /// The text that [`Signature::read`] reads back.
    pub fn print(&self) -> String {
        self.constants.iter().map(|(name, ty)| format!("{name}:{ty}\n")).collect()
    }

    /// The type of a name, in an arena's types.
    pub fn ty(&self, types: &mut Types, name: &str) -> Option<TyId> {
        self.constants.get(name).and_then(|ty| types.read(ty))
    }

    /// The names and the texts of their types, in order.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.constants.iter().map(|(name, ty)| (name.as_str(), ty.as_str()))
    }
}
