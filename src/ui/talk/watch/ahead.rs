//! A plan that is not proved shortest is walked at once; meanwhile a shorter way on is looked for from some steps ahead of
//! the robot, and taken if it comes before the robot is there. Invariant: a plan that is walked only grows shorter.

use crate::ui::page::shared::Shared;
use crate::ui::talk::past::lines;
use crate::ui::talk::state::State;
use crate::worker::protocol::{PlanText, Program, Request};
use std::rc::Rc;

/// Milliseconds that the planner has before the robot is there.
const MS: u32 = 3_000;

/// Whether a request is for a way on.
pub(crate) const fn is_for(request: &Request) -> bool {
    matches!(request, Request::GoOn { .. })
}

/// Looks for a shorter way on, if the plan that is played may be longer than the shortest and nothing else is to be done.
pub(crate) fn look(state: &State, shared: &mut Shared) {
    // Of a task over time this would be another plan's steps that are told.
    let plan = shared.document.plan().filter(|plan| plan.done.is_empty());
    let is_open = plan.and_then(|plan| plan.over()).is_some_and(|over| over > 0);
    let playback = state.watch.playback.as_ref().filter(|playback| playback.playing());
    let ahead = (MS / state.watch.speed.step_ms()) as usize;
    let from = playback.and_then(|playback| playback.state(playback.at() + ahead));
    let is_asked = is_open && state.watch.has_policy && !state.watch.is_best;
    if let Some(from) = from.filter(|_| is_asked && !shared.talker.is_at(|_| true)) {
        shared.send(Request::GoOn { run: vec![from.clone()] }, false);
    }
}

/// A way on has come: it is taken if it is shorter and the robot is not beyond where it begins.
pub(crate) fn came(state: &mut State, shared: &mut Shared, way: &PlanText) {
    let (Some(playback), Some(said)) = (&mut state.watch.playback, &mut shared.document.said)
    else {
        return;
    };
    let (Some(plan), Some(first), Some(last)) = (&said.plan, way.states.first(), way.states.last())
    else {
        return;
    };
    state.watch.is_best = way.reason.is_none();
    let mut left = playback.at()..=playback.steps();
    let Some(from) = left.find(|&at| playback.state(at) == Some(first)) else { return };
    if !way.reached || from + way.actions.len() >= playback.steps() {
        return;
    }
    let mut plan = (**plan).clone();
    plan.actions.splice(from.., way.actions.iter().cloned());
    plan.states.splice(from.., way.states.iter().cloned());
    playback.go_on_by(&plan);
    shared.document.world = last.clone();
    said.plan = Some(Rc::new(plan));
    lines::note(state, shared, false);
}

/// Something else is to be done: nothing is looked for.
pub(crate) fn end(shared: &mut Shared) {
    let pending = shared.talker.pending.as_ref();
    if pending.is_some_and(|pending| is_for(&pending.request)) {
        shared.cancel(Program::Talker);
    }
}
