//! The state of the page as a whole: what all pages share, and each page's own.

use super::action::View;
use crate::ui::page::shared::Shared;
use crate::ui::talk;

/// All that the page knows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// What the pages are lent.
    pub shared: Shared,
    /// Which of them is open.
    pub view: View,
    /// The Talk page.
    pub talk: talk::State,
    /// The program that the Train page is.
    pub bench: Bench,
}

/// How far the workbench is: a program of its own, which is fetched when its page is opened first, and then stays.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Bench {
    /// Nobody asked for it yet.
    #[default]
    Absent,
    /// It is being fetched.
    Coming,
    /// It is there.
    Here,
    /// It did not come; the text says why.
    Lost(String),
}
