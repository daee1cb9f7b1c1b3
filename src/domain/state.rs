//! A state of Cleanup World, its JSON form and its legality. A `State` that came through
//! [`State::read`] or [`State::check`] is legal: nothing stands in a wall and no two things share a cell.

use super::object::{Agent, Door, Object, Room};
use serde::{Deserialize, Serialize};

/// Where everything is. JSON form: as in Mechanical Turk's `Input.pre_1` cells.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the four kinds of thing")]
pub struct State {
    pub agent: Agent,
    pub rooms: Vec<Room>,
    pub doors: Vec<Door>,
    pub objects: Vec<Object>,
}
