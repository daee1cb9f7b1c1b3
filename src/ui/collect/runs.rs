//! Runs on view: each is played before one's eyes, by itself or a step at a time. One is played at once; what was not
//! watched to its end was not seen.

use super::effect::Effect;
use super::state::{Stage, State};
use crate::study::Showing;

/// Milliseconds of a step.
pub const PACE: u32 = 450;

/// What is on view: the showings of the turn, or those of the worked example.
pub fn on_view(state: &State) -> Vec<&Showing> {
    let Some((study, _)) = &state.study else { return Vec::new() };
    match state.stage() {
        Stage::Instructions => study
            .words
            .example
            .as_ref()
            .map_or(Vec::new(), |example| example.shows.iter().collect()),
        Stage::Turn(at) => {
            let turn = state.sitting.as_ref().and_then(|sitting| sitting.turns.get(at));
            let item = turn.and_then(|turn| Some((turn, study.items.get(turn.item)?)));
            item.map_or(Vec::new(), |(turn, item)| {
                turn.shows.iter().filter_map(|&at| item.shows.get(at)).collect()
            })
        }
        _ => Vec::new(),
    }
}

/// Whether a showing can be said to be seen when it is in sight.
pub fn is_shown(state: &State, at: usize) -> bool {
    let is_run = on_view(state).get(at).is_some_and(|showing| showing.steps().is_some());
    !is_run || state.runs.watched.contains(&at)
}

/// Plays a run, or has it rest.
pub(super) fn play(state: &mut State, at: usize) -> Vec<Effect> {
    if state.runs.playing.take() == Some(at) {
        return Vec::new();
    }
    let steps = on_view(state).get(at).and_then(|showing| showing.steps()).unwrap_or(0);
    let gone = state.runs.gone.entry(at).or_default();
    if *gone >= steps {
        *gone = 0;
    }
    state.runs.playing = Some(at);
    vec![Effect::Tick(PACE)]
}

/// The run that is played goes on.
pub(super) fn ticked(state: &mut State) -> Vec<Effect> {
    let Some(at) = state.runs.playing else { return Vec::new() };
    if step(state, at) { vec![Effect::Tick(PACE)] } else { Vec::new() }
}

/// A run goes on by a step; whether there is more of it.
pub(super) fn step(state: &mut State, at: usize) -> bool {
    let Some(steps) = on_view(state).get(at).and_then(|showing| showing.steps()) else {
        return false;
    };
    let runs = &mut state.runs;
    let gone = runs.gone.entry(at).or_default();
    *gone = (*gone + 1).min(steps);
    let is_over = *gone == steps;
    if is_over {
        runs.watched.insert(at);
        runs.playing.take_if(|playing| *playing == at);
    }
    !is_over
}
