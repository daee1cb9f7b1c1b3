//! What there is to say of one row, beside its command and states.

use super::care::Rule;
use crate::corpus::{BadRows, Decision, Mapping};
use serde::{Deserialize, Serialize};

/// A file that rows came from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Source {
    /// Its name.
    pub name: String,
    /// All columns of a table, in their order.
    pub columns: Vec<String>,
    /// Which of them says what.
    pub mapping: Mapping,
    /// The rows that something is wrong with, as they stand there.
    pub bad: BadRows,
    /// Whether it is JSON.
    pub is_json: bool,
    /// The number of its good rows, which follow those of the file before.
    pub rows: usize,
    /// Rows left out because something is wrong with them.
    pub left_out: usize,
}

/// Which part of a corpus a row is in.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
#[serde(rename_all = "snake_case")]
pub enum Half {
    /// It is learned from.
    #[default]
    Train,
    /// A model is judged on it.
    HeldOut,
    /// Neither.
    Aside,
}

/// What was decided of a row, without the reason.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[expect(missing_docs, reason = "as of `Decision`")]
pub enum Status {
    Open,
    Approved,
    Rejected,
}

impl Status {
    /// That of a decision.
    pub const fn of(decision: &Decision) -> Status {
        match decision {
            Decision::Open => Status::Open,
            Decision::Approved => Status::Approved,
            Decision::Rejected(_) => Status::Rejected,
        }
    }
}

/// What a model makes of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// The answer does what was shown.
    Right,
    /// Several forms are tied for best, and one of them does.
    Tied,
    /// A reading does that scores less than the best.
    Lower,
    /// There are readings, and none of them does.
    Invalid,
    /// There is no reading.
    Unread,
}

/// A row as a line of a table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Its number, from 0, by which it is asked for.
    pub row: u32,
    /// The number of its file.
    pub file: u32,
    /// The line of the file where it begins, from 1.
    pub line: u64,
    /// Its name.
    pub id: String,
    /// What was said.
    pub command: String,
    /// The label of its task.
    pub task: Option<String>,
    /// Who said it.
    pub worker: Option<String>,
    /// The number of its demonstrations.
    pub pairs: u32,
    /// What was decided of it.
    pub decision: Decision,
    /// Which half it is in.
    pub half: Half,
    /// What a model makes of it, once one was asked.
    pub outcome: Option<Outcome>,
    /// The best form that the model gives, if any.
    pub form: Option<String>,
    /// The rules that mark it, each with the reason.
    pub marks: Vec<(Rule, String)>,
}
