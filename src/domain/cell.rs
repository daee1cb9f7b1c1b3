//! What the cells of a world are made of: wall, floor or door.
//! Invariant: a door covers its cells whatever lies below; else a room's border is wall, its inside floor.

use super::object::{Door, Room};

/// What a cell is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cell {
    /// Nothing enters.
    Wall,
    /// The inside of a room.
    Floor,
    /// Part of the door with this index.
    Door(usize),
}

/// What the cell at column `x`, row `y` is made of; outside all rooms and doors there is wall.
#[must_use]
pub fn cell_at(rooms: &[Room], doors: &[Door], x: i32, y: i32) -> Cell {
    if let Some(d) = doors.iter().position(|d| d.bounds.contains(x, y)) {
        return Cell::Door(d);
    }
    let mut cell = Cell::Wall;
    for room in rooms {
        if room.bounds.strictly_inside(x, y) {
            cell = Cell::Floor;
        } else if room.bounds.contains(x, y) {
            return Cell::Wall;
        }
    }
    cell
}
