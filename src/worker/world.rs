//! Worlds by chance and as text, for the page that edits them.

use super::protocol::Event;
use crate::domain::{Blueprint, State, text};

/// A world that is drawn by chance.
pub(super) fn draw(blueprint: &Blueprint, seed: u32) -> Event {
    match blueprint.build(u64::from(seed)) {
        Ok(state) => Event::World(state),
        Err(error) => refuse(&error),
    }
}

/// A world from a drawing in characters; only a legal one.
pub(super) fn read(source: &str) -> Event {
    match text::read_legal(source) {
        Ok(state) => Event::World(state),
        Err(error) => refuse(&error),
    }
}

/// A world as a drawing in characters; only a legal one.
pub(super) fn write(state: &State) -> Event {
    match state.check() {
        Ok(()) => Event::WorldText { text: text::print(state) },
        Err(error) => refuse(&error),
    }
}

fn refuse(error: &dyn std::error::Error) -> Event {
    Event::Refused { message: error.to_string() }
}
