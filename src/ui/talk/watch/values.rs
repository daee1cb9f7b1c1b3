//! What the planner is asked for besides the plan: what the cells are worth, and what comes of many runs.

use super::course;
use super::state::{Layer, Values};
use crate::domain::State as World;
use crate::ui::page::preferences::Depth;
use crate::ui::page::shared::Shared;
use crate::ui::talk::state::State;
use crate::worker::protocol::Request;

/// How often a policy is followed when a person asks for it.
pub const RUNS: u32 = 500;

/// Asks for the values of the world that is shown, if they are to be seen and not known.
pub(crate) fn look(state: &State, shared: &mut Shared) {
    let wanted = shared.depth >= Depth::See
        && (state.watch.shows(Layer::Values) || state.watch.shows(Layer::Arrows))
        && state.watch.has_policy;
    let shown = state.shown(shared);
    let done = course::done(state, shared);
    let is_known = |values: &Values| values.done == done && same_around(&values.of, shown);
    let known = state.watch.values.as_ref().is_some_and(is_known);
    if wanted && !known {
        let shown = shown.clone();
        shared.talker.retain(|request| !matches!(request, Request::Values { .. }));
        shared.send(Request::Values { state: shown, done }, false);
    }
}

/// Whether two worlds differ in nothing but where the robot is: their values are the same.
fn same_around(a: &World, b: &World) -> bool {
    a.objects == b.objects && a.doors == b.doors && a.rooms == b.rooms
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
