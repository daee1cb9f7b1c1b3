//! How a text is kept: two copies, each with its number, size and checksum, the older one written over. What was cut
//! off while it was written is told by its checksum, and the copy before it is read.

use serde::{Deserialize, Serialize};

/// Copies of a text that are kept.
pub const COPIES: u32 = 2;

/// What the index says of a copy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Entry {
    /// What kind of text it is: `session`, `model`, `corpus`…
    pub kind: String,
    /// Its name among those of its kind.
    pub name: String,
    /// Which copy this is, from 0.
    pub copy: u32,
    /// Which writing it came of: the highest is the newest.
    pub number: u32,
    /// Bytes of the text.
    pub bytes: usize,
    /// BLAKE3 of it, in hexadecimal.
    pub sum: String,
    /// When it was written, in milliseconds since 1970.
    pub at: f64,
}

/// Where a copy lies in the store.
pub fn key(kind: &str, name: &str, copy: u32) -> String {
    format!("{kind}/{name}#{copy}")
}

/// Which copy the next writing goes over, and its number: never the newest.
pub fn next(entries: &[Entry]) -> (u32, u32) {
    let newest = entries.iter().max_by_key(|entry| entry.number);
    newest.map_or((0, 1), |newest| ((newest.copy + 1) % COPIES, newest.number.wrapping_add(1)))
}

/// The copies of a text, newest first.
pub fn newest_first(mut entries: Vec<Entry>) -> Vec<Entry> {
    entries.sort_by_key(|entry| std::cmp::Reverse(entry.number));
    entries
}

/// A text that is kept, as a person sees it: the copies together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Item {
    /// What kind of text it is.
    pub kind: String,
    /// Its name.
    pub name: String,
    /// Bytes of all copies.
    pub bytes: usize,
    /// When it was last written, in milliseconds since 1970.
    pub at: f64,
}

/// What is kept, the latest first.
pub fn items(entries: Vec<Entry>) -> Vec<Item> {
    let mut items: Vec<Item> = Vec::new();
    for Entry { kind, name, bytes, at, .. } in entries {
        match items.iter_mut().find(|item| item.kind == kind && item.name == name) {
            Some(item) => (item.bytes, item.at) = (item.bytes + bytes, item.at.max(at)),
            None => items.push(Item { kind, name, bytes, at }),
        }
    }
    items.sort_by(|a, b| b.at.total_cmp(&a.at).then_with(|| a.name.cmp(&b.name)));
    items
}
