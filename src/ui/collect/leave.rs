//! How a person leaves a study: by its ends, one after another, or by withdrawing.

use super::effect::Effect;
use super::ending;
use super::notes::{end_at, keep, who};
use super::state::{Over, Stage, State};
use crate::study::file::End;
use crate::study::journal::Note;

/// The end at hand is wanted.
pub(super) fn end(state: &mut State) -> Vec<Effect> {
    if state.stage() == Stage::Over {
        return sent_again(state);
    }
    let Stage::End(at) = state.stage() else { return Vec::new() };
    let Some(end) = end_at(state, at) else { return Vec::new() };
    if state.is_preview() {
        return ended(state);
    }
    let mut effects = ending::begin(state, &end);
    state.leaving = None;
    match (&end, effects.as_slice()) {
        // It leaves the page, and nothing says whether it arrived: all stays, to be sent again.
        (End::Form { .. }, [Effect::Submit { .. }]) => {
            state.leaving = effects.pop();
            keep(state, Note::Handed { end: at })
        }
        (End::Return { .. }, [Effect::Go(url)]) => {
            state.way_back = Some(url.clone());
            ended(state)
        }
        _ => effects,
    }
}

/// Sends the form again, of which nobody here can tell whether it arrived.
fn sent_again(state: &mut State) -> Vec<Effect> {
    let mut ends = state.study.iter().flat_map(|(study, _)| &study.ends);
    let form = ends.rfind(|end| matches!(end, End::Form { .. })).cloned();
    form.map(|form| ending::begin(state, &form)).unwrap_or_default()
}

/// The end at hand is done with; behind the last one all is erased.
pub(super) fn ended(state: &mut State) -> Vec<Effect> {
    let at = match state.stage() {
        Stage::End(at) => at,
        Stage::Over if state.over.is_none() => usize::MAX,
        _ => return Vec::new(),
    };
    let Some(((study, _), sitting)) = state.study.as_ref().zip(state.sitting.as_ref()) else {
        return Vec::new();
    };
    let left = (0..study.ends.len()).any(|end| end != at && !sitting.handed.contains(&end));
    if left {
        return keep(state, Note::Handed { end: at });
    }
    let has_code = study.ends.contains(&End::Code);
    let code = has_code.then(|| sitting.code(study));
    let name = sitting.name();
    state.over = Some(Over::Done(code.clone()));
    if state.is_preview() {
        return vec![Effect::Top];
    }
    vec![Effect::Erase { sitting: name, over: Some(code.unwrap_or_default()) }, Effect::Top]
}

/// What was not sent is tried again.
pub(super) fn again(state: &mut State) -> Vec<Effect> {
    let Stage::End(at) = state.stage() else { return Vec::new() };
    let waits = !state.ending.is_sending && state.ending.refusal.is_none();
    match end_at(state, at) {
        Some(end @ End::Endpoint { .. }) if waits => ending::begin(state, &end),
        _ => Vec::new(),
    }
}

/// The person has withdrawn: nothing is left.
pub(super) fn withdrawn(state: &mut State) -> Vec<Effect> {
    let sitting = who(state).sitting(&state.fingerprint);
    state.leaves = false;
    (state.sitting, state.keeping) = (None, None);
    (state.text, state.care, state.notes) = (String::new(), Default::default(), 0);
    state.over = Some(Over::Withdrawn);
    if state.is_preview() {
        return vec![Effect::Top];
    }
    vec![Effect::Erase { sitting, over: None }, Effect::Top]
}
