//! What a person can do on the Talk page. Plain data: a test plays actions, with no browser.

use super::command::link::Link;
use super::room::edit::Look;
use super::room::moved::Meant;
use super::room::point::{Key, Point};
use super::room::state::{Mode, Tool};
use super::share::state::Link as Address;
use super::teach::unlike::Unlike;
use super::watch::state::{Layer, Speed};
use super::why::help::Help;
use crate::domain::{Blueprint, Color, State as World};
use crate::ui::page::preferences::Depth;
use crate::worker::protocol::WorldRules;

/// Something that a person did.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// The page may do something by itself.
    Demo,
    /// A person has touched the page.
    Touched,
    /// The command box changed.
    Typed(String),
    /// A command was sent: what stands in the box.
    Ask,
    /// An example command was chosen: fill the box and send it.
    AskExample(String),
    /// Bring the command said before into the box, or the one after it.
    Recall(bool),
    /// Go on from after something that was said, by its place.
    GoOn(usize),
    /// Another reading was chosen.
    Choose(usize),
    /// What the person answered to the question is kept as a lesson.
    Remember,
    /// Words are pointed at, or no longer.
    Link(Option<Link>),
    /// The goal cells of a reading are to be seen, or no longer.
    Preview(Option<usize>),
    /// All readings are to be seen.
    AllReadings,
    /// More, or less, of what is behind the answer is to be seen.
    Deepen(Depth),
    /// A constituent of the derivation was chosen.
    ChooseNode(usize),
    /// Another step of its reduction is shown.
    Reduce(usize),
    /// The rules of the world changed.
    SetRules(WorldRules),
    /// A message's help was taken up.
    Help(Help),
    /// The model that comes with the page is wanted once more.
    FetchModel,
    /// Copy a text.
    Copy(String),

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
    /// What something is to mean that was taken elsewhere.
    Mean(Meant),
    /// A key in the room.
    Press(Key),
    /// Another world was chosen, by its place in [`crate::ui::page::world::WORLDS`].
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
    /// A world has been read from JSON, or why that is none.
    WorldRead(Result<World, String>),

    /// The words of a lesson changed.
    TypedLesson(String),
    /// Teach what is shown.
    Teach,
    /// Teach one of the readings that fit what was shown.
    TeachFit(usize),
    /// Begin the demonstration anew.
    ClearDraft,
    /// A way is not what is meant.
    Unlike(Unlike),
    /// Forget a lesson.
    Unteach(usize),
    /// Save all lessons as a corpus.
    SaveLessons,

    /// Make a link of all this.
    Share,
    /// The link is there and was copied (or could not be), or there is none; the text says why.
    Shared(Result<Address, String>),
    /// Save all this as a file.
    SaveSession,
    /// A file could not be made; the text says why.
    Unsaved(String),
    /// A link or a file was opened that holds this, or something unreadable.
    Open(Result<Vec<u8>, String>),
    /// The message about sharing was read.
    CloseShare,
}
