//! The entities of a state, seen one by one, and what makes them the same in two states: rooms and doors their
//! bounds, whatever they are called, objects their name.

use super::class::Class;
use crate::domain::{Bounds, Color, Door, Object, Room, Shape, State};

/// An entity as one state shows it.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "the four kinds of thing")]
pub enum Thing<'s> {
    Agent { x: i32, y: i32 },
    Room(&'s Room),
    Door(&'s Door),
    Object(&'s Object),
}

/// What an entity is known by from state to state.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Entity {
    /// The robot.
    Agent,
    /// The room with these bounds.
    Room(Bounds),
    /// The door with these bounds.
    Door(Bounds),
    /// The object of this name.
    Object(String),
    /// Whatever the `exists` at this depth (0 is the outermost) holds up that the initial state lacks.
    /// Planning meets none: nothing comes into a world.
    Stranger(usize),
}

impl<'s> Thing<'s> {
    /// All entities of a state: agent, rooms, doors, objects.
    pub fn all(state: &'s State) -> Vec<Thing<'s>> {
        let agent = Thing::Agent { x: state.agent.x, y: state.agent.y };
        let rooms = state.rooms.iter().map(Thing::Room);
        let doors = state.doors.iter().map(Thing::Door);
        let objects = state.objects.iter().map(Thing::Object);
        std::iter::once(agent).chain(rooms).chain(doors).chain(objects).collect()
    }

    /// Its kind.
    pub fn class(self) -> Class {
        match self {
            Thing::Agent { .. } => Class::Agent,
            Thing::Room(_) => Class::Room,
            Thing::Door(_) => Class::Door,
            Thing::Object(_) => Class::Object,
        }
    }

    /// What it is known by.
    pub fn entity(self) -> Entity {
        match self {
            Thing::Agent { .. } => Entity::Agent,
            Thing::Room(room) => Entity::Room(room.bounds),
            Thing::Door(door) => Entity::Door(door.bounds),
            Thing::Object(object) => Entity::Object(object.name.clone()),
        }
    }

    /// Whether it goes by that entity; cheaper than [`Thing::entity`].
    pub fn is(self, entity: &Entity) -> bool {
        match (self, entity) {
            (Thing::Agent { .. }, Entity::Agent) => true,
            (Thing::Room(room), Entity::Room(bounds)) => room.bounds == *bounds,
            (Thing::Door(door), Entity::Door(bounds)) => door.bounds == *bounds,
            (Thing::Object(object), Entity::Object(name)) => object.name == *name,
            _ => false,
        }
    }

    /// Column and row of what stands in one cell; `None` for a region.
    pub fn cell(self) -> Option<(i32, i32)> {
        match self {
            Thing::Agent { x, y } => Some((x, y)),
            Thing::Object(object) => Some((object.x, object.y)),
            Thing::Room(_) | Thing::Door(_) => None,
        }
    }

    /// The bounds of a region.
    pub fn bounds(self) -> Option<Bounds> {
        match self {
            Thing::Room(room) => Some(room.bounds),
            Thing::Door(door) => Some(door.bounds),
            Thing::Agent { .. } | Thing::Object(_) => None,
        }
    }

    /// Its colour.
    pub fn color(self) -> Option<Color> {
        match self {
            Thing::Room(room) => Some(room.color),
            Thing::Object(object) => Some(object.color),
            Thing::Agent { .. } | Thing::Door(_) => None,
        }
    }

    /// Its shape.
    pub fn shape(self) -> Option<Shape> {
        match self {
            Thing::Object(object) => Some(object.shape),
            Thing::Agent { .. } | Thing::Room(_) | Thing::Door(_) => None,
        }
    }

    /// Its size: a region's area between its border lines; an object's 1, 2 or 3; the agent has none.
    pub fn size(self) -> Option<i64> {
        match self {
            Thing::Agent { .. } => None,
            Thing::Room(room) => Some(room.bounds.area()),
            Thing::Door(door) => Some(door.bounds.area()),
            Thing::Object(object) => Some(object.magnitude()),
        }
    }
}
