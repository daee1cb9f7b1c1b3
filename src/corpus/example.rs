//! What a corpus is made of: examples, each a command and its demonstrations, and what became of a file's rows.

use super::cells::Cells;
use super::flaw::Flaw;
use super::limits::MAX_BAD_BYTES;
use super::mapping::Mapping;
use super::role::Role;
use crate::domain::{State, Way};
use serde::{Deserialize, Serialize};

/// One demonstration: the state before and the state after, and how one came to the other, where it is known.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "before and after")]
pub struct Pair {
    pub pre: State,
    pub post: State,
    /// What makes it a run.
    pub way: Option<Box<Way>>,
}

impl Pair {
    /// A demonstration whose way is not known.
    pub const fn of(pre: State, post: State) -> Pair {
        Pair { pre, post, way: None }
    }
}

/// What was decided of a row.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Decision {
    /// Nothing yet: it is used.
    #[default]
    Open,
    /// It is good.
    Approved,
    /// It is not used, and why; perhaps nobody said why.
    Rejected(Box<str>),
}

/// A command and the demonstrations it was said of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Example {
    /// Who knows it by which name: the assignment's id, or `line N` where a file gives none.
    pub id: String,
    /// The line of the file where it begins, from 1; 0 when it came from no file.
    pub line: u64,
    /// What was said, without the white space around it; it holds a letter or a digit.
    pub command: String,
    /// The label of the task, for evaluation only; learning does not look at it.
    pub task: Option<String>,
    /// Who said it.
    pub worker: Option<String>,
    /// What was decided of it.
    pub decision: Decision,
    /// At least one demonstration.
    pub pairs: Vec<Pair>,
    /// The cells of the columns that groundling has no use for, in the order of the header; written back as
    /// they were. Empty when it came from no CSV file.
    pub rest: Cells,
    /// The keys of a JSON object that groundling has no use for, each with its value behind it, as they were.
    pub keys: Cells,
}

impl Example {
    /// What a JSON object says under a key that groundling has no use for, as it stands there.
    pub fn value(&self, key: &str) -> Option<&str> {
        let at = (0..self.keys.len()).step_by(2).find(|&at| self.keys.get(at) == Some(key))?;
        self.keys.get(at + 1)
    }
}

/// Rows that something is wrong with, as they stand in a file, to be mended.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct BadRows {
    /// Their text, a line or more each, behind the header if they are of a table.
    pub text: Vec<u8>,
    /// The number of them.
    pub kept: usize,
    /// Rows that are not kept, since there are too many.
    pub more: usize,
}

impl BadRows {
    /// Takes in the text of one more.
    fn add(&mut self, raw: &[u8]) {
        if self.text.len() + raw.len() > MAX_BAD_BYTES {
            self.more += 1;
            return;
        }
        self.kept += 1;
        self.text.extend_from_slice(raw);
        if !raw.ends_with(b"\n") {
            self.text.push(b'\n');
        }
    }
}

/// Examples of one origin.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Corpus {
    /// The good rows, in the file's order.
    pub examples: Vec<Example>,
    /// All columns of the CSV file in their order; empty when it came from none.
    pub columns: Vec<String>,
    /// Which of them says what.
    pub mapping: Mapping,
    /// The rows that something is wrong with, as they stand in the file.
    pub bad: BadRows,
    /// Rows left out because they were rejected.
    pub rejected: usize,
    /// Rows left out because something is wrong with them.
    pub left_out: usize,
}

impl Corpus {
    /// All rows that were read: used, rejected and left out.
    pub fn rows(&self) -> usize {
        self.examples.len() + self.rejected + self.left_out
    }

    /// What a row of this corpus says under the name of a column, or of a key.
    pub fn value<'a>(&self, example: &'a Example, name: &str) -> Option<&'a str> {
        match self.mapping.role(name) {
            Role::Task => return example.task.as_deref(),
            Role::Command => return Some(&example.command),
            _ => {}
        }
        let others =
            self.columns.iter().filter(|column| !self.mapping.role(column).is_kept_apart());
        let at = others.into_iter().position(|column| column == name);
        match (at, name) {
            (Some(at), _) => example.rest.get(at),
            (None, "id") => Some(&example.id),
            (None, "command") => Some(&example.command),
            (None, "task") => example.task.as_deref(),
            (None, "worker") => example.worker.as_deref(),
            (None, key) => example.value(key),
        }
    }

    /// Takes in another file's rows.
    pub fn append(&mut self, other: Corpus) {
        self.examples.extend(other.examples);
        self.rejected += other.rejected;
        self.left_out += other.left_out;
        if self.columns.is_empty() {
            (self.columns, self.mapping) = (other.columns, other.mapping);
        }
    }

    /// Why no row of the file that this was read from can be used; nothing when one can.
    pub fn why_empty(&self, flaws: &[Flaw]) -> Option<String> {
        match (self.rows(), self.rejected) {
            _ if !self.examples.is_empty() => None,
            (rows, rejected) if rows > 0 && rows == rejected => Some(match rows {
                1 => "its only row is rejected".to_owned(),
                _ => format!("all its {rows} rows are rejected"),
            }),
            (_, rejected) => {
                let first = flaws.first().map_or("it has no rows".to_owned(), Flaw::to_string);
                let more = if rejected > 0 {
                    format!(" ({rejected} are rejected)")
                } else {
                    String::new()
                };
                Some(first + &more)
            }
        }
    }

    /// Takes in what came of one row, and hands back its flaws.
    pub fn add(&mut self, row: Row) -> Vec<Flaw> {
        self.rejected += usize::from(row.rejected);
        let is_bad = row.example.is_none() && !row.rejected;
        self.left_out += usize::from(is_bad);
        if is_bad {
            self.bad.add(&row.raw);
        }
        self.examples.extend(row.example);
        row.flaws
    }
}

/// What came of one row.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// The example, where the row is good.
    pub example: Option<Example>,
    /// Whether it was left out because it was rejected.
    pub rejected: bool,
    /// What is wrong or odd with it.
    pub flaws: Vec<Flaw>,
    /// A bad row as it stands in the file.
    pub raw: Vec<u8>,
}

impl Row {
    /// A row of which there is only bad to say.
    pub(crate) fn bad(flaw: Flaw, raw: Vec<u8>) -> Box<Row> {
        Box::new(Row { example: None, rejected: false, flaws: vec![flaw], raw })
    }
}
