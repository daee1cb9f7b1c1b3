//! What the page does for the workbench, a program of its own: has it fetched, and does what it tells.

use super::action::View;
use super::keep;
use super::state::{Bench, State};
use super::words::Text;
use crate::ui::page::document::Origin;
use crate::ui::page::effect::Effect;
use crate::ui::page::files::Given;
use crate::ui::page::model;
use crate::ui::page::news::News;

/// It is to be seen: has it fetched, if it is not there.
pub(super) fn begin(state: &mut State) {
    if matches!(state.bench, Bench::Absent | Bench::Lost(_)) {
        state.bench = Bench::Coming;
        state.shared.want(Effect::LoadWorkbench);
    }
}

/// It has come, or has not.
pub(super) fn loaded(state: &mut State, came: Result<(), String>) {
    state.bench = match came {
        Ok(()) => Bench::Here,
        Err(why) => {
            let words = (Text::of(state.shared.language).no_workbench)(&why);
            state.shared.say(words);
            Bench::Lost(why)
        }
    };
}

/// It tells something.
pub(super) fn told(state: &mut State, news: News) {
    match news {
        News::Say(words) => state.shared.say(words),
        News::Give(given) => give(state, given),
        News::Use { text, corpus } => {
            model::open(&mut state.shared, text, Origin::Trained(corpus));
        }
    }
}

/// Gives the robot what a person brought.
pub(super) fn give(State { shared, view, .. }: &mut State, given: Given) {
    match given {
        Given::Model(text) => {
            model::open(shared, text, Origin::File);
            if *view == View::Kept {
                *view = View::Talk;
            }
        }
        Given::Session(text) => {
            keep::put_aside(shared);
            shared.want(Effect::ReadSession(text));
            *view = View::Talk;
        }
    }
}
