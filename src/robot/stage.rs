//! What can happen to a driver, what it wants done, how far it is, and why it stopped.

use super::geometry::{Pose, Twist};
use super::session::Bad;
use super::sight::Unseen;
use super::trial::{Trial, Untried};
use crate::domain::State;

/// Something that happens.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// Time has gone on: many times a second.
    Tick,
    /// There is a link.
    Linked,
    /// The link is gone.
    Unlinked,
    /// The robot is here, in metres.
    Robot(Pose),
    /// So is the tracked thing of this number.
    Body(usize, Pose),
    /// What came in is not as it should be.
    Bad(Bad),
    /// What was sent does not leave: so many bytes wait.
    Backlog(u32),
    /// The dead man's key is held, or no more.
    Held(bool),
    /// Stop now.
    Emergency,
    /// The reason for the stop is seen to.
    Release,
    /// The page is no more to be seen.
    Hidden,
    /// The page is about to close.
    Closing,
    /// See whether the base stops by itself.
    Try,
    /// The robot may be driven.
    Arm,
    /// It may not be driven any more.
    Disarm,
    /// Another command: its plan, or none.
    Route(Vec<State>),
    /// What came of thinking again: a plan, or nothing.
    Again(Option<Vec<State>>),
}

/// Something that is to be done.
#[derive(Clone, Debug, PartialEq)]
pub enum Deed {
    /// Velocities may be published from now on, or no more.
    Arm(bool),
    /// Publish this velocity, now or never.
    Publish(Twist),
    /// Think again: the world is this, and the robot's run so far led there.
    Plan(Box<State>),
    /// A person is to be told.
    Tell(Told),
}

/// What a person is told.
#[derive(Clone, Debug, PartialEq)]
pub enum Told {
    /// The base stopped by itself, after so many milliseconds without a velocity.
    Stops(u32),
    /// It was not seen to.
    Untried(Untried),
    /// The robot drives.
    Drives,
    /// It waits for the key.
    Waits,
    /// It has done what was asked.
    Arrived,
    /// The world is not where it was expected: it thinks again.
    Rethinks,
    /// It stopped, and why.
    Halted(Halt),
}

/// How far a driver is.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Stage {
    /// Nothing is sent.
    #[default]
    Off,
    /// It is seen whether the base stops by itself.
    Trying(Trial),
    /// It drives as soon as the key is held.
    Ready,
    /// The key is held.
    Driving,
    /// It stopped, and stays so until a person releases it.
    Halted(Halt),
}

/// Why it stopped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Halt {
    /// A person said so.
    Emergency,
    /// The page was not to be seen.
    Hidden,
    /// No pose came for too long.
    NoPose,
    /// The pose leapt.
    Leapt,
    /// The link is gone.
    Unlinked,
    /// What was sent did not leave.
    Backlog,
    /// The page itself stood still for too long.
    Slept,
    /// What came in was not as it should be.
    Bad(Bad),
    /// What is seen is no state of the world.
    Unseen(Unseen),
    /// A step took too long.
    Stuck,
    /// It had to think again too often.
    TooOften,
    /// There is no way to what was asked any more.
    NoWay,
}
