//! The commands to try, one a kind.

use crate::domain::State as World;
use crate::worker::protocol::WorldRules;

/// How many kinds there are.
pub const KINDS: usize = 6;

/// The commands to try.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Examples {
    /// One a kind, as far as there are.
    pub found: [Option<String>; KINDS],
    /// What has been found so far: shown when all is there, lest a button moves away under a hand.
    pub coming: [Option<String>; KINDS],
    /// The room that they are for, its rules, and how much was taught.
    pub of: Option<(World, WorldRules, usize)>,
    /// Which timer counts.
    pub number: u32,
    /// The place whose kind is looked for.
    pub next: usize,
    /// Whether those that are shown are of another room, or none yet.
    pub is_behind: bool,
}

impl Examples {
    /// The one that is to be taught.
    pub const TAUGHT: usize = KINDS - 1;
}
