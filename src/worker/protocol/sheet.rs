//! What is said of a corpus that is worked on: files and their columns, rows and windows of them, what was decided, what
//! a model makes of them, and training on them.

use super::learning::{CorpusFile, Judgement, RunReport, Shown};
use super::reading::{Reading, Word};
use crate::corpus::Mapping;
use crate::learn::sheet::Care;
use serde::{Deserialize, Serialize};

/// A corpus file with what its columns say.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct MappedFile {
    /// The file.
    pub file: CorpusFile,
    /// Which column says what; the default where their names tell.
    pub mapping: Mapping,
}

/// What came of reading files.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct SheetReport {
    /// The files, in order.
    pub files: Vec<FileReport>,
    /// Bad rows and oddities.
    pub faults: Vec<Fault>,
    /// How the sheet stands; that from before, if no row can be used.
    pub care: Care,
    /// The fingerprint of all its rows, as a model trained on all of them tells it.
    pub corpus: String,
}

/// What came of reading one file.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct FileReport {
    /// Its name.
    pub name: String,
    /// Its good rows, rejected ones among them.
    pub rows: u32,
    /// Rows left out because something is wrong with them.
    pub left_out: u32,
    /// Those of them that can be saved to be mended.
    pub bad_rows: u32,
    /// Which column said what, where a person said so.
    pub mapping: Mapping,
    /// Why no row of it can be used.
    pub useless: Option<String>,
}

/// Something wrong (or odd) in a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fault {
    /// The number of the file.
    pub file: u32,
    /// The line where the row begins, from 1; 0 for the file as a whole.
    pub line: u64,
    /// The column's name, where one is to blame.
    pub column: Option<String>,
    /// What is wrong.
    pub what: String,
    /// What stands there, cut.
    pub snippet: Option<String>,
    /// What to do.
    pub mend: Option<String>,
    /// Whether the row was kept all the same.
    pub kept: bool,
}

/// The form of a file that is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Form {
    /// A table of batch results.
    Csv,
    /// An object a line.
    JsonLines,
}

/// How a corpus is parted.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Split {
    /// All of it is learned from.
    None,
    /// A share of it is held out, by chance.
    Share {
        /// Rows that stay together.
        by: crate::learn::experiment::By,
        /// The share, of a hundred.
        percent: u32,
        /// The seed of the chance.
        seed: u32,
    },
    /// What has these labels, or was said by these people, is held out.
    Named {
        /// Whether they are people, and not labels of tasks.
        workers: bool,
        /// Their names.
        names: Vec<String>,
    },
}

/// A row with all that a model makes of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RowReading {
    /// The row.
    pub row: u32,
    /// Its words as the parser took them.
    pub words: Vec<Word>,
    /// The distinct readings, best first, each with whether it does what each demonstration shows, in the state before
    /// the first one.
    pub readings: Vec<(Reading, Vec<bool>)>,
    /// Readings in all.
    pub n_readings: usize,
    /// Why there is no single answer, in the command line's words.
    pub reason: Option<String>,
    /// How likely the best reading is what was meant.
    pub probability: Option<f64>,
    /// The demonstrations.
    pub pairs: Vec<Shown>,
}

/// What the runs of a plan found, joined.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Joined {
    /// A row a run, in the plan's order.
    pub runs: Vec<RunReport>,
    /// All runs together, where they judge one corpus between them.
    pub all: Option<Judgement>,
    /// The results as a table for other programs.
    pub csv: String,
    /// The results as a report to be read.
    pub markdown: String,
    /// The results as a file, which a shard with all runs would have handed back.
    pub results: String,
}

/// A run that can go on from here.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Checkpoint {
    /// The checkpoint's text.
    pub text: String,
    /// The epoch at work, from 1.
    pub epoch: u32,
    /// Examples seen in it.
    pub example: usize,
}
