//! How a person comes to a study: the file is fetched, the sitting claimed, what is kept of it read, and it begins, or
//! goes on.

use super::action::{Kept, Trouble};
use super::effect::Effect;
use super::notes::{arrived, keep, who};
use super::state::{Hold, Over, State};
use crate::study::Link;
use crate::study::ends::Source;
use crate::study::file::{Again, Study};
use crate::study::journal::{Note, Sitting};
use crate::study::plan::plan;
use crate::study::rehearse::script;
use crate::ui::page::keep::fault::Fault;

/// The study that the link names is wanted.
pub(super) fn fetch(state: &mut State) -> Vec<Effect> {
    let Link { study, .. } = &state.link;
    match study {
        Some(file) if Link::is_beside(file) => vec![Effect::Fetch(file.clone())],
        Some(_) => {
            state.trouble = Some(Trouble::Elsewhere);
            Vec::new()
        }
        None => vec![Effect::Unpack],
    }
}

/// The study has come.
pub(super) fn came(state: &mut State, study: Box<Study>, source: Source) -> Vec<Effect> {
    state.fingerprint = study.fingerprint();
    state.language = state.language_of(&study);
    state.script = state.link.simulate.map(|seed| script(&study, seed));
    state.study = Some((study, source));
    let speak = Effect::Speak(state.language);
    if state.is_preview() {
        state.worker = Some("preview".to_owned());
        state.hold = Hold::Held;
        return vec![speak];
    }
    let named = state.script.as_ref().map(|script| script.worker.clone());
    state.worker = named.or_else(|| state.link.worker.clone());
    vec![speak, Effect::Open(state.fingerprint.clone())]
}

/// It is known who the person is here, or that nothing can be kept.
pub(super) fn knows(state: &mut State, known: Result<String, Fault>) -> Vec<Effect> {
    match known {
        Ok(pseudonym) => {
            state.worker.get_or_insert(pseudonym);
            claim(state, false)
        }
        Err(fault) => {
            // Nothing can be kept: the page goes on in memory, and says so.
            state.fault = Some(fault);
            state.worker.get_or_insert_with(|| "nobody".to_owned());
            state.hold = Hold::Held;
            Vec::new()
        }
    }
}

/// This tab wants the sitting.
pub(super) fn claim(state: &State, steal: bool) -> Vec<Effect> {
    vec![Effect::Claim { sitting: who(state).sitting(&state.fingerprint), steal }]
}

/// What is kept was read.
pub(super) fn read(state: &mut State, kept: Result<Kept, Fault>) -> Vec<Effect> {
    state.hold = Hold::Held;
    let Kept { notes, over } = match kept {
        Ok(kept) => kept,
        Err(fault) => {
            state.fault = Some(fault);
            return Vec::new();
        }
    };
    if let Some(code) = over {
        state.over = Some(Over::Done(Some(code).filter(|code| !code.is_empty())));
        return Vec::new();
    }
    state.notes = notes.len() as u32;
    let Some(sitting) = Sitting::of(&notes) else { return Vec::new() };
    let again = state.study.as_ref().map_or(Again::Resume, |(study, _)| study.again);
    // Answers that are all given wait to be handed over, whatever the study says of visits that were broken off.
    match again {
        _ if sitting.turn().is_none() => {}
        Again::Resume => {}
        Again::Refuse => {
            state.is_refused = true;
            return Vec::new();
        }
        Again::Restart => {
            state.notes = 0;
            return vec![Effect::Erase { sitting: sitting.name(), over: None }];
        }
    }
    state.text.clone_from(&sitting.draft.text);
    state.care = sitting.draft.care.clone();
    state.sitting = Some(sitting);
    arrived(state)
}

/// Somebody has agreed.
pub(super) fn begun(state: &mut State, now: f64) -> Vec<Effect> {
    let Some((study, _)) = &state.study else { return Vec::new() };
    let who = who(state);
    let turns = match &state.script {
        Some(script) => script.turns.clone(),
        None => plan(study, &who.worker),
    };
    let study = state.fingerprint.clone();
    keep(state, Note::Begun { study, who, turns, at: now })
}
