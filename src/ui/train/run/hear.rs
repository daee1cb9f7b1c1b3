//! What the engine says of training.

use super::state::State;
use crate::ui::page::news::News;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::ui::train::words::Text;
use crate::worker::protocol::Event;

/// Training on the corpus of this name has ended.
pub fn ended(state: &mut State, desk: &mut Desk, event: Event, corpus: &str) {
    state.progress = None;
    let text = Text::of(desk.language);
    match event {
        Event::Trained(report) => {
            desk.say((text.trained)(report.valid, report.examples));
            let news = News::Use { text: report.model, corpus: corpus.to_owned() };
            desk.want(Effect::Tell(news));
        }
        Event::Cancelled => {
            state.notice = Some(text.training_stopped.to_owned());
            desk.say(text.training_stopped);
        }
        Event::Refused { message } => {
            desk.say(message.clone());
            state.notice = Some(message);
        }
        _ => {}
    }
}
