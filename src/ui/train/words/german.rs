//! The workbench's frame in German.

use super::table::Text;
use crate::ui::train::action::Tab;

/// The words.
pub(super) static GERMAN: Text = Text {
    parts: "Teile der Werkbank",
    tab: |tab| match tab {
        Tab::Data => "Daten",
        Tab::Run => "Trainieren",
        Tab::Experiments => "Versuche",
        Tab::Lexicon => "Gelerntes",
        Tab::Study => "Studien",
        Tab::Kept => "Aufbewahrt",
    },
};
