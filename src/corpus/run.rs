//! Runs out of JSON and back: `{start, actions, contrast?}`, a state, letters ("nnes"), and other ways from the same start
//! that do not do what was asked. The start must be legal; what the actions lead to is worked out.

use super::cell::before;
use super::example::Pair;
use super::flaw::Wrong;
use super::json::json;
use super::object::Few;
use crate::domain::way::{MOST_ACTIONS, MOST_CONTRASTS};
use crate::domain::{Action, State, Way, letters, read_letters};
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use std::borrow::Cow;

#[derive(Deserialize)]
#[serde(expecting = "a run: {start, actions, contrast?}")]
struct RunIn<'a> {
    #[serde(borrow)]
    start: &'a RawValue,
    actions: String,
    contrast: Option<Few<String, MOST_CONTRASTS>>,
}

/// A run as it is written.
#[derive(Serialize)]
pub(super) struct RunOut<'a> {
    start: &'a State,
    actions: String,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    contrast: Vec<String>,
}

impl<'a> RunOut<'a> {
    pub(super) fn new(start: &'a State, way: &Way) -> RunOut<'a> {
        let contrast = way.contrasts.iter().map(|contrast| letters(contrast)).collect();
        RunOut { start, actions: letters(&way.actions), contrast }
    }
}

/// Reads a run.
///
/// # Errors
/// What is wrong, and what to mend.
pub fn read(text: &str) -> Result<Pair, Wrong> {
    let inner = text.trim().starts_with('"').then(|| serde_json::from_str(text).ok()).flatten();
    let text: Cow<'_, str> = inner.map_or(Cow::Borrowed(text), Cow::Owned);
    let run: RunIn<'_> = json(&text).map_err(|wrong| {
        let mend = "a run is {\"start\": a state, \"actions\": \"nnes\", \"contrast\": [\"ne\"]}";
        Wrong::with_mend(format!("this is no run: {}", wrong.what), mend)
    })?;
    let Few(contrast) = run.contrast.unwrap_or(Few(Vec::new()));
    way(before(run.start.get())?, &run.actions, &contrast)
}

/// The run of these letters from a start.
///
/// # Errors
/// What is wrong: the start is no legal state, or there are other letters, or too many.
pub fn of(start: State, actions: &str, contrast: &[String]) -> Result<Pair, Wrong> {
    start.check().map_err(|error| Wrong::from(error.to_string()))?;
    way(start, actions, contrast)
}

/// The run of these letters from a legal start.
fn way(start: State, letters: &str, contrast: &[String]) -> Result<Pair, Wrong> {
    if contrast.len() > MOST_CONTRASTS {
        return Err(Wrong::from(format!("a run has {MOST_CONTRASTS} contrasts at most")));
    }
    let contrasts = contrast.iter().map(|contrast| actions(contrast));
    let contrasts = contrasts.collect::<Result<_, _>>()?;
    pair(start, Way { actions: actions(letters)?, contrasts })
}

/// The demonstration that a way from a start is.
///
/// # Errors
/// When the start is too large a world.
pub fn pair(start: State, way: Way) -> Result<Pair, Wrong> {
    let states = way.states(&start).map_err(|error| Wrong::from(error.to_string()))?;
    let post = states.into_iter().next().and_then(|mut run| run.pop());
    let post = post.unwrap_or_else(|| start.clone());
    Ok(Pair { pre: start, post, way: Some(Box::new(way)) })
}

/// Writes a run as a cell; a run always has a JSON form.
pub(super) fn write(start: &State, way: &Way) -> Option<String> {
    serde_json::to_string(&RunOut::new(start, way)).ok()
}

fn actions(text: &str) -> Result<Box<[Action]>, Wrong> {
    if text.len() > MOST_ACTIONS {
        return Err(Wrong::from(format!("a run has {MOST_ACTIONS} actions at most")));
    }
    read_letters(text).map_err(|letter| {
        let known: String = Action::ALL.iter().map(|action| action.letter()).collect();
        Wrong::with_mend(
            format!("no action is called {letter:?}"),
            format!("the letters are {known}"),
        )
    })
}
