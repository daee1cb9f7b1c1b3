//! The state of the room: what it is for, what a person holds in it, and what other worlds are to be like.

use super::edit::{Look, Obstacle};
use crate::domain::{Blueprint, Color, Shape, State as World};
use crate::render::Thing;
use crate::ui::page::place::Place;
use crate::ui::talk::teach::trail::Trail;

/// What the room is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Watching.
    #[default]
    Watch,
    /// Changing the world.
    Edit,
    /// Showing what a command means.
    Teach,
}

impl Mode {
    /// All of them.
    pub const ALL: [Mode; 3] = [Mode::Watch, Mode::Edit, Mode::Teach];
}

/// What a pointer or Enter does in the room while it is changed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Takes the robot and objects elsewhere.
    #[default]
    Move,
    /// Puts a new object.
    Object,
    /// Paints rooms.
    Room,
    /// Makes and changes doors.
    Door,
    /// Takes away.
    Erase,
}

impl Tool {
    /// All of them.
    pub const ALL: [Tool; 5] = [Tool::Move, Tool::Object, Tool::Room, Tool::Door, Tool::Erase];
}

/// What is held in the room.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Held {
    /// An item on its way, where it is in cells.
    Item(Thing, [f32; 2]),
    /// A corner of a room that is painted.
    Corner(Place),
}

/// The element that is asked with.
pub const QUESTION: &str = "moved-teach";

/// What was taken elsewhere.
#[derive(Clone, Debug, PartialEq)]
pub struct Moved {
    /// The world with that.
    pub world: World,
    /// Where it was put down.
    pub at: Place,
    /// The states of the task over time that was at work, from where it was said.
    pub run: Vec<World>,
}

/// The room's side of the page.
#[derive(Clone, Debug, PartialEq)]
pub struct Room {
    /// What it is for.
    pub mode: Mode,
    /// The tool, while it is changed.
    pub tool: Tool,
    /// How new objects look.
    pub look: Look,
    /// The colour of new rooms.
    pub paint: Color,
    /// Where the keyboard is.
    pub cursor: Option<Place>,
    /// The cell that the pointer is on.
    pub hover: Option<Place>,
    /// What is held.
    pub held: Option<Held>,
    /// The way that the robot is taken along by a pointer, while it could be driven that way.
    pub trail: Option<Trail>,
    /// What was taken elsewhere while the room was watched.
    pub moved: Option<Moved>,
    /// Why the last change could not be made.
    pub obstacle: Option<Obstacle>,
    /// What random worlds are like.
    pub blueprint: Blueprint,
    /// The seed of the next one.
    pub seed: u32,
    /// The world as text, while it is shown.
    pub text: Option<String>,
    /// What is wrong with a world that was asked for.
    pub notice: Option<String>,
}

impl Room {
    /// A room that is watched.
    pub fn new() -> Room {
        Room {
            mode: Mode::default(),
            tool: Tool::default(),
            look: Look { shape: Shape::Block, color: Color::Yellow, size: None },
            paint: Color::Yellow,
            cursor: None,
            hover: None,
            held: None,
            trail: None,
            moved: None,
            obstacle: None,
            blueprint: Blueprint { objects: 3, ..Blueprint::default() },
            seed: 1,
            text: None,
            notice: None,
        }
    }

    /// A hand lets go, and what was in its way is forgotten.
    pub(crate) fn let_go(&mut self) {
        (self.held, self.trail, self.moved, self.obstacle) = (None, None, None, None);
    }
}

impl Default for Room {
    fn default() -> Room {
        Room::new()
    }
}
