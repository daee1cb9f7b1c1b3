//! A file of answers, read in steps, an answer each: lines of JSON, what an endpoint received (an object with `answers`), or
//! batch results with a column `Answer.answers` or rows that this page wrote.

use super::answer::{Answer, Care, Decided, FORMAT};
use super::showing::Showing;
use crate::corpus::{Decision, Example, Flaw, Options, Reading, Wrong};
use crate::domain::misread::{self, in_words};
use serde::Deserialize;
use serde_json::value::RawValue;
use std::io::Cursor;

/// The column of a form in which all answers of a sitting are posted.
pub const COLUMN: &str = "Answer.answers";

/// A file, being read.
pub struct Gathering {
    /// What is still to be read, the last first.
    work: Vec<Work>,
    bytes: usize,
    /// Its answers so far, with what it says was decided of each.
    pub answers: Vec<Decided>,
    /// What is wrong with it.
    pub flaws: Vec<Flaw>,
    /// How many of its rows or objects are no answer for that.
    pub left_out: usize,
}

enum Work {
    /// Objects of JSON, one after another, from a place on.
    Objects { text: String, at: usize, line: Line },
    /// An object, or a list of them.
    Value { text: String, line: u64 },
    /// The records of a table, with the place of the column.
    Cells(csv::StringRecordsIntoIter<Cursor<Vec<u8>>>, usize),
    /// Rows of a corpus.
    Rows(Box<Reading<Cursor<Vec<u8>>>>),
}

/// Where a text stands.
#[derive(Clone, Copy)]
enum Line {
    /// Its beginning is in this line.
    From(u64),
    /// All of it is a cell of this one.
    All(u64),
}

/// What tells what an object is; what else it has is read when that is known.
#[derive(Default, Deserialize)]
#[serde(default)]
struct Head<'a> {
    #[serde(borrow)]
    format: Option<&'a RawValue>,
    #[serde(borrow)]
    answers: Option<&'a RawValue>,
    #[serde(borrow, rename = "AssignmentStatus")]
    status: Option<&'a RawValue>,
    #[serde(borrow, rename = "Reject")]
    reject: Option<&'a RawValue>,
}

impl Gathering {
    /// The beginning of a file.
    pub fn new(text: &str) -> Gathering {
        let text = text.trim_start_matches('\u{feff}').to_owned();
        let bytes = text.len();
        let (work, flaws) = match text.trim_start().chars().next() {
            Some('{' | '[') => (vec![Work::Objects { text, at: 0, line: Line::From(1) }], vec![]),
            _ => match table(text) {
                Ok(work) => (vec![work], vec![]),
                Err(flaw) => (vec![], vec![flaw]),
            },
        };
        Gathering { work, bytes, answers: Vec::new(), flaws, left_out: 0 }
    }

    /// Bytes that are read, and bytes in all.
    pub fn progress(&self) -> (usize, usize) {
        let done = match self.work.first() {
            Some(Work::Objects { at, .. }) => *at,
            Some(Work::Rows(reading)) => reading.bytes() as usize,
            Some(Work::Cells(records, _)) => records.reader().position().byte() as usize,
            Some(Work::Value { .. }) => 0,
            None => self.bytes,
        };
        (done, self.bytes)
    }

    /// Reads one answer more; whether there was something to read.
    pub fn step(&mut self) -> bool {
        let Some(work) = self.work.pop() else { return false };
        match work {
            Work::Objects { text, at, line } => self.next(text, at, line),
            Work::Value { text, line } => self.value(&text, line),
            Work::Cells(mut records, column) => {
                let record = records.next();
                if record.is_some() {
                    self.work.push(Work::Cells(records, column));
                }
                match record {
                    Some(Ok(record)) => {
                        let line = record.position().map_or(0, csv::Position::line);
                        let text = record.get(column).unwrap_or_default().to_owned();
                        self.work.push(Work::Objects { text, at: 0, line: Line::All(line) });
                    }
                    Some(Err(error)) => {
                        self.refuse(0, format!("the table is damaged: {error}"));
                    }
                    None => {}
                }
            }
            Work::Rows(mut reading) => {
                if reading.step() {
                    self.work.push(Work::Rows(reading));
                } else {
                    let (corpus, flaws) = reading.end();
                    self.flaws.extend(flaws);
                    self.left_out += corpus.left_out;
                    self.answers.extend(corpus.examples.into_iter().map(of_example));
                }
            }
        }
        true
    }

