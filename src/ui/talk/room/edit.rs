//! Changes to a world, as an editor makes them: each gives a legal world or says what is in the way. Invariant: a
//! world that was legal stays legal, and no larger than planners take.

use crate::domain::{
    Action, Bounds, Cell, Color, Direction, Door, Dynamics, Lock, Object, Room, Rules, Shape, Size,
    State, StateError, cell_at,
};
use crate::render::Thing;
use crate::ui::page::place::{Place, item_at};

/// Most cells a side, as planners pack worlds.
const MOST_CELLS: i32 = 32;
/// Most objects that the editor puts into a world.
const MOST_OBJECTS: usize = 8;
/// Most rooms that the editor puts into a world.
const MOST_ROOMS: usize = 12;

/// A look for a new object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// Its shape.
    pub shape: Shape,
    /// Its colour.
    pub color: Color,
    /// Its size, where it has one.
    pub size: Option<Size>,
}

/// What stands in the way of a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// There is a wall, or nothing at all.
    NoFloor,
    /// Something stands there.
    Taken,
    /// There are as many objects as there can be.
    TooManyObjects,
    /// There are as many rooms as there can be.
    TooManyRooms,
    /// The room would have no floor.
    TooSmall,
    /// The world would be larger than planners take.
    TooLarge,
    /// The room would lie upon another.
    Overlap,
    /// There is no wall with floor on two opposite sides.
    NoPassage,
    /// Something stands in what would go.
    Occupied,
    /// The robot cannot be taken away.
    RobotStays,
    /// There is nothing.
    Nothing,
    /// The robot cannot go on.
    Blocked,
}

/// Takes an item to another cell.
///
/// # Errors
/// What stands in the way.
pub fn put(state: &State, item: Thing, (x, y): Place) -> Result<State, Obstacle> {
    let mut next = state.clone();
    match item {
        Thing::Robot => (next.agent.x, next.agent.y) = (x, y),
        Thing::Object(index) => {
            let object = next.objects.get_mut(index).ok_or(Obstacle::Nothing)?;
            (object.x, object.y) = (x, y);
        }
    }
    checked(next)
}

/// Turns the robot a quarter to the left.
pub fn turn(state: &State) -> State {
    let mut next = state.clone();
    next.agent.direction = next.agent.direction.left();
    next
}

/// Drives the robot one step, pushing what it meets.
///
/// # Errors
/// When it would stay where it is.
pub fn drive(state: &State, direction: Direction) -> Result<State, Obstacle> {
    let action = action(direction);
    let dynamics = Dynamics::new(state, Rules::default()).map_err(|_| Obstacle::TooLarge)?;
    let packed = dynamics.pack(state).map_err(|_| Obstacle::NoFloor)?;
    let next = dynamics.unpack(dynamics.step(packed, action));
    if next == *state { Err(Obstacle::Blocked) } else { Ok(next) }
}

/// What drives the robot to a side.
pub const fn action(direction: Direction) -> Action {
    match direction {
        Direction::North => Action::North,
        Direction::South => Action::South,
        Direction::East => Action::East,
        Direction::West => Action::West,
    }
}

/// Puts a new object into the world.
///
/// # Errors
/// What stands in the way.
pub fn add(state: &State, look: Look, (x, y): Place) -> Result<State, Obstacle> {
    if state.objects.len() >= MOST_OBJECTS {
        return Err(Obstacle::TooManyObjects);
    }
    let mut next = state.clone();
    let name = free_name("object", next.objects.iter().map(|o| &*o.name));
    let Look { shape, color, size } = look;
    next.objects.push(Object { name, shape, color, size, x, y });
    checked(next)
}

/// Puts a new object on the first cell that is free, from the middle of the largest room on.
///
/// # Errors
/// What stands in the way.
pub fn add_anywhere(state: &State, look: Look) -> Result<State, Obstacle> {
    let places = |(number, room): (usize, &Room)| {
        let bounds = room.bounds;
        let middle = ((bounds.left + bounds.right) / 2, (bounds.bottom + bounds.top) / 2);
        let inside = bounds.cells().filter(move |&(x, y)| bounds.strictly_inside(x, y));
        inside.map(move |(x, y)| {
            let away = x.abs_diff(middle.0) + y.abs_diff(middle.1);
            (std::cmp::Reverse(bounds.area()), number, away, y, x)
        })
    };
    let cells = state.rooms.iter().enumerate().flat_map(places);
    let free = cells.filter(|&(.., y, x)| add(state, look, (x, y)) != Err(Obstacle::Taken));
    free.min().map_or(Err(Obstacle::NoFloor), |(.., y, x)| add(state, look, (x, y)))
}

