//! What the page can do about a command that came to nothing, at the press of a button.

use crate::ui::talk::command::link::Link;
use crate::ui::talk::room::edit::Look;
use crate::worker::protocol::Claim;

/// What the page can do about a message.
#[derive(Clone, Debug, PartialEq)]
pub enum Help {
    /// Says a word in place of others, and asks again: the places of the words, and what to say.
    Say(Link, String),
    /// Does what was understood, and no more.
    Just(Claim),
    /// Shows what the command means.
    Teach,
    /// Points at words, and at what is in question in the room.
    Show(Link),
    /// Does what asks for less: without these demands or, once they are met, with them.
    Instead(Vec<Claim>, bool),
    /// Puts a thing into the room, and asks again.
    Add(Look),
    /// Changes the room.
    Edit,
    /// Lets the robot move what the command does not name, and asks again.
    FreeLandmarks,
    /// Lets the robot pull, and asks again.
    Pull,
    /// Opens all doors, and asks again.
    Unlock,
    /// Leaves nothing to chance, and asks again.
    NoChance,
    /// Goes to another random world.
    OtherWorld,
    /// Says what can be understood.
    Guide,
}
