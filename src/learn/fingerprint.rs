//! A fingerprint of commands and states, so that a model tells what it was trained on.

use crate::ccg::words;
use crate::corpus::Example;

/// The fingerprint of a corpus.
pub fn fingerprint(examples: &[Example]) -> String {
    let mut hasher = blake3::Hasher::new();
    for example in examples {
        // No command has a line break in it once it is split into words: parts cannot run into each other.
        hasher.update(words(&example.command).join(" ").as_bytes());
        hasher.update(b"\n");
        for state in example.pairs.iter().flat_map(|pair| [&pair.pre, &pair.post]) {
            // A state always has a JSON form: it has no maps and no floats.
            hasher.update(serde_json::to_string(state).unwrap_or_default().as_bytes());
            hasher.update(b"\n");
        }
    }
    hasher.finalize().to_hex().to_string()
}
