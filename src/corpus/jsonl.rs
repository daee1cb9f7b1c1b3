//! JSON lines: `{id, command, task?, worker?, pairs: [{pre, post}]}` a line, in and out.

use super::admit::{check_command, not_a_corpus};
use super::cell::{self, Moment};
use super::example::{
    Corpus, Example, Flaw, MAX_CELL_BYTES, MAX_FILE_BYTES, MAX_PAIRS, MAX_ROWS, Row,
};
use crate::domain::State;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use std::io::{BufRead, BufReader, Read, Write};

/// The longest line that is read, in bytes.
const MAX_LINE_BYTES: u64 = 2 * (MAX_CELL_BYTES * 4) as u64;

/// A line as it is read: states as text, so that an error has a place in its own state.
#[derive(Deserialize)]
struct LineIn<'a> {
    #[serde(default)]
    id: Option<String>,
    command: String,
    #[serde(default)]
    task: Option<String>,
    #[serde(default)]
    worker: Option<String>,
    #[serde(borrow)]
    pairs: Vec<PairIn<'a>>,
}

#[derive(Deserialize)]
struct PairIn<'a> {
    #[serde(borrow)]
    pre: &'a RawValue,
    #[serde(borrow)]
    post: &'a RawValue,
}

#[derive(Serialize)]
struct LineOut<'a> {
    id: &'a str,
    command: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    task: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    worker: Option<&'a str>,
    pairs: Vec<PairOut<'a>>,
}

#[derive(Serialize)]
struct PairOut<'a> {
    pre: &'a State,
    post: &'a State,
}

/// A reader of JSON lines, line by line. Empty lines are skipped.
pub struct Reader<R> {
    source: BufReader<R>,
    line: u64,
    rows: usize,
    bytes: u64,
    ended: bool,
}

impl<R: Read> Reader<R> {
    /// A reader at the beginning of `source`.
    ///
    /// # Errors
    /// Why the file holds no JSON lines: empty, not text.
    pub fn new(source: R) -> Result<Self, Flaw> {
        let mut source = BufReader::new(source);
        let head = source.fill_buf().map_err(|error| Flaw::of_file(error.to_string()))?;
        if let Some(reason) = not_a_corpus(head) {
            return Err(Flaw::of_file(reason));
        }
        let mark = if head.starts_with(b"\xEF\xBB\xBF") { 3 } else { 0 };
        source.consume(mark);
        Ok(Reader { source, line: 0, rows: 0, bytes: mark as u64, ended: false })
    }

    /// Bytes read so far, for progress.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    fn end(&mut self, message: String) -> Option<Row> {
        self.ended = true;
        Some(Row::bad(Flaw::of_file(message)))
    }
}

impl<R: Read> Iterator for Reader<R> {
    type Item = Row;

    fn next(&mut self) -> Option<Row> {
        while !self.ended {
            let mut text = Vec::new();
            let taken = self.source.by_ref().take(MAX_LINE_BYTES).read_until(b'\n', &mut text);
            let taken = match taken {
                Ok(0) if self.rows == 0 => return self.end("the file has no rows".into()),
                Ok(0) => break,
                Ok(taken) => taken as u64,
                Err(error) => return self.end(format!("the file could not be read: {error}")),
            };
            self.line += 1;
            self.bytes += taken;
            if self.bytes > MAX_FILE_BYTES {
                let limit = MAX_FILE_BYTES >> 20;
                return self
                    .end(format!("the file is larger than {limit} MB; the rest was not read"));
            }
            if taken == MAX_LINE_BYTES && !text.ends_with(b"\n") {
                return self.end(format!("line {} is too long; the rest was not read", self.line));
            }
            if text.trim_ascii().is_empty() {
                continue;
            }
            self.rows += 1;
            if self.rows > MAX_ROWS {
                return self.end(format!("more than {MAX_ROWS} rows; the rest was not read"));
            }
            return Some(match std::str::from_utf8(&text) {
                Ok(text) => row(text, self.line),
                Err(_) => Row::bad(Flaw::of_row(self.line, None, "the line is not UTF-8 text")),
            });
        }
        self.ended = true;
        None
    }
}

/// Writes a corpus as JSON lines.
///
/// # Errors
/// Those of `out`.
pub fn write(corpus: &Corpus, mut out: impl Write) -> std::io::Result<()> {
    for example in &corpus.examples {
        let pairs = example.pairs.iter().map(|pair| PairOut { pre: &pair.pre, post: &pair.post });
        let line = LineOut {
            id: &example.id,
            command: &example.command,
            task: example.task.as_deref(),
            worker: example.worker.as_deref(),
            pairs: pairs.collect(),
        };
        serde_json::to_writer(&mut out, &line)?;
        out.write_all(b"\n")?;
    }
    Ok(())
}

fn row(text: &str, line: u64) -> Row {
    let read: LineIn<'_> = match serde_json::from_str(text) {
        Ok(read) => read,
        Err(error) => {
            let full = error.to_string();
            let detail = full.split(" at line ").next().unwrap_or(&full);
            let message = format!("{detail}, at character {} of the line", error.column());
            return Row::bad(Flaw::of_row(line, None, message));
        }
    };
    let mut flaws = Vec::new();
    let mut flaw = |column: String, message: String| {
        flaws.push(Flaw::of_row(line, Some(&column), message));
    };
    let mut good = true;
    let command = read.command.trim().to_owned();
    if let Err(message) = check_command(&command) {
        flaw("command".into(), message);
        good = false;
    }
    if read.pairs.is_empty() || read.pairs.len() > MAX_PAIRS {
        flaw("pairs".into(), format!("a row needs 1 to {MAX_PAIRS} pairs of pre and post"));
        good = false;
    }
    let mut pairs = Vec::new();
    for (n, read) in read.pairs.iter().take(MAX_PAIRS).enumerate() {
        let found = cell::demonstration(read.pre.get(), read.post.get(), |moment, message| {
            let side = if moment == Moment::Before { "pre" } else { "post" };
            flaw(format!("pairs[{n}].{side}"), message);
        });
        good &= found.is_some();
        pairs.extend(found);
    }
    flaws.iter_mut().for_each(|flaw| flaw.kept = good);
    let example = good.then(|| Example {
        id: read.id.filter(|id| !id.is_empty()).unwrap_or_else(|| format!("line {line}")),
        line,
        command,
        task: read.task.filter(|task| !task.is_empty()),
        worker: read.worker.filter(|worker| !worker.is_empty()),
        pairs,
        rest: Vec::new(),
    });
    Row { example, rejected: false, flaws }
}
