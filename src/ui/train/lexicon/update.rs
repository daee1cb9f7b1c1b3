//! Does what a person wants with what was learned.

use super::action::Action;
use super::state::{PAGE, State};
use super::words::Text;
use crate::ui::page::files::{Given, Offered, given};
use crate::ui::train::desk::Desk;
use crate::worker::protocol::Request;

/// Does what a person wants.
pub fn update(state: &mut State, desk: &mut Desk, action: Action) {
    state.notice = None;
    match action {
        Action::Shown => {
            state.picked.clear();
            desk.ask(Request::Errors);
        }
        Action::Text(text) => (state.view.text, state.offset) = (text, 0),
        Action::Learned(learned) => (state.view.learned, state.offset) = (learned, 0),
        Action::Sort(sort) => {
            state.view.descending = state.view.sort == sort && !state.view.descending;
            (state.view.sort, state.offset) = (sort, 0);
        }
        Action::Page(offset) => state.offset = offset,
        Action::Pick(place, is_picked) => {
            if is_picked {
                state.picked.insert(place)
            } else {
                state.picked.remove(&place)
            };
            return;
        }
        Action::Without => {
            let places = state.picked.iter().copied().collect();
            return desk.ask(Request::Without { places });
        }
        // It is opened where the corpus is.
        Action::Row(_) => return,
        Action::Compare(files) => return compare(state, desk, files),
    }
    ask(state, desk);
}

/// Gives the engine the robot's model.
pub(in crate::ui::train) fn give(desk: &mut Desk) {
    if let Some(model) = &desk.in_use {
        let text = model.report.model.clone();
        desk.ask(Request::KeepModel { text });
    }
}

/// Asks for the entries that are to be shown.
pub(super) fn ask(state: &State, desk: &mut Desk) {
    let (view, offset) = (state.view.clone(), state.offset);
    desk.ask(Request::Entries { view, offset, count: PAGE });
}

fn compare(state: &mut State, desk: &mut Desk, files: Vec<Offered>) {
    let text = Text::of(desk.language);
    let Some((Offered { name, bytes }, model)) = files.into_iter().next().zip(desk.in_use.as_ref())
    else {
        return;
    };
    let read = bytes.and_then(|bytes| given(&name, bytes));
    let Ok(Some(Given::Model(second))) = read else {
        let words = (text.no_model)(&name);
        desk.say(words.clone());
        state.notice = Some(words);
        return;
    };
    state.comparing = name;
    let first = model.report.model.clone();
    desk.ask(Request::Compare { first, second });
}
