//! What page and engine say to each other. Every message is one JSON text in an [`Envelope`] that carries
//! the protocol's version; no id of an arena crosses (invariant 6), only text and plain data. A body is its
//! kind's name, or `{kind: content}`: a tag inside the content would cost both programs a tenth of their size.

use crate::ccg::{EntryText, Explanation};
use crate::domain::State;
use crate::learn::PlannerCost;
use crate::learn::experiment::By;
use serde::{Deserialize, Serialize};

/// The protocol's version; both sides refuse any other.
pub const VERSION: u32 = 3;

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
        /// What is known beforehand.
        lexicon: SeedLexicon,
        /// What differs from the paper's settings.
        settings: TrainSettings,
    },
    /// Teaches the model a few examples besides, of which each has a demonstration → [`Event::Taught`].
    Teach {
        /// The examples, at most [`MOST_TAUGHT`].
        examples: Vec<Lesson>,
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
    /// Says what the scores of a command's readings are made of → [`Event::Explained`].
    Explain {
        /// The command as typed.
        command: String,
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

/// The most examples that a model is taught at once.
pub const MOST_TAUGHT: usize = 100;

/// What is known before training.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SeedLexicon {
    /// A few colours and function words: nouns and verbs are learned, as in the paper's Section VII.
    Demonstration,
    /// The English of the whole domain.
    Domain,
}

/// A new example: what is said, and what is then done.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Lesson {
    /// The command.
    pub command: String,
    /// Its demonstrations.
    pub pairs: Vec<PairText>,
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

/// An experiment on the corpus that is kept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Experiment {
    /// The rows of the paper's Table II for one set: learning from 3, 2 and 1 demonstrations a command.
    Table2 {
        /// What the set is called; the paper's are `raw` and `pruned`.
        set: String,
        /// What is judged on.
        test: CorpusText,
    },
    /// The paper's Table III: learning without a planner and with one of horizon 1, 10 and 20.
    Table3 {
        /// What is judged on.
        test: CorpusText,
        /// States that a run's planner may expand.
        budget: u64,
    },
    /// Section VII: learns, then answers a command that was never heard.
    Demonstration {
        /// The command.
        command: String,
        /// The state of the world it is said in.
        state: State,
    },
    /// Cross-validation.
    Cross {
        /// Parts of the corpus.
        folds: u32,
        /// What stays together.
        by: By,
    },
}

/// A corpus file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct CorpusText {
    /// Its name; the ending chooses the form.
    pub name: String,
    /// Its text.
    pub text: String,
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
    /// The model was taught.
    Taught(Box<TeachReport>),
    /// A command was answered.
    Answer(Box<Answer>),
    /// The readings that an answer shows, in its order.
    Explained(Vec<Explanation>),
    /// An experiment has gone on by one example.
    Experimenting(ExperimentProgress),
    /// An experiment is over.
    Experimented(Box<ExperimentReport>),
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

/// What came of teaching.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct TeachReport {
    /// The model that was taught.
    pub model: TrainReport,
    /// The entries that were added.
    pub added: Vec<EntryText>,
    /// For each example whether it is now answered as its demonstrations show.
    pub understood: Vec<bool>,
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

/// How far an experiment is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ExperimentProgress {
    /// The run at work, from 0.
    pub run: usize,
    /// Runs in all.
    pub runs: usize,
    /// What the run is called.
    pub name: String,
    /// What it is doing.
    pub part: RunPart,
}

/// What a run is doing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RunPart {
    /// It learns.
    Learning(Progress),
    /// It is judged.
    Judging {
        /// Commands judged.
        judged: usize,
        /// Commands in all.
        commands: usize,
    },
}

/// What an experiment found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ExperimentReport {
    /// A row a run, in order.
    pub runs: Vec<RunReport>,
    /// All runs together, where their test halves part one corpus.
    pub all: Option<Judgement>,
    /// What the command that was never heard was answered.
    pub answer: Option<Answer>,
    /// What is wrong or odd with the test file.
    pub problems: Vec<Problem>,
}

/// What a run found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RunReport {
    /// What the run is called.
    pub name: String,
    /// Commands learned from.
    pub examples: usize,
    /// Those with a valid parse in the last epoch.
    pub valid: usize,
    /// Lexical entries.
    pub entries: usize,
    /// The F1 that the paper reports for this, where it does.
    pub paper_f1: Option<f64>,
    /// What planning cost, in a run that plans.
    pub planner: Option<PlannerCost>,
    /// How it was judged.
    pub judgement: Judgement,
}

/// How commands were answered.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Judgement {
    /// Commands.
    pub total: usize,
    /// Without skipping words.
    pub plain: Figures,
    /// With the parse that skips words counted.
    pub skipping: Figures,
    /// F1 with skipping, and with ties broken by which form refers.
    pub resolved_f1: f64,
    /// By task, with skipping.
    pub tasks: Vec<TaskFigures>,
    /// What wrong answers did instead.
    pub confusion: Vec<Confused>,
}

/// Counts, and precision, recall and F1, each with the ends of its 95 % interval.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the names say it")]
pub struct Figures {
    pub answered: usize,
    pub correct: usize,
    pub precision: [f64; 3],
    pub recall: [f64; 3],
    pub f1: [f64; 3],
}

/// The figures of one task; without a name those of commands without a label.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the names say it")]
pub struct TaskFigures {
    pub task: Option<String>,
    pub total: usize,
    pub answered: usize,
    pub correct: usize,
}

/// How many wrong answers to commands of a task did another; without a name, none.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the names say it")]
pub struct Confused {
    pub task: Option<String>,
    pub does: Option<String>,
    pub count: usize,
}
