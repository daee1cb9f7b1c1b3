//! What is said of corpora, models, training, teaching and experiments.

use super::planning::Answer;
use crate::ccg::EntryText;
use crate::domain::State;
use crate::ground::{Claim, Noun};
use crate::learn::PlannerCost;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The most examples that a model is taught at once.
pub const MOST_TAUGHT: usize = 100;

/// A new example: what is said, and what is then done.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(expecting = "a lesson: {command, pairs}")]
pub struct Lesson {
    /// The command.
    pub command: String,
    /// Its demonstrations whose way is not known; none where its meaning was said in other words.
    pub pairs: Vec<PairText>,
    /// Its demonstrations that were driven.
    #[serde(default)]
    pub runs: Vec<RunText>,
    /// What the whole command means, where the person said so.
    #[serde(default)]
    pub means: Option<Meaning>,
}

/// What a person says that a command means.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Meaning {
    /// The reading that was chosen: its goal as an s-expression.
    Form(String),
    /// What it is in other words.
    Words(String),
}

/// A corpus file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct CorpusFile {
    /// Its name, for messages.
    pub name: String,
    /// Its bytes, which say what it is: shared, since a file may be large and is asked about more than once.
    #[serde(with = "bytes")]
    pub bytes: Arc<Vec<u8>>,
}

/// Bytes cross as one piece, and not one by one.
pub(super) mod bytes {
    use serde::de::{Deserializer, Error, Visitor};
    use serde::ser::Serializer;
    use std::fmt;

    pub(in crate::worker::protocol) fn serialize<S: Serializer>(
        bytes: &[u8],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.serialize_bytes(bytes)
    }

    pub(in crate::worker::protocol) fn deserialize<'de, D: Deserializer<'de>, T: From<Vec<u8>>>(
        from: D,
    ) -> Result<T, D::Error> {
        struct Bytes;
        impl Visitor<'_> for Bytes {
            type Value = Vec<u8>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("bytes")
            }
            fn visit_bytes<E: Error>(self, bytes: &[u8]) -> Result<Vec<u8>, E> {
                Ok(bytes.to_vec())
            }
        }
        from.deserialize_bytes(Bytes).map(T::from)
    }
}

/// One demonstration: the state before and the state after.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(expecting = "a pair of states: {pre, post}")]
pub struct PairText {
    /// The state before.
    pub pre: State,
    /// The state after.
    pub post: State,
}

/// A demonstration of a row.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shown {
    /// Its first and its last state.
    pub pair: PairText,
    /// The run that it is, where the way is known.
    pub run: Option<RunText>,
}

/// One demonstration that was driven, as corpora have it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(expecting = "a run: {start, actions, contrast}")]
pub struct RunText {
    /// Where it begins.
    pub start: State,
    /// What was done, a letter an action.
    pub actions: String,
    /// Other ways from there, which are not what is meant.
    #[serde(default)]
    pub contrast: Vec<String>,
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TeachReport {
    /// The model that was taught.
    pub model: TrainReport,
    /// The entries that were added.
    pub added: Vec<EntryText>,
    /// What these mean, in plain words.
    pub told: Vec<Told>,
    /// For each example whether it is now answered as its demonstrations show, or as its meaning was said.
    pub understood: Vec<bool>,
    /// What the last example would do now, if it was shown.
    pub check: Option<Check>,
    /// Why the last example cannot mean what was said, if so.
    pub refusal: Option<Refusal>,
    /// Whether the last example was driven, and only where that ends was learned from.
    pub by_end: bool,
}

/// What words mean now.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Told {
    /// The words.
    pub words: String,
    /// Their meaning.
    pub what: What,
}

/// A meaning that was learned.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum What {
    /// None: the words go without.
    Nothing,
    /// The same as this word.
    Like(String),
    /// A thing.
    Thing(Noun),
    /// A goal.
    Goal(Claim),
    /// One that has no plain words.
    Other,
}

/// Whether what a command means now accounts for all that was shown.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// Whether it does.
    pub ends: bool,
    /// If not, readings that would.
    pub fits: Vec<Fit>,
}

/// A reading that accounts for all that was shown.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Fit {
    /// Its goal as an s-expression.
    pub form: String,
    /// What it says, for plain words.
    pub claim: Claim,
}

/// Why words cannot be taught by other words.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Refusal {
    /// This word of theirs is closed: it gets no new meaning.
    Closed(String),
    /// They are understood already.
    Known,
    /// The other words are not understood, or in several ways.
    Lost,
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

/// What came of the paper's demonstration.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Demonstrated {
    /// How the model answers what it has heard.
    pub run: RunReport,
    /// What the command that was never heard was answered.
    pub answer: Answer,
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