    /// Reads the next object of a text.
    fn next(&mut self, text: String, at: usize, line: Line) {
        let rest = text.get(at..).unwrap_or_default();
        let mut stream = serde_json::Deserializer::from_str(rest).into_iter::<&RawValue>();
        let Some(next) = stream.next() else { return };
        let blank = rest.len() - rest.trim_start().len();
        let told = |within: usize| match line {
            Line::From(first) => {
                let lines = rest.get(..within).unwrap_or_default().matches('\n').count() as u64;
                Line::From(first + lines)
            }
            all @ Line::All(_) => all,
        };
        match next {
            Ok(value) => {
                let (value, end) = (value.get().to_owned(), stream.byte_offset());
                let (Line::From(here) | Line::All(here)) = told(blank);
                let line = told(end);
                self.work.push(Work::Objects { text, at: at + end, line });
                self.work.push(Work::Value { text: value, line: here });
            }
            Err(error) => {
                let line = match line {
                    Line::From(first) => first + (error.line() as u64).saturating_sub(1),
                    Line::All(line) => line,
                };
                let what = format!("this is no JSON: {}", in_words(&error, true));
                let wrong = Wrong::with_mend(what, "mend the line, or give the file again");
                self.refuse(line, wrong);
                // What follows on the next line may be whole.
                if let Some(skip) = rest.get(blank..).and_then(|rest| rest.find('\n')) {
                    let end = blank + skip + 1;
                    let line = told(end);
                    self.work.push(Work::Objects { text, at: at + end, line });
                }
            }
        }
    }

    /// What an object is, or a list of them.
    fn value(&mut self, text: &str, line: u64) {
        let of = |text: &RawValue| Work::Value { text: text.get().to_owned(), line };
        if let Ok(list) = serde_json::from_str::<Vec<&RawValue>>(text) {
            return self.work.extend(list.into_iter().rev().map(of));
        }
        let head: Head<'_> = serde_json::from_str(text).unwrap_or_default();
        let string = |value: Option<&RawValue>| -> Option<String> {
            serde_json::from_str(value?.get()).ok()
        };
        if string(head.format).as_deref() == Some(FORMAT) {
            match misread::read::<Answer>(text) {
                Ok(answer) => {
                    let decided = decided(string(head.status), string(head.reject));
                    self.answers.push((answer, decided));
                }
                Err(error) => {
                    self.refuse(line, format!("the answer is damaged: {error}"));
                }
            }
            return;
        }
        match head.answers {
            Some(all) if all.get().starts_with('[') => self.work.push(of(all)),
            Some(all) if all.get().starts_with('"') => {
                let text = string(Some(all)).unwrap_or_default();
                self.work.push(Work::Objects { text, at: 0, line: Line::All(line) });
            }
            _ => {
                let what = "this is no answer to a study";
                let mend =
                    "give the files that the study's page made, or map the file of another program";
                self.refuse(line, Wrong::with_mend(what, mend));
            }
        }
    }

    /// Leaves out what begins in a line.
    fn refuse(&mut self, line: u64, why: impl Into<Wrong>) {
        self.flaws.push(Flaw { line, ..Flaw::of_file(why) });
        self.left_out += 1;
    }
}

/// A table: what a frame's form posted, or rows that this page wrote.
fn table(text: String) -> Result<Work, Flaw> {
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(text.as_bytes());
    let column = reader.headers().ok().and_then(|h| h.iter().position(|name| name == COLUMN));
    let whole = Cursor::new(text.into_bytes());
    let Some(column) = column else {
        let options = Options { with_rejected: true, ..Options::default() };
        return Reading::new(whole, options).map(|reading| Work::Rows(Box::new(reading)));
    };
    let records = csv::ReaderBuilder::new().flexible(true).from_reader(whole).into_records();
    Ok(Work::Cells(records, column))
}

/// What a line of answers says was decided of it.
fn decided(status: Option<String>, reject: Option<String>) -> Decision {
    match (status.as_deref(), reject) {
        (Some("Rejected"), why) => Decision::Rejected(why.unwrap_or_default().into()),
        (_, Some(why)) if !why.is_empty() => Decision::Rejected(why.into()),
        (Some("Approved"), _) => Decision::Approved,
        _ => Decision::Open,
    }
}

/// An example of a corpus as an answer of which nothing more is known.
fn of_example(example: Example) -> Decided {
    let worker = example.worker.unwrap_or_default();
    let shows = example.pairs.into_iter().map(Showing::from);
    let (runs, pairs) = shows.partition(|showing| showing.steps().is_some());
    let answer = Answer {
        format: FORMAT.to_owned(),
        id: format!("{}-1", example.id),
        command: example.command,
        item: example.task.clone().unwrap_or_default(),
        task: example.task,
        worker,
        pairs,
        runs,
        study: String::new(),
        turn: [1, 1],
        assignment: Some(example.id),
        hit: None,
        at: 0.0,
        care: Care::default(),
        simulated: None,
    };
    (answer, example.decision)
}
