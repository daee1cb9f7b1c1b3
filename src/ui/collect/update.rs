//! The reducer of the page that asks: an action changes the state, and what is to be done comes back. Pure.

use super::action::Action;
use super::arrive::{begun, came, claim, fetch, knows, read};
use super::effect::Effect;
use super::ending;
use super::leave::{again, end, ended, withdrawn};
use super::notes::{keep, noted, who};
use super::outbox::pause;
use super::runs::{is_shown, play, step, ticked};
use super::state::{Hold, Stage, State};
use crate::study::journal::Note;
use crate::ui::page::keep::fault::Fault;
use crate::ui::page::language::Language;

/// Changes the state as the action says, and returns what is to be done. `now` is the time, in milliseconds since 1970.
pub fn reduce(state: &mut State, action: Action, now: f64) -> Vec<Effect> {
    match action {
        Action::Opened(link, language) => {
            let wanted = link.language.as_deref().and_then(Language::of);
            state.language = wanted.unwrap_or(language);
            state.link = *link;
            return fetch(state);
        }
        Action::Prefers(preferences) => state.preferences = preferences,
        Action::Came(Ok((study, source))) => return came(state, study, source),
        Action::Came(Err(trouble)) => state.trouble = Some(trouble),
        Action::Known(known) => return knows(state, known),
        Action::Claimed(true) => return vec![Effect::Read(who(state).sitting(&state.fingerprint))],
        Action::Claimed(false) => state.hold = Hold::Elsewhere,
        Action::Read(kept) => return read(state, kept),
        Action::Noted(kept) => return noted(state, kept),
        Action::Broke(Fault::Elsewhere) => (state.hold, state.keeping) = (Hold::Elsewhere, None),
        Action::Broke(fault) => state.fault = Some(fault),

        Action::Agree if state.stage() == Stage::Welcome && state.keeping.is_none() => {
            return begun(state, now);
        }
        Action::Ready if state.stage() == Stage::Instructions => return keep(state, Note::Ready),
        Action::Typed(text, pasted) => return typed(state, text, pasted),
        Action::Rested => return rested(state),
        Action::Spent(ms, seen) => spent(state, ms, &seen),
        Action::Point(at) => match state.pointed.iter().position(|&shown| shown == at) {
            Some(place) => drop(state.pointed.remove(place)),
            None => {
                state.pointed.push(at);
                state.care.changes += 1;
            }
        },
        Action::Play(at) => return play(state, at),
        Action::Step(at) => {
            state.runs.playing = None;
            step(state, at);
        }
        Action::Ticked => return ticked(state),
        Action::Answer => return answered(state, now),
        Action::End => return end(state),
        Action::Ended => return ended(state),
        Action::Posted(Ok(())) => {
            state.ending.is_sending = false;
            return ended(state);
        }
        Action::Posted(Err(why)) => {
            state.ending.is_sending = false;
            state.ending.failed = Some(why);
            return vec![Effect::Retry(pause(state.ending.tries))];
        }
        Action::Again => return again(state),
        Action::Save => {
            let both = state.study.as_ref().zip(state.sitting.as_ref());
            return both
                .map(|((study, _), sitting)| ending::file(study, sitting))
                .into_iter()
                .collect();
        }
        Action::Erased(done) => {
            state.fault = done.err().or(state.fault.take());
            return state.way_back.take().map(Effect::Go).into_iter().collect();
        }
        Action::Withdraw => state.leaves = true,
        Action::Stay => state.leaves = false,
        Action::Withdrawn if state.leaves => return withdrawn(state),
        Action::Take => {
            state.hold = Hold::Waiting;
            return claim(state, true);
        }
        Action::Speak(language) => {
            state.language = language;
            return vec![Effect::Speak(language)];
        }
        Action::Agree | Action::Ready | Action::Withdrawn => {}
    }
    Vec::new()
}

fn typed(state: &mut State, text: String, pasted: u32) -> Vec<Effect> {
    if !matches!(state.stage(), Stage::Turn(_)) {
        return Vec::new();
    }
    state.care.pasted += pasted;
    state.care.keys += u32::from(pasted == 0);
    state.text = text;
    vec![Effect::Rest]
}

/// Keeps what stands in the box; while something else is being kept it waits for the next pause.
fn rested(state: &mut State) -> Vec<Effect> {
    let Stage::Turn(turn) = state.stage() else { return Vec::new() };
    let last = state.sitting.as_ref().map_or("", |sitting| sitting.draft.text.as_str());
    if state.keeping.is_some() {
        return vec![Effect::Rest];
    }
    if last == state.text {
        return Vec::new();
    }
    let (text, care) = (state.text.clone(), state.care.clone());
    keep(state, Note::Typed { turn, text, care })
}

fn spent(state: &mut State, ms: u32, seen: &[bool]) {
    if !matches!(state.stage(), Stage::Turn(_)) {
        return;
    }
    let shown: Vec<bool> =
        seen.iter().enumerate().map(|(at, &seen)| seen && is_shown(state, at)).collect();
    let care = &mut state.care;
    care.active_ms = care.active_ms.saturating_add(ms);
    care.seen_ms.resize(care.seen_ms.len().max(shown.len()), 0);
    for (sum, _) in care.seen_ms.iter_mut().zip(shown).filter(|(_, shown)| *shown) {
        *sum = sum.saturating_add(ms);
    }
}

fn answered(state: &mut State, now: f64) -> Vec<Effect> {
    let Stage::Turn(turn) = state.stage() else { return Vec::new() };
    if state.text.trim().is_empty() {
        return Vec::new();
    }
    let (text, care) = (state.text.clone(), state.care.clone());
    let note = Note::Answered { turn, text, care, at: now };
    if let Some(Note::Typed { .. }) = &state.keeping {
        // What was typed before is on its way to the store; this follows it.
        state.next = Some(note);
        return Vec::new();
    }
    keep(state, note)
}
