//! What the engines say of experiments.

use super::pool::{Outcome, Said};
use super::share::{self, Ground, tell};
use super::state::{Found, State};
use super::words::Text;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{Event, Request, Rules};
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
            state.results.insert(0, Rc::new(Found::new(plan, *joined)));
        }
        (Event::Refused { message }, _) => {
            share::give_up(state);
            tell(state, desk, message);
        }
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
    let asked = pool.asks().map(str::to_owned);
    share::leave(state, desk);
    let text = Text::of(desk.language);
    match outcome {
        Outcome::Works => {}
        Outcome::Found(plan, shards) => desk.ask(Request::JoinRuns { plan, shards }),
        Outcome::Demonstrated(found) => {
            desk.say((text.ended)(1));
            state.six = Some(Rc::new(*found));
        }
        Outcome::Asked(model, known) => {
            let (model, rules) = (Some(model), Rules::default());
            desk.send(Request::Audit { model, rules, known }, false);
        }
        Outcome::Failed(message) => match asked {
            // The engine of the data asks by itself.
            Some(model) => {
                let (model, rules) = (Some(model), Rules::default());
                desk.send(Request::Audit { model, rules, known: Vec::new() }, false);
            }
            None => {
                share::give_up(state);
                tell(state, desk, message);
            }
        },
    }
}
