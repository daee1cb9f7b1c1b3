//! Asking: a command is read while it is typed, sent to be answered, and may be meant in another way.

use super::query::query;
use super::state::MOST_CHARACTERS;
use crate::domain::State as World;
use crate::ui::page::effect::Effect;
use crate::ui::page::engine::Health;
use crate::ui::page::shared::Shared;
use crate::ui::talk::room::state::Mode;
use crate::ui::talk::state::State;
use crate::ui::talk::teach::other::in_other_words;
use crate::ui::talk::words::Text;
use crate::worker::protocol::{Request, WorldRules};
use std::rc::Rc;

/// Whether a command is being answered, or planned for.
pub fn is_asking(shared: &Shared) -> bool {
    shared.talker.is_at(|r| matches!(r, Request::Ask { .. } | Request::Plan { .. }))
}

/// The readings to choose from, as places, while the last command waits for that.
pub fn question<'a>(state: &State, shared: &'a Shared) -> Option<&'a [usize]> {
    let said = shared.document.said.as_ref().filter(|said| said.plan.is_none())?;
    let is_open = state.command.live.is_none() && !is_asking(shared);
    Some(&said.answer.asks[..]).filter(|asks| is_open && !asks.is_empty())
}

/// Another command stands in the box.
pub(crate) fn typed(state: &mut State, shared: &mut Shared, command: &str) {
    state.command.input = command.chars().take(MOST_CHARACTERS).collect();
    state.command.early = false;
    read(state, shared);
}

/// Reads what stands in the box, without planning: what is typed is understood at once, in place of what was asked before.
pub(crate) fn read(state: &mut State, shared: &mut Shared) {
    let is_read = |request: &Request| matches!(request, Request::Read { .. });
    shared.talker.retain(|request| !is_read(request));
    let command = state.command.input.clone();
    let said = shared.document.said.as_ref();
    (state.command.query, state.command.reply) = (None, None);
    let is_none = query(&command).is_some() || in_other_words(&command).is_some();
    if is_none
        || command.trim().is_empty()
        || said.is_some_and(|said| said.answer.command == command)
    {
        state.command.live = None;
    } else if shared.document.model.is_some() && shared.talker.health == Health::Ready {
        let world = state.shown(shared).clone();
        shared.send(Request::Read { command, state: world }, true);
    }
}

/// Sends a command in place of what stands in the box.
pub(crate) fn ask_for(state: &mut State, shared: &mut Shared, command: String) {
    state.command.input = command;
    ask(state, shared);
}

/// Sends the command in the box.
pub(crate) fn ask(state: &mut State, shared: &mut Shared) {
    if !shared.can_ask() {
        return ask_soon(state, shared);
    }
    state.settle(shared);
    state.room.mode = Mode::Watch;
    state.room.let_go();
    state.command.forget();
    (state.teach.notice, state.teach.offer) = (None, None);
    shared.want(Effect::Reveal("scene"));
    let command = state.command.input.clone();
    request(state, shared, |world, rules| Request::Ask { command, state: world, rules });
}

/// Sent before the model has come: it is said when that has.
pub(super) fn ask_soon(state: &mut State, shared: &mut Shared) {
    state.command.early = shared.can_ask_soon() && !state.command.input.trim().is_empty();
    if state.command.early {
        shared.say(Text::of(shared.language).soon);
    }
}

/// Means the last command in another of its ways.
pub(crate) fn choose(state: &mut State, shared: &mut Shared, reading: usize) {
    let Some(said) = &shared.document.said else { return };
    if said.chosen == reading && said.plan.is_some() || said.answer.readings.get(reading).is_none()
    {
        return;
    }
    state.settle(shared);
    shared.record();
    if let Some(said) = &mut shared.document.said {
        said.chosen = reading;
        said.plan = None;
    }
    (state.command.node, state.command.preview, state.command.link) = (None, None, None);
    plan_again(state, shared);
}

/// Does what can be done instead of the last command, from where that came to nothing.
pub(crate) fn instead(state: &mut State, shared: &mut Shared) {
    let plan = shared.document.plan().cloned();
    let Some((plan, instead)) = plan.and_then(|plan| Some((plan.clone(), plan.instead.clone()?)))
    else {
        return;
    };
    state.settle(shared);
    shared.record();
    let world = shared.document.world.clone();
    let Some(said) = &mut shared.document.said else { return };
    if plan.reason.as_deref() == Some("broken") {
        said.world = Rc::new(world);
    }
    let answer = Rc::make_mut(&mut said.answer);
    answer.readings.push(instead.reading);
    (said.chosen, said.plan) = (answer.readings.len() - 1, None);
    plan_again(state, shared);
}

/// Other rules hold in the world.
pub(crate) fn set_rules(state: &mut State, shared: &mut Shared, rules: WorldRules) {
    shared.record();
    shared.document.rules = rules;
    plan_again(state, shared);
}

/// Plans anew for the reading that is chosen, from the world that the command was said in.
pub(super) fn plan_again(state: &mut State, shared: &mut Shared) {
    state.watch.playback = None;
    let Some(said) = &shared.document.said else { return };
    let Some(reading) = said.answer.readings.get(said.chosen) else { return };
    let form = reading.form.clone();
    shared.document.world = (*said.world).clone();
    request(state, shared, |world, rules| Request::Plan { form, run: vec![world], rules });
}

/// Plans anew for what was said last, after what was since then: the world is another than it was to be.
pub(crate) fn plan_on(state: &mut State, shared: &mut Shared, run: Vec<World>) {
    let Some((said, world)) = shared.document.said.as_mut().zip(run.last()) else { return };
    let Some(form) = said.answer.readings.get(said.chosen).map(|one| one.form.clone()) else {
        return;
    };
    said.plan = None;
    shared.document.world = world.clone();
    request(state, shared, |_, rules| Request::Plan { form, run, rules });
}

fn request(
    state: &mut State,
    shared: &mut Shared,
    make: impl FnOnce(World, WorldRules) -> Request,
) {
    // What waits is about the plan before.
    shared
        .talker
        .retain(|request| matches!(request, Request::OpenModel { .. } | Request::Words { .. }));
    state.watch.begin(shared.clock);
    let request = make(shared.document.world.clone(), shared.document.rules);
    shared.send(request, true);
}
