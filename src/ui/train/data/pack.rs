//! A corpus as one file, as it is kept: a line of JSON that says what follows, and then the bytes of its files as they
//! were given. Dropped on the page it is opened like the files themselves.

use crate::domain::misread;
use crate::worker::protocol::{CorpusFile, MappedFile, Mapping};
use serde::{Deserialize, Serialize};

/// What such a file calls itself.
const FORMAT: &str = "groundling corpus";
/// The version of its form.
const VERSION: u32 = 1;
/// What it begins with.
const HEAD: &[u8] = b"{\"format\":\"groundling corpus\"";

/// A corpus with what was decided of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Pack {
    /// Its files.
    pub files: Vec<MappedFile>,
    /// Whether rows that were rejected are used.
    pub with_rejected: bool,
    /// What was decided of its rows, in the engine's words, if anything was.
    pub decisions: Option<String>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Head {
    format: String,
    version: u32,
    with_rejected: bool,
    decisions: Option<String>,
    files: Vec<Part>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Part {
    name: String,
    bytes: usize,
    mapping: Mapping,
}

/// Whether bytes are such a file.
pub fn is_pack(bytes: &[u8]) -> bool {
    bytes.starts_with(HEAD)
}

/// Some files as one.
pub fn write(files: &[MappedFile], with_rejected: bool, decisions: Option<String>) -> Vec<u8> {
    let part = |MappedFile { file, mapping }: &MappedFile| Part {
        name: file.name.clone(),
        bytes: file.bytes.len(),
        mapping: mapping.clone(),
    };
    let files_in = files.iter().map(part).collect();
    let head = Head {
        format: FORMAT.to_owned(),
        version: VERSION,
        with_rejected,
        decisions,
        files: files_in,
    };
    // Strings and numbers only: JSON can hold them all.
    let mut bytes = serde_json::to_vec(&head).unwrap_or_default();
    bytes.push(b'\n');
    files.iter().for_each(|one| bytes.extend_from_slice(&one.file.bytes));
    bytes
}

/// The corpus that bytes are.
///
/// # Errors
/// In words, what is wrong with them.
pub fn read(bytes: &[u8]) -> Result<Pack, String> {
    let end = bytes.iter().position(|&byte| byte == b'\n').ok_or("its first line is cut off")?;
    let (head, mut rest) = bytes.split_at(end);
    rest = rest.get(1..).unwrap_or_default();
    let head: Head = misread::read(&String::from_utf8_lossy(head))?;
    if head.format != FORMAT || head.version != VERSION {
        return Err(format!("it is no file of {FORMAT:?}, version {VERSION}"));
    }
    let mut files = Vec::new();
    for Part { name, bytes, mapping } in head.files {
        let (own, others) = rest.split_at_checked(bytes).ok_or(format!("{name} is cut off"))?;
        files.push(MappedFile { file: CorpusFile { name, bytes: own.to_vec().into() }, mapping });
        rest = others;
    }
    Ok(Pack { files, with_rejected: head.with_rejected, decisions: head.decisions })
}
