//! Splits JSON into its objects, from any byte stream, in steps: one a line, one list of them, or one after another
//! with line breaks inside. An object that is broken costs itself: reading goes on at the next line that begins as it
//! did.

use super::limits::{MAX_DEPTH, MAX_FILE_BYTES, MAX_OBJECT_BYTES};
use super::source::{Source, Unreadable};
use std::io::Read;

/// What a step comes to.
#[derive(Debug)]
pub(super) enum Item {
    /// There is more to do.
    Working,
    /// What stands where an object should, and the line where it begins.
    Text(u64, Vec<u8>),
    /// What begins in this line is no object, and why; it as it stands in the file.
    Broken(u64, String, Vec<u8>),
    /// There are no more.
    Over,
}

/// How the objects stand.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Layout {
    /// It is not known yet, but that the first of them is over.
    Unknown { is_over: bool },
    /// One a line.
    Lines,
    /// Anyhow.
    Free,
}

/// Where in the file the reader is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum At {
    /// Between objects.
    Between,
    /// In a line that is taken whole.
    Line,
    /// In an object, between its strings.
    Object,
    /// In a string, perhaps behind a backslash.
    String { is_escaped: bool },
    /// In what is broken: to the end of the line.
    Behind,
    /// In what is broken: to a line that begins as the object did.
    Seeking,
}

/// A reader of objects.
pub(super) struct Items<R> {
    source: Source<R>,
    layout: Layout,
    is_list: bool,
    at: At,
    /// Where in the buffer the object begins, and the next byte to look at.
    start: usize,
    next: usize,
    line: u64,
    start_line: u64,
    /// White space at the beginning of the line so far; nothing once something else stood there.
    indent: Option<usize>,
    /// That of the object, if it begins a line.
    start_indent: Option<usize>,
    open: Vec<u8>,
    /// Where reading could go on if the object is never closed: offset from `start`, and line.
    resume: Option<(usize, u64)>,
    /// Bytes that were gone back over.
    again: u64,
}

impl<R: Read> Items<R> {
    /// A reader at the beginning of a file.
    pub(super) fn new(source: Source<R>) -> Self {
        Items {
            source,
            layout: Layout::Unknown { is_over: false },
            is_list: false,
            at: At::Between,
            start: 0,
            next: 0,
            line: 1,
            start_line: 1,
            indent: Some(0),
            start_indent: None,
            open: Vec::new(),
            resume: None,
            again: 0,
        }
    }

    /// Bytes of the file that were taken so far, for progress.
    pub(super) fn bytes(&self) -> u64 {
        self.source.taken()
    }

    /// Goes on by a bounded part: to the end of an object, or of what is in the buffer.
    pub(super) fn step(&mut self) -> Result<Item, Unreadable> {
        loop {
            let Some(&byte) = self.source.buffer.get(self.next) else {
                if self.source.ended {
                    return Ok(self.end());
                }
                let is_inside = matches!(self.at, At::Line | At::Object | At::String { .. });
                let done = if is_inside { self.start } else { self.next };
                self.source.fill(done)?;
                self.next -= done;
                self.start = self.start.saturating_sub(done);
                return Ok(Item::Working);
            };
            let found = self.take(byte);
            if let Some(item) = found {
                return Ok(item);
            }
        }
    }

