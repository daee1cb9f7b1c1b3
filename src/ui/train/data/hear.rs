//! What the engine says of the corpus.

use super::look;
use super::mapping::Desk as Columns;
use super::open;
use super::sheet::{SMALL, Sheet};
use super::state::{Refused, State};
use super::words::Text;
use crate::ui::train::desk::Desk;
use crate::ui::train::effect::Effect;
use crate::worker::protocol::{Care, CorpusFile, Event, MappedFile, Request, SheetReport};
use std::rc::Rc;

/// How far something is.
pub fn progressed(state: &mut State, event: &Event) {
    match event {
        Event::Reading { done, of } => state.reading = Some((*done, *of)),
        Event::Auditing { done, of } => state.auditing = Some((*done, *of)),
        _ => {}
    }
}

/// A request has been answered.
pub fn answered(state: &mut State, desk: &mut Desk, request: Request, event: Event) {
    match &request {
        Request::OpenSheet { .. } => state.reading = None,
        Request::Audit { .. } => state.auditing = None,
        _ => {}
    }
    match (event, request) {
        (Event::Sheet(report), Request::OpenSheet { files, with_rejected }) => {
            opened(state, desk, *report, files, with_rejected);
        }
        (Event::Window(window), Request::Window { view, .. }) => {
            if let Some(sheet) = &mut state.sheet {
                sheet.table.came(&view, *window);
                look::ask(sheet, desk);
            }
        }
        (Event::Facets(facets), _) => {
            state.sheet.iter_mut().for_each(|sheet| sheet.facets = facets.clone().into());
        }
        (Event::Care(care), request) => cared(state, desk, care, request),
        (Event::Row { row, pairs }, _) => {
            let (row, pairs) = (row as u32, Rc::new(pairs));
            if let Some(sheet) = &mut state.sheet {
                let open = sheet.open.iter_mut().filter(|open| open.row == row);
                open.for_each(|open| open.pairs = Some(pairs.clone()));
                if sheet.is_small() {
                    sheet.pairs.insert(row, pairs);
                }
            }
        }
        (Event::RowReading(reading), _) => {
            let open = state.sheet.iter_mut().filter_map(|sheet| sheet.open.as_mut());
            for open in open.filter(|open| open.row == reading.row) {
                open.reading = Some(Rc::new((*reading).clone()));
            }
        }
        (Event::Previewed(preview), Request::Preview { .. }) => {
            let files: Rc<[CorpusFile]> = state.to_map.clone();
            state.columns = Some(Columns::new(files, *preview));
        }
        (Event::Saved { name, bytes }, _) => {
            desk.want(Effect::GiveBack(CorpusFile { name, bytes: bytes.into() }));
        }
        (Event::Cancelled, Request::OpenSheet { .. }) => {
            let words = Text::of(desk.language).reading_stopped;
            open::say(state, desk, words.to_owned());
        }
        (Event::Refused { message }, request) => {
            let is_files = matches!(request, Request::OpenSheet { .. } | Request::Preview { .. });
            if is_files || matches!(request, Request::SaveSheet { .. } | Request::Audit { .. }) {
                open::say(state, desk, message);
            } else {
                desk.say(message);
            }
        }
        _ => {}
    }
}

/// Files were read.
fn opened(
    state: &mut State,
    desk: &mut Desk,
    report: SheetReport,
    files: Vec<MappedFile>,
    with_rejected: bool,
) {
    let text = Text::of(desk.language);
    let useless: Vec<String> = report
        .files
        .iter()
        .filter_map(|file| Some(format!("{}: {}", file.name, file.useless.as_ref()?)))
        .collect();
    if !useless.is_empty() {
        let message = (text.no_rows)(&useless.join(" "));
        desk.say(message.clone());
        let SheetReport { files: reports, faults, .. } = report;
        state.refused = Some(Refused { message, reports, faults, files });
        return;
    }
    let mut sheet = Sheet::new(report, files, with_rejected);
    match state.sheet.take() {
        // An engine that began anew has read it again.
        Some(before) if before.report == sheet.report && before.files == sheet.files => {
            sheet.table.view = before.table.view;
        }
        _ => desk.say((text.corpus_open)(&sheet.name, sheet.care.rows as usize)),
    }
    state.refused = None;
    desk.ask(Request::Facets);
    look::ask(&mut sheet, desk);
    if sheet.care.rows <= SMALL {
        for row in 0..sheet.care.rows as usize {
            desk.ask(Request::ShowRow { row });
        }
    }
    state.sheet = Some(sheet);
}

/// The sheet stands otherwise.
fn cared(state: &mut State, desk: &mut Desk, care: Care, request: Request) {
    let Some(sheet) = &mut state.sheet else { return };
    let text = Text::of(desk.language);
    match (&request, care.done) {
        (Request::Undo, Some(done)) => desk.say((text.undone)(&(text.done)(&done))),
        (_, Some(done)) => desk.say((text.done)(&done)),
        (Request::Audit { .. }, None) => {
            sheet.is_audited = true;
            desk.say(text.audited);
        }
        (_, None) => {}
    }
    if !matches!(request, Request::Care) {
        Rc::make_mut(&mut sheet.log).push(request);
    }
    sheet.care = care;
    sheet.table.changed();
    if let Some(before) = sheet.open.take() {
        let opened = look::open(before.row, desk, sheet.is_audited);
        // What is seen stays until what is new has come.
        sheet.open = Some(super::sheet::Open { row: opened.row, ..before });
    }
    desk.ask(Request::Facets);
    look::ask(sheet, desk);
}
