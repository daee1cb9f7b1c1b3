//! What the engine says of studies.

use super::state::State;
use super::update::pack;
use super::words::Text;
use crate::ui::train::desk::Desk;
use crate::worker::protocol::{Event, StudySaid};

/// Something is being done.
pub fn progressed(state: &mut State, said: &StudySaid) {
    match said {
        StudySaid::Making(done, of) => state.making = Some((*done, *of)),
        StudySaid::Judging(done, of) => state.judging = Some((*done, *of)),
        _ => {}
    }
}

/// Something that was asked has been answered.
pub fn answered(state: &mut State, desk: &mut Desk, event: Event) {
    let text = Text::of(desk.language);
    (state.making, state.judging) = (None, None);
    let said = match event {
        Event::Study(StudySaid::Made { study, open }) => {
            state.open = open;
            match state.take(&study) {
                Ok(()) => {
                    pack(state, desk);
                    (text.made)(state.study.as_ref().map_or(0, |study| study.items.len()))
                }
                Err(error) => error.to_string(),
            }
        }
        Event::Study(StudySaid::Judged(verdicts)) => {
            let study = state.against();
            let n = verdicts.len();
            state.review.judged(&study, verdicts);
            (text.judged)(n)
        }
        Event::Refused { message } => message,
        _ => return,
    };
    desk.say(said.clone());
    state.notice = Some(said);
}
