//! Saying what stands in the box: a lesson in other words, a question, or a command.

use super::query::query;
use super::{ask, wonder};
use crate::ui::page::shared::Shared;
use crate::ui::talk::state::State;
use crate::ui::talk::teach::learn;
use crate::ui::talk::teach::other::in_other_words;
use crate::worker::protocol::{Meaning, Refusal};

/// Says it; as soon as somebody can hear it.
pub(crate) fn say(state: &mut State, shared: &mut Shared) {
    if !shared.can_ask() {
        return ask::ask_soon(state, shared);
    }
    if let Some(lesson) = in_other_words(&state.command.input) {
        return match &lesson.means {
            Some(Meaning::Words(words)) if query(words).is_some() => {
                learn::refuse(state, shared, &lesson.command, &Refusal::Lost);
            }
            _ => learn::learn_besides(state, shared, lesson),
        };
    }
    match query(&state.command.input) {
        Some((query, about)) => wonder::ask(state, shared, query, about),
        None => ask::ask(state, shared),
    }
}

/// There is someone to hear: what was sent already is said, what is being typed is read. A question that waits, or was
/// answered, is not typed any more.
pub(crate) fn begin(state: &mut State, shared: &mut Shared) {
    if std::mem::take(&mut state.command.early) {
        say(state, shared);
    } else if state.command.query.is_none() && state.command.reply.is_none() {
        ask::read(state, shared);
    }
}
