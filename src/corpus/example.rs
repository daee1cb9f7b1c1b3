//! What a corpus is made of: examples, each a command and its demonstrations, and the flaws found in reading.

use crate::domain::State;
use std::fmt;

/// The largest file that is read, in bytes.
pub const MAX_FILE_BYTES: u64 = 64 << 20;
/// The largest cell (or JSON line's state) that is read, in bytes.
pub const MAX_CELL_BYTES: usize = 1 << 20;
/// The most rows that are read from one file.
pub const MAX_ROWS: usize = 100_000;
/// The longest command that is kept, in characters; how many words a parser takes is the parser's affair.
pub const MAX_COMMAND_CHARS: usize = 2_000;
/// The most demonstrations of one row.
pub const MAX_PAIRS: usize = 100;

/// One demonstration: the state before and the state after.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "before and after")]
pub struct Pair {
    pub pre: State,
    pub post: State,
}

/// A command and the demonstrations it was said of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Example {
    /// Who knows it by which name: the assignment's id, or `line N` where a file gives none.
    pub id: String,
    /// The line of the file where it begins, from 1; 0 when it came from no file.
    pub line: u64,
    /// What was said, without the white space around it; never empty.
    pub command: String,
    /// The label of the task, for evaluation only; learning does not look at it.
    pub task: Option<String>,
    /// Who said it.
    pub worker: Option<String>,
    /// At least one demonstration.
    pub pairs: Vec<Pair>,
    /// The cells of the columns that groundling has no use for, in the order of the header; written back as
    /// they were. Empty when it came from no CSV file.
    pub rest: Vec<String>,
}

/// Examples of one origin.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Corpus {
    /// The good rows, in the file's order.
    pub examples: Vec<Example>,
    /// All columns of the CSV file in their order; empty when it came from none.
    pub columns: Vec<String>,
    /// Rows left out because they were rejected.
    pub rejected: usize,
}

/// Something wrong, or odd, in an outside text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flaw {
    /// The line where the row begins, from 1; 0 for the file as a whole.
    pub line: u64,
    /// The column's name, where one is to blame.
    pub column: Option<String>,
    /// What is wrong and what to mend, in words for a person.
    pub message: String,
    /// Whether the row was kept all the same.
    pub kept: bool,
}

impl Flaw {
    /// A flaw of the file as a whole.
    pub fn of_file(message: impl Into<String>) -> Flaw {
        Flaw { line: 0, column: None, message: message.into(), kept: false }
    }

    /// A flaw of the row that begins at `line`; whether the row is kept is settled later.
    pub(crate) fn of_row(line: u64, column: Option<&str>, message: impl Into<String>) -> Flaw {
        Flaw { line, column: column.map(str::to_owned), message: message.into(), kept: false }
    }
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.line > 0 {
            write!(f, "line {}: ", self.line)?;
        }
        if let Some(column) = &self.column {
            write!(f, "{column}: ")?;
        }
        f.write_str(&self.message)
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
}

impl Row {
    /// A row, or the rest of a file, of which there is only bad to say.
    pub(crate) fn bad(flaw: Flaw) -> Row {
        Row { example: None, rejected: false, flaws: vec![flaw] }
    }
}
