//! A signature: the constants that a language may speak of, each with its type, and of which sorts of entity its
//! arguments can be. Text form: `name:type` a line, then, parted by spaces, the sorts of each argument, joined by
//! `|` (any sort where nothing is said); a line `sorts` before them names the sorts; `*:type` admits every other name
//! as a constant of that type, without being one; `#` begins a comment.

use super::ty::{TyId, Types};
use indexmap::IndexMap;

/// A set of sorts, a bit each.
pub type SortSet = u8;
/// Sorts that a signature may have.
pub const MAX_SORTS: usize = SortSet::BITS as usize;

/// Constants and their types, in the order of the text. A name has one type.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Signature {
    sorts: Vec<String>,
    constants: IndexMap<String, Entry>,
    /// The type of every other name.
    others: Option<String>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Entry {
    ty: String,
    arguments: Vec<SortSet>,
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
            let mut fields = content.split_whitespace();
            let first = fields.next().unwrap_or("");
            if first == "sorts" {
                signature.sorts.extend(fields.map(str::to_owned));
                if signature.sorts.len() > MAX_SORTS {
                    return Err(error("there are too many sorts"));
                }
                continue;
            }
            let (name, ty) = first.split_once(':').ok_or(error("a constant is name:type"))?;
            let ty = types.read(ty).ok_or(error("what follows the colon is not a type"))?;
            if name == "*" {
                signature.others = Some(types.print(ty));
                continue;
            }
            let arguments: Option<_> = fields.map(|set| signature.read_sorts(set)).collect();
            let arguments = arguments.ok_or(error("after the type come sorts, joined by |"))?;
            let entry = Entry { ty: types.print(ty), arguments };
            let again = signature.constants.insert(name.to_owned(), entry);
            if again.is_some() {
                return Err(error("this name has a type already"));
            }
        }
        Ok(signature)
    }

    /// The text that [`Signature::read`] reads back.
    pub fn print(&self) -> String {
        let sorts = match self.sorts.join(" ") {
            none if none.is_empty() => none,
            sorts => format!("sorts {sorts}\n"),
        };
        let constant = |(name, Entry { ty, arguments }): (&String, &Entry)| {
            let sets = arguments.iter().map(|&set| format!(" {}", self.print_sorts(set)));
            format!("{name}:{ty}{}\n", sets.collect::<String>())
        };
        let others = self.others.iter().map(|ty| format!("*:{ty}\n"));
        sorts + &self.constants.iter().map(constant).chain(others).collect::<String>()
    }

    fn read_sorts(&self, text: &str) -> Option<SortSet> {
        text.split('|').try_fold(0, |set, name| {
            let place = self.sorts.iter().position(|sort| sort == name)?;
            Some(set | 1 << place)
        })
    }

    fn print_sorts(&self, set: SortSet) -> String {
        let named = self.sorts.iter().enumerate().filter(|(place, _)| set & (1 << place) != 0);
        named.map(|(_, name)| name.as_str()).collect::<Vec<_>>().join("|")
    }

    /// The constants of which sorts are said, with those of each argument.
    pub fn arguments(&self) -> impl Iterator<Item = (&str, &[SortSet])> {
        let said = self.constants.iter().filter(|(_, entry)| !entry.arguments.is_empty());
        said.map(|(name, entry)| (name.as_str(), entry.arguments.as_slice()))
    }

    /// The type of a name, in an arena's types.
    pub fn ty(&self, types: &mut Types, name: &str) -> Option<TyId> {
        let own = self.constants.get(name).map(|entry| &entry.ty);
        own.or(self.others.as_ref()).and_then(|ty| types.read(ty))
    }

    /// The constants' names and the texts of their types, in order.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.constants.iter().map(|(name, entry)| (name.as_str(), entry.ty.as_str()))
    }
}
