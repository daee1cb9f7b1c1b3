//! What one page wishes of another, done by the only one who knows both.

use super::action::View;
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
    let State { shared, view, talk, train } = state;
    let mut corpora = Vec::new();
    for Offered { name, bytes } in files {
        let opened = bytes.and_then(|bytes| {
            let kind = files::kind(&name, &bytes);
            if kind == Kind::Corpus {
                corpora.push(CorpusFile { name: name.clone(), bytes });
                return Ok(());
            }
            let text = files::text(bytes)?;
            if kind == Kind::Model {
                model::open_file(shared, text);
            } else {
                talk::update::update(talk, shared, talk::Action::Open(Ok(text)));
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
