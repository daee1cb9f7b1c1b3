//! What an engine says to the page.

use super::learning::{
    Demonstrated, ExperimentProgress, Judgement, Progress, Shown, TeachReport, TrainReport,
};
use super::planning::{Answer, PlanProgress, PlanText, Runs, ValueMap};
use super::reading::Study;
use super::request::Wanted;
use super::sheet::{Checkpoint, Joined, RowReading, SheetReport};
use super::study::StudySaid;
use crate::corpus::Preview;
use crate::domain::State;
use crate::learn::asking::Answered;
use crate::learn::audit::Errors;
use crate::learn::inspect::{Difference, EntryWindow};
use crate::learn::look::Look;
use crate::learn::sheet::{Care, Facets, Window};
use serde::{Deserialize, Serialize};

/// What an engine says to the page; first what the page itself reads (`talk`).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Event {
    /// The engine is up.
    Ready,
    /// The engine still answers.
    Pong,
    /// The engine has met an error in the program and can do nothing more.
    Crashed {
        /// The panic's message and place.
        message: String,
    },
    /// The request failed; what was loaded before is as it was.
    Refused {
        /// What is wrong, where, and what to do: for a person.
        message: String,
    },
    /// The request was cancelled; what was loaded before is as it was.
    Cancelled,
    /// There is a model that was opened.
    Opened(TrainReport),
    /// There is a general resource for words that the lexicon does not know.
    Words,
    /// The model was taught.
    Taught(Box<TeachReport>),
    /// A command was answered.
    Answer(Box<Answer>),
    /// A planner is at work: how far it is.
    Planning(PlanProgress),
    /// There is a plan, or a reason for none.
    Planned(Box<PlanText>),
    /// What the cells are worth.
    Values(ValueMap),
    /// A run has ended; what came of all so far.
    RollingOut(Runs),
    /// All runs have ended.
    RolledOut(Runs),
    /// The readings that an answer shows, in its order.
    Explained(Vec<Study>),
    /// A command to try, if there is one of that kind.
    Example {
        /// The kind.
        wanted: Wanted,
        /// The command.
        command: Option<String>,
    },
    /// A world.
    World(State),
    /// A world as text.
    WorldText {
        /// It is read back by [`Request::ReadWorld`](super::Request::ReadWorld).
        text: String,
    },
    /// A corpus is being read.
    Reading {
        /// Bytes that are read.
        done: u64,
        /// Bytes in all.
        of: u64,
    },
    /// One row's states.
    Row {
        /// Index into the sheet.
        row: usize,
        /// Its demonstrations.
        pairs: Vec<Shown>,
    },
    /// Training has seen one more example.
    Progress(Progress),
    /// There is a model that was learned.
    Trained(TrainReport),
    /// An experiment has gone on by one example.
    Experimenting(ExperimentProgress),
    /// The demonstration is over.
    Demonstrated(Box<Demonstrated>),
    /// The beginning of a file.
    Previewed(Box<Preview>),
    /// Files were read.
    Sheet(Box<SheetReport>),
    /// Some lines of a view.
    Window(Box<Window>),
    /// What there is to filter by.
    Facets(Box<Facets>),
    /// What a model makes of a row.
    RowReading(Box<RowReading>),
    /// How the sheet stands.
    Care(Care),
    /// What was decided of all rows.
    Decisions {
        /// A file of JSON, for the same rows.
        text: String,
    },
    /// Rows are judged.
    Auditing {
        /// Rows that are.
        done: u32,
        /// Rows in all.
        of: u32,
    },
    /// What a model makes of a part of the commands.
    Answered {
        /// The commands of the part.
        commands: Vec<Answered>,
    },
    /// Where a model errs.
    Errors(Box<Errors>),
    /// A file to save.
    Saved {
        /// Its name.
        name: String,
        /// Its bytes.
        #[serde(with = "super::learning::bytes")]
        bytes: Vec<u8>,
    },
    /// The model of a run was judged on what is held out.
    HeldOut {
        /// The epoch that has ended; one past the last for the model that the run ends with.
        epoch: u32,
        /// How it was judged.
        judgement: Box<Judgement>,
    },
    /// What was learned last, if anything was.
    Look(Option<Box<Look>>),
    /// Some entries of a lexicon.
    Entries(Box<EntryWindow>),
    /// What tells two models apart.
    Difference(Box<Difference>),
    /// The plan of some runs.
    Plan {
        /// A file of JSON that repeats them.
        text: String,
    },
    /// What some of a plan's runs found.
    Shard {
        /// A file of JSON.
        text: String,
    },
    /// What all of a plan's runs found.
    Joined(Box<Joined>),
    /// A run that can go on from here.
    Checkpoint(Checkpoint),
    /// A request that needs no other answer was heard.
    Heard,
    /// What this request began rests.
    Paused,
    /// Something was done about a study, or is being done.
    Study(StudySaid),
}
