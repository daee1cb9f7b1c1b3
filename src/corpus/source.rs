//! A file's bytes as UTF-8, a chunk at a time, from any byte stream: a byte-order mark is skipped, UTF-16 that begins
//! with its mark is turned into UTF-8. Whoever reads keeps what it has not done with, and takes the next chunk when it
//! wants one, so that reading goes in bounded steps.

use super::flaw::Wrong;
use super::limits::MAX_FILE_BYTES;
use super::packed::Stream;
use std::io::Read;

/// Bytes that a step takes.
const CHUNK: usize = 64 << 10;

/// Why a file cannot be read to its end; none of it is used then.
#[derive(Debug, thiserror::Error)]
pub enum Unreadable {
    /// The stream failed.
    #[error("the file could not be read: {0}")]
    Io(#[from] std::io::Error),
    /// It is packed, and what is packed is cut short, damaged or followed by something else.
    #[error("this gzip file is cut short or damaged")]
    Damaged,
    /// It is too large.
    #[error("the file is larger than {} MB", MAX_FILE_BYTES >> 20)]
    TooLarge,
    /// It is packed, and too large.
    #[error("the file unpacks to more than {} MB", MAX_FILE_BYTES >> 20)]
    UnpacksTooLarge,
}

impl Unreadable {
    /// It in words, with what to do.
    pub(super) fn wrong(&self) -> Wrong {
        match self {
            Unreadable::Io(_) => Wrong::from(self.to_string()),
            Unreadable::Damaged => {
                Wrong::with_mend(self.to_string(), "pack it anew, or give the file unpacked")
            }
            Unreadable::TooLarge | Unreadable::UnpacksTooLarge => {
                Wrong::with_mend(self.to_string(), "split it, and give all parts")
            }
        }
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Encoding {
    Utf8,
    Utf16 { big_endian: bool },
}

/// A file that is being read.
pub(super) struct Source<R> {
    stream: Stream<R>,
    encoding: Encoding,
    /// Bytes of UTF-16 that make no character yet.
    raw: Vec<u8>,
    /// What was read and not yet let go of, in UTF-8 as far as the file is text.
    pub(super) buffer: Vec<u8>,
    /// Bytes read so far, unpacked.
    bytes: u64,
    /// Whether there is no more to come.
    pub(super) ended: bool,
}

impl<R: Read> Source<R> {
    /// The beginning of a stream, with some of it in the buffer.
    pub(super) fn new(stream: R) -> Result<Self, Unreadable> {
        let mut source = Source {
            stream: Stream::new(stream)?,
            encoding: Encoding::Utf8,
            raw: Vec::new(),
            buffer: Vec::new(),
            bytes: 0,
            ended: false,
        };
        while !source.ended && source.buffer.len() < 512 {
            source.fill(0)?;
        }
        let mark = match source.buffer.as_slice() {
            [0xEF, 0xBB, 0xBF, ..] => 3,
            [0xFF, 0xFE, ..] => 2,
            [0xFE, 0xFF, ..] => 2,
            _ => 0,
        };
        if mark == 2 {
            source.encoding = Encoding::Utf16 { big_endian: source.buffer[0] == 0xFE };
            source.raw = source.buffer.split_off(mark);
            source.buffer.clear();
            source.decode();
        } else {
            source.buffer.drain(..mark);
        }
        Ok(source)
    }

    /// Lets go of the first `done` bytes of the buffer, and takes the next chunk.
    pub(super) fn fill(&mut self, done: usize) -> Result<(), Unreadable> {
        self.buffer.drain(..done);
        let into = if self.encoding == Encoding::Utf8 { &mut self.buffer } else { &mut self.raw };
        let before = into.len();
        let read = self.stream.by_ref().take(CHUNK as u64).read_to_end(into);
        read.map_err(
            |error| if self.stream.is_packed() { Unreadable::Damaged } else { error.into() },
        )?;
        let got = into.len() - before;
        self.bytes += got as u64;
        self.ended = got == 0;
        if self.bytes > MAX_FILE_BYTES {
            let is_packed = self.stream.is_packed();
            return Err(if is_packed { Unreadable::UnpacksTooLarge } else { Unreadable::TooLarge });
        }
        if self.encoding != Encoding::Utf8 {
            self.decode();
        }
        Ok(())
    }

    /// Bytes of the file that were taken so far, packed as they are.
    pub(super) fn taken(&self) -> u64 {
        self.stream.taken()
    }

    /// Turns the UTF-16 that is there into UTF-8; half a character waits for the rest.
    fn decode(&mut self) {
        let Encoding::Utf16 { big_endian } = self.encoding else { return };
        let unit = if big_endian { u16::from_be_bytes } else { u16::from_le_bytes };
        let mut whole = self.raw.len() & !1;
        let is_high = |unit: u16| (0xD800..0xDC00).contains(&unit);
        if whole > 0 && !self.ended && is_high(unit([self.raw[whole - 2], self.raw[whole - 1]])) {
            whole -= 2;
        }
        let text = utf_16(&self.raw[..whole], unit);
        self.buffer.extend_from_slice(text.as_bytes());
        self.raw.drain(..whole);
    }
}

/// A file's bytes as text, for files that are read whole: without a byte-order mark, UTF-16 with its mark as well.
///
/// # Errors
/// The line, from 1, where the first byte stands that is no text.
pub fn text_of(bytes: Vec<u8>) -> Result<String, usize> {
    let bytes = match bytes.as_slice() {
        [0xFF, 0xFE, rest @ ..] => utf_16(rest, u16::from_le_bytes).into_bytes(),
        [0xFE, 0xFF, rest @ ..] => utf_16(rest, u16::from_be_bytes).into_bytes(),
        [0xEF, 0xBB, 0xBF, rest @ ..] => rest.to_vec(),
        _ => bytes,
    };
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        1 + error.as_bytes().iter().take(at).filter(|byte| **byte == b'\n').count()
    })
}

/// Whole units of UTF-16 as text; what makes no character is marked.
fn utf_16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> String {
    let (units, _) = bytes.as_chunks();
    let units = units.iter().map(|&pair| unit(pair));
    char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
}
