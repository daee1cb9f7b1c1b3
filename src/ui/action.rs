//! What can happen to the page ([`Action`]) and what the page wants done ([`Effect`]). Both are plain data:
//! a test plays actions and reads effects, with no browser.

use super::edit::Look;
use super::files::Fault;
use super::point::Point;
use super::room::{Mode, Tool};
use super::text::Language;
use super::watch::{Layer, Speed};
use super::why::Help;
use crate::domain::{Blueprint, Color, Direction};
use crate::render::Theme;
use crate::worker::protocol::{Envelope, Event, Program, Request, WorldRules};
use serde::{Deserialize, Serialize};

/// What the person's system asks of every page.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Preferences {
    /// Whether things should jump rather than glide.
    pub reduced_motion: bool,
    /// Light or dark.
    pub theme: Theme,
}

/// The pages of the page.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum View {
    /// Talk to the robot and watch it.
    #[default]
    Talk,
    /// Train a parser on a corpus.
    Train,
}

/// How deep a person wants to look.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Depth {
    /// The room, the command, what was understood, and what the robot does.
    #[default]
    Say,
    /// Readings, goals, policies and values.
    See,
    /// Derivations, forms, features and scores.
    Study,
}

impl Depth {
    /// All of them, shallow first.
    pub const ALL: [Depth; 3] = [Depth::Say, Depth::See, Depth::Study];
}

/// What a key does in the room.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// An arrow; with shift or without.
    Arrow(Direction, bool),
    /// Enter or space: use the tool, or take and put down.
    Act,
    /// Escape: put nothing down.
    Cancel,
    /// R: turn the robot.
    Turn,
}

/// Something that happened: a person did it, the engine said it, or a timer ran out.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// The page has opened, in this language.
    Opened(Language),
    /// What the person prefers is known, or has changed.
    Prefers(Preferences),
    /// An engine sent a message.
    Heard(Program, Envelope<Event>),
    /// An engine could not be loaded or died; the text says how.
    EngineBroke(Program, String),
    /// A timer ran out.
    Rang(Timer),
    /// A person asked for a new engine.
    RestartEngine(Program),
    /// The model that comes with the page is there, or is not; the text says why.
    Fetched(Result<String, String>),
    /// A person wants that model once more.
    FetchModel,

    /// Another view was opened.
    Go(View),
    /// Another depth was chosen.
    Deepen(Depth),
    /// Another language was chosen.
    Speak(Language),
    /// Take the last change back.
    Undo,
    /// Do what was undone again.
    Redo,

    /// A file was opened and read as text.
    FileRead {
        /// Its name.
        name: String,
        /// Its text.
        text: String,
    },
    /// A file of this name was offered that cannot be read.
    FileRefused(String, Fault),
    /// Go back to the page's own six sentences.
    OpenDemo,
    /// Open or close a row of the corpus.
    ToggleRow(usize),
    /// Show more rows of the corpus.
    MoreRows,
    /// Save the corpus as a file.
    SaveCorpus,
    /// Train on the corpus that is open.
    Train,
    /// Stop training.
    CancelTraining,
    /// Save the model as a file.
    SaveModel,

    /// The command box changed.
    Typed(String),
    /// A command was sent: what stands in the box.
    Ask,
    /// An example command was chosen: fill the box and send it.
    AskExample(String),
    /// Another reading was chosen.
    Choose(usize),
    /// Words are pointed at, or no longer.
    Link(Option<super::link::Link>),
    /// The goal cells of a reading are to be seen, or no longer.
    Preview(Option<usize>),
    /// All readings are to be seen.
    AllReadings,
    /// A constituent of the derivation was chosen.
    ChooseNode(usize),
    /// Another step of its reduction is shown.
    Reduce(usize),
    /// A message's help was taken up.
    Help(Help),
    /// Stop the planner.
    StopPlanning,

    /// The room is for something else now.
    SetMode(Mode),
    /// Another tool was taken.
    Take(Tool),
    /// New objects look so.
    SetLook(Look),
    /// New rooms have this colour.
    SetPaint(Color),
    /// A pointer in the room.
    Point(Point),
    /// A key in the room.
    Press(Key),
    /// Another world was chosen, by its place in [`super::world::WORLDS`].
    PickWorld(usize),
    /// Put the world back as it was opened.
    ResetWorld,
    /// Random worlds are to be like this.
    SetBlueprint(Blueprint),
    /// Another seed for the next random world.
    SetSeed(u32),
    /// Make the random world of the seed, and count it on.
    DrawWorld,
    /// Show the world as text, or no longer.
    ToggleText,
    /// The world's text was changed.
    TypedText(String),
    /// Open the world that the text draws.
    ApplyText,
    /// The rules of the world changed.
    SetRules(WorldRules),

    /// The words of a lesson changed.
    TypedLesson(String),
    /// Teach what is shown.
    Teach,
    /// Begin the demonstration anew.
    ClearDraft,
    /// Forget a lesson.
    Unteach(usize),
    /// Save all lessons as a corpus.
    SaveLessons,

    /// Play or pause the plan.
    TogglePlay,
    /// Go to a step of the plan, and pause there.
    Seek(usize),
    /// Play faster or slower.
    SetSpeed(Speed),
    /// Show or hide a layer of the room.
    ToggleLayer(Layer),
    /// Follow the policy many times.
    TryMany,

    /// Make a link of all this.
    Share,
    /// The link is there and was copied (or could not be), or there is none; the text says why.
    Shared(Result<Link, String>),
    /// Save all this as a file.
    SaveSession,
    /// A link was opened that holds this, or something unreadable.
    LinkOpened(Result<String, String>),
    /// Something was copied, or could not be.
    Copied(bool),
    /// Copy a text.
    Copy(String),
    /// The message about sharing was read.
    CloseShare,
}

/// A link to the page as it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Link {
    /// The address.
    pub address: String,
    /// Whether it is on the clipboard.
    pub copied: bool,
}

/// Something for the view to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Start a new engine, ending the one there is.
    SpawnEngine(Program),
    /// Send an engine a message.
    Post(Program, Envelope<Request>),
    /// Ring after so many milliseconds.
    StartTimer(Timer, u32),
    /// Get the model that comes with the page.
    FetchModel,
    /// The person reads another language.
    SetLanguage(Language),
    /// Make a link that holds a text, show it in the address bar and copy it.
    Share(String),
    /// Copy a text.
    Copy(String),
    /// Move the keyboard's focus to an element, and bring it into view.
    Focus(&'static str),
    /// Offer a text to the person as a file.
    Save {
        /// The file's name.
        name: String,
        /// Its text.
        text: String,
    },
}

/// What a timer was for. The number tells a stale one from the one that counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Timer {
    /// The next step of the plan that is played.
    Play(u32),
    /// Time to see whether an engine still answers.
    Watch(Program, u32),
}
