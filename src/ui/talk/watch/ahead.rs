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
    let (Some(plan), Some(reading)) = (shared.document.plan(), shared.document.reading()) else {
        return;
    };
    let is_open = plan.over().is_some_and(|over| over > 0);
    let playback = state.watch.playback.as_ref().filter(|playback| playback.playing());
    let ahead = (MS / state.watch.speed.step_ms()) as usize;
    let run = playback.and_then(|playback| playback.until(playback.at() + ahead));
    // A plan that was made on the way does not begin where the words were said.
    let run =
        run.filter(|run| shared.document.said.as_ref().map(|said| &*said.world) == run.first());
    let is_asked = is_open && state.watch.has_policy && !state.watch.is_best;
    if let Some(run) = run.filter(|_| is_asked && !shared.talker.is_at(|_| true)) {
        let (form, rules) = (reading.form.clone(), shared.document.rules);
        shared.send(Request::GoOn { form, run: run.to_vec(), rules }, false);
    }
}

/// A way on from after so many actions has come: it is taken if it is shorter and the robot is not beyond where it begins.
pub(crate) fn came(state: &mut State, shared: &mut Shared, from: usize, way: &PlanText) {
    let (Some(playback), Some(said)) = (&mut state.watch.playback, &mut shared.document.said)
    else {
        return;
    };
    let (Some(plan), Some(first), Some(last)) = (&said.plan, way.states.first(), way.states.last())
    else {
        return;
    };
    state.watch.is_best = way.reason.is_none();
    let is_there = from >= playback.at() && playback.state(from) == Some(first);
    if !is_there || !way.reached || from + way.actions.len() >= playback.steps() {
        return;
    }
    let mut plan = (**plan).clone();
    plan.actions.splice(from.., way.actions.iter().cloned());
    plan.states.splice(from.., way.states.iter().cloned());
    if !plan.done.is_empty() {
        plan.done.splice(from.., way.done.iter().copied());
    }
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
