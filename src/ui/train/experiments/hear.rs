//! What the engine says of experiments.

use super::state::{Found, State};
use super::update;
use super::words::Text;
use crate::ui::train::desk::Desk;
use crate::worker::protocol::{Event, Request};
use std::rc::Rc;

/// Something that was asked has been answered.
pub fn answered(state: &mut State, desk: &mut Desk, request: Request, event: Event) {
    let text = Text::of(desk.language);
    if matches!(request, Request::RunShard { .. }) {
        state.progress = None;
    }
    match (event, request) {
        (Event::Plan { text }, Request::PlanRuns { .. }) => update::run(state, desk, text),
        (Event::Shard { text }, Request::RunShard { plan, .. }) => {
            desk.ask(Request::JoinRuns { plan, shards: vec![text] });
        }
        (Event::Joined(joined), Request::JoinRuns { plan, .. }) => {
            desk.say((text.ended)(joined.runs.len()));
            state.results.insert(0, Rc::new(Found { plan, joined: *joined }));
        }
        (Event::Cancelled, _) => {
            desk.say(text.stopped);
            state.notice = Some(text.stopped.to_owned());
        }
        (Event::Refused { message }, _) => {
            desk.say(message.clone());
            state.notice = Some(message);
        }
        _ => {}
    }
}
