//! The page's state and its one reducer: `reduce(state, action)` changes the state and returns what is to be
//! done. Pure: no browser, no clock but what the caller says. Nothing that is loaded is lost but by being replaced
//! with a good one.

use super::action::{Action, Depth, Effect, Preferences, Timer, View};
use super::document::{Document, Origin};
use super::edit::Place;
use super::engine::{Engine, Health};
use super::history::History;
use super::playback::Playback;
use super::room::{Mode, Room};
use super::share::{Resume, Sharing};
use super::talk::Talk;
use super::teach::Teach;
use super::text::{Language, Text};
use super::train::Train;
use super::watch::Watch;
use super::{hear, model, room, share, talk, teach, train, watch};
use crate::domain::State as World;
use crate::render::Extent;
use crate::worker::protocol::{Answer, Program, Reading, Request};

/// All that the page knows.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The engine that answers.
    pub talker: Engine,
    /// The engine that learns; started when it is wanted.
    pub learner: Engine,
    /// What undo and redo go through.
    pub document: Document,
    /// Where they can go.
    pub history: History<Document>,
    /// Which view is open.
    pub view: View,
    /// How deep the person looks.
    pub depth: Depth,
    /// The language of the page; commands are in the parser's.
    pub language: Language,
    /// What the person prefers.
    pub preferences: Preferences,
    /// What is said, and about it.
    pub talk: Talk,
    /// What is done in the room.
    pub room: Room,
    /// What is watched.
    pub watch: Watch,
    /// What is taught.
    pub teach: Teach,
    /// What is trained.
    pub train: Train,
    /// What is shared.
    pub sharing: Sharing,
    /// What of a session waits for a model.
    pub resume: Resume,
    /// Why there is no model, or not the one that was wanted.
    pub model_notice: Option<String>,
    /// Where the model that is being opened comes from.
    pub opening: Origin,
    /// What a screen reader is told.
    pub announcement: String,
    /// The time of the action at work, in milliseconds.
    pub clock: f64,
}

impl State {
    /// A page that has not opened yet.
    pub fn new() -> State {
        State {
            talker: Engine::new(Program::Talker),
            learner: Engine::new(Program::Learner),
            document: Document::new(),
            history: History::new(),
            view: View::default(),
            depth: Depth::default(),
            language: Language::default(),
            preferences: Preferences::default(),
            talk: Talk::default(),
            room: Room::new(),
            watch: Watch::new(),
            teach: Teach::default(),
            train: Train::default(),
            sharing: Sharing::default(),
            resume: Resume::default(),
            model_notice: None,
            opening: Origin::Shipped,
            announcement: String::new(),
            clock: 0.0,
        }
    }

    /// The page's words.
    pub fn text(&self) -> &'static Text {
        self.language.text()
    }

    /// The state of the world that is shown: what is being demonstrated, a step of the plan, or the world itself.
    pub fn shown(&self) -> &World {
        let draft = self.document.draft.as_ref().filter(|_| self.room.mode == Mode::Teach);
        let playback = || self.watch.playback.as_ref().and_then(Playback::shown);
        draft.map(|draft| &draft.after).or_else(playback).unwrap_or(&self.document.world)
    }

    /// The answer that is shown: what is being typed, or what was said.
    pub fn heard(&self) -> Option<&Answer> {
        let said = || self.document.said.as_ref().map(|said| &*said.answer);
        self.talk.live.as_deref().or_else(said)
    }

    /// The reading of it that counts.
    pub fn heard_reading(&self) -> Option<&Reading> {
        match &self.talk.live {
            Some(live) => live.readings.first(),
            None => self.document.reading(),
        }
    }

    /// Whether a command can be sent.
    pub fn can_ask(&self) -> bool {
        self.document.model.is_some() && self.talker.health == Health::Ready
    }

    /// Whether a command is being answered, or planned for.
    pub fn is_asking(&self) -> bool {
        self.talker.is_at(|r| matches!(r, Request::Ask { .. } | Request::Plan { .. }))
    }

    /// Whether training can begin.
    pub fn can_train(&self) -> bool {
        let rows = self.train.corpus.as_ref().map_or(0, |c| c.report.rows.len());
        rows > 0 && self.learner.health == Health::Ready && !self.is_training()
    }

    /// Whether it is training, or will be as soon as it can.
    pub fn is_training(&self) -> bool {
        self.learner.is_at(|request| matches!(request, Request::Train { .. }))
    }

    /// Whether it is being taught.
    pub fn is_teaching(&self) -> bool {
        self.learner.is_at(|request| matches!(request, Request::Teach { .. }))
    }

    /// The nearest cell that the picture shows.
    pub fn inside(&self, (x, y): Place) -> Place {
        let Extent { left, bottom, columns, rows } = Extent::of(self.shown());
        let last = |first: i32, n: u32| first.saturating_add_unsigned(n.saturating_sub(1));
        (x.clamp(left, last(left, columns)), y.clamp(bottom, last(bottom, rows)))
    }

    pub(super) fn engine(&mut self, program: Program) -> &mut Engine {
        match program {
            Program::Talker => &mut self.talker,
            Program::Learner => &mut self.learner,
        }
    }

    pub(super) fn stop_at(&mut self, program: Program, effects: &mut Vec<Effect>) {
        self.engine(program).cancel(effects);
    }

    pub(super) fn say(&mut self, words: impl Into<String>) {
        self.announcement = words.into();
    }

    /// Remembers the document as it is, for undo.
    pub(super) fn record(&mut self) {
        self.history.record(self.document.clone());
    }

    /// The world goes on from what is shown; no plan is left.
    pub(super) fn settle(&mut self) {
        if let Some(playback) = self.watch.playback.take() {
            let shown = playback.shown().cloned();
            self.document.world = shown.unwrap_or_else(|| self.document.world.clone());
        }
    }
}

