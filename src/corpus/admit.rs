//! What is taken of a file, whatever its form: which rows, which commands, what counts as nothing, and what is no
//! corpus at all.

use super::example::Decision;
use super::flaw::Wrong;
use super::limits::MAX_COMMAND_CHARS;
use super::mapping::Mapping;

/// What to read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Keep rows that were rejected.
    pub with_rejected: bool,
    /// Which column says what, where the names do not tell.
    pub mapping: Mapping,
}

/// What programs write where there is nothing: R, pandas, spreadsheets, databases.
const NOTHING: [&str; 9] = ["", "na", "n/a", "nan", "null", "none", "#n/a", "<na>", "undefined"];

/// The text without the white space around it, unless it is a mark of nothing.
pub(super) fn something(text: &str) -> Option<&str> {
    let text = text.trim();
    let nothing = NOTHING.iter().any(|mark| text.eq_ignore_ascii_case(mark));
    (!nothing).then_some(text)
}

/// What was decided of a row: it is rejected by its status, or by the reason that was given; approved by its status, or
/// by a mark.
pub(super) fn decision(
    status: Option<&str>,
    approve: Option<&str>,
    reason: Option<&str>,
) -> Decision {
    let reason = reason.and_then(something);
    let says = |word: &str| status.is_some_and(|status| status.trim().eq_ignore_ascii_case(word));
    if says("rejected") || reason.is_some() {
        Decision::Rejected(reason.unwrap_or_default().into())
    } else if says("approved") || approve.and_then(something).is_some() {
        Decision::Approved
    } else {
        Decision::Open
    }
}

/// The command of a row, if it can be kept. A word has a letter or a digit, as for those who read it.
///
/// # Errors
/// Why no corpus keeps it.
pub fn command(text: Option<&str>) -> Result<String, Wrong> {
    let Some(command) = text.and_then(something) else {
        return Err(Wrong::with_mend(
            "the command is empty",
            "say what the robot should do, or delete the row",
        ));
    };
    let length = command.chars().count();
    if length > MAX_COMMAND_CHARS {
        let what = format!("the command has {length} characters, more than {MAX_COMMAND_CHARS}");
        return Err(Wrong::with_mend(what, "shorten it"));
    }
    if !command.contains(char::is_alphanumeric) {
        return Err(Wrong {
            snippet: Some(super::flaw::cut(command, 20)),
            ..Wrong::with_mend(
                "the command has no word",
                "say what the robot should do, or delete the row",
            )
        });
    }
    Ok(command.to_owned())
}

/// That there is nothing to read.
pub(super) fn empty() -> Wrong {
    Wrong::with_mend("the file is empty", "it needs a header and a row for each command, or JSON")
}

/// The file's own reason to be no corpus, from its first bytes; those of a text are UTF-8 by now.
pub(super) fn not_a_corpus(head: &[u8]) -> Option<Wrong> {
    let wrong = |what: &str, mend: &str| Some(Wrong::with_mend(what, mend));
    match head {
        [b'P', b'K', 3, 4, ..] => {
            wrong("this is a spreadsheet or a zip file", "save it as CSV in UTF-8")
        }
        [0x1F, 0x8B, ..] => wrong("this file is packed twice", "unpack it once"),
        [0xD0, 0xCF, 0x11, 0xE0, ..] => {
            wrong("this is an old spreadsheet", "save it as CSV in UTF-8")
        }
        _ if head.contains(&0) => {
            wrong("this is not a text file", "a corpus is CSV or JSON, in UTF-8")
        }
        _ => None,
    }
}
