//! What the page does by itself for who has just come: one command is typed, letter by letter, sent, and done. It ends
//! at the first key or touch, or when something is said, and is not begun for who prefers less motion, opened a link, did
//! something already, or comes back to a session.

use super::state::Demo;
use crate::ui::page::effect::{Effect, Timer};
use crate::ui::page::shared::Shared;
use crate::ui::page::world::WORLDS;
use crate::ui::talk::command::ask;
use crate::ui::talk::state::State;
use crate::ui::talk::watch::play;

/// Milliseconds before the first letter, from letter to letter, and before it is sent.
const WAITS: [u32; 3] = [1_000, 55, 900];

/// It is wanted, unless something was done already.
pub(crate) fn want(state: &mut State, shared: &mut Shared) {
    if state.demo == Demo::Unwanted && !shared.preferences.reduced_motion {
        state.demo = Demo::Wanted;
        begin(state, shared);
    }
}

/// A command can be sent, perhaps.
pub fn begin(state: &mut State, shared: &mut Shared) {
    if state.demo != Demo::Wanted || !shared.can_ask() || !shared.keep.is_read() {
        return;
    }
    let is_fresh = shared.document.said.is_none()
        && shared.keep.origin.is_none()
        && state.command.input.is_empty()
        && shared.document.preset == Some(0)
        && shared.document.lessons.is_empty();
    state.demo = if is_fresh { Demo::Typing(0) } else { Demo::Over };
    if is_fresh {
        shared.want(Effect::StartTimer(Timer::Demo(0), WAITS[0]));
    }
}

/// It is time for the next letter, or to send the command.
pub fn rang(state: &mut State, shared: &mut Shared, number: u32) {
    let (Demo::Typing(letters), Some(world)) = (state.demo, WORLDS.first()) else { return };
    if number as usize != letters {
        return;
    }
    if let Some(words) = world.example.get(..=letters) {
        ask::typed(state, shared, words);
        state.demo = Demo::Typing(letters + 1);
        let wait = if letters + 1 < world.example.len() { WAITS[1] } else { WAITS[2] };
        shared.want(Effect::StartTimer(Timer::Demo(number + 1), wait));
    } else {
        state.demo = Demo::Doing;
        ask::ask(state, shared);
    }
}

/// A person has touched the page: it is theirs from now on.
pub(crate) fn end(state: &mut State, shared: &mut Shared) {
    match std::mem::replace(&mut state.demo, Demo::Over) {
        Demo::Typing(_) => ask::typed(state, shared, ""),
        Demo::Doing => {
            if state.watch.playback.as_ref().is_some_and(|plan| plan.playing()) {
                play::toggle(state, shared);
            }
        }
        Demo::Unwanted | Demo::Wanted | Demo::Over => {}
    }
}
