//! What a Cleanup World is made of: agent, rooms, doors and movable objects (Williams et al., Section III).
//! Cell coordinates, y grows north; bounds are inclusive, a room's border cells are wall.

use super::name::named;
use serde::ser::{SerializeStruct, Serializer};
use serde::{Deserialize, Serialize};

/// One of the four compass directions; `north` is +y, `east` is +x.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names are the compass's")]
pub enum Direction {
    North,
    South,
    East,
    West,
}

named!(Direction, "direction", North "north" '^', South "south" 'v', East "east" '>', West "west" '<');

impl Direction {
    /// The step to the neighbouring cell, (columns, rows).
    #[must_use]
    pub const fn step(self) -> (i32, i32) {
        match self {
            Self::North => (0, 1),
            Self::South => (0, -1),
            Self::East => (1, 0),
            Self::West => (-1, 0),
        }
    }

    /// The direction one looks in after a quarter turn to the left.
    #[must_use]
    pub const fn left(self) -> Self {
        match self {
            Self::North => Self::West,
            Self::West => Self::South,
            Self::South => Self::East,
            Self::East => Self::North,
        }
    }

    /// The direction one looks in after turning round.
    #[must_use]
    pub const fn opposite(self) -> Self {
        match self {
            Self::North => Self::South,
            Self::South => Self::North,
            Self::East => Self::West,
            Self::West => Self::East,
        }
    }
}

/// A colour of rooms and objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
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

named!(
    Color, "colour",
    Red "red" 'r', Green "green" 'g', Blue "blue" 'b', Yellow "yellow" 'y', Magenta "magenta" 'm',
    Brown "brown" 'n', Orange "orange" 'o', Tan "tan" 't', Teal "teal" 'e',
);

/// The shape of a movable object.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names are the shapes'")]
pub enum Shape {
    Chair,
    Basket,
    Block,
    Bag,
    Backpack,
    Box,
}

named!(
    Shape, "shape",
    Chair "chair" 'C', Basket "basket" 'K', Block "block" 'B', Bag "bag" 'G', Backpack "backpack" 'P',
    Box "box" 'X',
);

/// The size of a movable object where one is given: 1, 2 or 3 in `size:<e,n>`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names are the sizes'")]
pub enum Size {
    Small,
    Medium,
    Large,
}

named!(Size, "size", Small "small" 's', Medium "medium" 'm', Large "large" 'l');

/// Whether a door can be passed: `unknown` opens, or locks, when it is first tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names are the states'")]
pub enum Lock {
    Unlocked,
    Locked,
    Unknown,
}

named!(Lock, "lock", Unlocked "unlocked" '+', Locked "locked" 'x', Unknown "unknown" '?');

/// The robot: its cell and where it looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(expecting = "a robot: {x, y, direction}")]
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

impl Bounds {
    /// Whether the cell lies within, border included.
    #[must_use]
    pub const fn contains(&self, x: i32, y: i32) -> bool {
        self.left <= x && x <= self.right && self.bottom <= y && y <= self.top
    }

    /// Whether the cell lies within and not on the border: what `in` means.
    #[must_use]
    pub const fn strictly_inside(&self, x: i32, y: i32) -> bool {
        self.left < x && x < self.right && self.bottom < y && y < self.top
    }

    /// Whether the two share a cell.
    #[must_use]
    pub const fn overlaps(&self, other: &Self) -> bool {
        self.left <= other.right
            && other.left <= self.right
            && self.bottom <= other.top
            && other.bottom <= self.top
    }

    /// The size of a region in `size:<e,n>`: width times height between the border lines, so 0 for one cell.
    #[must_use]
    pub fn area(&self) -> i64 {
        (i64::from(self.right) - i64::from(self.left))
            * (i64::from(self.top) - i64::from(self.bottom))
    }

    /// Whether left ≤ right and bottom ≤ top.
    #[must_use]
    pub const fn is_ordered(&self) -> bool {
        self.left <= self.right && self.bottom <= self.top
    }

