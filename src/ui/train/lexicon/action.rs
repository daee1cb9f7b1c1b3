//! What a person can do with what was learned.

use crate::ui::page::files::Offered;
use crate::worker::protocol::EntrySort;

/// Something that a person did.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// It is to be seen.
    Shown,
    /// Look for entries with these letters in words, category or meaning.
    Text(String),
    /// Leave those out that were known before, or no more.
    Learned(bool),
    /// Sort so; the same once more turns the order round.
    Sort(EntrySort),
    /// Go to the entries from this place on.
    Page(u32),
    /// Pick an entry, by its place in the lexicon, or no more.
    Pick(u32, bool),
    /// The robot is to use the model without the entries that are picked.
    Without,
    /// Open a row of the corpus.
    Row(u32),
    /// Hold the robot's model against that of a file.
    Compare(Vec<Offered>),
}
