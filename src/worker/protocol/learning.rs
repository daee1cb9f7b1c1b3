//! What is said of corpora, models, training, teaching and experiments.

use super::planning::Answer;
use crate::ccg::EntryText;
use crate::domain::State;
use crate::learn::PlannerCost;
use crate::learn::experiment::By;
use serde::{Deserialize, Serialize};

/// The most examples that a model is taught at once.
pub const MOST_TAUGHT: usize = 100;

/// A new example: what is said, and what is then done.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(expecting = "a lesson: {command, pairs}")]
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
        test: CorpusFile,
    },
    /// The paper's Table III: learning without a planner and with one of horizon 1, 10 and 20.
    Table3 {
        /// What is judged on.
        test: CorpusFile,
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
pub struct CorpusFile {
    /// Its name, for messages.
    pub name: String,
    /// Its bytes, which say what it is.
    #[serde(with = "bytes")]
    pub bytes: Vec<u8>,
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

    pub(in crate::worker::protocol) fn deserialize<'de, D: Deserializer<'de>>(
        from: D,
    ) -> Result<Vec<u8>, D::Error> {
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
        from.deserialize_bytes(Bytes)
    }
}

/// What came of reading a corpus.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct CorpusReport {
    /// The file's name, or the names of all files.
    pub name: String,
    /// The good rows, in the files' order.
    pub rows: Vec<RowSummary>,
    /// Rows left out because they were rejected.
    pub rejected: usize,
    /// Rows left out because something is wrong with them.
    pub left_out: usize,
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
#[serde(expecting = "a pair of states: {pre, post}")]
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
