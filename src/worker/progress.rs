//! Long work of the learner, and how far it is: a corpus that is read a few rows a step, a training run.

use super::protocol::{Problem, Progress};
use crate::corpus::{Corpus, Flaw, Form, Options, Rows};
use crate::learn;
use std::io::Cursor;

/// Rows that a step reads.
const ROWS_A_STEP: usize = 4;

/// A corpus that is being read.
pub(super) struct CorpusReading {
    rows: Rows<Cursor<Vec<u8>>>,
    corpus: Corpus,
    problems: Vec<Problem>,
}

impl CorpusReading {
    /// The beginning of a file, or why it is no corpus.
    pub(super) fn new(name: &str, text: String) -> Result<Self, Flaw> {
        let source = Cursor::new(text.into_bytes());
        let rows = Rows::new(Form::of_name(name), source, Options::default())?;
        let corpus = Corpus { columns: rows.columns().to_vec(), ..Corpus::default() };
        Ok(CorpusReading { rows, corpus, problems: Vec::new() })
    }

    /// Reads a few rows; once there are no more, what is good in the file and what is wrong with it.
    pub(super) fn step(&mut self) -> Option<(Corpus, Vec<Problem>)> {
        for _ in 0..ROWS_A_STEP {
            match self.rows.next() {
                Some(row) => self.problems.extend(self.corpus.add(row).into_iter().map(problem)),
                None => {
                    let problems = std::mem::take(&mut self.problems);
                    return Some((std::mem::take(&mut self.corpus), problems));
                }
            }
        }
        None
    }
}

/// What is wrong with a row, for the page.
pub(super) fn problem(flaw: Flaw) -> Problem {
    Problem { line: flaw.line, column: flaw.column, message: flaw.message, kept: flaw.kept }
}

/// How far a training run of so many epochs and examples is.
pub(super) fn progress(progress: learn::Progress, epochs: u32, examples: usize) -> Progress {
    Progress {
        epoch: progress.epoch,
        epochs,
        example: progress.example,
        examples,
        valid: progress.so_far.valid,
        updates: progress.so_far.updates,
        entries: progress.so_far.entries,
    }
}
