//! Files that a person gives the page: what they are, and which are refused before they are read.

/// The largest file that is read: 64 MiB.
pub const MAX_BYTES: f64 = 67_108_864.0;

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A corpus: batch-results CSV or JSON.
    Corpus,
    /// A model.
    Model,
    /// All of a talk, as this page saves it.
    Session,
}

/// Why a file cannot be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// There is nothing in it.
    Empty,
    /// It is larger than [`MAX_BYTES`].
    TooLarge,
    /// The browser cannot get at it.
    Unreadable,
    /// It is not UTF-8, first in this line.
    NotText(usize),
}

/// A file that a person gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Offered {
    /// Its name.
    pub name: String,
    /// Its bytes, or why it cannot be read.
    pub bytes: Result<Vec<u8>, Fault>,
}

/// A text that a person gives to the robot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Given {
    /// A model.
    Model(String),
    /// All of a talk.
    Session(String),
}

/// Refuses a file by its size in bytes.
///
/// # Errors
/// When it is empty or too large.
pub fn admit(bytes: f64) -> Result<(), Fault> {
    match bytes {
        bytes if bytes <= 0.0 => Err(Fault::Empty),
        bytes if bytes > MAX_BYTES => Err(Fault::TooLarge),
        _ => Ok(()),
    }
}

/// What a file is: a session and a model say so in their first line, anything else is taken for a corpus.
pub fn kind(name: &str, bytes: &[u8]) -> Kind {
    let start = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes).trim_ascii_start();
    if start.starts_with(b"{\"groundling-session\"") {
        return Kind::Session;
    }
    let named = name.rsplit_once('.').is_some_and(|(_, end)| end.eq_ignore_ascii_case("model"));
    if named || start.starts_with(b"groundling") { Kind::Model } else { Kind::Corpus }
}

/// What a file gives to the robot; nothing when it is neither a model nor a session.
///
/// # Errors
/// When it is not UTF-8.
pub fn given(name: &str, bytes: Vec<u8>) -> Result<Option<Given>, Fault> {
    let given = match kind(name, &bytes) {
        Kind::Corpus => return Ok(None),
        Kind::Model => Given::Model,
        Kind::Session => Given::Session,
    };
    text(bytes).map(given).map(Some)
}

/// The text of a file that is read whole, without its byte-order mark.
///
/// # Errors
/// When it is not UTF-8.
fn text(mut bytes: Vec<u8>) -> Result<String, Fault> {
    if bytes.starts_with(b"\xEF\xBB\xBF") {
        bytes.drain(..3);
    }
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        Fault::NotText(1 + error.as_bytes().iter().take(at).filter(|b| **b == b'\n').count())
    })
}
