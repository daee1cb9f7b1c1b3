//! What a person can do about experiments.

use super::matrix::Kind;
use super::pool::Said;
use crate::ui::page::files::Offered;

/// Something that a person did.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Choose an experiment.
    Choose(Kind),
    /// So many parts of a cross-validation.
    Folds(u32),
    /// What stays together, by its place in the list of all.
    By(usize),
    /// So many seeds.
    Seeds(u32),
    /// Run it.
    Go,
    /// Run one of the paper's.
    Paper(Kind),
    /// Run the paper's six sentences.
    Six,
    /// An engine of the pool said something.
    Told(u32, Said),
    /// Stop it.
    Stop,
    /// Repeat the runs of a file.
    Repeat(Vec<Offered>),
    /// Save something of a result.
    Save(usize, Saved),
    /// Forget a result.
    Forget(usize),
}

/// What of a result is saved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Saved {
    /// The figures as a table.
    Csv,
    /// A picture of them.
    Svg,
    /// All that was found, as JSON.
    Json,
    /// A report to be read.
    Report,
    /// The file that repeats the runs.
    Plan,
}
