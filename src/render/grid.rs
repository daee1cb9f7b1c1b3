//! A state as a grid of cells: what the page shows where there is no picture. Rows run from the north, as they are
//! read; a cell's class is for the style sheet. What cells are called is up to the page's language.

use super::floor::{Extent, Floor, Ground};
use crate::domain::{Agent, Color, Direction, Lock, Object, State};

/// One cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Its column.
    pub x: i32,
    /// Its row.
    pub y: i32,
    /// What it is made of.
    pub ground: Ground,
    /// The room's colour, where it lies inside one.
    pub room: Option<Color>,
    /// A sign of a character or two: the robot's arrow, or a shape's and a colour's letter; a door's sign.
    pub symbol: String,
    /// Names for the style sheet, separated by spaces: `cell floor room-red object shape-chair color-blue`.
    pub class: String,
}

/// All cells of a state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grid {
    /// What is covered.
    pub extent: Extent,
    /// From the north; cells from the west.
    pub rows: Vec<Vec<Cell>>,
}

impl Grid {
    /// The grid of a state. Where two things claim a cell, the robot shows, then the first object.
    pub fn of(state: &State) -> Self {
        let floor = Floor::of(state);
        let row = |y: i32| floor.extent.xs().map(|x| Cell::of(state, &floor, x, y)).collect();
        Self { extent: floor.extent, rows: floor.extent.ys().rev().map(row).collect() }
    }

    /// The cell at a place, if it is shown.
    pub fn cell(&self, x: i32, y: i32) -> Option<&Cell> {
        let mut cells = self.rows.iter().flatten();
        self.extent.contains(x, y).then(|| cells.find(|cell| (cell.x, cell.y) == (x, y))).flatten()
    }
}

impl Cell {
    fn of(state: &State, floor: &Floor, x: i32, y: i32) -> Self {
        let ground = floor.at(x, y);
        let room = match ground {
            Ground::Room(i) => state.rooms.get(i).map(|room| room.color),
            _ => None,
        };
        let (mut class, mut symbol) = match ground {
            Ground::Outside => ("cell outside".to_owned(), String::new()),
            Ground::Wall => ("cell wall".to_owned(), String::new()),
            Ground::Room(_) => {
                (format!("cell floor room-{}", room.map_or("", Color::name)), String::new())
            }
            Ground::Door(i) => {
                let lock = state.doors.get(i).map_or(Lock::Unlocked, |door| door.lock);
                let sign = match lock {
                    Lock::Unlocked => "",
                    Lock::Locked => "x",
                    Lock::Unknown => "?",
                };
                (format!("cell door door-{lock}"), sign.to_owned())
            }
        };
        let robot = (state.agent.x, state.agent.y) == (x, y);
        let object = state.objects.iter().find(|o| (o.x, o.y) == (x, y));
        match object {
            _ if robot => {
                class.push_str(&format!(" robot facing-{}", state.agent.direction));
                symbol = arrow(&state.agent).to_owned();
            }
            Some(object) => {
                let Object { shape, color, .. } = object;
                class.push_str(&format!(" object shape-{shape} color-{color}"));
                if let Some(size) = object.size {
                    class.push_str(&format!(" size-{size}"));
                }
                symbol = format!("{}{}", shape.letter(), color.letter());
            }
            None => {}
        }
        Self { x, y, ground, room, symbol, class }
    }
}

const fn arrow(agent: &Agent) -> &'static str {
    match agent.direction {
        Direction::North => "▲",
        Direction::South => "▼",
        Direction::East => "▶",
        Direction::West => "◀",
    }
}
