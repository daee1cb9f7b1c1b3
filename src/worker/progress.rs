//! Long work of the learner, and how far it is: files that are read in bounded steps, a training run.

use super::protocol::{CorpusFile, Problem, Progress};
use crate::corpus::{Corpus, Flaw, Options, Reading};
use crate::learn;
use std::io::Cursor;

/// Files that are being read as one corpus.
pub(super) struct CorpusReading {
    waiting: std::vec::IntoIter<CorpusFile>,
    now: Option<(String, Reading<Cursor<Vec<u8>>>)>,
    options: Options,
    n_files: usize,
    /// Bytes of the files that are read, and of all.
    done: u64,
    of: u64,
    corpus: Corpus,
    problems: Vec<Problem>,
}

/// What there is of files that were read.
pub(super) struct Read {
    pub(super) corpus: Corpus,
    pub(super) problems: Vec<Problem>,
}

impl CorpusReading {
    /// The beginning of some files.
    pub(super) fn new(files: Vec<CorpusFile>, options: Options) -> Self {
        CorpusReading {
            n_files: files.len(),
            of: files.iter().map(|file| file.bytes.len() as u64).sum(),
            waiting: files.into_iter(),
            now: None,
            options,
            done: 0,
            corpus: Corpus::default(),
            problems: Vec::new(),
        }
    }

    /// Bytes that are read, and bytes in all.
    pub(super) fn progress(&self) -> (u64, u64) {
        let now = self.now.as_ref().map_or(0, |(_, reading)| reading.bytes());
        ((self.done + now).min(self.of), self.of)
    }

    /// Does a bounded part; once there is no more, what is good in the files and what is wrong with them. A file of
    /// which no row can be used is the end: there is no corpus then.
    pub(super) fn step(&mut self) -> Option<Read> {
        match &mut self.now {
            Some((_, reading)) => {
                if reading.step() {
                    return None;
                }
                let (name, reading) = self.now.take()?;
                self.done += reading.bytes();
                let (corpus, flaws) = reading.end();
                self.take_in(&name, corpus, flaws)
            }
            None => {
                let Some(CorpusFile { name, bytes }) = self.waiting.next() else {
                    return Some(self.end());
                };
                match Reading::new(Cursor::new(bytes), self.options.clone()) {
                    Ok(reading) => {
                        self.now = Some((name, reading));
                        None
                    }
                    Err(flaw) => self.take_in(&name, Corpus::default(), vec![flaw]),
                }
            }
        }
    }

    fn take_in(&mut self, name: &str, corpus: Corpus, flaws: Vec<Flaw>) -> Option<Read> {
        let is_bad = corpus.examples.is_empty();
        if is_bad && flaws.is_empty() {
            let why = corpus.why_empty(&flaws).unwrap_or_default();
            self.problems.push(self.problem(name, Flaw::of_file(why)));
        }
        let problems: Vec<Problem> =
            flaws.into_iter().map(|flaw| self.problem(name, flaw)).collect();
        self.problems.extend(problems);
        let (rejected, left_out) = (corpus.rejected, corpus.left_out);
        self.corpus.append(corpus);
        is_bad.then(|| {
            self.corpus = Corpus { rejected, left_out, ..Corpus::default() };
            self.end()
        })
    }

    fn end(&mut self) -> Read {
        let (corpus, problems) =
            (std::mem::take(&mut self.corpus), std::mem::take(&mut self.problems));
        Read { corpus, problems }
    }

    /// What is wrong with a row, for the page: with its file, where there are several.
    fn problem(&self, name: &str, flaw: Flaw) -> Problem {
        let Flaw { line, column, wrong, kept } = flaw;
        let message = if self.n_files > 1 { format!("{name}: {wrong}") } else { wrong.to_string() };
        Problem { line, column, message, kept }
    }
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
