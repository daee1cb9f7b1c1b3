//! Messages as bytes, in postcard's form: fields stand in order without names, which makes the code that reads and
//! writes them half as large as JSON's, in page and engines alike. The version comes first and is looked at first,
//! since nothing else can be read without knowing it.

use super::message::{Envelope, VERSION};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Why bytes are no message.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum WireError {
    /// They come from a program of another version.
    #[error("page and engine are of different versions: load the page again")]
    Version,
    /// They are cut short, or something else altogether.
    #[error("the bytes are no message")]
    Malformed,
}

/// What makes messages of bytes.
pub type Reader<T> = fn(&[u8]) -> Result<Envelope<T>, WireError>;

/// A message as bytes.
///
/// # Errors
/// When a part has no such form, which none of the protocol's lacks.
pub fn encode<T: Serialize>(envelope: &Envelope<T>) -> Result<Vec<u8>, WireError> {
    postcard::to_allocvec(envelope).map_err(|_| WireError::Malformed)
}

/// The message that bytes are.
///
/// # Errors
/// When they are of another version, or no message.
pub fn decode<T: DeserializeOwned>(bytes: &[u8]) -> Result<Envelope<T>, WireError> {
    read(bytes)
}

/// Reads what begins with the version.
pub(super) fn read<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, WireError> {
    match postcard::take_from_bytes::<u32>(bytes) {
        Ok((VERSION, _)) => postcard::from_bytes(bytes).map_err(|_| WireError::Malformed),
        Ok(_) => Err(WireError::Version),
        Err(_) => Err(WireError::Malformed),
    }
}
