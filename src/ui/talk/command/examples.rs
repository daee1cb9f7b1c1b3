//! Commands to try in the room as it stands, one a kind: the engine looks for them whenever the room has come to rest.

use super::offer::{Examples, KINDS};
use crate::domain::State as World;
use crate::ui::page::effect::{Effect, Timer};
use crate::ui::page::shared::Shared;
use crate::ui::page::world::WORLDS;
use crate::ui::talk::state::State;
use crate::worker::protocol::{Request, Wanted, WorldRules};

/// Milliseconds that the room has to rest.
const REST_MS: u32 = 300;

/// The kind at a place. The room's own stands second: the plainest first.
fn kind(shared: &Shared, place: usize) -> Option<Wanted> {
    Some(match place {
        0 => Wanted::Go,
        1 => match shared.document.preset.and_then(|preset| WORLDS.get(preset)) {
            Some(world) => Wanted::Said(world.example.to_owned()),
            None => Wanted::Describe,
        },
        2 => Wanted::Bring,
        3 => Wanted::Beside,
        4 => Wanted::Describe,
        Examples::TAUGHT => Wanted::Unknown,
        _ => return None,
    })
}

/// Notices when the room has changed, and waits until it has come to rest.
pub fn keep_up(state: &mut State, shared: &mut Shared) {
    let of = (&shared.document.world, &shared.document.rules, shared.document.lessons.len());
    let examples = &mut state.command_examples;
    let is_known = examples.of.as_ref().is_some_and(|(w, r, n)| (w, r, *n) == of);
    if shared.can_ask() && !is_known {
        examples.of = Some((of.0.clone(), *of.1, of.2));
        examples.number = examples.number.wrapping_add(1);
        examples.is_behind = true;
        shared.want(Effect::StartTimer(Timer::Examples(examples.number), REST_MS));
    }
}

/// The room has come to rest, unless another timer was started meanwhile.
pub fn rang(state: &mut State, shared: &mut Shared, number: u32) {
    if number == state.command_examples.number {
        (state.command_examples.coming, state.command_examples.next) = Default::default();
        shared.talker.retain(|request| !matches!(request, Request::Example { .. }));
        look(shared, 0);
    }
}

/// Has the engine look for one of the kind at a place.
fn look(shared: &mut Shared, place: usize) {
    if let Some(wanted) = kind(shared, place) {
        let (state, rules) = (shared.document.world.clone(), shared.document.rules);
        shared.send(Request::Example { wanted, state, rules }, false);
    }
}

/// The engine has looked in a room. What it was asked before the room changed, or the search began anew, counts no more.
pub fn came(
    state: &mut State,
    shared: &mut Shared,
    (wanted, room): (&Wanted, (&World, &WorldRules)),
    command: Option<String>,
) {
    let place = state.command_examples.next;
    let is_own = state.command_examples.of.as_ref().is_some_and(|(w, r, _)| (w, r) == room);
    if !is_own || kind(shared, place).as_ref() != Some(wanted) {
        return;
    }
    let Examples { found, coming, is_behind, .. } = &mut state.command_examples;
    let is_new = !coming[..place].contains(&command);
    coming[place] = command.filter(|_| is_new);
    // In a room of one's own the last but one would be the second again.
    let next = if place == 3 && shared.document.preset.is_none() { 5 } else { place + 1 };
    if next == KINDS {
        (*found, *is_behind) = (std::mem::take(coming), false);
    }
    state.command_examples.next = next;
    look(shared, next);
}
