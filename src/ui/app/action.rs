//! What can happen: a person did it on a page or around it, an engine said it, or a timer ran out.

use crate::ui::page::effect::Timer;
use crate::ui::page::files::Given;
use crate::ui::page::keep::ask;
use crate::ui::page::language::Language;
use crate::ui::page::news::News;
use crate::ui::page::preferences::{Depth, Preferences};
use crate::ui::talk;
use crate::worker::protocol::{Envelope, Event, Program};

/// The pages.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum View {
    /// Talk to the robot and watch it.
    #[default]
    Talk,
    /// Train a parser on a corpus.
    Train,
    /// See what is kept on this machine.
    Kept,
    /// Read what can be said, and which keys there are.
    Help,
}

impl View {
    /// The view that an address names behind its `#`; one that names none is of the first.
    pub fn of(name: &str) -> Option<View> {
        Some(match name {
            "" | "talk" => View::Talk,
            // Studies are a part of it, which it turns to by itself.
            "train" | "study" => View::Train,
            "kept" => View::Kept,
            "help" => View::Help,
            _ => return None,
        })
    }
}

/// Something that happened.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// A person did something on the Talk page.
    Talk(talk::Action),

    /// The page has opened, in this language.
    Opened(Language),
    /// What the person prefers is known, or has changed.
    Prefers(Preferences),
    /// Another page was opened.
    Go(View),
    /// Another depth was chosen.
    Deepen(Depth),
    /// Another language was chosen.
    Speak(Language),
    /// Take the last change back.
    Undo,
    /// Do what was undone again.
    Redo,
    /// Something was given to the robot: a model or a session.
    Given(Given),
    /// The workbench has come, or has not; the text says why.
    Loaded(Result<(), String>),
    /// The workbench has news.
    Bench(News),
    /// Something was copied, or could not be.
    Copied(bool),

    /// An engine sent a message.
    Heard(Program, Envelope<Event>),
    /// An engine could not be loaded or died; the text says how.
    EngineBroke(Program, String),
    /// A person asked for a new engine.
    RestartEngine(Program),
    /// The store said something.
    Stored(ask::News),
    /// The page was opened by this link, which is being unpacked.
    Linked(String),
    /// The page is not to be seen any more, and may be closed.
    Hidden,
    /// Begin afresh.
    Afresh,
    /// Go back to one's own session.
    GoBack,
    /// Have this tab keep the session.
    KeepHere,
    /// What there is to say of the session was read.
    CloseOrigin,
    /// A timer ran out.
    Rang(Timer),
    /// The model that comes with the page is there, or is not; the text says why.
    Fetched(Result<String, String>),
    /// The guide is there, or is not; the text says why.
    FetchedGuide(Result<String, String>),
    /// The general resource for words is there, or is not; the text says why.
    FetchedWords(Result<String, String>),
}
