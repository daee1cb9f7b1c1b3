//! Bytes of a file that may be packed (gzip, RFC 1952), which its first bytes say. A packed file may have several
//! members, and zeros behind each, as programs that join, index or pad files make them: all are read, or none.

use super::limits::MAX_EMPTY_MEMBERS;
use flate2::bufread::GzDecoder;
use std::io::{self, BufRead, BufReader, Chain, Cursor, Error, ErrorKind, Read};

/// The first bytes of a packed file.
pub(super) const MAGIC: [u8; 2] = [0x1F, 0x8B];

/// A stream that counts, with what was looked at of it put back.
pub(super) struct Counted<R> {
    stream: Chain<Cursor<Vec<u8>>, R>,
    taken: u64,
}

impl<R: Read> Read for Counted<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let got = self.stream.read(into)?;
        self.taken += got as u64;
        Ok(got)
    }
}

/// The bytes of a file, unpacked.
pub(super) enum Stream<R> {
    /// They are as they stand.
    Plain(Counted<R>),
    /// They were packed.
    Packed(Box<Packed<R>>),
}

/// A packed file on its way.
pub(super) struct Packed<R> {
    place: Place<R>,
    /// Members in a row that held nothing.
    empty: usize,
}

enum Place<R> {
    /// In a member.
    Inside(GzDecoder<BufReader<Counted<R>>>),
    /// Behind one, or behind zeros.
    Between(BufReader<Counted<R>>),
    /// At the end, so many bytes behind the beginning.
    Over(u64),
}

impl<R: Read> Stream<R> {
    /// The bytes of a stream, which is packed if it begins so.
    pub(super) fn new(mut stream: R) -> io::Result<Self> {
        let mut head = Vec::new();
        stream.by_ref().take(MAGIC.len() as u64).read_to_end(&mut head)?;
        let is_packed = head == MAGIC;
        let counted = Counted { stream: Cursor::new(head).chain(stream), taken: 0 };
        Ok(if is_packed {
            let place = Place::Between(BufReader::new(counted));
            Stream::Packed(Box::new(Packed { place, empty: 0 }))
        } else {
            Stream::Plain(counted)
        })
    }

    /// Whether it is packed.
    pub(super) fn is_packed(&self) -> bool {
        matches!(self, Stream::Packed(_))
    }

    /// Bytes of the file that were taken so far, packed as they are.
    pub(super) fn taken(&self) -> u64 {
        match self {
            Stream::Plain(counted) => counted.taken,
            Stream::Packed(packed) => match &packed.place {
                Place::Inside(member) => member.get_ref().get_ref().taken,
                Place::Between(stream) => stream.get_ref().taken,
                Place::Over(taken) => *taken,
            },
        }
    }
}

impl<R: Read> Read for Stream<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        match self {
            Stream::Plain(counted) => counted.read(into),
            Stream::Packed(packed) => packed.read(into),
        }
    }
}

impl<R: Read> Read for Packed<R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        loop {
            self.place = match std::mem::replace(&mut self.place, Place::Over(0)) {
                Place::Over(taken) => {
                    self.place = Place::Over(taken);
                    return Ok(0);
                }
                Place::Inside(mut member) => {
                    let got = member.read(into)?;
                    if got > 0 || into.is_empty() {
                        (self.place, self.empty) = (Place::Inside(member), 0);
                        return Ok(got);
                    }
                    Place::Between(member.into_inner())
                }
                Place::Between(mut stream) => match stream.fill_buf()? {
                    [] => Place::Over(stream.get_ref().taken),
                    [0, rest @ ..] => {
                        let zeros = 1 + rest.iter().take_while(|&&byte| byte == 0).count();
                        stream.consume(zeros);
                        Place::Between(stream)
                    }
                    [first, ..] if *first == MAGIC[0] && self.empty < MAX_EMPTY_MEMBERS => {
                        self.empty += 1;
                        Place::Inside(GzDecoder::new(stream))
                    }
                    _ => return Err(Error::from(ErrorKind::InvalidData)),
                },
            };
        }
    }
}
