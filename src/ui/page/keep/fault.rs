//! What can go wrong with the store, each told apart in words.

/// Why something is not kept, or cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The browser has no store, or allows none: a private window, or one told to keep nothing.
    None,
    /// A newer build of the page made the store.
    Newer,
    /// A page of an older build is open and holds the store.
    Older,
    /// There is no room left.
    Full,
    /// Both copies are damaged.
    Damaged,
    /// Another tab keeps the same.
    Elsewhere,
    /// Something else, in the browser's words.
    Other(String),
}

impl Fault {
    /// Its name, by which the keeper's program tells it.
    pub fn name(&self) -> &str {
        match self {
            Fault::None => "none",
            Fault::Newer => "newer",
            Fault::Older => "older",
            Fault::Full => "full",
            Fault::Damaged => "damaged",
            Fault::Elsewhere => "elsewhere",
            Fault::Other(words) => words,
        }
    }

    /// The one of this name.
    pub fn of(name: &str) -> Fault {
        let all = [
            Fault::None,
            Fault::Newer,
            Fault::Older,
            Fault::Full,
            Fault::Damaged,
            Fault::Elsewhere,
        ];
        let known = all.into_iter().find(|fault| fault.name() == name);
        known.unwrap_or_else(|| Fault::Other(name.to_owned()))
    }
}
