//! What one page wishes of another, done by the only one who knows both.

use super::action::View;
use super::keep;
use super::state::State;
use crate::ui::page::files::{self, Kind, Offered};
use crate::ui::page::model;
use crate::ui::{talk, train};
use crate::worker::protocol::CorpusFile;

/// Does what the Train page wishes.
pub(super) fn grant(state: &mut State, wish: Option<train::Wish>) {
    match wish {
        Some(train::Wish::Open(files)) => open(state, files),
        Some(train::Wish::Use(report, corpus)) => {
            let teach = model::trained(&mut state.shared, report, corpus);
            if teach {
                talk::teach::learn::learn_again(&mut state.talk, &mut state.shared);
            }
        }
        None => {}
    }
}

/// Opens files on the page that such files are for; all corpora among them are one. Where one cannot be read, none is.
pub(super) fn open(state: &mut State, files: Vec<Offered>) {
    let State { shared, view, talk, train, .. } = state;
    let mut corpora = Vec::new();
    for Offered { name, bytes } in files {
        let opened = bytes.and_then(|bytes| {
            match files::kind(&name, &bytes) {
                Kind::Corpus => corpora.push(CorpusFile { name: name.clone(), bytes }),
                Kind::Model => {
                    model::open_file(shared, files::text(bytes)?);
                    if *view == View::Kept {
                        *view = View::Talk;
                    }
                }
                Kind::Session => {
                    let text = files::text(bytes)?;
                    keep::put_aside(shared);
                    talk::update::update(talk, shared, talk::Action::Open(Ok(text)));
                    *view = View::Talk;
                }
            }
            Ok(())
        });
        if let Err(fault) = opened {
            train::update::refuse(train, shared, &name, fault);
            *view = View::Train;
            return;
        }
    }
    if !corpora.is_empty() {
        train::update::read_corpus(train, shared, corpora, false);
        *view = View::Train;
    }
}
