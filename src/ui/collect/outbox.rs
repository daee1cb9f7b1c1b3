//! How the end at hand stands: what is on its way, how often it was tried, and when it is tried again.

use crate::study::ends::Refusal;

/// How the end at hand stands.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Ending {
    /// Whether something is on its way.
    pub is_sending: bool,
    /// How often it was tried.
    pub tries: u32,
    /// Why it did not arrive the last time.
    pub failed: Option<String>,
    /// Why it may not be sent.
    pub refusal: Option<Refusal>,
    /// Whether what the person was to do (save, copy) was done.
    pub is_done: bool,
}

/// The longest pause between two tries, in milliseconds.
const LONGEST: u32 = 60_000;

/// The pause before the next try: a second, doubled each time.
pub fn pause(tries: u32) -> u32 {
    1_000u32.checked_shl(tries.saturating_sub(1)).unwrap_or(LONGEST).clamp(1_000, LONGEST)
}
