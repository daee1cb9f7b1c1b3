//! What can happen to the page that drives a robot.

use super::state::{Kind, Topic};
use crate::ui::page::language::Language;
use crate::ui::page::preferences::Preferences;
use crate::worker::protocol::{Envelope, Event};

/// Something that happened.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// The page was opened in a browser of this language; whether it came in a secure way.
    Opened(Language, bool),
    /// What the person prefers is known, or has changed.
    Prefers(Preferences),
    /// The page is wanted in another language.
    Speak(Language),
    /// Time has gone on; so many bytes wait to leave.
    Tick(u32),

    /// Which robot is to be driven.
    Pick(Kind),
    /// The bridge's address is this now.
    Address(String),
    /// A topic has this name now.
    Name(Topic, String),
    /// The types are to be asked of the bridge, or are these: by their place among [`TYPES`](super::state::TYPES).
    Types(Option<usize>),
    /// A link is wanted, or no more.
    Link(bool),
    /// It is open.
    LinkOpened,
    /// A text came over it.
    LinkHeard(String),
    /// It is closed, or could not be opened.
    LinkClosed,
    /// It is time to open it again.
    LinkAgain(u32),

    /// What was kept of how a robot is set up has come, or there is nothing.
    Recalled(Option<String>),

    /// One of the page's worlds is to be that of the robot.
    World(usize),
    /// Its rooms are drawn so.
    Drawing(String),
    /// They are to be read.
    Draw,
    /// A cell measures so many metres.
    Size(f64),
    /// The robot stands as it is drawn.
    Here,
    /// Calibration by four corners begins.
    Corners,
    /// The robot stands in the corner that is asked for.
    Corner,

    /// The plan is to be rehearsed.
    Rehearse,
    /// The base is to be seen to stop by itself.
    Try,
    /// The robot may be driven, or no more.
    Arm(bool),
    /// How fast it may go.
    Speed(f64),
    /// The dead man's key is held, or no more.
    Held(bool),
    /// Stop now.
    Stop,
    /// The reason for the stop is seen to.
    Release,
    /// The page is no more to be seen.
    Hidden,
    /// It is about to close.
    Closing,

    /// The command is this now.
    Typed(String),
    /// It is to be done.
    Ask,
    /// It was meant as the reading of this place.
    Choose(usize),
    /// What can be done instead is to be done.
    Instead,
    /// The engine that talks said something.
    Heard(Envelope<Event>),
    /// It broke, and how.
    EngineBroke(String),
    /// It is time to see whether it still answers.
    Look(u32),
    /// It is to be started again.
    Restart,
    /// The model has come, or has not.
    Model(Result<String, String>),
    /// What other words may stand for has come, or has not.
    Words(Result<String, String>),
}
