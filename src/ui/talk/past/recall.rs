//! Notes what is said, brings it back into the box, and goes on from after it.

use super::state::{Line, MOST_LINES, Outcome};
use crate::ui::page::shared::Shared;
use crate::ui::talk::command::ask;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;

/// Notes what was said and what came of it: as another line, or as more of the last one.
pub(crate) fn note(state: &mut State, shared: &Shared, is_new: bool) {
    let Some(said) = &shared.document.said else { return };
    let line = Line {
        command: said.answer.command.clone(),
        outcome: Outcome::of(said),
        world: shared.document.world.clone(),
    };
    let lines = &mut state.past.lines;
    state.past.at = None;
    if !is_new && lines.last().is_some_and(|last| last.command == line.command) {
        lines.pop();
    }
    if lines.len() == MOST_LINES {
        lines.remove(0);
    }
    lines.push(line);
}

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
