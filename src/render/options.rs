//! How a state is to be shown, as plain data: what is pointed out in it, what its cells are worth, what a person
//! is about to do. Everything is optional, and nothing of it moves while the robot glides. Cells are (x, y).

use super::palette::Theme;
use crate::domain::{Action, Direction};

/// How a state is to be shown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// The set of colours.
    pub theme: Theme,
    /// Whether each object bears its colour's letter.
    pub letters: bool,
    /// Whether the rooms' names are to be written over the picture: without that each bears its colour's letter.
    pub named: bool,
    /// What cells are worth, in 0..=1, as tiles whose colour and size both tell it ([`spread`] makes the most of
    /// the colours).
    pub values: Vec<(i32, i32, f32)>,
    /// What to do in a cell.
    pub arrows: Vec<(i32, i32, Arrow)>,
    /// Cells where a goal holds, hatched.
    pub goal: Vec<(i32, i32)>,
    /// Cells to point out, such as what a phrase refers to, outlined; neighbours share one outline.
    pub highlight: Vec<(i32, i32)>,
    /// The cell that the keyboard is at.
    pub cursor: Option<(i32, i32)>,
    /// What is being dragged.
    pub ghost: Option<Ghost>,
}

/// What to do in a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrow {
    /// Step to a side.
    Step(Direction),
    /// Turn a quarter to the left, in place.
    TurnLeft,
    /// Turn a quarter to the right, in place.
    TurnRight,
    /// Change places with what stands on that side.
    Pull(Direction),
}

/// Something on its way from its cell to another, in a person's hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ghost {
    /// What it is; in its own cell it stays, pale.
    pub what: Thing,
    /// Where it is held, in cells.
    pub at: [f32; 2],
    /// The cell where it would be let go.
    pub target: (i32, i32),
    /// Whether it may stand there.
    pub allowed: bool,
}

/// What can be dragged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Thing {
    /// The robot.
    Robot,
    /// An object, by index into the state's objects.
    Object(usize),
}

impl Arrow {
    /// The arrow for an action by its name, for a robot that faces that way; `None` for a name of no action.
    pub fn of_action(name: &str, facing: Direction) -> Option<Self> {
        Some(match name.parse().ok()? {
            Action::North => Self::Step(Direction::North),
            Action::South => Self::Step(Direction::South),
            Action::East => Self::Step(Direction::East),
            Action::West => Self::Step(Direction::West),
            Action::Forward => Self::Step(facing),
            Action::TurnLeft => Self::TurnLeft,
            Action::TurnRight => Self::TurnRight,
            Action::Pull => Self::Pull(facing),
        })
    }
}

/// Values made ready to be shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// For [`Options::values`].
    pub cells: Vec<(i32, i32, f32)>,
    /// What a tenth and 1 stand for, for a legend; nothing when nothing is worth anything.
    pub ends: Option<[f64; 2]>,
}

/// Stretches values over 0..=1, so that a discount near 1 does not leave all cells one colour: 0 stays 0 (it is
/// the value of no way at all), the others begin at a tenth.
pub fn spread(values: &[(i32, i32, f64)]) -> Spread {
    let worth = || values.iter().map(|(_, _, value)| *value).filter(|value| *value > 0.0);
    let (low, high) = (worth().fold(f64::INFINITY, f64::min), worth().fold(0.0, f64::max));
    let stretched = |value: f64| match () {
        () if value <= 0.0 || value.is_nan() => 0.0,
        () if high > low => 0.1 + 0.9 * (value - low) / (high - low),
        () => 1.0,
    };
    let cells = values.iter().map(|(x, y, value)| (*x, *y, stretched(*value) as f32)).collect();
    Spread { cells, ends: (low <= high).then_some([low, high]) }
}
