//! Something was taken elsewhere in the room that is watched: what that is to mean is asked where it was put down.

use super::hand;
use super::state::{Mode, Moved};
use crate::ui::page::effect::Effect;
use crate::ui::page::shared::Shared;
use crate::ui::talk::command::ask;
use crate::ui::talk::state::State;

/// What it is to mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meant {
    /// It shows what a command means, which is then said.
    Lesson,
    /// The world is to be like that.
    World,
    /// Nothing.
    Nothing,
}

/// The person says what it means.
pub(crate) fn mean(state: &mut State, shared: &mut Shared, meant: Meant) {
    let Some(Moved { world, mut run, .. }) = state.room.moved.take() else { return };
    match meant {
        Meant::Lesson => {
            shared.document.draft = None;
            hand::set_mode(state, shared, Mode::Teach);
            shared.document.draft().show(world, None);
            shared.want(Effect::Focus("lesson"));
        }
        // What is at work goes on from there, or says why it cannot.
        Meant::World if !run.is_empty() => {
            run.push(world);
            shared.record();
            ask::plan_on(state, shared, run);
        }
        Meant::World => hand::change(state, shared, Ok(world)),
        Meant::Nothing => {}
    }
    if meant != Meant::Lesson {
        shared.want(Effect::Focus("command"));
    }
}
