//! The messages themselves: requests of the page, events of the engine, and the envelope around both.

use super::learning::{
    CorpusFile, CorpusReport, Experiment, ExperimentProgress, Lesson, PairText, Progress,
    SeedLexicon, TeachReport, TrainReport, TrainSettings,
};
use super::planning::{Answer, PlanProgress, PlanText, Runs, ValueMap, WorldRules};
use super::reading::Study;
use crate::domain::{Blueprint, State};
use serde::{Deserialize, Serialize};

/// The protocol's version; both sides refuse any other.
pub const VERSION: u32 = 8;

/// One message: a request and every event that answers it carry the same `id`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Envelope<T> {
    /// The protocol's version, [`VERSION`]; the first field, by which readers know what follows.
    pub groundling: u32,
    /// Which request this is, or answers; chosen by the page, 0 for what nobody asked for.
    pub id: u32,
    /// The message itself.
    pub body: T,
}

/// The page's programs, each an engine in a worker of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Program {
    /// It answers, plans and says what it found; the page always has it.
    Talker,
    /// It reads corpora, trains, teaches and runs experiments; loaded when there is something to learn.
    Learner,
}

impl Program {
    /// Its name, which is what the page's worker script is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Program::Talker => "talker",
            Program::Learner => "learner",
        }
    }
}

/// A kind of command to try.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Wanted {
    /// This one, if it can be done, or if it is certain that it cannot.
    Said(String),
    /// To go somewhere.
    Go,
    /// To bring something somewhere.
    Bring,
    /// Something that is told by what it is like.
    Describe,
    /// To be, or to bring something, next to something.
    Beside,
    /// With a word that is not known: what there is to teach.
    Unknown,
}

/// What the page asks of an engine. A request other than `Cancel` and `Ping` replaces the one at work.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Request {
    /// Reads corpus files and keeps them as one corpus, if each has a good row → [`Event::Reading`] now and then, then
    /// [`Event::Corpus`].
    ReadCorpus {
        /// The files.
        files: Vec<CorpusFile>,
        /// Keep rows that were rejected.
        with_rejected: bool,
    },
    /// The states of one row of the corpus that is kept → [`Event::Row`].
    ShowRow {
        /// Index into [`CorpusReport::rows`].
        row: usize,
    },
    /// Trains on the corpus that is kept → [`Event::Progress`] after every example, then [`Event::Trained`].
    Train {
        /// What is known beforehand.
        lexicon: SeedLexicon,
        /// What differs from the paper's settings.
        settings: TrainSettings,
    },
    /// Teaches a model a few examples besides, of which each has a demonstration → [`Event::Taught`]. Nothing is kept.
    Teach {
        /// The model file's text.
        model: String,
        /// The examples, at most [`MOST_TAUGHT`](super::MOST_TAUGHT).
        examples: Vec<Lesson>,
    },
    /// Opens a model file → [`Event::Opened`].
    OpenModel {
        /// The model file's text.
        text: String,
    },
    /// Understands words that no lexicon knows by a general resource, with whatever model is open, now and later →
    /// [`Event::Words`].
    Words {
        /// The resource's text.
        text: String,
    },
    /// Parses and grounds a command that is being typed, and plans nothing → [`Event::Answer`]. The policy that is
    /// kept stays.
    Read {
        /// The command as typed.
        command: String,
        /// The state of the world it would be said in.
        state: State,
    },
    /// Parses, grounds and plans a command → [`Event::Planning`] now and then, then [`Event::Answer`]. The policy is
    /// kept. Where something was left out, or where it is better to ask first, nothing is planned.
    Ask {
        /// The command as typed.
        command: String,
        /// The state of the world it is said in.
        state: State,
        /// What can happen in that world.
        rules: WorldRules,
    },
    /// Plans for a goal, such as another reading's → [`Event::Planning`] now and then, then [`Event::Planned`]. The
    /// policy is kept.
    Plan {
        /// The goal as an s-expression.
        form: String,
        /// The state of the world.
        state: State,
        /// What can happen in that world.
        rules: WorldRules,
    },
    /// What each cell is worth to the robot under the policy that is kept, with all else as it is in a state →
    /// [`Event::Values`].
    Values {
        /// A state of the world that the policy is for.
        state: State,
    },
    /// Follows the policy that is kept many times → [`Event::RollingOut`] after each, then [`Event::RolledOut`].
    RollOut {
        /// How often, at most [`MOST_RUNS`](super::MOST_RUNS).
        runs: u32,
        /// The seed of what happens.
        seed: u32,
    },
    /// Takes the readings of a command apart, for those who study them → [`Event::Explained`].
    Explain {
        /// The command as typed.
        command: String,
    },
    /// Looks for a command to try in a world → [`Event::Example`]. The policy that is kept stays.
    Example {
        /// Of which kind.
        wanted: Wanted,
        /// The state of the world.
        state: State,
        /// What can happen in it.
        rules: WorldRules,
    },
    /// Draws a world by chance → [`Event::World`].
    Draw {
        /// What is wanted.
        blueprint: Blueprint,
        /// The seed of the rest.
        seed: u32,
    },
    /// Reads a world that is drawn in characters, or its JSON → [`Event::World`].
    ReadWorld {
        /// The text.
        text: String,
    },
    /// Draws a world in characters → [`Event::WorldText`].
    WriteWorld {
        /// The world.
        state: State,
    },
    /// Runs an experiment on the corpus that is kept → [`Event::Experimenting`] after every example, then
    /// [`Event::Experimented`]. Corpus and model stay as they are.
    Experiment {
        /// Which.
        experiment: Experiment,
        /// What differs from the paper's settings in every run.
        settings: TrainSettings,
    },
    /// Stops what is at work → [`Event::Cancelled`] for that request's id.
    Cancel,
    /// Asks whether the engine still answers → [`Event::Pong`]; replaces nothing.
    Ping,
}

