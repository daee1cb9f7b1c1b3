//! A row of whatever form on its way to an example: what it says is there as text, and its demonstrations are read one
//! a step, since their states are most of a corpus.

use super::admit;
use super::cell::{self, Moment};
use super::cells::Cells;
use super::example::{Decision, Example, Pair, Row};
use super::flaw::{Flaw, Wrong};
use super::run;

/// What a form's reader comes to in a step.
pub(super) enum Found {
    Nothing,
    Row(Box<Row>),
    Draft(Box<Draft>),
    Over,
}

/// The text of a state, and what its place is called.
#[derive(Debug)]
pub(super) struct Place {
    pub(super) column: String,
    pub(super) text: String,
}

/// The text of a demonstration.
#[derive(Debug)]
pub(super) enum Shown {
    /// The states before and after.
    Pair(Place, Place),
    /// A start, the actions from there, and contrasts.
    Run(Place),
}

/// A row that is being read.
#[derive(Debug)]
pub(super) struct Draft {
    line: u64,
    /// The row as it stands in the file.
    pub(super) raw: Vec<u8>,
    command: Option<String>,
    flaws: Vec<Flaw>,
    /// Whether nothing was wrong so far.
    good: bool,
    /// The name of the row, its task and who said it, as far as the file has them.
    pub(super) id: Option<String>,
    pub(super) task: Option<String>,
    pub(super) worker: Option<String>,
    pub(super) decision: Decision,
    pub(super) rest: Cells,
    pub(super) keys: Cells,
    pairs: Vec<Pair>,
    shown: std::vec::IntoIter<Shown>,
}

impl Draft {
    /// A row that begins at a line and stands there so, of which nothing is known.
    pub(super) fn new(line: u64, raw: Vec<u8>) -> Draft {
        Draft {
            line,
            raw,
            command: None,
            flaws: Vec::new(),
            good: true,
            id: None,
            task: None,
            worker: None,
            decision: Decision::Open,
            rest: Cells::default(),
            keys: Cells::default(),
            pairs: Vec::new(),
            shown: Vec::new().into_iter(),
        }
    }

    /// Something is wrong with the row: it will be left out.
    pub(super) fn blame(&mut self, column: Option<&str>, wrong: impl Into<Wrong>) {
        self.good = false;
        self.flaws.push(Flaw::of_row(self.line, column, wrong));
    }

    /// Something is odd in the row, which is no reason to leave it out.
    pub(super) fn wonder(&mut self, column: Option<&str>, wrong: impl Into<Wrong>) {
        self.flaws.push(Flaw::of_row(self.line, column, wrong));
    }

    /// What was said, or what keeps it from being a command, in this column.
    pub(super) fn say(&mut self, column: &str, command: Result<String, Wrong>) {
        match command.and_then(|command| admit::command(Some(&command))) {
            Ok(command) => self.command = Some(command),
            Err(wrong) => self.blame(Some(column), wrong),
        }
    }

    /// Its demonstrations.
    pub(super) fn show(&mut self, shown: Vec<Shown>) {
        self.shown = shown.into_iter();
    }

    /// Reads one demonstration; what came of the row, when it was the last one.
    pub(super) fn step(&mut self) -> Option<Row> {
        let (line, flaws) = (self.line, &mut self.flaws);
        let pair = match self.shown.next() {
            None => return Some(self.end()),
            Some(Shown::Pair(pre, post)) => {
                cell::demonstration(&pre.text, &post.text, |moment, wrong| {
                    let place = if moment == Moment::Before { &pre } else { &post };
                    flaws.push(Flaw::of_row(line, Some(&place.column), wrong));
                })
            }
            Some(Shown::Run(Place { column, text })) => {
                let run = run::read(&text);
                run.map_err(|wrong| flaws.push(Flaw::of_row(line, Some(&column), wrong))).ok()
            }
        };
        self.good &= pair.is_some();
        self.pairs.extend(pair);
        None
    }

    fn end(&mut self) -> Row {
        let command = self.command.take().filter(|_| self.good);
        let mut flaws = std::mem::take(&mut self.flaws);
        flaws.iter_mut().for_each(|flaw| flaw.kept = command.is_some());
        let something =
            |text: Option<String>| text.as_deref().and_then(admit::something).map(str::to_owned);
        let mut pairs = std::mem::take(&mut self.pairs);
        pairs.shrink_to_fit();
        let example = command.map(|command| Example {
            id: something(self.id.take()).unwrap_or_else(|| format!("line {}", self.line)),
            line: self.line,
            command,
            task: something(self.task.take()),
            worker: something(self.worker.take()),
            decision: std::mem::take(&mut self.decision),
            pairs,
            rest: std::mem::take(&mut self.rest),
            keys: std::mem::take(&mut self.keys),
        });
        let raw = if example.is_none() { std::mem::take(&mut self.raw) } else { Vec::new() };
        Row { example, rejected: false, flaws, raw }
    }
}
