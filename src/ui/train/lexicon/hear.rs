//! What the engine says of what was learned.

use super::state::State;
use super::update;
use super::words::Text;
use crate::ui::page::news::News;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{Event, Request};
use std::rc::Rc;

/// Something that was asked has been answered.
pub fn answered(state: &mut State, desk: &mut Desk, request: &Request, event: Event) {
    let text = Text::of(desk.language);
    match (event, request) {
        (Event::Entries(window), Request::Entries { view, .. }) if *view == state.view => {
            state.window = Some(Rc::new(*window));
        }
        (Event::Errors(errors), _) => state.errors = Some(Rc::new(*errors)),
        (Event::Difference(difference), _) => {
            let name = std::mem::take(&mut state.comparing);
            state.difference = Some((name, Rc::new(*difference)));
            desk.say(text.compared);
        }
        (Event::Trained(report), Request::Without { places }) => {
            let corpus = (text.without)(places.len());
            desk.want(Effect::Tell(News::Use { text: report.model, corpus }));
            state.picked.clear();
        }
        // Nothing was learned here: what the robot knows is looked at.
        (Event::Refused { .. }, Request::Entries { .. }) if desk.in_use.is_some() => {
            update::give(desk);
        }
        (Event::Heard, Request::KeepModel { .. }) => {
            state.is_robots = true;
            update::ask(state, desk);
        }
        // Nobody was asked about the rows yet: there are no errors to be seen.
        (Event::Refused { .. }, Request::Errors) => state.errors = None,
        (Event::Refused { message }, _) => {
            desk.say(message.clone());
            state.notice = Some(message);
        }
        _ => {}
    }
}
