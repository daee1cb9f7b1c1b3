//! One door for both forms: rows from any byte stream, one by one so that a long reading can be pumped.

use super::admit::Options;
use super::example::{Corpus, Flaw, Row};
use super::{jsonl, mturk};
use std::io::Read;

/// How a file is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Mechanical Turk's batch results.
    Csv,
    /// An example a line.
    JsonLines,
}

impl Form {
    /// The form that a file's name speaks of: JSON lines for `.jsonl` and `.ndjson`, otherwise CSV.
    pub fn of_name(name: &str) -> Form {
        let name = name.to_ascii_lowercase();
        if name.ends_with(".jsonl") || name.ends_with(".ndjson") {
            Form::JsonLines
        } else {
            Form::Csv
        }
    }
}

/// The rows of a file, one by one.
pub enum Rows<R> {
    /// Of batch results.
    Csv(Box<mturk::Reader<R>>),
    /// Of JSON lines.
    JsonLines(jsonl::Reader<R>),
}

impl<R: Read> Rows<R> {
    /// A reader at the beginning of `source`.
    ///
    /// # Errors
    /// Why the file is no corpus at all.
    pub fn new(form: Form, source: R, options: Options) -> Result<Self, Flaw> {
        match form {
            Form::Csv => mturk::Reader::new(source, options).map(Box::new).map(Rows::Csv),
            Form::JsonLines => jsonl::Reader::new(source).map(Rows::JsonLines),
        }
    }

    /// All columns of a CSV file; none otherwise.
    pub fn columns(&self) -> &[String] {
        match self {
            Rows::Csv(reader) => reader.columns(),
            Rows::JsonLines(_) => &[],
        }
    }

    /// Bytes read so far, for progress.
    pub fn bytes(&self) -> u64 {
        match self {
            Rows::Csv(reader) => reader.bytes(),
            Rows::JsonLines(reader) => reader.bytes(),
        }
    }
}

impl<R: Read> Iterator for Rows<R> {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        match self {
            Rows::Csv(reader) => reader.next(),
            Rows::JsonLines(reader) => reader.next(),
        }
    }
}

impl Corpus {
    /// Takes in what came of one row, and hands back its flaws.
    pub fn add(&mut self, row: Row) -> Vec<Flaw> {
        self.examples.extend(row.example);
        self.rejected += usize::from(row.rejected);
        row.flaws
    }
}

/// Reads a whole file: what is good of it, and what is wrong or odd with it.
pub fn read(form: Form, source: impl Read, options: Options) -> (Corpus, Vec<Flaw>) {
    let mut corpus = Corpus::default();
    let rows = match Rows::new(form, source, options) {
        Ok(rows) => rows,
        Err(flaw) => return (corpus, vec![flaw]),
    };
    corpus.columns = rows.columns().to_vec();
    let flaws = rows.flat_map(|row| corpus.add(row)).collect();
    (corpus, flaws)
}
