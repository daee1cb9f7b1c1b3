//! The state of what was learned.

use crate::worker::protocol::{Difference, EntryView, EntryWindow, Errors};
use std::collections::BTreeSet;
use std::rc::Rc;

/// So many entries are shown at once.
pub const PAGE: u32 = 50;

/// All that is known of what was learned.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Which entries, and in which order.
    pub view: EntryView,
    /// The first of them that is shown.
    pub offset: u32,
    /// Those that are, once they have come.
    pub window: Option<Rc<EntryWindow>>,
    /// Whether it was the robot's model that was looked at, since nothing was learned here.
    pub is_robots: bool,
    /// Entries that are picked, by their place in the lexicon.
    pub picked: BTreeSet<u32>,
    /// Where the model errs, once it was asked about the rows.
    pub errors: Option<Rc<Errors>>,
    /// What tells the robot's model from that of a file, and the file's name.
    pub difference: Option<(String, Rc<Difference>)>,
    /// The name of the file that is being compared.
    pub comparing: String,
    /// What cannot be shown, and why.
    pub notice: Option<String>,
}
