//! Long work of the learner, and how far it is: files that are read in bounded steps, a training run.

use super::protocol::{CorpusFile, Fault, MappedFile, Progress};
use crate::corpus::{Corpus, Example, Flaw, Options, Reading};
use crate::learn;
use crate::learn::sheet::Source;
use std::io::Cursor;
use std::sync::Arc;

/// Files that are being read as one corpus.
pub(super) struct CorpusReading {
    waiting: std::vec::IntoIter<MappedFile>,
    now: Option<(Source, Reading<Cursor<Vec<u8>>>)>,
    /// Bytes of the files that are read, and of all.
    done: u64,
    of: u64,
    read: Read,
}

/// What there is of files that were read.
#[derive(Default)]
pub(super) struct Read {
    /// The good rows of all files; none if one of them has none.
    pub(super) examples: Vec<Example>,
    /// The files.
    pub(super) sources: Vec<Source>,
    /// For each why no row of it can be used.
    pub(super) useless: Vec<Option<String>>,
    /// What is wrong or odd, with the number of its file.
    pub(super) flaws: Vec<(u32, Flaw)>,
}

impl CorpusReading {
    /// The beginning of some files.
    pub(super) fn new(files: Vec<MappedFile>) -> Self {
        CorpusReading {
            of: files.iter().map(|mapped| mapped.file.bytes.len() as u64).sum(),
            waiting: files.into_iter(),
            now: None,
            done: 0,
            read: Read::default(),
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
                let (source, reading) = self.now.take()?;
                self.done += reading.bytes();
                let (corpus, flaws) = reading.end();
                self.take_in(source, corpus, flaws)
            }
            None => {
                let Some(MappedFile { file: CorpusFile { name, bytes }, mapping }) =
                    self.waiting.next()
                else {
                    return Some(std::mem::take(&mut self.read));
                };
                // Rejected rows are shown too: whether they are used is the sheet's matter.
                let options = Options { with_rejected: true, mapping: mapping.clone() };
                let source = Source { name, mapping, ..Source::default() };
                match Reading::new(Cursor::new(Arc::unwrap_or_clone(bytes)), options) {
                    Ok(reading) => {
                        self.now = Some((source, reading));
                        None
                    }
                    Err(flaw) => self.take_in(source, Corpus::default(), vec![flaw]),
                }
            }
        }
    }

    fn take_in(&mut self, source: Source, corpus: Corpus, flaws: Vec<Flaw>) -> Option<Read> {
        let file = self.read.sources.len() as u32;
        let useless = corpus.why_empty(&flaws);
        let is_bad = useless.is_some();
        if let Some(why) = useless.iter().find(|_| flaws.is_empty()) {
            self.read.flaws.push((file, Flaw::of_file(why.clone())));
        }
        self.read.flaws.extend(flaws.into_iter().map(|flaw| (file, flaw)));
        self.read.useless.push(useless);
        self.read.sources.push(Source {
            is_json: corpus.columns.is_empty(),
            rows: corpus.examples.len(),
            left_out: corpus.left_out,
            columns: corpus.columns,
            bad: corpus.bad,
            ..source
        });
        self.read.examples.extend(corpus.examples);
        is_bad.then(|| {
            let mut read = std::mem::take(&mut self.read);
            read.examples = Vec::new();
            read
        })
    }
}

impl Read {
    /// What is wrong with the rows, for the page.
    pub(super) fn faults(&self) -> Vec<Fault> {
        let fault = |(file, Flaw { line, column, wrong, kept }): &(u32, Flaw)| Fault {
            file: *file,
            line: *line,
            column: column.clone(),
            what: wrong.what.clone(),
            snippet: wrong.snippet.clone(),
            mend: wrong.mend.clone(),
            kept: *kept,
        };
        self.flaws.iter().map(fault).collect()
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
