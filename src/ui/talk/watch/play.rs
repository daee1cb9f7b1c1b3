//! A plan on its way: step by step by itself, or to where a person wants it.

use super::ahead;
use super::playback::Playback;
use super::state::Speed;
use super::values::look;
use crate::ui::page::shared::Shared;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;

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
        ahead::look(state, shared);
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
