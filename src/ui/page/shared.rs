//! What every page is lent: it reads and changes the document, sends requests to the engines, says what a screen
//! reader is to tell, and leaves what it wants done. It is asked; it hands nothing on to a page.

use super::coming::Resource;
use super::document::{Document, Origin};
use super::effect::Effect;
use super::engine::{Engine, Health};
use super::engines::Owner;
use super::history::History;
use super::language::Language;
use super::preferences::{Depth, Preferences};
use crate::worker::protocol::{Program, Request};

/// What all pages share.
#[derive(Clone, Debug, PartialEq)]
pub struct Shared {
    /// The engine that answers.
    pub talker: Engine,
    /// The engine that lessons are learned in; started when it is wanted.
    pub learner: Engine,
    /// What undo and redo go through.
    pub document: Document,
    /// Where they can go.
    pub history: History<Document>,
    /// Why there is no model, or not the one that was wanted.
    pub model_notice: Option<String>,
    /// Where the model that is being opened comes from.
    pub opening: Origin,
    /// What words that no lexicon knows may stand for.
    pub words: Resource,
    /// How deep the person looks.
    pub depth: Depth,
    /// The language of the page; commands are in the parser's.
    pub language: Language,
    /// What the person prefers.
    pub preferences: Preferences,
    /// What a screen reader is told.
    pub announcement: String,
    /// The time of the action at work, in milliseconds.
    pub clock: f64,
    wanted: Vec<Effect>,
}

impl Shared {
    /// What there is before the page has opened.
    pub fn new() -> Shared {
        Shared {
            talker: Engine::new(Program::Talker),
            learner: Engine::new(Program::Learner),
            document: Document::new(),
            history: History::new(),
            model_notice: None,
            opening: Origin::Shipped,
            words: Resource::default(),
            depth: Depth::default(),
            language: Language::default(),
            preferences: Preferences::default(),
            announcement: String::new(),
            clock: 0.0,
            wanted: Vec::new(),
        }
    }

    /// Whether a command can be sent.
    pub fn can_ask(&self) -> bool {
        self.document.model.is_some() && self.talker.health == Health::Ready
    }

    /// Whether a command can be sent, now or once all that it takes has come.
    pub fn can_ask_soon(&self) -> bool {
        let lives = !matches!(self.talker.health, Health::Stopped(_));
        lives && (self.document.model.is_some() || self.model_notice.is_none())
    }

    /// A screen reader is to tell these words.
    pub fn say(&mut self, words: impl Into<String>) {
        self.announcement = words.into();
    }

    /// Remembers the document as it is, for undo.
    pub fn record(&mut self) {
        self.history.record(self.document.clone());
    }

    /// Wants something done.
    pub fn want(&mut self, effect: Effect) {
        self.wanted.push(effect);
    }

    /// What is wanted, in order; nothing is left.
    pub fn take_wanted(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.wanted)
    }

    /// Sends a request to the engine that answers such; an `urgent` one goes before all that wait.
    pub fn send(&mut self, request: Request, urgent: bool) {
        let program = request.program().unwrap_or(Program::Talker);
        let (engine, wanted) = self.engine(program);
        engine.send(request, urgent, wanted);
    }

    /// Has an engine loaded, if it is not yet.
    pub fn wake(&mut self, program: Program) {
        let (engine, wanted) = self.engine(program);
        engine.wake(wanted);
    }

    /// Asks an engine to stop what it is doing.
    pub fn cancel(&mut self, program: Program) {
        let (engine, wanted) = self.engine(program);
        engine.cancel(wanted);
    }
}

impl Owner for Shared {
    type Effect = Effect;

    fn engine(&mut self, program: Program) -> (&mut Engine, &mut Vec<Effect>) {
        let engine = match program {
            Program::Talker => &mut self.talker,
            Program::Learner => &mut self.learner,
        };
        (engine, &mut self.wanted)
    }

    fn language(&self) -> Language {
        self.language
    }

    fn say(&mut self, words: &str) {
        words.clone_into(&mut self.announcement);
    }
}

impl Default for Shared {
    fn default() -> Shared {
        Shared::new()
    }
}
