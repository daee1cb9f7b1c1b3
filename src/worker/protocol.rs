//! What page and engine say to each other. Every message is one JSON text in an [`Envelope`] that carries
//! the protocol's version; no id of an arena crosses (invariant 6), only text and plain data. A body is its
//! kind's name, or `{kind: content}`: a tag inside the content would cost both programs a tenth of their size.

use crate::domain::State;
use serde::{Deserialize, Serialize};

/// The protocol's version; both sides refuse any other.
pub const VERSION: u32 = 1;

/// One message: a request and every event that answers it carry the same `id`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Envelope<T> {
    /// The protocol's version, [`VERSION`].
    pub groundling: u32,
    /// Which request this is, or answers; chosen by the page, 0 for what nobody asked for.
    pub id: u32,
    /// The message itself.
    pub body: T,
}

/// What the page asks of the engine. A request other than `Cancel` and `Ping` replaces the one at work.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Request {
    /// Reads a corpus file and keeps it, if it has a good row → [`Event::Corpus`].
    ReadCorpus {
        /// The file's name, for messages; its ending chooses the form (`.jsonl`, otherwise CSV).
        name: String,
        /// The file's text.
        text: String,
    },
    /// The states of one row of the corpus that is kept → [`Event::Row`].
    ShowRow {
        /// Index into [`CorpusReport::rows`].
        row: usize,
    },
    /// Trains on the corpus that is kept → [`Event::Progress`] after every example, then [`Event::Trained`].
    Train {
        /// What differs from the paper's settings.
        settings: TrainSettings,
    },
    /// Opens a model file → [`Event::Trained`].
    OpenModel {
        /// The model file's text.
        text: String,
    },
    /// Parses, grounds and plans a command → [`Event::Answer`].
    Ask {
        /// The command as typed.
        command: String,
        /// The state of the world it is said in.
        state: State,
        /// Whether the robot may pull.
        pull: bool,
    },
    /// Stops what is at work → [`Event::Cancelled`] for that request's id.
    Cancel,
    /// Asks whether the engine still answers → [`Event::Pong`]; replaces nothing.
    Ping,
}

/// The settings of a training run that the page offers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TrainSettings {
    /// Passes over the corpus.
    pub epochs: u32,
    /// Edges kept per span when parsing.
    pub beam: u32,
    /// Edges kept per span when generating lexical entries.
    pub lexical_beam: u32,
    /// Pairs of each row that are looked at, from the first; `None` for all.
    pub demonstrations: Option<u32>,
    /// The seed of the order of examples.
    pub seed: u32,
}

/// What the engine says to the page.
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
    /// There is a model.
    Trained(TrainReport),
    /// A command was answered.
    Answer(Box<Answer>),
    /// The request failed; what was loaded before is as it was.
    Refused {
        /// What is wrong, where, and what to do: for a person.
        message: String,
    },
    /// The request was cancelled; what was loaded before is as it was.
    Cancelled,
}

/// What came of reading a corpus.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct CorpusReport {
    /// The file's name.
    pub name: String,
    /// The good rows, in the file's order.
    pub rows: Vec<RowSummary>,
    /// Rows left out because they were rejected.
    pub rejected: usize,
    /// Bad rows and oddities.
    pub problems: Vec<Problem>,
}

/// One good row of a corpus, without its states.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct RowSummary {
    /// The command.
    pub command: String,
    /// Its task's label, where there is one.
    pub task: Option<String>,
    /// The number of its demonstrations.
    pub pairs: usize,
}

/// Something wrong (or odd) in an outside text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Problem {
    /// The line where the row begins, from 1; 0 for the file as a whole.
    pub line: u64,
    /// The column's name, where one is to blame.
    pub column: Option<String>,
    /// What is wrong and what to mend.
    pub message: String,
    /// Whether the row was kept all the same.
    pub kept: bool,
}

/// One demonstration: the state before and the state after.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct PairText {
    /// The state before.
    pub pre: State,
    /// The state after.
    pub post: State,
}

/// How far training is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Progress {
    /// The epoch at work, from 1.
    pub epoch: u32,
    /// Epochs in all.
    pub epochs: u32,
    /// Examples seen in this epoch.
    pub example: usize,
    /// Examples in an epoch.
    pub examples: usize,
    /// Examples of this epoch with a valid parse.
    pub valid: usize,
    /// Updates of the weights in this epoch.
    pub updates: usize,
    /// Lexical entries now.
    pub entries: usize,
}

/// A model and what there is to say of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct TrainReport {
    /// The model file's text, byte for byte what the command line writes.
    pub model: String,
    /// Commands it was trained on.
    pub examples: usize,
    /// Those with a valid parse in the last epoch.
    pub valid: usize,
    /// Lexical entries.
    pub entries: usize,
}

/// What a command was taken to mean and what came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// The command as typed.
    pub command: String,
    /// Its words as the parser sees them.
    pub words: Vec<String>,
    /// The distinct readings, best first; those tied for best are all there.
    pub readings: Vec<Reading>,
    /// Words the parser had to skip, if the skipping parse answered.
    pub skipped: Vec<String>,
    /// Words of the command that the lexicon has never seen.
    pub unknown: Vec<String>,
    /// Why there is no single reading, in the command line's words (`empty`, `too_long`, `unknown_words`, `no_parse`, `tie`, `budget`).
    pub reason: Option<String>,
    /// The plan for the best reading, or why there is none.
    pub plan: Option<PlanText>,
}

/// One reading of a command.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reading {
    /// The goal as an s-expression.
    pub form: String,
    /// The goal as a person writes logic.
    pub human: String,
    /// Its score.
    pub score: f64,
    /// Its derivation as text.
    pub derivation: String,
    /// Phrases that do not refer in the state given, in words; empty when all do.
    pub failures: Vec<String>,
}

/// A plan as the page plays it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlanText {
    /// The actions, in order: `north south east west pull`.
    pub actions: Vec<String>,
    /// The states, one more than actions.
    pub states: Vec<State>,
    /// States that the planner expanded.
    pub expanded: usize,
    /// Why there is no plan, in the command line's words (`no_referent`, `unreachable`, `budget`).
    pub reason: Option<String>,
}
