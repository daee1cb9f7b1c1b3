//! A task over time while it is done: its steps, and how far they are; what it forbids, and the way so far.

use super::playback::Playback;
use crate::domain::State as World;
use crate::ui::page::grammar::Phrases;
use crate::ui::page::place::Place;
use crate::ui::page::shared::Shared;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use crate::worker::protocol::{Claim, Noun};

/// How far a step is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stand {
    /// It is done.
    Done,
    /// It is next.
    Next,
    /// Others come before it.
    Later,
}

/// A task over time in short.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Strip {
    /// Its steps in their order.
    pub steps: Vec<(String, Stand)>,
    /// What it forbids.
    pub never: Vec<String>,
}

/// The task of the reading that counts; nothing where that is a goal of states.
pub fn strip(state: &State, shared: &Shared) -> Option<Strip> {
    let reading = state.heard_reading(shared)?;
    let mut strip = Strip::default();
    let phrases = Text::of(shared.language).phrases;
    collect(&reading.claim, phrases, &mut strip);
    let done = usize::from(done(state, shared));
    for (at, (_, stand)) in strip.steps.iter_mut().enumerate() {
        *stand = if at < done {
            Stand::Done
        } else if at == done {
            Stand::Next
        } else {
            Stand::Later
        };
    }
    (strip.steps.len() > 1 || !strip.never.is_empty()).then_some(strip)
}

/// How many steps of a task over time are done in what is shown.
pub fn done(state: &State, shared: &Shared) -> u8 {
    let Some(plan) = shared.document.plan().filter(|_| state.command.live.is_none()) else {
        return 0;
    };
    let at = state.watch.playback.as_ref().map_or(0, Playback::at);
    plan.done.get(at).copied().unwrap_or(0)
}

/// The cells that the robot may not stand in on the way.
pub fn forbidden<'a>(state: &State, shared: &'a Shared) -> &'a [Place] {
    let reading = shared.document.reading().filter(|_| state.command.live.is_none());
    reading.map_or(&[], |reading| &reading.forbidden)
}

/// What was so far, in a task over time.
pub fn way<'a>(state: &'a State, shared: &Shared) -> &'a [World] {
    let is_timed = shared.document.plan().is_some_and(|plan| !plan.done.is_empty());
    let playback = state.watch.playback.as_ref().filter(|_| is_timed);
    playback.map_or(&[], Playback::so_far)
}

fn collect(claim: &Claim, phrases: &dyn Phrases, strip: &mut Strip) {
    match claim {
        Claim::All(parts) if parts.iter().any(|part| matches!(part, Claim::Never(_))) => {
            parts.iter().for_each(|part| collect(part, phrases, strip));
        }
        Claim::Then(parts) => parts.iter().for_each(|part| collect(part, phrases, strip)),
        Claim::Never(denied) => strip.never.push(short(denied, phrases)),
        Claim::Until(both) => {
            let [hold, reach] = &**both;
            collect(reach, phrases, strip);
            if let Claim::Not(denied) = hold {
                strip.never.push(short(denied, phrases));
            }
        }
        other => strip.steps.push((short(other, phrases), Stand::Later)),
    }
}

/// A place by its name, anything else as what is done.
fn short(claim: &Claim, phrases: &dyn Phrases) -> String {
    match claim {
        Claim::Related { relation, nouns } if relation == "in" && nouns[0] == Noun::Robot => {
            phrases.noun(&nouns[1])
        }
        Claim::Any(any) => {
            any.iter().map(|one| short(one, phrases)).collect::<Vec<_>>().join(" / ")
        }
        // What is not to be is said beside.
        Claim::All(all) => {
            let asked = all.iter().filter(|one| !matches!(one, Claim::Not(_)));
            asked.map(|one| short(one, phrases)).collect::<Vec<_>>().join(" + ")
        }
        other => phrases.deed(other).replace('*', ""),
    }
}
