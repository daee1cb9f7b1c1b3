//! Does what a person wants about training.

use super::action::Action;
use super::state::{SETTINGS, State, can_train, is_training};
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::ui::train::words::Text;
use crate::worker::protocol::{Request, SeedLexicon};

/// Does what a person wants; the corpus that is open has so many commands, and this is known before.
pub fn update(
    state: &mut State,
    desk: &mut Desk,
    action: Action,
    commands: usize,
    lexicon: SeedLexicon,
) {
    match action {
        Action::Train if can_train(desk, commands) => {
            (state.notice, state.progress) = (None, None);
            desk.say(Text::of(desk.language).training_begun);
            desk.send(Request::Train { lexicon, settings: SETTINGS }, true);
        }
        Action::Train => {}
        Action::Cancel => {
            desk.learner.retain(|request| !matches!(request, Request::Train { .. }));
            if is_training(desk) {
                desk.cancel();
            }
        }
        Action::SaveModel => {
            if let Some(model) = &desk.in_use {
                let text = model.report.model.clone();
                desk.want(Effect::Save { name: "groundling.model".to_owned(), text });
            }
        }
    }
}
