//! Notes what is said and what came of it.

use super::state::{Line, MOST_LINES, Outcome};
use crate::ui::page::shared::Shared;
use crate::ui::talk::state::State;

/// Notes what was said and what came of it: as another line, or as more of the last one of the same words.
pub(crate) fn note(state: &mut State, shared: &Shared, is_new: bool) {
    let Some(said) = &shared.document.said else { return };
    let line = Line {
        command: said.answer.command.clone(),
        outcome: Outcome::of(said),
        world: shared.document.world.clone(),
    };
    let mut lines = state.past.lines.iter_mut().rev().filter(|_| !is_new);
    match lines.find(|other| other.command == line.command) {
        Some(same) => *same = line,
        None => push(state, line),
    }
}

/// Adds a line.
pub(crate) fn push(state: &mut State, line: Line) {
    let lines = &mut state.past.lines;
    state.past.at = None;
    if lines.len() == MOST_LINES {
        lines.remove(0);
    }
    lines.push(line);
}
