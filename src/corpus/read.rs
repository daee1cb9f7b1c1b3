//! One door for every form: what a file is goes by its first sign, and its rows come in steps from any byte stream, so
//! that a long reading can be pumped, shown and ended.

use super::admit::{Options, empty, not_a_corpus};
use super::draft::{Draft, Found};
use super::example::{Corpus, Row};
use super::flaw::{Flaw, Wrong};
use super::header::Header;
use super::limits::{MAX_FLAWS, MAX_ROWS};
use super::source::Source;
use super::{jsonl, mturk};
use std::io::Read;

/// What a step of reading comes to.
#[derive(Debug)]
pub enum Step {
    /// There is more to do.
    Working,
    /// A row is read.
    Row(Box<Row>),
    /// There are no more.
    Over,
}

enum Form<R> {
    /// Batch results.
    Table(Box<mturk::Reader<R>>),
    /// JSON, an example an object.
    Json(Box<jsonl::Reader<R>>),
}

/// The rows of a file, one by one.
pub struct Rows<R> {
    form: Form<R>,
    draft: Option<Box<Draft>>,
    rows: usize,
}

impl<R: Read> Rows<R> {
    /// A reader at the beginning of `stream`.
    ///
    /// # Errors
    /// Why the file is no corpus at all.
    pub fn new(stream: R, options: Options) -> Result<Self, Flaw> {
        let source = Source::new(stream).map_err(|fault| Flaw::of_file(fault.wrong()))?;
        if let Some(wrong) = not_a_corpus(&source.buffer) {
            return Err(Flaw::of_file(wrong));
        }
        let form = match source.buffer.trim_ascii_start().first() {
            None if source.ended => return Err(Flaw::of_file(empty())),
            Some(b'{' | b'[') => Form::Json(Box::new(jsonl::Reader::new(source, options))),
            _ => Form::Table(Box::new(mturk::Reader::new(source, options))),
        };
        Ok(Rows { form, draft: None, rows: 0 })
    }

    /// What the columns of a table are, once they are read.
    pub fn header(&self) -> Option<&Header> {
        match &self.form {
            Form::Table(reader) => reader.header(),
            Form::Json(_) => None,
        }
    }

    /// What stands before the rows of a table, as it stands in the file, once it is read.
    fn head(&self) -> &[u8] {
        match &self.form {
            Form::Table(reader) => reader.head(),
            Form::Json(_) => &[],
        }
    }

    /// Bytes of the file that were read so far, packed as they are, for progress.
    pub fn bytes(&self) -> u64 {
        match &self.form {
            Form::Table(reader) => reader.bytes(),
            Form::Json(reader) => reader.bytes(),
        }
    }

    /// Goes on by a bounded part: some bytes of the file, or a demonstration.
    ///
    /// # Errors
    /// Why the file cannot be read to its end; nothing of it is to be used then.
    pub fn step(&mut self) -> Result<Step, Flaw> {
        if let Some(draft) = &mut self.draft {
            let Some(row) = draft.step() else { return Ok(Step::Working) };
            self.draft = None;
            return Ok(Step::Row(Box::new(row)));
        }
        let found = match &mut self.form {
            Form::Table(reader) => reader.step()?,
            Form::Json(reader) => reader.step()?,
        };
        if matches!(found, Found::Row(_) | Found::Draft(_)) {
            self.rows += 1;
            if self.rows > MAX_ROWS {
                return Err(Flaw::of_file(Wrong::with_mend(
                    format!("the file has more than {MAX_ROWS} rows"),
                    "split it, and give all parts",
                )));
            }
        }
        match found {
            Found::Nothing => Ok(Step::Working),
            Found::Row(row) => Ok(Step::Row(Box::new(row))),
            Found::Draft(draft) => {
                self.draft = Some(draft);
                Ok(Step::Working)
            }
            Found::Over if self.rows == 0 => Err(Flaw::of_file(match self.form {
                Form::Table(_) => "the file has a header and no rows".to_owned(),
                Form::Json(_) => "the file has no rows".to_owned(),
            })),
            Found::Over => Ok(Step::Over),
        }
    }
}

/// A file on its way to a corpus.
pub struct Reading<R> {
    rows: Rows<R>,
    corpus: Corpus,
    flaws: Vec<Flaw>,
    more_flaws: usize,
}

impl<R: Read> Reading<R> {
    /// The beginning of a file.
    ///
    /// # Errors
    /// Why the file is no corpus at all.
    pub fn new(stream: R, options: Options) -> Result<Self, Flaw> {
        let mapping = options.mapping.clone();
        let rows = Rows::new(stream, options)?;
        let corpus = Corpus { mapping, ..Corpus::default() };
        Ok(Reading { rows, corpus, flaws: Vec::new(), more_flaws: 0 })
    }

    /// Bytes read so far, for progress.
    pub fn bytes(&self) -> u64 {
        self.rows.bytes()
    }

    /// Does a bounded part; whether there is more to do.
    pub fn step(&mut self) -> bool {
        match self.rows.step() {
            Ok(Step::Working) => true,
            Ok(Step::Row(row)) => {
                for flaw in self.corpus.add(*row) {
                    if self.flaws.len() < MAX_FLAWS {
                        self.flaws.push(flaw);
                    } else {
                        self.more_flaws += 1;
                    }
                }
                true
            }
            Ok(Step::Over) => {
                self.corpus.columns =
                    self.rows.header().map(|header| header.columns.clone()).unwrap_or_default();
                if self.corpus.bad.kept > 0 {
                    self.corpus.bad.text.splice(..0, self.rows.head().iter().copied());
                }
                if self.more_flaws > 0 {
                    let more = format!("{} more are not listed", self.more_flaws);
                    self.flaws.push(Flaw { kept: true, ..Flaw::of_file(more) });
                }
                false
            }
            Err(flaw) => {
                self.corpus = Corpus::default();
                self.flaws = vec![flaw];
                false
            }
        }
    }

    /// What is good of the file, and what is wrong or odd with it. Of a file that cannot be read to its end there is
    /// nothing but the reason.
    pub fn end(self) -> (Corpus, Vec<Flaw>) {
        (self.corpus, self.flaws)
    }
}

/// Reads a whole file: what is good of it, and what is wrong or odd with it.
pub fn read(stream: impl Read, options: Options) -> (Corpus, Vec<Flaw>) {
    match Reading::new(stream, options) {
        Ok(mut reading) => {
            while reading.step() {}
            reading.end()
        }
        Err(flaw) => (Corpus::default(), vec![flaw]),
    }
}