impl Default for State {
    fn default() -> State {
        State::new()
    }
}

/// Changes the state as the action says, and returns what is to be done.
pub fn reduce(state: &mut State, action: Action) -> Vec<Effect> {
    let mut effects = Vec::new();
    let all = &mut effects;
    match action {
        Action::Opened(language) => {
            state.language = language;
            state.talker.wake(all);
            all.extend([Effect::FetchModel, Effect::SetLanguage(language)]);
        }
        Action::Prefers(preferences) => state.preferences = preferences,
        Action::Heard(program, envelope) => hear::heard(state, program, envelope, all),
        Action::EngineBroke(program, why) => hear::stopped(state, program, why),
        Action::Rang(Timer::Watch(program, watch)) => {
            if state.engine(program).look(watch, all) {
                let why = state.text().engine_silent;
                hear::stopped(state, program, why.to_owned());
            }
        }
        Action::RestartEngine(program) => hear::restart(state, program, all),
        Action::Fetched(text) => model::fetched(state, text, all),
        Action::FetchModel => {
            state.model_notice = None;
            all.push(Effect::FetchModel);
        }

        Action::Go(view) => {
            state.view = view;
            if view == View::Train {
                train::begin(state, all);
            }
        }
        Action::Deepen(depth) => {
            state.depth = depth;
            watch::look(state, all);
            talk::study(state, all);
        }
        Action::Speak(language) => {
            state.language = language;
            all.push(Effect::SetLanguage(language));
        }
        Action::Undo => travel(state, History::undo, state.text().undone, all),
        Action::Redo => travel(state, History::redo, state.text().redone, all),

        Action::FileRead { .. }
        | Action::FileRefused(..)
        | Action::OpenDemo
        | Action::ToggleRow(_)
        | Action::MoreRows
        | Action::SaveCorpus
        | Action::Train
        | Action::CancelTraining
        | Action::SaveModel => train::act(state, action, all),

        Action::Typed(_)
        | Action::Ask
        | Action::AskExample(_)
        | Action::Choose(_)
        | Action::Link(_)
        | Action::AllReadings
        | Action::Preview(_)
        | Action::ChooseNode(_)
        | Action::Reduce(_)
        | Action::Help(_)
        | Action::SetRules(_) => talk::act(state, action, all),

        Action::SetMode(_)
        | Action::Take(_)
        | Action::SetLook(_)
        | Action::SetPaint(_)
        | Action::Point(_)
        | Action::Press(_)
        | Action::PickWorld(_)
        | Action::ResetWorld
        | Action::SetBlueprint(_)
        | Action::SetSeed(_)
        | Action::DrawWorld
        | Action::ToggleText
        | Action::TypedText(_)
        | Action::ApplyText => room::act(state, action, all),

        Action::TypedLesson(_)
        | Action::Teach
        | Action::ClearDraft
        | Action::Unteach(_)
        | Action::SaveLessons => teach::act(state, action, all),

        Action::Rang(Timer::Play(_))
        | Action::TogglePlay
        | Action::Seek(_)
        | Action::SetSpeed(_)
        | Action::ToggleLayer(_)
        | Action::TryMany
        | Action::StopPlanning => watch::act(state, action, all),

        Action::Share
        | Action::Shared(_)
        | Action::SaveSession
        | Action::LinkOpened(_)
        | Action::Copied(_)
        | Action::Copy(_)
        | Action::CloseShare => share::act(state, action, all),
    }
    effects
}

/// Goes through the history: the document becomes another, and what hangs on it is brought along.
fn travel(
    state: &mut State,
    step: fn(&mut History<Document>, &mut Document) -> bool,
    words: &str,
    effects: &mut Vec<Effect>,
) {
    state.settle();
    let model = state.document.model.clone();
    if !step(&mut state.history, &mut state.document) {
        return;
    }
    state.watch.forget();
    (state.room.held, state.room.obstacle) = (None, None);
    let said = state.document.said.as_ref().map(|said| said.answer.command.clone());
    state.talk = Talk { input: said.unwrap_or_default(), ..Talk::default() };
    if state.document.model != model
        && let Some(model) = state.document.model.clone()
    {
        model::go_on_with(state, model, effects);
    }
    talk::study(state, effects);
    let words = format!("{words} {}", state.text().robot(state.shown()));
    state.say(words);
}
