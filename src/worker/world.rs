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

/// A world from a drawing in characters, or from JSON, which begins with a brace; only a legal one.
pub(super) fn read(source: &str) -> Event {
    let state = if source.trim_start().starts_with('{') {
        from_json(source)
    } else {
        text::read_legal(source).map_err(|error| error.to_string())
    };
    match state {
        Ok(state) => Event::World(state),
        Err(message) => Event::Refused { message },
    }
}

/// A world from JSON. What is wrong is told by line and column alone: naming its place, as the command line does, takes a
/// second reader of everything that a state is made of.
fn from_json(source: &str) -> Result<State, String> {
    let state: State =
        serde_json::from_str(source).map_err(|error| format!("it is no world: {error}"))?;
    state.check().map_err(|error| error.to_string())?;
    Ok(state)
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
