//! The state of the page as a whole: what all pages share, and each page's own.

use super::action::View;
use crate::ui::page::shared::Shared;
use crate::ui::{help, talk, train};

/// All that the page knows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// What the pages are lent.
    pub shared: Shared,
    /// Which of them is open.
    pub view: View,
    /// The Talk page.
    pub talk: talk::State,
    /// The Train page.
    pub train: train::State,
    /// The guide.
    pub help: help::State,
}
