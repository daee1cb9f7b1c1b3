//! Splits CSV (RFC 4180, and what programs make of it) into records, from any byte stream, in steps. Unlike a plain
//! CSV reader it can go back: after a quote that is never closed it resumes at the next line, so that one bad row
//! costs one row. Lines count from 1 and are those of an editor, also inside quoted cells.

use super::cells::Cells;
use super::limits::{MAX_CELL_BYTES, MAX_COLUMNS, MAX_FILE_BYTES};
use super::source::{Source, Unreadable};
use std::io::Read;

/// One record: its cells without their quotes.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Record {
    /// The line where it begins.
    pub line: u64,
    /// The number of lines it covers.
    pub lines: u64,
    /// The cells' text, [`MAX_COLUMNS`] of them at most; bytes that are not UTF-8 are read as Latin-1.
    pub cells: Cells,
    /// The number of cells that the file has there.
    pub n_cells: usize,
    /// Numbers of the cells that are not UTF-8 text, ascending.
    pub not_text: Vec<usize>,
    /// Numbers of the cells that are left empty because they are larger than [`MAX_CELL_BYTES`], ascending.
    pub cut: Vec<usize>,
    /// The record as it stands in the file.
    pub raw: Vec<u8>,
    /// Number of the first cell where text follows the closing quote.
    pub stray: Option<usize>,
}

/// What parts cells, the usual one first.
const SEPARATORS: [u8; 3] = [b',', b';', b'\t'];

/// What a step comes to.
#[derive(Debug)]
pub enum Step {
    /// There is more to do.
    Working,
    /// A record that is not an empty line.
    Record(Record),
    /// A quote opened in the record that begins at this line is never closed; reading goes on at the next one. The line
    /// as it stands in the file.
    Unclosed(u64, Vec<u8>),
    /// The file has no more records.
    Over,
}

/// Why reading ends before the file does; none of it is used then.
#[derive(Debug, thiserror::Error)]
pub enum Fault {
    /// See there.
    #[error(transparent)]
    Unreadable(#[from] Unreadable),
    /// The first record is wider than any table.
    #[error("the first line has more than {MAX_COLUMNS} cells")]
    Wide,
    /// It went back too often.
    #[error("too many quotes are never closed")]
    Hopeless,
}

#[derive(Clone, Copy, PartialEq)]
enum At {
    Start,
    Bare,
    Quoted,
    QuoteSeen,
}

/// A reader of records.
pub struct Records<R> {
    source: Source<R>,
    separator: u8,
    /// What the file says of it, as it stands there.
    said: Vec<u8>,
    /// Where in the buffer the current record begins, and the next byte to look at.
    start: usize,
    next: usize,
    line: u64,
    start_line: u64,
    is_first: bool,
    /// Whether the next byte begins a record.
    is_fresh: bool,
    /// The record at work, its last cell, and where in it the reader is.
    record: Record,
    cell: Vec<u8>,
    at: At,
    /// Bytes that were gone back over.
    again: u64,
}

impl<R: Read> Records<R> {
    /// A reader at the beginning of a file. What parts the cells is found out: what a first line `sep=…` says, or that
    /// of comma, semicolon and tab which stands most often in the first line.
    pub(super) fn new(source: Source<R>) -> Self {
        let (separator, skip) = separator(&source.buffer);
        let said = source.buffer.get(..skip).unwrap_or_default().to_vec();
        Records {
            source,
            separator,
            said,
            start: skip,
            next: skip,
            line: 1 + u64::from(skip > 0),
            start_line: 1,
            is_first: true,
            is_fresh: true,
            record: Record::default(),
            cell: Vec::new(),
            at: At::Start,
            again: 0,
        }
    }

    /// Bytes of the file that were taken so far, for progress.
    pub fn bytes(&self) -> u64 {
        self.source.taken()
    }

    /// What the file says of its separator before the first record, as it stands there.
    pub(super) fn said(&self) -> &[u8] {
        &self.said
    }

    /// Goes on by a bounded part: to the end of the record, or of what is in the buffer.
    ///
    /// # Errors
    /// Why the file cannot be read to its end.
    pub fn step(&mut self) -> Result<Step, Fault> {
        loop {
            if std::mem::take(&mut self.is_fresh) {
                // Empty lines are no records.
                while self.source.buffer.get(self.next) == Some(&b'\n') {
                    self.next += 1;
                    self.line += 1;
                }
                self.start = self.next;
                (self.start_line, self.at) = (self.line, At::Start);
                self.record = Record { line: self.line, ..Record::default() };
                self.cell.clear();
            }
            let Some(&byte) = self.source.buffer.get(self.next) else {
                if !self.source.ended {
                    self.source.fill(self.start)?;
                    self.next -= std::mem::take(&mut self.start);
                    return Ok(Step::Working);
                }
                return match (self.next > self.start, self.at) {
                    (false, _) => Ok(Step::Over),
                    (true, At::Quoted) => self.unclosed(),
                    (true, _) => Ok(self.end_record()),
                };
            };
            // Whether a line break is of two characters shows only when the second one is there.
            if byte == b'\r'
                && self.at != At::Quoted
                && self.next + 1 == self.source.buffer.len()
                && !self.source.ended
            {
                self.source.fill(self.start)?;
                self.next -= std::mem::take(&mut self.start);
                continue;
            }
            self.next += 1;
            match (self.at, byte) {
                (At::Quoted, b'"') => self.at = At::QuoteSeen,
                (At::Start, b'"') => self.at = At::Quoted,
                (At::QuoteSeen, b'"') => {
                    self.push(byte);
                    self.at = At::Quoted;
                }
                (At::Quoted, _) => {
                    self.line += u64::from(byte == b'\n');
                    self.push(byte);
                    if self.cell.len() > MAX_CELL_BYTES && self.line > self.start_line {
                        return self.unclosed();
                    }
                }
                (_, byte) if byte == self.separator => {
                    self.close();
                    self.at = At::Start;
                    if self.is_first && self.record.n_cells == MAX_COLUMNS {
                        return Err(Fault::Wide);
                    }
                }
                (_, b'\n' | b'\r') => {
                    let pair = byte == b'\r' && self.source.buffer.get(self.next) == Some(&b'\n');
                    self.next += usize::from(pair);
                    self.line += 1;
                    match self.end_record() {
                        // An empty line.
                        Step::Record(Record { n_cells: 1, cells, .. })
                            if cells.get(0) == Some("") => {}
                        record => return Ok(record),
                    }
                }
                (_, _) => {
                    if self.at == At::QuoteSeen {
                        self.record.stray.get_or_insert(self.record.n_cells);
                    }
                    self.push(byte);
                    self.at = At::Bare;
                }
            }
        }
    }

