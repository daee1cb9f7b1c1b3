//! A closer look at an answer: what its scores are made of, and the reading that it had in a session that was opened.

use super::ask;
use crate::ui::page::document::Said;
use crate::ui::page::preferences::Depth;
use crate::ui::page::shared::Shared;
use crate::ui::talk::state::State;
use crate::worker::protocol::Request;

/// Asks what the scores are made of, if that is to be seen and not known.
pub(crate) fn study(state: &State, shared: &mut Shared) {
    if shared.depth < Depth::Study || state.command.studies.is_some() {
        return;
    }
    if let Some(said) = &shared.document.said {
        let command = said.answer.command.clone();
        shared.talker.retain(|request| !matches!(request, Request::Explain { .. }));
        shared.send(Request::Explain { command }, false);
    }
}

/// Looks closer at the answer that has come: studies it, and means it as the session that was opened did.
pub(crate) fn look_closer(state: &mut State, shared: &mut Shared) {
    study(state, shared);
    let wanted = state.resume.form.take();
    let instead = shared.document.plan().and_then(|plan| plan.instead.as_ref());
    if instead.is_some_and(|instead| wanted.as_ref() == Some(&instead.reading.form)) {
        return ask::instead(state, shared);
    }
    let readings = shared.document.said.iter().flat_map(|said| said.answer.readings.iter());
    let place = wanted.and_then(|form| readings.clone().position(|reading| reading.form == form));
    let asks_first = shared.document.said.as_ref().is_some_and(Said::asks_first);
    if let Some(place) = place.filter(|&place| place > 0 || asks_first) {
        ask::choose(state, shared, place);
    }
}
