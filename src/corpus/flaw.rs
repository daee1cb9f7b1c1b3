//! What is wrong, or odd, in an outside text, as data: where, what, what stands there, and what to do.

use std::fmt;

/// The most characters that a message repeats of what a person's file holds.
const MAX_ECHO: usize = 40;

/// The most characters of what is wrong.
const MAX_WHAT: usize = 400;

/// What is wrong with a piece of text, before it is known where the piece stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wrong {
    /// What is wrong.
    pub what: String,
    /// What stands there, cut.
    pub snippet: Option<String>,
    /// What to do.
    pub mend: Option<String>,
}

impl Wrong {
    /// What is wrong; what to do is `mend`.
    pub(crate) fn with_mend(what: impl Into<String>, mend: impl Into<String>) -> Wrong {
        Wrong { mend: Some(mend.into()), ..Wrong::from(what.into()) }
    }
}

impl From<String> for Wrong {
    fn from(what: String) -> Wrong {
        Wrong { what: cut(&what, MAX_WHAT), snippet: None, mend: None }
    }
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.what)?;
        if let Some(snippet) = &self.snippet {
            write!(f, ", near {snippet:?}")?;
        }
        self.mend.iter().try_for_each(|mend| write!(f, "; {mend}"))
    }
}

/// Something wrong, or odd, in an outside text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flaw {
    /// The line where the row begins, from 1; 0 for the file as a whole.
    pub line: u64,
    /// The column's name, where one is to blame.
    pub column: Option<String>,
    /// What is wrong, in words for a person.
    pub wrong: Wrong,
    /// Whether the row was kept all the same.
    pub kept: bool,
}

impl Flaw {
    /// A flaw of the file as a whole.
    pub fn of_file(wrong: impl Into<Wrong>) -> Flaw {
        Flaw { line: 0, column: None, wrong: wrong.into(), kept: false }
    }

    /// A flaw of the row that begins at `line`; whether the row is kept is settled later.
    pub(crate) fn of_row(line: u64, column: Option<&str>, wrong: impl Into<Wrong>) -> Flaw {
        let column = column.map(|name| cut(name, MAX_ECHO));
        Flaw { line, column, wrong: wrong.into(), kept: false }
    }
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.line > 0 {
            write!(f, "line {}: ", self.line)?;
        }
        if let Some(column) = &self.column {
            write!(f, "{column}: ")?;
        }
        self.wrong.fmt(f)
    }
}

/// A text of at most so many characters: the beginning of a longer one.
pub fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or_default()),
        None => text.to_owned(),
    }
}

/// Some of the names that a file holds, for a message: the first few, each cut.
pub(super) fn some<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    const NAMED: usize = 12;
    let mut names = names.into_iter();
    let mut named: Vec<String> =
        names.by_ref().take(NAMED).map(|name| cut(name, MAX_ECHO)).collect();
    if names.next().is_some() {
        named.push("…".to_owned());
    }
    named.join(", ")
}

/// A message of the JSON reader with what it repeats of the text cut: what stands in back quotes or double quotes.
pub(super) fn cut_quoted(message: &str) -> String {
    let mut out = String::with_capacity(message.len().min(400));
    let mut rest = message;
    while let Some(start) = rest.find(['`', '"']) {
        let quote = &rest[start..=start];
        let (before, after) = rest.split_at(start + 1);
        // What is quoted may hold the quote itself: it ends at the last one when it is too long for a name.
        let close = after.find(quote).unwrap_or(after.len());
        out.push_str(before);
        out.push_str(&cut(&after[..close], MAX_ECHO));
        rest = &after[close..];
        if let Some(behind) = rest.strip_prefix(quote) {
            out.push_str(quote);
            rest = behind;
        }
    }
    out.push_str(rest);
    out
}
