//! What the engines say of experiments.

use super::pool::{Outcome, Said};
use super::share::{self, Ground, tell};
use super::state::{Found, State};
use super::words::Text;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{Event, Request};
use std::rc::Rc;

/// Something that the engine of the data was asked has been answered.
pub fn answered(
    state: &mut State,
    desk: &mut Desk,
    request: Request,
    event: Event,
    ground: &Ground,
) {
    let text = Text::of(desk.language);
    match (event, request) {
        (Event::Plan { text }, Request::PlanRuns { .. }) => {
            share::run(state, desk, text, ground);
        }
        (Event::Joined(joined), Request::JoinRuns { plan, .. }) => {
            desk.say((text.ended)(joined.runs.len()));
            state.results.insert(0, Rc::new(Found { plan, joined: *joined }));
        }
        (Event::Refused { message }, _) => tell(state, desk, message),
        _ => {}
    }
}

/// An engine of the pool said something.
pub fn told(state: &mut State, desk: &mut Desk, seat: u32, said: Said) {
    let Some(pool) = &mut state.pool else { return };
    let mut errands = Vec::new();
    let outcome = pool.told(seat, said, &mut errands);
    for (seat, errand) in errands {
        desk.want(Effect::Pool(seat, errand));
    }
    if outcome == Outcome::Works {
        return;
    }
    share::leave(state, desk);
    let text = Text::of(desk.language);
    match outcome {
        Outcome::Works => {}
        Outcome::Found(plan, shards) => desk.ask(Request::JoinRuns { plan, shards }),
        Outcome::Demonstrated(found) => {
            desk.say((text.ended)(1));
            state.six = Some(Rc::new(*found));
        }
        Outcome::Failed(message) => tell(state, desk, message),
    }
}
