//! All of the corpus: its files, its rows, and what is decided of them.

use super::care::{Decide, rules};
use super::files::files;
use super::filters::filters;
use super::grid::{Grid, Words};
use super::mapping::mapping;
use super::row::row;
use super::split::Parting;
use crate::ui::train::data::action::Action;
use crate::ui::train::data::sheet::Sheet;
use crate::ui::train::data::state::State;
use crate::ui::train::data::words::Text;
use crate::ui::train::desk::Desk;
use yew::{Callback, Html, html};

/// The corpus.
pub(crate) fn panel(state: &State, desk: &Desk, act: &Callback<Action>) -> Html {
    let text = Text::of(desk.language);
    html! {
        <div class="data">
            { files(state, text, act) }
            if let Some(columns) = &state.columns { { mapping(columns, text, act) } }
            if let Some(sheet) = &state.sheet { { rows(state, sheet, desk, text, act) } }
        </div>
    }
}

fn rows(
    state: &State,
    sheet: &Sheet,
    desk: &Desk,
    text: &'static Text,
    act: &Callback<Action>,
) -> Html {
    let (theme, view) = (desk.preferences.theme, &sheet.table.view);
    let n_picked = sheet.table.picked.len();
    let rows = match n_picked {
        0 => (text.all_seen)(sheet.table.total()),
        n => (text.picked)(n),
    };
    let can_audit = desk.in_use.is_some() && !desk.is_learning() && state.auditing.is_none();
    let names = sheet.report.files.iter().map(|file| file.name.clone());
    let files: Vec<String> = if sheet.files.len() > 1 { names.collect() } else { Vec::new() };
    let (undo, redo) = (sheet.care.undo.is_some(), sheet.care.redo.is_some());
    html! {
        <div class="bench">
            <div class="card table">
                { filters(sheet, text, act) }
                <Grid sheet={sheet.clone()} words={Words(text)} {theme} act={act.clone()} />
                <Decide {rows} {n_picked} rule={view.rule} {undo} {redo} words={Words(text)} act={act.clone()} />
            </div>
            <div class="column">
                { row(sheet, text, theme, act) }
                { rules(state, sheet, can_audit, text, act) }
                <Parting words={Words(text)} task={view.task.clone()} worker={view.worker.clone()} {files} act={act.clone()} />
            </div>
        </div>
    }
}
