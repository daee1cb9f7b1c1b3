//! JSON of an outside text, with what is wrong named by its place, and the known word that a strange one may be.

use super::flaw::{Wrong, cut, cut_quoted};
use super::limits::MAX_CELL_BYTES;
use crate::domain::misread::{in_words, is_broken};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

/// Reads any JSON text, naming the place of what is wrong.
///
/// # Errors
/// What is wrong, where in the text, and what to mend.
pub fn json<'a, T: Deserialize<'a>>(text: &'a str) -> Result<T, Wrong> {
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
pub fn whole_json<'a, T: Deserialize<'a>>(text: &'a str) -> Result<T, Wrong> {
    let mut reader = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
        let path = error.path().to_string();
        explain(text, &path, error.inner())
    })?;
    reader.end().map_err(|error| explain(text, ".", &error))?;
    Ok(value)
}

/// The same for a value that has been read.
///
/// # Errors
/// What is wrong, where in the value, and what to mend.
pub fn of_value<T: DeserializeOwned>(value: Value) -> Result<T, Wrong> {
    serde_path_to_error::deserialize(value).map_err(|error| {
        let (path, what) = (error.path().to_string(), in_words(error.inner(), false));
        misfit(&cut_quoted(&what), &path, None)
    })
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
    let is_broken = is_broken(text, error);
    let detail = cut_quoted(&in_words(error, is_broken));
    if is_broken {
        let near: String = text.chars().skip(character.saturating_sub(12)).take(24).collect();
        // As Python prints what it has read.
        let mend = text.trim_start().starts_with("{'").then(|| "write it as JSON does".to_owned());
        let what = format!("not JSON: {detail}, at character {character}");
        return Wrong { snippet: Some(near), mend, ..Wrong::from(what) };
    }
    misfit(&detail, path, Some(character))
}

/// What is wrong with JSON that is not what is wanted.
fn misfit(what: &str, path: &str, character: Option<usize>) -> Wrong {
    let at = if path == "." { "the top".to_owned() } else { cut(path, 80) };
    let place = character.map_or(String::new(), |character| format!(", character {character}"));
    let mend = unknown_word(what).map(|(word, near)| format!("did you mean {near} for {word}?"));
    Wrong { mend, ..Wrong::from(format!("{what}, at {at}{place}")) }
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