    /// Takes the next byte.
    fn take(&mut self, byte: u8) -> Option<Item> {
        let indent = self.indent;
        match byte {
            b'\n' => self.indent = Some(0),
            b' ' | b'\t' | b'\r' => self.indent = indent.map(|n| n + 1),
            _ => self.indent = None,
        }
        if self.at == At::Between && !byte.is_ascii_whitespace() && byte != b',' {
            match byte {
                b'[' if self.layout == (Layout::Unknown { is_over: false }) && !self.is_list => {
                    self.is_list = true;
                }
                b']' if self.is_list => {}
                _ => return self.begin(byte, indent),
            }
        }
        if self.at == At::Seeking && byte == b'{' && indent.is_some() && indent == self.start_indent
        {
            self.at = At::Between;
            return self.begin(byte, indent);
        }
        self.next += 1;
        self.line += u64::from(byte == b'\n');
        match (self.at, byte) {
            (At::Between, b'\n') if self.layout == (Layout::Unknown { is_over: true }) => {
                self.layout = if self.is_list { Layout::Free } else { Layout::Lines };
            }
            (At::Behind, b'\n') => self.at = At::Between,
            (At::Line, b'\n') => return Some(self.end_object()),
            (At::Object, b'"') => self.at = At::String { is_escaped: false },
            (At::Object, b'{' | b'[') => {
                if byte == b'{'
                    && self.resume.is_none()
                    && indent.is_some()
                    && indent == self.start_indent
                    && self.line > self.start_line
                {
                    let begin = self.next - 1 - indent.unwrap_or(0);
                    self.resume = Some((begin - self.start, self.line));
                }
                self.open.push(byte);
                if self.open.len() > MAX_DEPTH {
                    return Some(self.give_up("it is nested too deeply"));
                }
            }
            (At::Object, b'}' | b']') => {
                let fits =
                    matches!((self.open.pop(), byte), (Some(b'{'), b'}') | (Some(b'['), b']'));
                if !fits {
                    return Some(self.give_up("a bracket closes what is not open"));
                }
                if self.open.is_empty() {
                    return Some(self.end_object());
                }
            }
            (At::String { .. }, b'\n') => {
                return Some(self.give_up("a quote is never closed in its line"));
            }
            (At::String { is_escaped: true }, _) => self.at = At::String { is_escaped: false },
            (At::String { .. }, b'\\') => self.at = At::String { is_escaped: true },
            (At::String { .. }, b'"') => self.at = At::Object,
            _ => {}
        }
        let is_inside = matches!(self.at, At::Line | At::Object | At::String { .. });
        (is_inside && self.next - self.start > MAX_OBJECT_BYTES)
            .then(|| self.give_up(&format!("it is larger than {} MB", MAX_OBJECT_BYTES >> 20)))
    }

    /// Something begins.
    fn begin(&mut self, byte: u8, indent: Option<usize>) -> Option<Item> {
        (self.start, self.start_line, self.start_indent) = (self.next, self.line, indent);
        self.open.clear();
        self.resume = None;
        if self.layout == (Layout::Unknown { is_over: true }) {
            self.layout = Layout::Free;
        }
        self.next += 1;
        match byte {
            b'{' if self.layout != Layout::Lines => {
                self.open.push(byte);
                self.at = At::Object;
            }
            _ => self.at = At::Line,
        }
        None
    }

    /// An object, or a line that is taken for one, is over.
    fn end_object(&mut self) -> Item {
        let text = self.source.buffer.get(self.start..self.next).unwrap_or_default();
        let text = text.trim_ascii();
        let text = if self.at == At::Line { text.strip_suffix(b",").unwrap_or(text) } else { text };
        if self.layout == (Layout::Unknown { is_over: false }) {
            let is_line = self.start_line == self.line && !self.is_list;
            self.layout = if is_line { Layout::Unknown { is_over: true } } else { Layout::Free };
        }
        self.at = At::Between;
        Item::Text(self.start_line, text.to_vec())
    }

    /// The object cannot be one: reading goes on where the next one may begin.
    fn give_up(&mut self, why: &str) -> Item {
        let line = self.start_line;
        let end = self.resume.map_or(self.next, |(offset, _)| self.start + offset);
        let raw = self.source.buffer.get(self.start..end).unwrap_or_default().to_vec();
        let was_line_end = self.source.buffer.get(self.next - 1) == Some(&b'\n');
        let far = (self.next - self.start) as u64;
        if let Some((offset, at)) =
            self.resume.take().filter(|_| self.again + far <= MAX_FILE_BYTES)
        {
            self.again += far;
            (self.next, self.line) = (self.start + offset, at);
            self.indent = Some(0);
            self.at = At::Between;
        } else if self.layout != Layout::Lines && self.start_indent.is_some() {
            self.at = At::Seeking;
        } else {
            self.at = if was_line_end { At::Between } else { At::Behind };
        }
        Item::Broken(line, why.to_owned(), raw)
    }

    /// The file is over.
    fn end(&mut self) -> Item {
        match self.at {
            At::Line => self.end_object(),
            At::Object | At::String { .. } => self.give_up("it is never closed"),
            At::Between | At::Behind | At::Seeking => Item::Over,
        }
    }
}
