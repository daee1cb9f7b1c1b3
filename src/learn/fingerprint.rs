//! A fingerprint of commands and states, so that a model tells what it was trained on.

use crate::ccg::words;
use crate::corpus::{Example, Pair};
use crate::domain::letters;

/// The fingerprint of a corpus.
pub fn fingerprint(examples: &[Example]) -> String {
    let mut hasher = blake3::Hasher::new();
    for example in examples {
        // No command has a line break in it once it is split into words: parts cannot run into each other.
        hasher.update(words(&example.command).join(" ").as_bytes());
        hasher.update(b"\n");
        for Pair { pre, post, way } in &example.pairs {
            for state in [pre, post] {
                // A state always has a JSON form: it has no maps and no floats.
                hasher.update(serde_json::to_string(state).unwrap_or_default().as_bytes());
                hasher.update(b"\n");
            }
            for actions in
                way.iter().flat_map(|way| std::iter::once(&way.actions).chain(&way.contrasts))
            {
                hasher.update(letters(actions).as_bytes());
                hasher.update(b"\n");
            }
        }
    }
    hasher.finalize().to_hex().to_string()
}
