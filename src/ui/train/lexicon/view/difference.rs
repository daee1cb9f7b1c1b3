//! What tells two models apart.

use super::table::table;
use crate::ui::page::view::files::open_file;
use crate::ui::train::lexicon::action::Action;
use crate::ui::train::lexicon::state::State;
use crate::ui::train::lexicon::words::Text;
use crate::worker::protocol::{Difference, EntryText};
use yew::{Callback, Html, html};

/// Lines of a table that are shown.
const SHOWN: usize = 40;

/// The robot's model beside that of a file.
pub(super) fn difference(state: &State, text: &Text, act: &Callback<Action>) -> Html {
    html! {
        <section class="card" aria-labelledby="compare-title" data-testid="compare">
            <h2 id="compare-title">{ text.compare }</h2>
            { open_file("compare-file", text.compare_with, ".model,.txt", None, &act.reform(Action::Compare)) }
            if let Some((name, found)) = &state.difference { { tables(name, found, text) } }
        </section>
    }
}

fn tables(name: &str, found: &Difference, text: &Text) -> Html {
    let alone = |entries: &[(EntryText, f64)]| -> Vec<Html> {
        let row = |(entry, weight): &(EntryText, f64)| {
            html! { <tr><td>{ &entry.words }</td><td><code>{ &entry.meaning }</code></td><td>{ format!("{weight:.2}") }</td></tr> }
        };
        entries.iter().take(SHOWN).map(row).collect()
    };
    let heads = [text.words, text.meaning, text.weight];
    let moved = found.entries.iter().take(SHOWN).map(|(entry, first, second)| {
        html! {
            <tr>
                <td>{ &entry.words }</td><td><code>{ &entry.meaning }</code></td>
                <td>{ format!("{first:.2} → {second:.2}") }</td>
            </tr>
        }
    });
    html! {
        <>
            <p class="figures" data-testid="compared">{ (text.common)(found.common) }</p>
            { table(&(text.alone)(text.robots, found.first_alone.count), &heads, alone(&found.first_alone.first)) }
            { table(&(text.alone)(name, found.second_alone.count), &heads, alone(&found.second_alone.first)) }
            { table(text.moved, &heads, moved.collect()) }
        </>
    }
}
