//! Brings what was said back into the box, and goes on from after it.

use super::state::Line;
use crate::ui::page::shared::Shared;
use crate::ui::talk::command::ask;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;

/// Brings the command before the one in the box back into it, or the one after it.
pub(crate) fn recall(state: &mut State, shared: &mut Shared, back: bool) {
    let lines = &state.past.lines;
    let at = state.past.at.unwrap_or(lines.len());
    let at = if back { at.checked_sub(1) } else { Some(at + 1) };
    let Some(at) = at.filter(|&at| at <= lines.len()) else { return };
    let command = lines.get(at).map(|line| line.command.clone()).unwrap_or_default();
    ask::typed(state, shared, &command);
    state.past.at = Some(at);
}

/// The world becomes what it was after a line.
pub(crate) fn go_on(state: &mut State, shared: &mut Shared, place: usize) {
    let Some(Line { command, world, .. }) = state.past.lines.get(place).cloned() else { return };
    state.settle(shared);
    shared.record();
    shared.document.change(world);
    state.watch.forget();
    state.room.let_go();
    state.command.forget();
    let text = Text::of(shared.language);
    let robot = text.phrases.robot(state.shown(shared));
    shared.say(format!("{} {robot}", (text.gone_back)(&command)));
    ask::read(state, shared);
}
