//! An answer as a line of JSON: what was said, of what, by whom, and how carefully. A file of such lines is a corpus, too:
//! the workbench and `train` read it as it is. Invariant: equal answers have equal lines, and a sitting's completion code
//! is a function of its answers.

use super::showing::Showing;
use crate::corpus::Decision;
use serde::{Deserialize, Serialize};

/// What an answer calls itself.
pub const FORMAT: &str = "groundling answer 1";

/// An answer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// Says that it is one.
    pub format: String,
    /// Its name: that of the sitting with the turn's number behind it.
    pub id: String,
    /// What was said, as it was typed.
    pub command: String,
    /// The label of the task.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub task: Option<String>,
    /// Who said it.
    pub worker: String,
    /// The pairs that it was said of.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pairs: Vec<Showing>,
    /// The runs that it was said of.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub runs: Vec<Showing>,
    /// The fingerprint of the study.
    pub study: String,
    /// The item's name.
    pub item: String,
    /// The turn's number, from 1, and how many there are.
    pub turn: [usize; 2],
    /// What the platform calls this turn of theirs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub assignment: Option<String>,
    /// What the platform calls the whole.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hit: Option<String>,
    /// When, in milliseconds since 1970, by the clock of their machine.
    pub at: f64,
    /// How carefully, as far as that can be seen.
    pub care: Care,
    /// Whether it is of a rehearsal; if so, whether a careless participant was played.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub simulated: Option<bool>,
}

/// How carefully somebody answered, as far as that can be seen.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Care {
    /// Milliseconds in which the page was seen and something was done with it.
    pub active_ms: u32,
    /// Milliseconds that each showing was in sight.
    pub seen_ms: Vec<u32>,
    /// Keys that were pressed in the command.
    pub keys: u32,
    /// Characters that were pasted into it.
    pub pasted: u32,
    /// How often one asked what changed.
    pub changes: u32,
}

/// An answer, with what was decided of it.
pub type Decided = (Answer, Decision);

impl Answer {
    /// The sitting that it is of.
    pub fn sitting(&self) -> &str {
        self.id.rsplit_once('-').map_or(self.id.as_str(), |(sitting, _)| sitting)
    }

    /// What it was said of, in the order in which it was shown.
    pub fn shown(&self) -> impl Iterator<Item = &Showing> {
        self.pairs.iter().chain(&self.runs)
    }

    /// The answer as a line.
    pub fn line(&self) -> String {
        // Texts, numbers and states: JSON can hold them all.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// The words without case, signs and blanks: what tells whether two people said the same.
    pub fn plain(&self) -> String {
        plain(&self.command)
    }
}

/// Words without case, signs and blanks.
pub fn plain(words: &str) -> String {
    let lower = words.to_lowercase();
    let parts = lower.split(|c: char| !c.is_alphanumeric()).filter(|part| !part.is_empty());
    parts.collect::<Vec<&str>>().join(" ")
}

/// The lines of some answers, as a file.
pub fn lines(answers: &[Answer]) -> String {
    answers.iter().map(|answer| answer.line() + "\n").collect()
}

/// The code that says that somebody has given these answers to a study: eight signs that are hard to mistake.
pub fn code<'a>(study: &str, answers: impl IntoIterator<Item = &'a Answer>) -> String {
    const SIGNS: &[u8; 32] = b"0123456789ABCDEFGHJKMNPQRSTVWXYZ";
    let mut hasher = blake3::Hasher::new();
    hasher.update(study.as_bytes());
    for answer in answers {
        for part in [&answer.id, &answer.command] {
            hasher.update(&(part.len() as u64).to_le_bytes());
            hasher.update(part.as_bytes());
        }
    }
    let hash = hasher.finalize();
    let signs = hash.as_bytes().iter().take(8);
    signs.map(|&byte| char::from(SIGNS[usize::from(byte % 32)])).collect()
}

/// A short name that is a function of these parts.
pub fn short(parts: &[&str]) -> String {
    let mut hasher = blake3::Hasher::new();
    for part in parts {
        hasher.update(&(part.len() as u64).to_le_bytes());
        hasher.update(part.as_bytes());
    }
    hasher.finalize().to_hex().as_str().chars().take(12).collect()
}
