//! A state as a grid of named cells: what the page shows and reads out where there is no picture. Rows run from
//! the north, as they are read; a cell's label is a phrase for a screen reader, its class is for the style sheet.

use super::floor::{Extent, Floor, Ground};
use crate::domain::{Agent, Color, Direction, Lock, Object, Size, State};

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
    /// Where it is and what is there: "column 2, row 3, red room: blue chair".
    pub label: String,
    /// What is there, in a phrase without its place: "large red chair", "robot facing north".
    pub contents: Option<String>,
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
        let (place, mut class, mut symbol) = match ground {
            Ground::Outside => ("outside".to_owned(), "cell outside".to_owned(), String::new()),
            Ground::Wall => ("wall".to_owned(), "cell wall".to_owned(), String::new()),
            Ground::Room(_) => {
                let color = room.map_or("", Color::name);
                (format!("{color} room"), format!("cell floor room-{color}"), String::new())
            }
            Ground::Door(i) => {
                let lock = state.doors.get(i).map_or(Lock::Unlocked, |door| door.lock);
                let (words, sign) = match lock {
                    Lock::Unlocked => ("open door", ""),
                    Lock::Locked => ("locked door", "x"),
                    Lock::Unknown => ("untried door", "?"),
                };
                (words.to_owned(), format!("cell door door-{lock}"), sign.to_owned())
            }
        };
        let robot = (state.agent.x, state.agent.y) == (x, y);
        let object = state.objects.iter().find(|o| (o.x, o.y) == (x, y));
        let contents = match object {
            _ if robot => {
                let direction = state.agent.direction;
                class.push_str(&format!(" robot facing-{direction}"));
                symbol = arrow(&state.agent).to_owned();
                Some(format!("robot facing {direction}"))
            }
            Some(object) => {
                let Object { shape, color, .. } = object;
                class.push_str(&format!(" object shape-{shape} color-{color}"));
                if let Some(size) = object.size {
                    class.push_str(&format!(" size-{size}"));
                }
                symbol = format!("{}{}", shape.letter(), color.letter());
                Some(name(object))
            }
            None => None,
        };
        let label = match &contents {
            Some(contents) => format!("column {x}, row {y}, {place}: {contents}"),
            None => format!("column {x}, row {y}, {place}"),
        };
        Self { x, y, ground, room, label, contents, symbol, class }
    }
}

/// What changed from one state to the next, in a sentence to read out; `None` when nothing did.
pub fn announce(before: &State, after: &State) -> Option<String> {
    let grid = Grid::of(after);
    let place = |x, y| match grid.cell(x, y).map(|cell| cell.ground) {
        Some(Ground::Room(i)) => after
            .rooms
            .get(i)
            .map_or(String::new(), |room| format!("the {} room, column {x}, row {y}", room.color)),
        Some(Ground::Door(_)) => format!("the doorway at column {x}, row {y}"),
        _ => format!("column {x}, row {y}"),
    };
    let mut parts = Vec::new();
    let (was, is) = (&before.agent, &after.agent);
    if (was.x, was.y) != (is.x, is.y) {
        parts.push(format!("the robot moves {} to {}", is.direction, place(is.x, is.y)));
    } else if was.direction != is.direction {
        parts.push(format!("the robot turns {}", is.direction));
    }
    for object in &after.objects {
        let was = before.objects.iter().find(|b| b.name == object.name);
        if was.is_some_and(|was| (was.x, was.y) != (object.x, object.y)) {
            parts.push(format!("the {} is now in {}", name(object), place(object.x, object.y)));
        }
    }
    for door in &after.doors {
        let was = before.doors.iter().find(|b| b.bounds == door.bounds);
        if was.is_some_and(|was| was.lock != door.lock) {
            let now = if door.lock == Lock::Unlocked { "open" } else { door.lock.name() };
            let (x, y) = (door.bounds.left, door.bounds.bottom);
            parts.push(format!("the door at column {x}, row {y} is {now}"));
        }
    }
    let mut sentence = parts.join("; ");
    sentence.get_mut(..1)?.make_ascii_uppercase();
    sentence.push('.');
    Some(sentence)
}

/// An object in words; a medium size goes without saying.
fn name(object: &Object) -> String {
    let Object { color, shape, size, .. } = object;
    match size {
        Some(size @ (Size::Small | Size::Large)) => format!("{size} {color} {shape}"),
        Some(Size::Medium) | None => format!("{color} {shape}"),
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
