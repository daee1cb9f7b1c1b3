//! What every part of the workbench is lent: its engine, what it knows of the page, and where it leaves what it wants
//! done. It hands nothing on to a part.

use super::effect::Effect;
use crate::ui::page::document::Model;
use crate::ui::page::engine::{Engine, Health};
use crate::ui::page::engines::Owner;
use crate::ui::page::language::Language;
use crate::ui::page::news::News;
use crate::ui::page::preferences::Preferences;
use crate::worker::protocol::{Program, Request};

/// What all parts share.
#[derive(Clone, Debug, PartialEq)]
pub struct Desk {
    /// The engine that learns.
    pub learner: Engine,
    /// The language of the page.
    pub language: Language,
    /// The time of the action at work, in milliseconds.
    pub clock: f64,
    /// How many engines the machine has room for.
    pub cores: u32,
    /// What the person prefers.
    pub preferences: Preferences,
    /// The model that the robot uses.
    pub in_use: Option<Model>,
    /// Why the robot has no model, or not the one that was wanted.
    pub model_notice: Option<String>,
    wanted: Vec<Effect>,
}

impl Desk {
    /// Says these words aloud, and nowhere else.
    pub fn say(&mut self, words: impl Into<String>) {
        self.want(Effect::Tell(News::Say(words.into())));
    }

    /// Wants something done.
    pub fn want(&mut self, effect: Effect) {
        self.wanted.push(effect);
    }

    /// What is wanted, in order; nothing is left.
    pub fn take_wanted(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.wanted)
    }

    /// Sends a request to the engine; an `urgent` one goes before all that wait.
    pub fn send(&mut self, request: Request, urgent: bool) {
        self.learner.send(request, urgent, &mut self.wanted);
    }

    /// Asks the engine what it answers at once.
    pub fn ask(&mut self, request: Request) {
        self.learner.ask(request, &mut self.wanted);
    }

    /// Whether the engine was asked this and has not answered yet.
    pub fn is_asking(&self, request: &Request) -> bool {
        self.learner.is_asked(request)
    }

    /// Whether it is learning, or will be as soon as it can.
    pub fn is_learning(&self) -> bool {
        self.learner.is_at(|request| matches!(request, Request::Learn { .. }))
    }

    /// Whether it asks a model about all rows, or will as soon as it can.
    pub fn is_auditing(&self) -> bool {
        self.learner.is_at(|request| matches!(request, Request::Audit { .. }))
    }

    /// Asks the engine to stop what it is doing.
    pub fn cancel(&mut self) {
        self.learner.cancel(&mut self.wanted);
    }

    /// Whether the engine is up.
    pub fn is_ready(&self) -> bool {
        self.learner.health == Health::Ready
    }
}

impl Default for Desk {
    fn default() -> Desk {
        Desk {
            learner: Engine::new(Program::Learner),
            language: Language::default(),
            clock: 0.0,
            cores: 1,
            preferences: Preferences::default(),
            in_use: None,
            model_notice: None,
            wanted: Vec::new(),
        }
    }
}

impl Owner for Desk {
    type Effect = Effect;

    fn engine(&mut self, _program: Program) -> (&mut Engine, &mut Vec<Effect>) {
        (&mut self.learner, &mut self.wanted)
    }

    fn language(&self) -> Language {
        self.language
    }

    fn say(&mut self, words: &str) {
        Desk::say(self, words);
    }
}
