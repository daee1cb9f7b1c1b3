//! Notes of a sitting: each is kept first, and then the sitting goes on behind it.

use super::effect::Effect;
use super::ending;
use super::outbox::Ending;
use super::state::{Hold, Runs, Stage, State};
use crate::study::ends::target;
use crate::study::file::End;
use crate::study::journal::{Note, Sitting, Who};
use crate::ui::page::keep::fault::Fault;

/// Who takes part.
pub(super) fn who(state: &State) -> Who {
    Who {
        worker: state.worker.clone().unwrap_or_default(),
        assignment: state.link.assignment.clone(),
        hit: state.link.hit.clone(),
        simulated: state.script.as_ref().map(|script| script.careless),
    }
}

/// Keeps a note, behind which the sitting goes on.
pub(super) fn keep(state: &mut State, note: Note) -> Vec<Effect> {
    if state.keeping.is_some() {
        return Vec::new();
    }
    if state.is_preview() {
        return moved(state, &note);
    }
    let sitting = who(state).sitting(&state.fingerprint);
    state.keeping = Some(note.clone());
    vec![Effect::Keep { sitting, place: state.notes, note: Box::new(note) }]
}

/// A note is kept, or cannot be: either way the sitting goes on.
pub(super) fn noted(state: &mut State, kept: Result<(), Fault>) -> Vec<Effect> {
    let Some(note) = state.keeping.take() else { return Vec::new() };
    match kept {
        Ok(()) => {
            state.notes += 1;
            if state.fault == Some(Fault::Full) {
                state.fault = None;
            }
        }
        Err(Fault::Elsewhere) => {
            state.hold = Hold::Elsewhere;
            return Vec::new();
        }
        Err(fault) => state.fault = Some(fault),
    }
    let mut effects = moved(state, &note);
    if let Some(next) = state.next.take() {
        effects.extend(keep(state, next));
    }
    effects.extend(state.leaving.take());
    effects
}

/// The sitting goes on behind a note.
fn moved(state: &mut State, note: &Note) -> Vec<Effect> {
    match &mut state.sitting {
        None => state.sitting = Sitting::of([note]),
        Some(sitting) => sitting.take(note),
    }
    if matches!(note, Note::Typed { .. }) {
        return Vec::new();
    }
    if matches!(note, Note::Answered { .. }) {
        (state.text, state.care) = (String::new(), Default::default());
        state.pointed.clear();
    }
    state.runs = Runs::default();
    if matches!(note, Note::Handed { .. }) {
        state.ending = Ending::default();
    }
    let mut effects = vec![Effect::Top];
    effects.extend(arrived(state));
    effects
}

/// What a stage begins with by itself: an endpoint is posted to at once.
pub(super) fn arrived(state: &mut State) -> Vec<Effect> {
    match state.stage() {
        Stage::End(_) if state.is_preview() => Vec::new(),
        Stage::End(at) => match end_at(state, at) {
            Some(end @ End::Endpoint { .. }) => ending::begin(state, &end),
            Some(end @ End::Form { .. }) => {
                // Whether it may be sent at all is said before the button is pressed.
                let asked = state
                    .study
                    .as_ref()
                    .map(|(study, source)| target(study, *source, &end, &state.link));
                state.ending.refusal = asked.and_then(Result::err);
                Vec::new()
            }
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}

/// An end of the study.
pub(super) fn end_at(state: &State, at: usize) -> Option<End> {
    state.study.as_ref()?.0.ends.get(at).cloned()
}
