//! How far the page is with what it does by itself.

/// How far it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Demo {
    /// Nobody asked for it.
    #[default]
    Unwanted,
    /// It begins as soon as a command can be sent.
    Wanted,
    /// So many letters stand there.
    Typing(usize),
    /// It was sent.
    Doing,
    /// It is over.
    Over,
}

impl Demo {
    /// Whether what stands in the box is the page's own.
    pub fn is_typing(self) -> bool {
        matches!(self, Demo::Typing(1..))
    }
}
