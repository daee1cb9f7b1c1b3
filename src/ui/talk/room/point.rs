//! What a pointer or a key does in the room, in cells: the picture says it, `hand` decides what it means.

use crate::domain::Direction;
use crate::ui::page::place::Place;

/// A pointer's doing at a place in the room.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// What it does.
    pub kind: PointKind,
    /// Its column, between cells; a cell's middle is its coordinate.
    pub x: f32,
    /// Its row, growing north.
    pub y: f32,
    /// The cell it is over, which may lie outside the world.
    pub cell: Place,
}

/// What a pointer does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointKind {
    /// The main button, a finger or a pen goes down.
    Down,
    /// It moves: held down, every bit of the way; else from cell to cell.
    Move,
    /// It is let go.
    Up,
    /// It leaves the room, or the browser takes it away: nothing is let go.
    Leave,
}

/// What a key does in the room.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// An arrow; with shift or without.
    Arrow(Direction, bool),
    /// Enter or space: use the tool, or take and put down.
    Act,
    /// Escape: put nothing down.
    Cancel,
    /// R: turn the robot.
    Turn,
}