    /// Its cells, row by row from the south-west corner.
    pub fn cells(self) -> impl Iterator<Item = (i32, i32)> {
        (self.bottom..=self.top).flat_map(move |y| (self.left..=self.right).map(move |x| (x, y)))
    }

    /// The smallest rectangle that holds both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        Self {
            left: self.left.min(other.left),
            bottom: self.bottom.min(other.bottom),
            right: self.right.max(other.right),
            top: self.top.max(other.top),
        }
    }
}

/// A room: a coloured rectangle whose border cells are wall.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(from = "RoomJson", into = "RoomJson")]
pub struct Room {
    /// Unique among rooms and doors of a state; not what identifies it between two states.
    pub name: String,
    /// The colour of its floor.
    pub color: Color,
    /// Its extent, walls included.
    pub bounds: Bounds,
}

/// A door: cells of a shared wall that are passage.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(from = "DoorJson", into = "DoorJson")]
pub struct Door {
    /// Unique among rooms and doors of a state.
    pub name: String,
    /// The cells it covers.
    pub bounds: Bounds,
    /// Whether it can be passed.
    pub lock: Lock,
}

/// A movable thing.
#[derive(Clone, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(expecting = "an object: {name, shape, color, x, y}")]
pub struct Object {
    /// Unique among objects; identifies it between two states.
    pub name: String,
    /// Its shape.
    pub shape: Shape,
    /// Its colour.
    pub color: Color,
    /// Its size, where one is given.
    #[serde(default)]
    pub size: Option<Size>,
    /// Column of its cell.
    pub x: i32,
    /// Row of its cell.
    pub y: i32,
}

impl Serialize for Object {
    /// A size that is not given is left out where fields have names, as in the corpora's JSON.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let has_size = self.size.is_some() || !serializer.is_human_readable();
        let mut object = serializer.serialize_struct("Object", 5 + usize::from(has_size))?;
        object.serialize_field("name", &self.name)?;
        object.serialize_field("shape", &self.shape)?;
        object.serialize_field("color", &self.color)?;
        if has_size {
            object.serialize_field("size", &self.size)?;
        }
        object.serialize_field("x", &self.x)?;
        object.serialize_field("y", &self.y)?;
        object.end()
    }
}

impl Object {
    /// Its size in `size:<e,n>`: 1 small, 3 large, otherwise 2.
    #[must_use]
    pub const fn magnitude(&self) -> i64 {
        match self.size {
            Some(Size::Small) => 1,
            Some(Size::Large) => 3,
            Some(Size::Medium) | None => 2,
        }
    }
}

/// A room as JSON has it: flat, so that an error can name the very field.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Room", expecting = "a room: {name, color, left, bottom, right, top}")]
struct RoomJson {
    name: String,
    color: Color,
    left: i32,
    bottom: i32,
    right: i32,
    top: i32,
}

impl From<RoomJson> for Room {
    fn from(RoomJson { name, color, left, bottom, right, top }: RoomJson) -> Self {
        Self { name, color, bounds: Bounds { left, bottom, right, top } }
    }
}

impl From<Room> for RoomJson {
    fn from(Room { name, color, bounds }: Room) -> Self {
        let Bounds { left, bottom, right, top } = bounds;
        Self { name, color, left, bottom, right, top }
    }
}

/// A door as JSON has it.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Door", expecting = "a door: {name, left, bottom, right, top, lock}")]
struct DoorJson {
    name: String,
    left: i32,
    bottom: i32,
    right: i32,
    top: i32,
    lock: Lock,
}

impl From<DoorJson> for Door {
    fn from(DoorJson { name, left, bottom, right, top, lock }: DoorJson) -> Self {
        Self { name, bounds: Bounds { left, bottom, right, top }, lock }
    }
}

impl From<Door> for DoorJson {
    fn from(Door { name, bounds, lock }: Door) -> Self {
        let Bounds { left, bottom, right, top } = bounds;
        Self { name, left, bottom, right, top, lock }
    }
}
