//! JSON of an outside text, with what is wrong named by its place, and the known word that a strange one may be.

use super::flaw::{Wrong, cut, cut_quoted};
use super::limits::MAX_CELL_BYTES;
use serde::de::DeserializeOwned;

/// Reads any JSON text, naming the place of what is wrong.
///
/// # Errors
/// What is wrong, where in the text, and what to mend.
pub fn json<T: DeserializeOwned>(text: &str) -> Result<T, Wrong> {
    if text.trim().is_empty() {
        return Err(Wrong::with_mend("the cell is empty", "it must hold JSON"));
    }
    if text.len() > MAX_CELL_BYTES {
        return Err(Wrong::from(format!("the cell is larger than {} MB", MAX_CELL_BYTES >> 20)));
    }
    whole_json(text)
}

/// The same for a text that is a file of its own, and may be larger.
///
/// # Errors
/// What is wrong, where in the text, and what to mend.
pub fn whole_json<T: DeserializeOwned>(text: &str) -> Result<T, Wrong> {
    let mut reader = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
        let path = error.path().to_string();
        explain(text, &path, error.inner())
    })?;
    reader.end().map_err(|error| explain(text, ".", &error))?;
    Ok(value)
}

/// The candidate that is nearest to `word` by edits, if one is near.
pub fn did_you_mean<'a>(
    word: &str,
    candidates: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    candidates
        .into_iter()
        .map(|candidate| (strsim::damerau_levenshtein(word, candidate), candidate))
        .filter(|(distance, candidate)| *distance <= 1 + candidate.chars().count() / 4)
        .min()
        .map(|(_, candidate)| candidate)
}

fn explain(text: &str, path: &str, error: &serde_json::Error) -> Wrong {
    let offset = offset(text, error.line(), error.column());
    let character = text.get(..offset).unwrap_or(text).chars().count().max(1);
    let full = error.to_string();
    let detail = full.split(" at line ").next().unwrap_or(&full);
    if error.is_syntax() || error.is_eof() {
        let near: String = text.chars().skip(character.saturating_sub(12)).take(24).collect();
        // As Python prints what it has read.
        let mend = text.trim_start().starts_with("{'").then(|| "write it as JSON does".to_owned());
        let what =
            format!("not JSON: {}, at character {character} of the cell", cut_quoted(detail));
        return Wrong { snippet: Some(near), mend, ..Wrong::from(what) };
    }
    let at = if path == "." { "the top".to_owned() } else { cut(path, 80) };
    let mend = unknown_word(detail).map(|(word, near)| format!("did you mean {near} for {word}?"));
    let what = format!("{}, at {at}, character {character}", cut_quoted(detail));
    Wrong { mend, ..Wrong::from(what) }
}

/// The word that a message of the world's closed sets refuses, and the known one nearest to it.
fn unknown_word(detail: &str) -> Option<(&str, &str)> {
    let rest = detail.strip_prefix("unknown ")?;
    let word = rest.split('`').nth(1)?;
    let known = rest.rsplit_once("use one of ")?.1.split(", ");
    did_you_mean(word, known).map(|near| (word, near))
}

/// The byte offset of a line and a column that serde_json names (both from 1, the column in bytes).
fn offset(text: &str, line: usize, column: usize) -> usize {
    let before: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    let mut offset = (before + column).min(text.len());
    while !text.is_char_boundary(offset) {
        offset -= 1;
    }
    offset
}
