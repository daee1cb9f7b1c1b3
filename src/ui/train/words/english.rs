//! The workbench's frame in English; what each word is for stands here for all languages.

use super::table::Text;
use crate::ui::train::action::Tab;

/// The words.
pub(super) static ENGLISH: Text = Text {
    parts: "Parts of the workbench",
    tab: |tab| match tab {
        Tab::Data => "Data",
        Tab::Run => "Train",
        Tab::Experiments => "Experiments",
        Tab::Lexicon => "What it learned",
        Tab::Study => "Studies",
        Tab::Kept => "Kept",
    },
};