/// Paints a room: one cell inside a room gives it a colour, a rectangle between two corners is a new room, walls
/// included.
///
/// # Errors
/// What stands in the way.
pub fn paint(state: &State, color: Color, from: Place, to: Place) -> Result<State, Obstacle> {
    let mut next = state.clone();
    if from == to {
        let room = next.rooms.iter_mut().find(|r| r.bounds.strictly_inside(from.0, from.1));
        room.ok_or(Obstacle::TooSmall)?.color = color;
        return Ok(next);
    }
    let bounds = Bounds {
        left: from.0.min(to.0),
        bottom: from.1.min(to.1),
        right: from.0.max(to.0),
        top: from.1.max(to.1),
    };
    if bounds.right - bounds.left < 2 || bounds.top - bounds.bottom < 2 {
        return Err(Obstacle::TooSmall);
    }
    if state.rooms.len() >= MOST_ROOMS {
        return Err(Obstacle::TooManyRooms);
    }
    // Rooms may share walls, but no wall may cross another room's floor.
    let crosses = |b: &Bounds| {
        bounds.left < b.right
            && b.left < bounds.right
            && bounds.bottom < b.top
            && b.bottom < bounds.top
    };
    if state.rooms.iter().any(|room| crosses(&room.bounds)) {
        return Err(Obstacle::Overlap);
    }
    let all = state.extent().map_or(bounds, |extent| extent.hull(bounds));
    if all.right - all.left >= MOST_CELLS || all.top - all.bottom >= MOST_CELLS {
        return Err(Obstacle::TooLarge);
    }
    let name = free_name("room", regions(&next));
    next.rooms.push(Room { name, color, bounds });
    checked(next)
}

/// Makes a door in a wall, or changes one: open, untried, locked, none.
///
/// # Errors
/// What stands in the way.
pub fn door(state: &State, (x, y): Place) -> Result<State, Obstacle> {
    let mut next = state.clone();
    if let Cell::Door(index) = cell_at(&state.rooms, &state.doors, x, y) {
        let door = next.doors.get_mut(index).ok_or(Obstacle::Nothing)?;
        door.lock = match door.lock {
            Lock::Unlocked => Lock::Unknown,
            Lock::Unknown => Lock::Locked,
            Lock::Locked => return remove_door(state, index),
        };
        return Ok(next);
    }
    let is_floor = |dx, dy| cell_at(&state.rooms, &state.doors, x + dx, y + dy) == Cell::Floor;
    let is_passage = (is_floor(1, 0) && is_floor(-1, 0)) || (is_floor(0, 1) && is_floor(0, -1));
    if cell_at(&state.rooms, &state.doors, x, y) != Cell::Wall || !is_passage {
        return Err(Obstacle::NoPassage);
    }
    let name = free_name("door", regions(&next));
    let bounds = Bounds { left: x, bottom: y, right: x, top: y };
    next.doors.push(Door { name, bounds, lock: Lock::Unlocked });
    checked(next)
}

/// Opens every door.
pub fn unlock(state: &State) -> State {
    let mut next = state.clone();
    next.doors.iter_mut().for_each(|door| door.lock = Lock::Unlocked);
    next
}

/// Takes away what is on a cell: an object, else a door, else the room with the doors in its walls.
///
/// # Errors
/// What stands in the way.
pub fn erase(state: &State, place: Place) -> Result<State, Obstacle> {
    let (x, y) = place;
    match item_at(state, place) {
        Some(Thing::Robot) => return Err(Obstacle::RobotStays),
        Some(Thing::Object(index)) => {
            let mut next = state.clone();
            next.objects.remove(index);
            return Ok(next);
        }
        None => {}
    }
    if let Cell::Door(index) = cell_at(&state.rooms, &state.doors, x, y) {
        return remove_door(state, index);
    }
    let room = state.rooms.iter().position(|r| r.bounds.strictly_inside(x, y));
    let mut next = state.clone();
    let gone = next.rooms.remove(room.ok_or(Obstacle::Nothing)?);
    // A door stays where there is still floor on both of its sides.
    let leads = |door: &Door| {
        let b = door.bounds;
        let floor = |x, y| next.rooms.iter().any(|r| r.bounds.strictly_inside(x, y));
        (floor(b.left - 1, b.bottom) && floor(b.right + 1, b.bottom))
            || (floor(b.left, b.bottom - 1) && floor(b.left, b.top + 1))
            || !gone.bounds.overlaps(&b)
    };
    let doors = next.doors.iter().filter(|door| leads(door)).cloned().collect();
    next.doors = doors;
    checked(next).map_err(|_| Obstacle::Occupied)
}

fn remove_door(state: &State, index: usize) -> Result<State, Obstacle> {
    let mut next = state.clone();
    next.doors.remove(index);
    checked(next).map_err(|_| Obstacle::Occupied)
}

/// The world, if it is legal.
fn checked(state: State) -> Result<State, Obstacle> {
    match state.check() {
        Ok(()) => Ok(state),
        Err(StateError::Shared { .. }) => Err(Obstacle::Taken),
        Err(StateError::TooLarge { .. } | StateError::TooFar { .. }) => Err(Obstacle::TooLarge),
        Err(_) => Err(Obstacle::NoFloor),
    }
}

fn regions(state: &State) -> impl Iterator<Item = &str> + Clone {
    state.rooms.iter().map(|r| &*r.name).chain(state.doors.iter().map(|d| &*d.name))
}

/// The first of `object0`, `object1` … that none has.
fn free_name<'a>(stem: &str, taken: impl Iterator<Item = &'a str> + Clone) -> String {
    let mut number = 0;
    loop {
        let name = format!("{stem}{number}");
        if taken.clone().all(|other| other != name) {
            return name;
        }
        number += 1;
    }
}
