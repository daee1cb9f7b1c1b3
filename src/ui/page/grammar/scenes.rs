//! How a language speaks of a world: things, places, what stands where, and what changed. The page that asks people needs
//! no more of a grammar, and links no more.

use crate::domain::{Bounds, Cell, Color, Lock, Object, Shape, Size, State, cell_at};
use crate::render::Thing;
use crate::ui::page::place::{Place, item_at};

/// Where something is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spot {
    /// Inside a room.
    Room(Color),
    /// In a doorway.
    Door(Lock),
    /// In a wall.
    Wall,
    /// Outside all rooms.
    Outside,
}

/// How a language speaks of a world.
pub trait Scenes {
    /// Several, as people list them: "a, b and c".
    fn list(&self, all: &[String]) -> String;
    /// An object's look: "large red chair".
    fn look(&self, color: Color, shape: Shape, size: Option<Size>) -> String;
    /// A colour.
    fn color(&self, color: Color) -> &'static str;
    /// A room by its colour: "blue room".
    fn room(&self, color: Color) -> String;
    /// A shape.
    fn shape(&self, shape: Shape) -> &'static str;
    /// A size.
    fn size(&self, size: Size) -> &'static str;
    /// A spot: "in the red room".
    fn spot(&self, spot: Spot) -> String;
    /// Where something stands: "The block is in the red room."
    fn stands(&self, what: &str, spot: Spot) -> String;
    /// "column 3, row 4".
    fn coordinates(&self, cell: Place) -> String;
    /// Where the robot is: "The robot is in the red room, facing north."
    fn robot(&self, state: &State) -> String;
    /// A world as a whole.
    fn world(&self, state: &State) -> String;
    /// "the robot moves to …", "the red chair is now …", "the door at … is locked": what changed.
    fn moved_robot(&self, state: &State, to: Spot) -> String;
    /// The robot has turned.
    fn turned_robot(&self, state: &State) -> String;
    /// An object is elsewhere now.
    fn moved_object(&self, object: &Object, to: Spot) -> String;
    /// A door's lock is another.
    fn changed_door(&self, cell: Place, lock: Lock) -> String;
    /// Rooms, doors or objects came or went.
    fn rebuilt(&self, state: &State) -> String;
    /// What is held: "Holding the robot."
    fn holds(&self, what: Option<&Object>) -> String;
    /// A corner of a room is held.
    fn holds_corner(&self) -> String;
    /// The robot on a cell.
    fn robot_here(&self, state: &State) -> String;

    /// A cell and what is there, for those who hear the room: "column 3, row 4, in the red room: yellow block".
    fn cell(&self, state: &State, cell: Place) -> String {
        let place = format!("{}, {}", self.coordinates(cell), self.spot(spot(state, cell)));
        match item_at(state, cell) {
            Some(Thing::Robot) => format!("{place}: {}", self.robot_here(state)),
            Some(Thing::Object(index)) => match state.objects.get(index) {
                Some(object) => format!("{place}: {}", self.object(object)),
                None => place,
            },
            None => place,
        }
    }

    /// An object: "large red chair".
    fn object(&self, object: &Object) -> String {
        self.look(object.color, object.shape, object.size)
    }

    /// What changed from one world to the next.
    fn change(&self, before: &State, after: &State) -> String {
        let (was, is) = (&before.agent, &after.agent);
        let mut changes = Vec::new();
        if (was.x, was.y) != (is.x, is.y) {
            changes.push(self.moved_robot(after, spot(after, (is.x, is.y))));
        } else if was.direction != is.direction {
            changes.push(self.turned_robot(after));
        }
        for object in &after.objects {
            let was = before.objects.iter().find(|was| was.name == object.name);
            if was.is_some_and(|was| (was.x, was.y) != (object.x, object.y)) {
                changes.push(self.moved_object(object, spot(after, (object.x, object.y))));
            }
        }
        for door in &after.doors {
            let was = before.doors.iter().find(|was| was.bounds == door.bounds);
            if was.is_some_and(|was| was.lock != door.lock) {
                let Bounds { left, bottom, .. } = door.bounds;
                changes.push(self.changed_door((left, bottom), door.lock));
            }
        }
        let counts = |state: &State| (state.rooms.len(), state.doors.len(), state.objects.len());
        if counts(before) != counts(after) || (changes.is_empty() && before != after) {
            changes.push(self.rebuilt(after));
        }
        changes.join(" ")
    }
}

/// What kind of place a cell is.
pub fn spot(state: &State, (x, y): Place) -> Spot {
    match cell_at(&state.rooms, &state.doors, x, y) {
        Cell::Door(index) => {
            Spot::Door(state.doors.get(index).map_or(Lock::Unlocked, |door| door.lock))
        }
        Cell::Floor => {
            let room = state.rooms.iter().find(|room| room.bounds.strictly_inside(x, y));
            room.map_or(Spot::Outside, |room| Spot::Room(room.color))
        }
        Cell::Wall if state.rooms.iter().any(|room| room.bounds.contains(x, y)) => Spot::Wall,
        Cell::Wall => Spot::Outside,
    }
}

/// The colour of the room that a cell is in.
pub fn room_at(state: &State, cell: Place) -> Option<Color> {
    match spot(state, cell) {
        Spot::Room(color) => Some(color),
        _ => None,
    }
}
