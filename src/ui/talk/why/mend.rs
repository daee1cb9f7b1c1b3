//! Does what a button of a message says.

use super::help::Help;
use crate::domain::State as World;
use crate::ui::page::effect::Effect;
use crate::ui::page::shared::Shared;
use crate::ui::talk::command::ask;
use crate::ui::talk::room::edit::{self, Obstacle};
use crate::ui::talk::room::state::Mode;
use crate::ui::talk::room::{hand, worlds};
use crate::ui::talk::state::State;
use crate::ui::talk::teach::learn;
use crate::worker::protocol::WorldRules;

/// Takes up a message's help.
pub(crate) fn mend(state: &mut State, shared: &mut Shared, help: Help) {
    let rules = shared.document.rules;
    match help {
        Help::Say((start, end), phrase) => {
            let Some(answer) = state.heard(shared) else { return };
            let mut words: Vec<String> =
                answer.words.iter().map(|word| word.text.clone()).collect();
            if start <= end && end <= words.len() {
                words.splice(start..end, [phrase]);
                ask::ask_for(state, shared, words.join(" "));
            }
        }
        Help::Just(_) => ask::choose(state, shared, 0),
        Help::Teach => {
            let command = command(state, shared);
            hand::set_mode(state, shared, Mode::Teach);
            learn::typed(state, &command);
            shared.want(Effect::Focus("room"));
        }
        Help::Instead(..) => ask::instead(state, shared),
        Help::Show(link) => state.command.link = Some(link),
        Help::Add(look) => {
            let added = edit::add_anywhere(state.shown(shared), look);
            in_another_room(state, shared, added);
        }
        Help::Edit => {
            hand::set_mode(state, shared, Mode::Edit);
            shared.want(Effect::Focus("room"));
        }
        Help::FreeLandmarks => {
            ask::set_rules(state, shared, WorldRules { landmarks_stay: false, ..rules });
        }
        Help::Pull => ask::set_rules(state, shared, WorldRules { pull: true, ..rules }),
        Help::NoChance => {
            let sure = WorldRules { slip: 0.0, lock: 0.0, loss: 0.0, ..rules };
            ask::set_rules(state, shared, sure);
        }
        Help::Unlock => {
            let unlocked = Ok(edit::unlock(state.shown(shared)));
            in_another_room(state, shared, unlocked);
        }
        Help::OtherWorld => worlds::draw(state, shared),
        // It is a link, which the browser follows.
        Help::Guide => {}
    }
}

/// The command that the answer shown is to.
fn command(state: &State, shared: &Shared) -> String {
    state.heard(shared).map(|answer| answer.command.clone()).unwrap_or_default()
}

/// Changes the room, and says the same in it again.
fn in_another_room(state: &mut State, shared: &mut Shared, changed: Result<World, Obstacle>) {
    let command = command(state, shared);
    // Not what is being demonstrated.
    state.room.mode = Mode::Watch;
    hand::change(state, shared, changed);
    ask::ask_for(state, shared, command);
}
