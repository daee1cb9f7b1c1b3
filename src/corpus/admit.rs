//! What is taken of a file, whatever its form: which rows, which commands, and what is no corpus at all.

use super::example::MAX_COMMAND_CHARS;

pub(super) const EMPTY: &str = "the file is empty; it needs a header and a row for each command";

/// What to read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Keep rows that were rejected.
    pub with_rejected: bool,
}

/// Whether a command can be kept.
pub(super) fn check_command(command: &str) -> Result<(), String> {
    let length = command.chars().count();
    if command.is_empty() {
        return Err("the command is empty; say what the robot should do, or delete the row".into());
    }
    if length > MAX_COMMAND_CHARS {
        return Err(format!(
            "the command has {length} characters, more than {MAX_COMMAND_CHARS}; shorten it"
        ));
    }
    Ok(())
}

/// The file's own reason to be no corpus, from its first bytes.
pub(super) fn not_a_corpus(head: &[u8]) -> Option<&'static str> {
    match head {
        [] => Some(EMPTY),
        [b'P', b'K', 3, 4, ..] => {
            Some("this is a spreadsheet or a zip file; save it as CSV in UTF-8")
        }
        [0xFF, 0xFE, ..] | [0xFE, 0xFF, ..] => Some("this is UTF-16 text; save it as CSV in UTF-8"),
        _ if head.contains(&0) => Some("this is not a text file; a corpus is CSV or JSON lines"),
        _ if head.trim_ascii().is_empty() => Some(EMPTY),
        _ => None,
    }
}