impl Request {
    /// The program that it is for; nothing where any will do.
    pub fn program(&self) -> Option<Program> {
        match self {
            Request::ReadCorpus { .. }
            | Request::ShowRow { .. }
            | Request::Train { .. }
            | Request::Teach { .. }
            | Request::Experiment { .. } => Some(Program::Learner),
            Request::OpenModel { .. }
            | Request::Words { .. }
            | Request::Read { .. }
            | Request::Ask { .. }
            | Request::Plan { .. }
            | Request::Values { .. }
            | Request::RollOut { .. }
            | Request::Explain { .. }
            | Request::Example { .. }
            | Request::Draw { .. }
            | Request::ReadWorld { .. }
            | Request::WriteWorld { .. } => Some(Program::Talker),
            Request::Cancel | Request::Ping => None,
        }
    }
}

/// What an engine says to the page.
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
    /// A corpus is being read.
    Reading {
        /// Bytes that are read.
        done: u64,
        /// Bytes in all.
        of: u64,
    },
    /// A corpus was read.
    Corpus(CorpusReport),
    /// One row's states.
    Row {
        /// Index into [`CorpusReport::rows`].
        row: usize,
        /// Its demonstrations.
        pairs: Vec<PairText>,
    },
    /// Training has seen one more example.
    Progress(Progress),
    /// There is a model that was learned.
    Trained(TrainReport),
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
        /// It is read back by [`Request::ReadWorld`].
        text: String,
    },
    /// An experiment has gone on by one example.
    Experimenting(ExperimentProgress),
    /// An experiment is over.
    Experimented {
        /// An [`ExperimentReport`](super::ExperimentReport) as JSON: a page that only keeps it need not take it apart.
        report: String,
    },
    /// The request failed; what was loaded before is as it was.
    Refused {
        /// What is wrong, where, and what to do: for a person.
        message: String,
    },
    /// The request was cancelled; what was loaded before is as it was.
    Cancelled,
}
