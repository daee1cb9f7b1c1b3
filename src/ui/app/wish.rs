//! What one page wishes of another, done by the only one who knows both.

use super::action::View;
use super::keep;
use super::state::State;
use crate::ui::page::files::{self, Kind, Offered};
use crate::ui::page::model;
use crate::ui::{talk, train};

/// Does what the Train page wishes.
pub(super) fn grant(state: &mut State, wish: Option<train::Wish>) {
    match wish {
        Some(train::Wish::Open(file)) => open(state, file),
        Some(train::Wish::Use(report, corpus)) => {
            let teach = model::trained(&mut state.shared, report, corpus);
            if teach {
                talk::teach::learn::learn_again(&mut state.talk, &mut state.shared);
            }
        }
        None => {}
    }
}

/// Opens a file on the page that such files are for.
pub(super) fn open(state: &mut State, Offered { name, text }: Offered) {
    let State { shared, view, talk, train, .. } = state;
    match text.map(|text| (files::kind(&name, &text), text)) {
        Ok((Kind::Corpus, text)) => {
            train::update::read_corpus(train, shared, name, text);
            *view = View::Train;
        }
        Ok((Kind::Model, text)) => {
            model::open_file(shared, text);
            if *view == View::Kept {
                *view = View::Talk;
            }
        }
        Ok((Kind::Session, text)) => {
            keep::put_aside(shared);
            talk::update::update(talk, shared, talk::Action::Open(Ok(text)));
            *view = View::Talk;
        }
        Err(fault) => {
            train::update::refuse(train, shared, &name, fault);
            *view = View::Train;
        }
    }
}
