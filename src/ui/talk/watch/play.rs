//! Playing a plan step by step, and asking the planner for what is to be seen of its policy.

use super::playback::Playback;
use super::state::{Layer, Speed};
use crate::domain::State as World;
use crate::ui::page::preferences::Depth;
use crate::ui::page::shared::Shared;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use crate::worker::protocol::Request;

/// How often a policy is followed when a person asks for it.
pub const RUNS: u32 = 500;

/// There is a plan for the reading that is chosen, or there can be none: it is played, and the world goes on from its
/// end.
pub(crate) fn begin(state: &mut State, shared: &mut Shared) {
    let plan = shared.document.plan();
    let work = plan.and_then(|plan| plan.work.clone());
    let playback = plan.and_then(|plan| Playback::begin(plan));
    state.watch.end(work, shared.clock);
    state.watch.playback = playback;
    if let Some(last) = state.watch.playback.as_ref().and_then(Playback::last) {
        shared.document.world = last.clone();
        shared.want(state.watch.tick());
    }
    look(state, shared);
}

/// Asks for the values of the world that is shown, if they are to be seen and not known.
pub(crate) fn look(state: &State, shared: &mut Shared) {
    let wanted = shared.depth >= Depth::See
        && (state.watch.shows(Layer::Values) || state.watch.shows(Layer::Arrows))
        && state.watch.has_policy;
    let shown = state.shown(shared);
    let known = state.watch.values.as_ref().is_some_and(|values| same_around(&values.of, shown));
    if wanted && !known {
        let shown = shown.clone();
        shared.talker.retain(|request| !matches!(request, Request::Values { .. }));
        shared.send(Request::Values { state: shown }, false);
    }
}

/// Whether two worlds differ in nothing but where the robot is: their values are the same.
fn same_around(a: &World, b: &World) -> bool {
    a.objects == b.objects && a.doors == b.doors && a.rooms == b.rooms
}

/// It is time for the next step, if this timer is the one that counts.
pub(crate) fn rang(state: &mut State, shared: &mut Shared, play: u32) {
    if !state.watch.awaits(play) {
        return;
    }
    let Some(playback) = &mut state.watch.playback else { return };
    playback.advance();
    let text = Text::of(shared.language);
    if let Some(event) = playback.surprise() {
        shared.say(text.surprise(event));
    }
    let (playing, ended, steps) = (playback.playing(), playback.ended(), playback.steps());
    if playing {
        shared.want(state.watch.tick());
    } else if ended {
        let robot = text.phrases.robot(state.shown(shared));
        shared.say(format!("{} {robot}", (text.done_in)(steps)));
    }
    look(state, shared);
}

/// Plays or pauses.
pub(crate) fn toggle(state: &mut State, shared: &mut Shared) {
    let Some(playback) = &mut state.watch.playback else { return };
    if playback.playing() {
        playback.pause();
        state.watch.hold();
    } else {
        playback.play();
        shared.want(state.watch.tick());
    }
}

/// Goes to a step, and pauses there.
pub(crate) fn seek(state: &mut State, shared: &mut Shared, step: usize) {
    let Some(playback) = &mut state.watch.playback else { return };
    playback.seek(step);
    let text = Text::of(shared.language);
    let step = text.step(playback);
    state.watch.hold();
    let robot = text.phrases.robot(state.shown(shared));
    shared.say(format!("{step} {robot}"));
    look(state, shared);
}

/// Plays faster or slower.
pub(crate) fn set_speed(state: &mut State, shared: &mut Shared, speed: Speed) {
    state.watch.speed = speed;
    if state.watch.playback.as_ref().is_some_and(Playback::playing) {
        shared.want(state.watch.tick());
    }
}

/// Shows or hides a layer of the room.
pub(crate) fn toggle_layer(state: &mut State, shared: &mut Shared, layer: Layer) {
    let shown = &mut state.watch.layers[layer as usize];
    *shown = !*shown;
    look(state, shared);
}

/// Follows the policy many times.
pub(crate) fn try_many(state: &mut State, shared: &mut Shared) {
    state.watch.runs = None;
    shared.talker.retain(|request| !matches!(request, Request::RollOut { .. }));
    shared.send(Request::RollOut { runs: RUNS, seed: 0 }, true);
}