    /// Goes back to the line after the first one of the record read last, which swallowed others.
    ///
    /// # Errors
    /// When it went back too often.
    pub fn resume_at_second_line(&mut self) -> Result<(), Fault> {
        let record = self.source.buffer.get(self.start..self.next).unwrap_or_default();
        self.again += record.len() as u64;
        let first = record.iter().position(|&byte| byte == b'\n');
        self.next = first.map_or(self.next, |at| self.start + at + 1);
        self.line = self.start_line + u64::from(first.is_some());
        self.is_fresh = true;
        if self.again > MAX_FILE_BYTES { Err(Fault::Hopeless) } else { Ok(()) }
    }

    fn unclosed(&mut self) -> Result<Step, Fault> {
        let (line, start) = (self.start_line, self.start);
        self.resume_at_second_line()?;
        let raw = self.source.buffer.get(start..self.next).unwrap_or_default().to_vec();
        Ok(Step::Unclosed(line, raw))
    }

    fn end_record(&mut self) -> Step {
        self.close();
        self.is_first = false;
        self.is_fresh = true;
        let mut record = std::mem::take(&mut self.record);
        record.lines = (self.line - record.line).max(1);
        record.raw = self.source.buffer.get(self.start..self.next).unwrap_or_default().to_vec();
        Step::Record(record)
    }

    fn push(&mut self, byte: u8) {
        // One byte more than is kept tells that there was more.
        if self.cell.len() <= MAX_CELL_BYTES {
            self.cell.push(byte);
        }
    }

    fn close(&mut self) {
        let Record { cells, n_cells, not_text, cut, .. } = &mut self.record;
        if cells.len() < MAX_COLUMNS {
            if self.cell.len() > MAX_CELL_BYTES {
                cut.push(*n_cells);
            } else if let Ok(text) = std::str::from_utf8(&self.cell) {
                cells.push(text);
            } else {
                not_text.push(*n_cells);
                cells.push(&self.cell.iter().map(|&byte| char::from(byte)).collect::<String>());
            }
            if cells.len() <= *n_cells {
                cells.push("");
            }
        }
        *n_cells += 1;
        self.cell.clear();
    }
}

/// What parts the cells of a file that begins so, and how many bytes of it say that and are no record.
fn separator(head: &[u8]) -> (u8, usize) {
    let is_break = |byte: &u8| matches!(byte, b'\n' | b'\r');
    let end = head.iter().position(is_break).unwrap_or(head.len());
    let (line, rest) = head.split_at(end);
    if let Some(separator) = separator_said(line) {
        let end = end + if rest.starts_with(b"\r\n") { 2 } else { rest.len().min(1) };
        return (separator, end);
    }
    let mut counts = [0usize; SEPARATORS.len()];
    let mut is_quoted = false;
    for byte in line {
        is_quoted ^= *byte == b'"';
        if let Some(at) = SEPARATORS.iter().position(|other| other == byte && !is_quoted) {
            counts[at] += 1;
        }
    }
    // The first of those that stand equally often, as a comma does where none stands.
    let most = (0..counts.len()).rev().max_by_key(|&at| counts[at]).unwrap_or(0);
    (SEPARATORS[most], 0)
}

/// What a line `sep=…` says parts the cells; such a line may stand in quotes. A program that has taken it for a record
/// writes it with cells that are empty behind it: then it is what parts those.
fn separator_said(line: &[u8]) -> Option<u8> {
    let is_quoted = line.first() == Some(&b'"');
    let line = line.strip_prefix(b"\"").unwrap_or(line);
    let (name, said) = line.split_at_checked(4)?;
    if !name.eq_ignore_ascii_case(b"sep=") {
        return None;
    }
    let (separator, rest) = match said {
        [b'\\', b't', rest @ ..] => (b'\t', rest),
        [separator, rest @ ..] => (*separator, rest),
        [] => return None,
    };
    let rest = if is_quoted { rest.strip_prefix(b"\"")? } else { rest };
    match rest.trim_ascii_end().first().filter(|first| SEPARATORS.contains(first)) {
        Some(first) if rest.iter().all(|byte| byte == first || *byte == b' ') => Some(*first),
        None if rest.trim_ascii().is_empty() && !separator.is_ascii_alphanumeric() => {
            Some(separator)
        }
        _ => None,
    }
}
