//! The state of the Talk page: that of its parts, and what is to be seen of it all together.

use super::command::offer::Examples;
use super::command::state::Command;
use super::demo::state::Demo;
use super::past::state::Past;
use super::room::state::{Mode, Room};
use super::share::state::{Resume, Sharing};
use super::teach::state::Teach;
use super::watch::playback::Playback;
use super::watch::state::Watch;
use crate::domain::State as World;
use crate::ui::page::shared::Shared;
use crate::worker::protocol::{Answer, Reading};

/// All that the Talk page knows by itself.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// What is said, and about it.
    pub command: Command,
    /// Commands to try.
    pub command_examples: Examples,
    /// What was said before.
    pub past: Past,
    /// What is done in the room.
    pub room: Room,
    /// What is watched.
    pub watch: Watch,
    /// What is taught.
    pub teach: Teach,
    /// What is shared.
    pub sharing: Sharing,
    /// What the page does by itself.
    pub demo: Demo,
    /// What of a session waits for a model.
    pub resume: Resume,
}

impl State {
    /// A page on which nothing was done yet.
    pub fn new() -> State {
        State {
            command: Command::default(),
            command_examples: Examples::default(),
            past: Past::default(),
            room: Room::new(),
            watch: Watch::new(),
            teach: Teach::default(),
            sharing: Sharing::default(),
            demo: Demo::default(),
            resume: Resume::default(),
        }
    }

    /// The state of the world that is shown: what is being demonstrated, a step of the plan, or the world itself.
    pub fn shown<'a>(&'a self, shared: &'a Shared) -> &'a World {
        let draft = shared.document.draft.as_ref().filter(|_| self.room.mode == Mode::Teach);
        if let Some(moved) = self.room.moved.as_ref().filter(|_| self.room.mode == Mode::Watch) {
            return &moved.world;
        }
        let playback = || self.watch.playback.as_ref().and_then(Playback::shown);
        draft.map(|draft| &draft.after).or_else(playback).unwrap_or(&shared.document.world)
    }

    /// The answer that is shown: what is being typed, or what was said.
    pub fn heard<'a>(&'a self, shared: &'a Shared) -> Option<&'a Answer> {
        let said = || shared.document.said.as_ref().map(|said| &*said.answer);
        self.command.live.as_deref().or_else(said)
    }

    /// The reading of it that counts.
    pub fn heard_reading<'a>(&'a self, shared: &'a Shared) -> Option<&'a Reading> {
        match &self.command.live {
            Some(live) => live.readings.first(),
            None => shared.document.reading(),
        }
    }

    /// Whether a person has begun to do something here.
    pub fn is_begun(&self, shared: &Shared) -> bool {
        let has_said = shared.document.said.is_some() || shared.history.can_undo();
        has_said || !self.command.input.is_empty()
    }

    /// The world goes on from what is shown; no plan is left.
    pub(crate) fn settle(&mut self, shared: &mut Shared) {
        if let Some(playback) = self.watch.playback.take()
            && let Some(shown) = playback.shown()
        {
            shared.document.world = shown.clone();
        }
    }
}

impl Default for State {
    fn default() -> State {
        State::new()
    }
}
