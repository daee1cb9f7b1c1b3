//! States out of JSON, and whether two of them make a demonstration. What is wrong is said by its place inside
//! the cell. The state before must be legal; the state after may be odd, since people's data is.

use super::example::Pair;
use super::flaw::{Wrong, cut, cut_quoted};
use super::limits::MAX_CELL_BYTES;
use crate::domain::{Bounds, State};
use serde::de::DeserializeOwned;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Reads a state before a demonstration.
///
/// # Errors
/// What is wrong, where in the text, and what to mend.
pub fn before(text: &str) -> Result<State, Wrong> {
    let state: State = json(&unwrapped(text))?;
    state.check().map_err(|error| Wrong::from(error.to_string()))?;
    Ok(state)
}

/// Reads a state after a demonstration, and what is odd in it: things that share a cell.
///
/// # Errors
/// What is wrong, where in the text, and what to mend.
pub fn after(text: &str) -> Result<(State, Vec<String>), Wrong> {
    let state: State = json(&unwrapped(text))?;
    let shared = state.check_after().map_err(|error| Wrong::from(error.to_string()))?;
    let odd = |error: &dyn std::fmt::Display| format!("{error} (kept, since it is a state after)");
    Ok((state, shared.iter().map(|error| odd(error)).collect()))
}

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
    let mut reader = serde_json::Deserializer::from_str(text);
    let value = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
        let path = error.path().to_string();
        explain(text, &path, error.inner())
    })?;
    reader.end().map_err(|error| explain(text, ".", &error))?;
    Ok(value)
}

/// The JSON of a state that a program has put into a string; any other text as it is.
fn unwrapped(text: &str) -> Cow<'_, str> {
    let inner = text.trim().starts_with('"').then(|| serde_json::from_str(text).ok()).flatten();
    inner.map_or(Cow::Borrowed(text), Cow::Owned)
}

/// Which state of a demonstration a flaw is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "before and after")]
pub enum Moment {
    Before,
    After,
}

/// A demonstration of two cells; every flaw and oddity goes to `flaw`. `None` when it cannot be used.
pub fn demonstration(pre: &str, post: &str, mut flaw: impl FnMut(Moment, Wrong)) -> Option<Pair> {
    let before = before(pre).map_err(|error| flaw(Moment::Before, error));
    let after = after(post).map_err(|error| flaw(Moment::After, error));
    let (Ok(before), Ok((after, mut said))) = (before, after) else { return None };
    let (pair, more) = match pair(before, after) {
        Ok((pair, oddities)) => (Some(pair), oddities),
        Err(errors) => (None, errors),
    };
    said.extend(more);
    said.into_iter().for_each(|message| flaw(Moment::After, Wrong::from(message)));
    pair
}

/// A demonstration of two states, and what is odd about it.
///
/// # Errors
/// Each thing that is in one state and not in the other: objects by name, rooms and doors by bounds.
pub fn pair(pre: State, post: State) -> Result<(Pair, Vec<String>), Vec<String>> {
    let mut errors = Vec::new();
    let mut oddities = Vec::new();
    let objects = |state: &State| -> BTreeMap<String, String> {
        let look = |o: &crate::domain::Object| format!("{:?} {:?} {:?}", o.shape, o.color, o.size);
        state.objects.iter().map(|o| (o.name.clone(), look(o))).collect()
    };
    let rooms = |state: &State| -> BTreeMap<Bounds, (String, String)> {
        let row = |r: &crate::domain::Room| (r.bounds, (r.name.clone(), format!("{:?}", r.color)));
        state.rooms.iter().map(row).collect()
    };
    let doors = |state: &State| -> BTreeMap<Bounds, (String, String)> {
        state.doors.iter().map(|d| (d.bounds, (d.name.clone(), String::new()))).collect()
    };
    let (before, after) = (objects(&pre), objects(&post));
    for (name, missing, there) in differences(&before, &after) {
        errors.push(format!("the object {name} is there {there} but not {missing}"));
    }
    for (name, look) in &before {
        if after.get(name).is_some_and(|other| other != look) {
            oddities.push(format!("the object {name} looks different afterwards"));
        }
    }
    for (kind, before, after) in
        [("room", rooms(&pre), rooms(&post)), ("door", doors(&pre), doors(&post))]
    {
        for (bounds, missing, there) in differences(&before, &after) {
            errors.push(format!(
                "the {kind} at {} is there {there} but not {missing}",
                place(bounds)
            ));
        }
        let mut renamed = Vec::new();
        for (bounds, (name, color)) in &before {
            let Some((new_name, new_color)) = after.get(bounds) else { continue };
            if name != new_name {
                renamed.push(format!("{name} is {new_name}"));
            }
            if color != new_color {
                oddities.push(format!("the {kind} {name} has another colour afterwards"));
            }
        }
        if !renamed.is_empty() {
            let names = renamed.join(", ");
            oddities.push(format!(
                "{kind}s have other names afterwards ({names}); they were matched by their bounds"
            ));
        }
    }
    if errors.is_empty() { Ok((Pair { pre, post }, oddities)) } else { Err(errors) }
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

fn differences<'a, K: Ord, V>(
    before: &'a BTreeMap<K, V>,
    after: &'a BTreeMap<K, V>,
) -> impl Iterator<Item = (&'a K, &'static str, &'static str)> {
    let gone = before.keys().filter(|k| !after.contains_key(k)).map(|k| (k, "after", "before"));
    let new = after.keys().filter(|k| !before.contains_key(k)).map(|k| (k, "before", "after"));
    gone.chain(new)
}

fn place(b: &Bounds) -> String {
    format!("left {} bottom {} right {} top {}", b.left, b.bottom, b.right, b.top)
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
