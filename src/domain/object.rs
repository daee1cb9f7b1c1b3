//! What a Cleanup World is made of: agent, rooms, doors and movable objects (Williams et al., Section III).
//! Cell coordinates, y grows north; bounds are inclusive, a room's border cells are wall.

use serde::{Deserialize, Serialize};

/// One of the four compass directions; `north` is +y, `east` is +x.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[expect(missing_docs, reason = "the names are the compass's")]
pub enum Direction {
    North,
    South,
    East,
    West,
}

/// A colour of rooms and objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[expect(missing_docs, reason = "the names are the colours'")]
pub enum Color {
    Red,
    Green,
    Blue,
    Yellow,
    Magenta,
    Brown,
    Orange,
    Tan,
    Teal,
}

/// The shape of a movable object.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[expect(missing_docs, reason = "the names are the shapes'")]
pub enum Shape {
    Chair,
    Basket,
    Block,
    Bag,
    Backpack,
    Box,
}

/// The size of a movable object where one is given: 1, 2 or 3 in `size:<e,n>`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[expect(missing_docs, reason = "the names are the sizes'")]
pub enum Size {
    Small,
    Medium,
    Large,
}

/// Whether a door can be passed: `unknown` opens, or locks, when it is first tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[expect(missing_docs, reason = "the names are the states'")]
pub enum Lock {
    Unlocked,
    Locked,
    Unknown,
}

/// The robot: its cell and where it looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Agent {
    /// Column of the robot's cell.
    pub x: i32,
    /// Row of the robot's cell.
    pub y: i32,
    /// The direction it faces.
    pub direction: Direction,
}

/// A rectangle of cells, bounds inclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the four sides")]
pub struct Bounds {
    pub left: i32,
    pub bottom: i32,
    pub right: i32,
    pub top: i32,
}

/// A room: a coloured rectangle whose border cells are wall.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Room {
    /// Unique among rooms and doors of a state; not what identifies it between two states.
    pub name: String,
    /// The colour of its floor.
    pub color: Color,
    /// Its extent, walls included.
    #[serde(flatten)]
    pub bounds: Bounds,
}

/// A door: cells of a shared wall that are passage.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Door {
    /// Unique among rooms and doors of a state.
    pub name: String,
    /// The cells it covers.
    #[serde(flatten)]
    pub bounds: Bounds,
    /// Whether it can be passed.
    pub lock: Lock,
}

/// A movable thing.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Object {
    /// Unique among objects; identifies it between two states.
    pub name: String,
    /// Its shape.
    pub shape: Shape,
    /// Its colour.
    pub color: Color,
    /// Its size, where one is given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub size: Option<Size>,
    /// Column of its cell.
    pub x: i32,
    /// Row of its cell.
    pub y: i32,
}
