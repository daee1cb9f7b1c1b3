//! Looking at a sheet: which rows, in which order, a window of them at a time; and what there is to filter by.

use super::care::Rule;
use super::row::{Half, Line, Outcome, Status};
use serde::{Deserialize, Serialize};

/// The most lines of a window.
pub const MOST_LINES: u32 = 1_000;

/// The most values of a facet.
pub const MOST_VALUES: usize = 1_000;

/// Which rows, and in which order. What is `None` leaves none out.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct View {
    /// Parts of words that the command, or its name, has all of.
    pub text: String,
    /// The label of the task; empty for rows without one.
    pub task: Option<String>,
    /// Who said it; empty for rows that do not tell.
    pub worker: Option<String>,
    /// What was decided.
    pub status: Option<Status>,
    /// What the model makes of them.
    pub outcome: Option<Outcome>,
    /// A rule that marks them.
    pub rule: Option<Rule>,
    /// Which half they are in.
    pub half: Option<Half>,
    /// The number of their file.
    pub file: Option<u32>,
    /// By what they are sorted; rows that are alike in it stay in their order.
    pub sort: Sort,
    /// Whether the last comes first.
    pub descending: bool,
}

/// By what rows are sorted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "the names say it")]
pub enum Sort {
    /// The order of the files.
    #[default]
    Row,
    Command,
    Task,
    Worker,
    Status,
    Outcome,
    Pairs,
    /// The length of the command.
    Length,
}

/// Some of the rows that a view has.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Window {
    /// Rows that the view has in all.
    pub total: u32,
    /// The place of the first line among them.
    pub offset: u32,
    /// The lines.
    pub lines: Vec<Line>,
}

/// Values and how many rows have each, the most frequent first.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Facet {
    /// The values; the empty text for rows without one.
    pub values: Vec<(String, u32)>,
    /// Values that are not listed, since there are too many.
    pub more: u32,
}

/// What there is to filter by.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Facets {
    /// Labels of tasks.
    pub tasks: Facet,
    /// Who said it.
    pub workers: Facet,
    /// What was decided, and of how many rows.
    pub statuses: Vec<(Status, u32)>,
    /// What the model makes of them; rows that it was not asked are in none.
    pub outcomes: Vec<(Outcome, u32)>,
    /// Rules, and how many rows each marks.
    pub rules: Vec<(Rule, u32)>,
    /// The halves.
    pub halves: Vec<(Half, u32)>,
    /// Rows of each file.
    pub files: Vec<u32>,
}
