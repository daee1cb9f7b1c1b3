//! The world on the page: the worlds to choose from, the one that is open, and what undo goes back to.

use crate::domain::State;

/// A world to choose: its name and its state as JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// Its name, for a person.
    pub name: &'static str,
    /// Its state.
    pub json: &'static str,
}

/// The worlds that the page offers, the first one open at the start.
pub const WORLDS: [Choice; 4] = [
    Choice { name: "Three rooms", json: include_str!("../../assets/worlds/three-rooms.json") },
    Choice { name: "Hall", json: include_str!("../../assets/worlds/hall.json") },
    Choice { name: "Store", json: include_str!("../../assets/worlds/store.json") },
    Choice { name: "Locked", json: include_str!("../../assets/worlds/locked.json") },
];

/// Undo goes back at most so many changes.
const UNDO_DEPTH: usize = 100;

/// The open world and its past.
#[derive(Clone, Debug, PartialEq)]
pub struct World {
    /// Which of [`WORLDS`] is open.
    pub choice: usize,
    /// The state it is in, but for a plan that is being played.
    pub current: State,
    past: Vec<State>,
}

impl World {
    /// Opens a world in the state it begins in; `None` when there is no such world.
    pub fn open(choice: usize) -> Option<World> {
        // They are known to be legal, by a test: the page need not carry the reader that explains flaws.
        let current = serde_json::from_str(WORLDS.get(choice)?.json).ok()?;
        Some(World { choice, current, past: Vec::new() })
    }

    /// An empty plane with the robot in it, for a page that has no world.
    pub fn empty() -> World {
        let agent = crate::domain::Agent { x: 0, y: 0, direction: crate::domain::Direction::North };
        let current = State { agent, rooms: Vec::new(), doors: Vec::new(), objects: Vec::new() };
        World { choice: 0, current, past: Vec::new() }
    }

    /// Moves on to `next`; `from` is what undo goes back to.
    pub fn change(&mut self, from: State, next: State) {
        if from == next {
            return;
        }
        if self.past.len() == UNDO_DEPTH {
            self.past.remove(0);
        }
        self.past.push(from);
        self.current = next;
    }

    /// Takes the last change back; whether there was one.
    pub fn undo(&mut self) -> bool {
        let before = self.past.pop();
        let found = before.is_some();
        self.current = before.unwrap_or_else(|| self.current.clone());
        found
    }

    /// Whether there is something to undo.
    pub fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }
}
