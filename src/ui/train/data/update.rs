//! Does what a person wants with the corpus.

use super::action::{Action, Map};
use super::state::State;
use super::{care, look, open};
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{CorpusFile, Request};

/// Does what a person wants; whether it is the corpus that there is to be seen of it.
pub fn update(state: &mut State, desk: &mut Desk, action: Action) -> bool {
    match action {
        Action::Offered(files) => return open::open(state, desk, files),
        Action::OpenDemo => open::open_demo(state, desk),
        Action::UseRejected => {
            let refused = state.refused.take().map(|refused| (refused.files, true));
            let refused = refused.filter(|(files, _)| !files.is_empty());
            let open = || {
                let sheet = state.sheet.as_ref()?;
                Some((sheet.files.to_vec(), !sheet.with_rejected))
            };
            if let Some((files, with_rejected)) = refused.or_else(open) {
                open::read(state, desk, files, with_rejected);
            }
        }
        Action::Stop => {
            desk.learner.retain(|request| !matches!(request, Request::OpenSheet { .. }));
            if state.reading.is_some() || state.auditing.is_some() {
                desk.cancel();
            }
        }
        Action::SaveCorpus(form) => {
            for file in 0..state.sheet.as_ref().map_or(0, |sheet| sheet.files.len() as u32) {
                desk.ask(Request::SaveSheet { file, form });
            }
        }
        Action::SaveBadRows(file) => desk.ask(Request::SaveBadRows { file }),
        Action::Look(action) => {
            if let Some(sheet) = &mut state.sheet {
                look::look(sheet, desk, action);
            }
            // Who scrolls is there; a grid that comes to be there tells how far it is scrolled by itself.
            return false;
        }
        Action::Care(action) => {
            if let Some(sheet) = &mut state.sheet {
                care::care(sheet, desk, action);
            }
        }
        Action::Map(action) => map(state, desk, action),
    }
    true
}

/// The workbench is to be seen: it begins with the page's own sentences.
pub fn begin(state: &mut State, desk: &mut Desk) {
    let reads = |request: &Request| matches!(request, Request::OpenSheet { .. });
    if state.sheet.is_none() && !desk.learner.is_at(reads) {
        open::open_demo(state, desk);
    }
}

fn map(state: &mut State, desk: &mut Desk, action: Map) {
    match action {
        Map::Begin => {
            let refused = state.refused.as_ref().map(|refused| &refused.files[..]);
            let open = || state.sheet.as_ref().map(|sheet| &sheet.files[..]);
            let files = refused.filter(|files| !files.is_empty()).or_else(open);
            let files: Vec<CorpusFile> =
                files.unwrap_or_default().iter().map(|one| one.file.clone()).collect();
            if let Some(first) = files.first() {
                desk.ask(Request::Preview { file: first.clone() });
            }
            state.to_map = files.into();
        }
        Map::Choose(at, column) => {
            state.columns.iter_mut().for_each(|columns| columns.choose(at, column));
        }
        Map::Use => {
            if let Some(columns) = &state.columns {
                let files = columns.mapped();
                open::read(state, desk, files, false);
            }
        }
        Map::Save => {
            if let Some(columns) = &state.columns {
                let (name, text) = ("mapping.json".to_owned(), columns.mapping().write());
                desk.want(Effect::Save { name, text });
            }
        }
        Map::Leave => state.columns = None,
    }
}
