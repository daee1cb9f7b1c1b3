//! Other worlds in the room: those that come with the page, random ones, as text, and the one that it began as.

use super::state::Room;
use crate::domain::State as World;
use crate::ui::page::effect::Effect;
use crate::ui::page::shared::Shared;
use crate::ui::page::world::{Choice, WORLDS};
use crate::ui::talk::command::ask;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use crate::worker::protocol::Request;

/// Opens a world that comes with the page, by its place in [`WORLDS`].
pub(crate) fn pick(state: &mut State, shared: &mut Shared, choice: usize) {
    if let Some(world) = WORLDS.get(choice).and_then(Choice::open) {
        open(state, shared, world, Some(choice));
    }
}

/// Opens another world.
fn open(state: &mut State, shared: &mut Shared, world: World, preset: Option<usize>) {
    state.settle(shared);
    shared.record();
    shared.document.open(world, preset);
    state.room.let_go();
    (state.room.cursor, state.room.notice) = (None, None);
    state.watch.forget();
    shared.say(Text::of(shared.language).phrases.world(&shared.document.world));
    ask::read(state, shared);
}

/// Puts the world back as it was opened.
pub(crate) fn reset(state: &mut State, shared: &mut Shared) {
    let origin = (*shared.document.origin).clone();
    state.settle(shared);
    if origin == shared.document.world {
        return;
    }
    shared.record();
    shared.document.change(origin);
    shared.document.draft = None;
    ask::read(state, shared);
    let text = Text::of(shared.language);
    let robot = text.phrases.robot(state.shown(shared));
    shared.say(format!("{} {robot}", text.as_it_began));
}

/// Has the random world of the seed made.
pub(crate) fn draw(state: &State, shared: &mut Shared) {
    let Room { blueprint, seed, .. } = state.room;
    shared.send(Request::Draw { blueprint, seed }, true);
}

/// Shows the world as text, or no longer.
pub(crate) fn toggle_text(state: &mut State, shared: &mut Shared) {
    match state.room.text.take() {
        Some(_) => state.room.notice = None,
        None => {
            let request = Request::WriteWorld { state: state.shown(shared).clone() };
            shared.send(request, true);
        }
    }
}

/// Has the world opened that the text draws, or that it is as JSON, which begins with a brace.
pub(crate) fn apply_text(state: &State, shared: &mut Shared) {
    match state.room.text.clone() {
        Some(text) if text.trim_start().starts_with('{') => shared.want(Effect::ReadWorld(text)),
        Some(text) => shared.send(Request::ReadWorld { text }, true),
        None => {}
    }
}

/// A world has been read from JSON, or why that is none.
pub(crate) fn was_read(state: &mut State, shared: &mut Shared, world: Result<World, String>) {
    match world {
        Ok(world) => {
            open(state, shared, world, None);
            state.room.text = None;
        }
        Err(why) => {
            shared.say(why.clone());
            state.room.notice = Some(why);
        }
    }
}

/// A world that was asked for has come: the seed of a random one is counted on, the text of a drawn one put away.
pub(crate) fn came(state: &mut State, shared: &mut Shared, world: World, request: &Request) {
    if matches!(request, Request::Draw { .. }) {
        state.room.seed = state.room.seed.wrapping_add(1);
    }
    open(state, shared, world, None);
    if matches!(request, Request::ReadWorld { .. }) {
        state.room.text = None;
    }
}
