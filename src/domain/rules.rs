//! What can differ from one Cleanup World to another: the robot's form, `pull`, which objects may be moved,
//! and what may go wrong, each with its probability (Williams et al., Sections III and VII).

use super::name::named;
use super::object::Direction;

/// What the robot can do. Compass form: turn to a side and step, pushing what is in the way. Robot form: turn
/// by a quarter, or step ahead in the same way. In both: pull what it faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names say it")]
pub enum Action {
    North,
    South,
    East,
    West,
    Pull,
    Forward,
    TurnLeft,
    TurnRight,
}

named!(
    Action, "action",
    North "north" 'n', South "south" 's', East "east" 'e', West "west" 'w', Pull "pull" 'p',
    Forward "forward" 'f', TurnLeft "turn_left" 'l', TurnRight "turn_right" 'r',
);

/// How the robot is driven.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Form {
    /// `north south east west`: turn to that side, then step.
    #[default]
    Compass,
    /// `forward turn_left turn_right`: step where it faces, or turn by a quarter.
    Robot,
}

/// Which objects may be moved, by their index in the state. An object that may not stands like a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Movable(u64);

impl Movable {
    /// Every object.
    pub const ALL: Self = Self(u64::MAX);
    /// No object.
    pub const NONE: Self = Self(0);

    /// These and the object with this index. A state has at most 64 objects; others are nobody.
    #[must_use]
    pub const fn with(self, index: usize) -> Self {
        Self(if index < 64 { self.0 | 1 << index } else { self.0 })
    }

    /// These and those.
    #[must_use]
    pub const fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether the object with this index may be moved.
    #[inline]
    #[must_use]
    pub const fn allows(self, index: usize) -> bool {
        index < 64 && self.0 >> index & 1 == 1
    }
}

impl Default for Movable {
    /// Every object.
    fn default() -> Self {
        Self::ALL
    }
}

/// What may go wrong, with its probability; nothing by default. Drawn in the order of the methods.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Chances {
    slip: f64,
    lock: f64,
    loss: f64,
}

/// A number that is no probability.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{name}: {value} is no probability, which lies between 0 and 1")]
pub struct NotAProbability {
    /// `slip_probability`, `lock_probability` or `loss_probability`.
    pub name: &'static str,
    /// What was given.
    pub value: f64,
}

impl Chances {
    /// Chances with these probabilities.
    ///
    /// # Errors
    /// The first that is not within [0, 1].
    pub fn new(slip: f64, lock: f64, loss: f64) -> Result<Self, NotAProbability> {
        for (name, value) in
            [("slip_probability", slip), ("lock_probability", lock), ("loss_probability", loss)]
        {
            if !(0.0..=1.0).contains(&value) {
                return Err(NotAProbability { name, value });
            }
        }
        Ok(Self { slip, lock, loss })
    }

    /// That an action does nothing at all.
    #[must_use]
    pub const fn slip(self) -> f64 {
        self.slip
    }

    /// That a door that nobody tried turns out to be locked when something would first enter it.
    #[must_use]
    pub const fn lock(self) -> f64 {
        self.lock
    }

    /// That an object that is pushed or pulled stays where it is.
    #[must_use]
    pub const fn loss(self) -> f64 {
        self.loss
    }
}

/// The rules of a world. The default is the deterministic world in compass form, without `pull`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rules {
    /// Whether there is the action `pull`.
    pub pull: bool,
    /// How the robot is driven.
    pub form: Form,
    /// Which objects may be moved.
    pub movable: Movable,
    /// What may go wrong.
    pub chances: Chances,
}

impl Rules {
    /// The actions of such a world, in the order of ties.
    #[must_use]
    pub const fn actions(self) -> &'static [Action] {
        const COMPASS: &[Action] =
            &[Action::North, Action::South, Action::East, Action::West, Action::Pull];
        const ROBOT: &[Action] =
            &[Action::Forward, Action::TurnLeft, Action::TurnRight, Action::Pull];
        let all = match self.form {
            Form::Compass => COMPASS,
            Form::Robot => ROBOT,
        };
        if self.pull { all } else { all.split_at(all.len() - 1).0 }
    }

    /// The side that an action steps to for a robot that faces `heading`; `None` for those that take no step
    /// and for those of the other form, which do nothing.
    #[inline]
    pub(super) const fn step(self, action: Action, heading: Direction) -> Option<Direction> {
        match (self.form, action) {
            (Form::Compass, Action::North) => Some(Direction::North),
            (Form::Compass, Action::South) => Some(Direction::South),
            (Form::Compass, Action::East) => Some(Direction::East),
            (Form::Compass, Action::West) => Some(Direction::West),
            (Form::Robot, Action::Forward) => Some(heading),
            _ => None,
        }
    }
}
