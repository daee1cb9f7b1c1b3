//! Splits CSV (RFC 4180, and what programs make of it) into records, from any byte stream. Unlike a plain CSV
//! reader it can go back: after a quote that is never closed it resumes at the next line, so that one bad row
//! costs one row. Lines count from 1 and are those of an editor, also inside quoted cells.

use super::example::{MAX_CELL_BYTES, MAX_FILE_BYTES};
use std::io::Read;

const CHUNK: usize = 64 << 10;
/// How often a reader goes back for a quote that is never closed before it gives the file up.
const MAX_RESUMES: u32 = 100;

/// One record: its cells without their quotes.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Record {
    /// The line where it begins.
    pub line: u64,
    /// The number of lines it covers.
    pub lines: u64,
    /// The cells' text; bytes that are not UTF-8 are replaced.
    pub cells: Vec<String>,
    /// Index of the first cell that is not UTF-8 text.
    pub not_text: Option<usize>,
    /// Index of the first cell that was cut because it is larger than [`MAX_CELL_BYTES`].
    pub cut: Option<usize>,
    /// Index of the first cell where text follows the closing quote.
    pub stray: Option<usize>,
}

/// Why there is no record here.
#[derive(Debug, thiserror::Error)]
pub enum Fault {
    /// The stream failed; reading ends.
    #[error("the file could not be read: {0}")]
    Io(#[from] std::io::Error),
    /// Reading ends.
    #[error("the file is larger than {} MB; what comes after was not read", MAX_FILE_BYTES >> 20)]
    TooLarge,
    /// Reading goes on at the next line.
    #[error(
        "a quote opened in this row is never closed; close it, or double it if it belongs to the text"
    )]
    Unclosed {
        /// The line where the record begins.
        line: u64,
    },
    /// Reading ends.
    #[error("too many quotes are never closed; the rest of the file was not read")]
    Hopeless,
}

impl Fault {
    /// Whether nothing can be read after this.
    pub fn is_final(&self) -> bool {
        !matches!(self, Fault::Unclosed { .. })
    }
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
    source: R,
    /// Bytes from the beginning of the current record on.
    buffer: Vec<u8>,
    /// Where in `buffer` the current record begins, and the next byte to look at.
    start: usize,
    next: usize,
    line: u64,
    start_line: u64,
    read: u64,
    ended: bool,
    resumes: u32,
}

impl<R: Read> Records<R> {
    /// A reader at the beginning of `source`; a byte-order mark is skipped.
    pub fn new(source: R) -> Result<Self, Fault> {
        let mut records = Records {
            source,
            buffer: Vec::new(),
            start: 0,
            next: 0,
            line: 1,
            start_line: 1,
            read: 0,
            ended: false,
            resumes: 0,
        };
        while !records.ended && records.buffer.len() < 512 {
            records.fill()?;
        }
        if records.buffer.starts_with(b"\xEF\xBB\xBF") {
            records.next = 3;
        }
        Ok(records)
    }

    /// The bytes that are buffered: right after [`Records::new`], the beginning of the file.
    pub fn head(&self) -> &[u8] {
        self.buffer.get(self.next..).unwrap_or_default()
    }

    /// Bytes taken from the source so far, for progress.
    pub fn bytes(&self) -> u64 {
        self.read
    }

    /// The next record that is not an empty line; `None` at the end.
    pub fn next_record(&mut self) -> Option<Result<Record, Fault>> {
        loop {
            self.start = self.next;
            self.start_line = self.line;
            match self.scan() {
                Ok(None) => return None,
                Ok(Some(record))
                    if record.cells.iter().all(String::is_empty) && record.cells.len() < 2 => {}
                Ok(Some(record)) => return Some(Ok(record)),
                Err(fault) => {
                    if fault.is_final() {
                        self.give_up();
                    }
                    return Some(Err(fault));
                }
            }
        }
    }

    /// Goes back to the line after the first one of the record read last, which swallowed others.
    pub fn resume_at_second_line(&mut self) {
        let record = self.buffer.get(self.start..self.next).unwrap_or_default();
        if let Some(at) = record.iter().position(|&byte| byte == b'\n') {
            self.next = self.start + at + 1;
            self.line = self.start_line + 1;
        }
    }

    fn give_up(&mut self) {
        self.ended = true;
        self.buffer.clear();
        self.start = 0;
        self.next = 0;
    }

    fn scan(&mut self) -> Result<Option<Record>, Fault> {
        let mut record = Record { line: self.line, ..Record::default() };
        let mut cell = Vec::new();
        let mut at = At::Start;
        let mut any = false;
        loop {
            let Some(byte) = self.byte()? else {
                if !any {
                    return Ok(None);
                }
                if at == At::Quoted {
                    self.resumes += 1;
                    if self.resumes > MAX_RESUMES {
                        return Err(Fault::Hopeless);
                    }
                    let line = self.start_line;
                    self.resume_at_second_line();
                    return Err(Fault::Unclosed { line });
                }
                record.close(&mut cell);
                break;
            };
            any = true;
            match (at, byte) {
                (At::Quoted, b'"') => at = At::QuoteSeen,
                (At::Start, b'"') => at = At::Quoted,
                (At::QuoteSeen, b'"') => {
                    record.push(&mut cell, byte);
                    at = At::Quoted;
                }
                (At::Quoted, _) => {
                    self.line += u64::from(byte == b'\n');
                    record.push(&mut cell, byte);
                }
                (_, b',') => {
                    record.close(&mut cell);
                    at = At::Start;
                }
                (_, b'\n' | b'\r') => {
                    if byte == b'\r' && self.peek()? == Some(b'\n') {
                        self.next += 1;
                    }
                    record.close(&mut cell);
                    self.line += 1;
                    break;
                }
                (_, _) => {
                    if at == At::QuoteSeen {
                        record.stray.get_or_insert(record.cells.len());
                    }
                    record.push(&mut cell, byte);
                    at = At::Bare;
                }
            }
        }
        record.lines = (self.line - record.line).max(1);
        Ok(Some(record))
    }

    fn byte(&mut self) -> Result<Option<u8>, Fault> {
        let byte = self.peek()?;
        self.next += usize::from(byte.is_some());
        Ok(byte)
    }

    fn peek(&mut self) -> Result<Option<u8>, Fault> {
        while self.next >= self.buffer.len() && !self.ended {
            self.fill()?;
        }
        Ok(self.buffer.get(self.next).copied())
    }

    fn fill(&mut self) -> Result<(), Fault> {
        self.buffer.drain(..self.start);
        self.next -= self.start;
        self.start = 0;
        let before = self.buffer.len();
        self.source.by_ref().take(CHUNK as u64).read_to_end(&mut self.buffer)?;
        let got = self.buffer.len() - before;
        self.read += got as u64;
        self.ended = got == 0;
        if self.read > MAX_FILE_BYTES { Err(Fault::TooLarge) } else { Ok(()) }
    }
}

impl Record {
    fn push(&mut self, cell: &mut Vec<u8>, byte: u8) {
        if cell.len() < MAX_CELL_BYTES {
            cell.push(byte);
        } else if self.cut.is_none() {
            self.cut = Some(self.cells.len());
        }
    }

    fn close(&mut self, cell: &mut Vec<u8>) {
        let text = String::from_utf8(std::mem::take(cell)).unwrap_or_else(|error| {
            self.not_text.get_or_insert(self.cells.len());
            String::from_utf8_lossy(error.as_bytes()).into_owned()
        });
        self.cells.push(text);
    }
}
