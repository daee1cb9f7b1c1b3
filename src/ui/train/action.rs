//! What can happen to the workbench: a person did it in one of its parts, the page told it, an engine said it, or a
//! timer ran out.

use super::{data, experiments, kept, lexicon, run, study};
use crate::ui::page::document::Model;
use crate::ui::page::language::Language;
use crate::ui::page::preferences::Preferences;
use crate::worker::protocol::{Envelope, Event, Program};

/// The parts that can be seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tab {
    /// The corpus.
    #[default]
    Data,
    /// Training.
    Run,
    /// Several runs beside one another.
    Experiments,
    /// What was learned.
    Lexicon,
    /// Studies, and what people answered.
    Study,
    /// What is kept.
    Kept,
}

impl Tab {
    /// All of them, in order.
    pub const ALL: [Tab; 6] =
        [Tab::Data, Tab::Run, Tab::Experiments, Tab::Lexicon, Tab::Study, Tab::Kept];

    /// What it is called in the page's code.
    pub const fn name(self) -> &'static str {
        match self {
            Tab::Data => "data",
            Tab::Run => "run",
            Tab::Experiments => "experiments",
            Tab::Lexicon => "lexicon",
            Tab::Study => "study",
            Tab::Kept => "kept",
        }
    }
}

/// Something that happened.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Something was done with the corpus.
    Data(data::Action),
    /// Something was done about training.
    Run(run::Action),
    /// Something was done about experiments.
    Experiments(experiments::Action),
    /// Something was done with what was learned.
    Lexicon(lexicon::Action),
    /// Something was done about studies.
    Study(study::Action),
    /// Something was done with what is kept, or the store said something.
    Kept(kept::Action),

    /// Another part was chosen.
    Turn(Tab),
    /// It is to be seen, or no more.
    Shown(bool),
    /// The page is in another language.
    Speak(Language),
    /// The machine has room for so many engines.
    Cores(u32),
    /// What the person prefers is known, or has changed.
    Prefers(Preferences),
    /// The robot uses this model.
    Uses(Model),
    /// Why the robot has no model, or not the one that was wanted.
    Notice(Option<String>),

    /// An engine sent a message.
    Heard(Program, Envelope<Event>),
    /// An engine could not be loaded or died; the text says how.
    EngineBroke(Program, String),
    /// A person asked for a new engine.
    RestartEngine(Program),
    /// It is time to see whether an engine still answers.
    Look(Program, u32),
}
