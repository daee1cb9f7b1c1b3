//! Rows of the corpus as buttons that open them.

use crate::ui::train::lexicon::action::Action;
use crate::ui::train::lexicon::words::Text;
use crate::worker::protocol::Rows;
use yew::{Callback, Html, html};

/// Buttons that are shown.
const SHOWN: usize = 3;

/// How many rows there are, and the first few.
pub(super) fn rows(rows: &Rows, text: &Text, act: &Callback<Action>) -> Html {
    html! {
        <span class="rows-of">
            <span>{ rows.count }</span>
            { for rows.first.iter().take(SHOWN).map(|&row| html! {
                <button type="button" class="link" data-testid="open-row-of" aria-label={(text.open_row)(row + 1)}
                    onclick={act.reform(move |_| Action::Row(row))}>{ "#" }{ row + 1 }</button>
            }) }
        </span>
    }
}
