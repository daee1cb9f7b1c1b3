//! Ways through a world, as letters: the states and the rooms that they lead through.

use super::grammar::Phrases;
use crate::domain::straight::passed;
use crate::domain::{State, Way, read_letters};

/// The states of a way from a start, the start among them; none of one that cannot be gone.
pub fn states(start: &State, way: &str) -> Vec<State> {
    let actions = read_letters(way).unwrap_or_default();
    let states = Way { actions, ..Way::default() }.states(start);
    states.ok().and_then(|all| all.into_iter().next()).unwrap_or_default()
}

/// The rooms that a way leads the robot through, in words.
pub fn rooms(start: &State, way: &str, phrases: &dyn Phrases) -> String {
    let rooms = passed(&states(start, way), None).into_iter();
    let rooms = rooms.filter_map(|room| Some(phrases.room(start.rooms.get(room)?.color)));
    phrases.list(&rooms.collect::<Vec<_>>())
}
