//! Ways that are not what is meant: one that was driven, the one that the page would have taken, the plan that it made.

use super::learn::{self, look};
use super::trail::driving;
use crate::ui::page::document::Draft;
use crate::ui::page::effect::Effect;
use crate::ui::page::shared::Shared;
use crate::ui::talk::command::ask::is_asking;
use crate::ui::talk::room::hand;
use crate::ui::talk::room::state::Mode;
use crate::ui::talk::state::State;

/// A way that is not what is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unlike {
    /// The one that was driven.
    Driven,
    /// The one that the page would have taken.
    Straight,
    /// The plan that was made.
    Planned,
}

/// A way is not what is meant: it is kept as a contrast, and what is meant is shown anew if that was shown. A plan that no
/// driving follows is only not meant.
pub(crate) fn unlike(state: &mut State, shared: &mut Shared, which: Unlike) {
    let contrast = match which {
        Unlike::Driven => shared.document.draft.as_ref().and_then(driven),
        Unlike::Straight => state.teach.straight.clone(),
        Unlike::Planned => shared.document.plan().and_then(|plan| driving(&plan.states)),
    };
    match which {
        Unlike::Planned => begin_anew(state, shared),
        _ if contrast.is_none() => return,
        _ => shared.record(),
    }
    let draft = shared.document.draft();
    let contrast = contrast.filter(|way| !draft.contrasts.contains(way));
    draft.contrasts.extend(contrast);
    if which == Unlike::Driven {
        draft.clear();
    }
    look(state, shared);
    shared.want(Effect::Focus(if which == Unlike::Straight { "lesson" } else { "room" }));
}

/// The way that was driven, if that is known and leads anywhere.
pub fn driven(draft: &Draft) -> Option<String> {
    draft.way.clone().filter(|way| !way.is_empty())
}

/// Whether there is a plan for what was said.
pub fn is_planned(state: &State, shared: &Shared) -> bool {
    let plan = shared.document.plan().filter(|_| state.command.live.is_none());
    plan.is_some_and(|plan| plan.reached && !plan.actions.is_empty() && !is_asking(shared))
}

/// Where a command was said, what it means is shown; the plan for it is undone.
fn begin_anew(state: &mut State, shared: &mut Shared) {
    let Some(said) = shared.document.said.clone() else { return };
    state.settle(shared);
    shared.record();
    shared.document.change((*said.world).clone());
    shared.document.draft = None;
    hand::set_mode(state, shared, Mode::Teach);
    learn::typed(state, &said.answer.command);
}
