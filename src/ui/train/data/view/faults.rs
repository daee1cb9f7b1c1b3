//! What is wrong with files, line by line: what stands there, and what to do.

use crate::ui::train::data::action::Action;
use crate::ui::train::data::words::Text;
use crate::worker::protocol::{Fault, FileReport};
use yew::{Callback, Html, classes, html};

/// So many faults are listed one by one.
const LISTED: usize = 100;

/// What is wrong with some files, and their bad rows to be saved.
pub(super) fn faults(
    text: &Text,
    files: &[FileReport],
    faults: &[Fault],
    act: &Callback<Action>,
) -> Html {
    if faults.is_empty() {
        return Html::default();
    }
    let rest = faults.len().saturating_sub(LISTED);
    let several = files.len() > 1;
    html! {
        <>
            <ul class="problems" data-testid="problems">
                { for faults.iter().take(LISTED).map(|fault| one(text, files, several, fault)) }
                if rest > 0 { <li>{ (text.and_more)(rest) }</li> }
            </ul>
            { for (0..).zip(files).filter(|(_, file)| file.bad_rows > 0).map(|(at, file)| html! {
                <button type="button" class="link" data-testid="save-bad-rows"
                    onclick={act.reform(move |_| Action::SaveBadRows(at))}>
                    { (text.save_bad)(&file.name, file.bad_rows) }
                </button>
            }) }
        </>
    }
}

fn one(text: &Text, files: &[FileReport], several: bool, fault: &Fault) -> Html {
    let name = files.get(fault.file as usize).filter(|_| several).map(|file| &file.name);
    html! {
        <li class={classes!(if fault.kept { "kept" } else { "lost" })} data-testid="problem">
            <span class="where">
                if let Some(name) = name { { name }{", "} }
                { if fault.line > 0 { (text.line)(fault.line) } else { text.file.to_owned() } }
                if let Some(column) = &fault.column { {", "}<code>{ column }</code> }
                { if fault.kept { text.row_kept } else { "" } }
            </span>
            { &fault.what }
            if let Some(snippet) = &fault.snippet { {": "}<code>{ snippet }</code> }
            if let Some(mend) = &fault.mend { {"; "}{ mend } }
        </li>
    }
}
