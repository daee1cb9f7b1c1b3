//! The worlds that the page offers.

use crate::domain::{Agent, Direction, State, text};

/// A world to choose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// Its key in the page's texts.
    pub name: Name,
    /// A command that shows what is special in it.
    pub example: &'static str,
    /// Its drawing in characters.
    pub drawing: &'static str,
}

/// What a world is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Name {
    ThreeRooms,
    Hall,
    Store,
    Locked,
}

/// The worlds that the page offers, the first one open at the start.
pub const WORLDS: [Choice; 4] = [
    Choice {
        name: Name::ThreeRooms,
        example: "put the yellow block in the biggest room",
        drawing: include_str!("../../../assets/worlds/three-rooms.txt"),
    },
    Choice {
        name: Name::Hall,
        example: "put the chair next to the bag",
        drawing: include_str!("../../../assets/worlds/hall.txt"),
    },
    Choice {
        name: Name::Store,
        example: "take the magenta box to the red room",
        drawing: include_str!("../../../assets/worlds/store.txt"),
    },
    Choice {
        name: Name::Locked,
        example: "go to the room with the basket",
        drawing: include_str!("../../../assets/worlds/locked.txt"),
    },
];

impl Choice {
    /// The world in the state it begins in. They are known to be legal, by a test.
    pub fn open(&self) -> Option<State> {
        text::read_legal(self.drawing).ok()
    }
}

/// An empty plane with the robot in it, for a page that has no world.
pub fn empty() -> State {
    let agent = Agent { x: 0, y: 0, direction: Direction::North };
    State { agent, rooms: Vec::new(), doors: Vec::new(), objects: Vec::new() }
}
