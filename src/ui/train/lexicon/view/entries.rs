//! The entries of the lexicon, a page at a time.

use crate::ui::page::view::fields::{line, tick};
use crate::ui::page::view::notice::notice;
use crate::ui::train::lexicon::action::Action;
use crate::ui::train::lexicon::state::{PAGE, State};
use crate::ui::train::lexicon::words::Text;
use crate::worker::protocol::{EntryLine, EntrySort, EntryWindow};
use web_sys::{Event, HtmlInputElement};
use yew::{Callback, Html, TargetCast, html};

/// Sentences that are shown of an entry.
const SENTENCES: usize = 2;

/// The lexicon.
pub(super) fn entries(state: &State, text: &Text, act: &Callback<Action>) -> Html {
    html! {
        <section class="card" aria-labelledby="lexicon-title">
            <h2 id="lexicon-title">{ text.lexicon }</h2>
            <p class="dim">{ text.lexicon_help }</p>
            <div class="fields" role="search">
                { line("search-entries", text.search, "search", &state.view.text, act.reform(Action::Text)) }
                { tick("learned-only".into(), text.learned_only.into(), state.view.learned, false, act.reform(Action::Learned)) }
            </div>
            { notice(state.notice.as_deref(), "lexicon-notice") }
            if let Some(window) = &state.window { { page(state, window, text, act) } }
        </section>
    }
}

fn page(state: &State, window: &EntryWindow, text: &Text, act: &Callback<Action>) -> Html {
    let EntryWindow { total, offset, lines, .. } = window;
    let (total, offset, end) = (*total, *offset, offset + lines.len() as u32);
    let turn = |id: &'static str, words: &'static str, to: u32, off: bool| {
        html! {
            <button type="button" class="quiet" data-testid={id} disabled={off}
                onclick={act.reform(move |_| Action::Page(to))}>{ words }</button>
        }
    };
    let head = |words: &'static str, sort: EntrySort| {
        let order = match (state.view.sort == sort, state.view.descending) {
            (false, _) => "none",
            (true, false) => "ascending",
            (true, true) => "descending",
        };
        html! {
            <th scope="col" aria-sort={order}>
                <button type="button" class="sort" onclick={act.reform(move |_| Action::Sort(sort))}>{ words }</button>
            </th>
        }
    };
    if total == 0 {
        let words = match (state.view.learned, state.view.text.trim()) {
            (true, "") => text.nothing_learned,
            _ => text.no_entry,
        };
        return html! { <p class="dim" role="status" data-testid="entries-shown">{ words }</p> };
    }
    let shown = (text.shown)(offset + 1, end, total);
    let picked = state.picked.len();
    html! {
        <>
            <p class="buttons figures">
                <span role="status" data-testid="entries-shown">{ shown.clone() }</span>
                { turn("entries-before", text.before, offset.saturating_sub(PAGE), offset == 0) }
                { turn("entries-next", text.next, end, end >= total) }
                if picked > 0 {
                    <button type="button" class="quiet" data-testid="leave-out" onclick={act.reform(|_| Action::Without)}>
                        { (text.leave_out)(picked) }
                    </button>
                }
            </p>
            <div class="scroll" tabindex="0" role="region" aria-label={shown}>
                <table class="figures entries-table" data-testid="entries">
                    <thead><tr>
                        { head("#", EntrySort::Place) }
                        { head(text.words, EntrySort::Words) }
                        <th scope="col">{ text.category }</th>
                        { head(text.meaning, EntrySort::Meaning) }
                        { head(text.weight, EntrySort::Weight) }
                        { head(text.uses, EntrySort::Uses) }
                        <th scope="col">{ text.example }</th>
                        <th scope="col">{ text.from }</th>
                    </tr></thead>
                    <tbody>{ for lines.iter().map(|line| entry(state, line, &window.sentences, text, act)) }</tbody>
                </table>
            </div>
        </>
    }
}

fn entry(
    state: &State,
    line: &EntryLine,
    sentences: &[(u32, String)],
    text: &Text,
    act: &Callback<Action>,
) -> Html {
    let EntryLine { place, entry, weight, from, uses } = line;
    let place = *place;
    let pick = act.reform(move |event: Event| {
        let input = event.target_dyn_into::<HtmlInputElement>();
        Action::Pick(place, input.is_some_and(|input| input.checked()))
    });
    let from = match from {
        Some(command) => command.as_str(),
        None if entry.learned => "",
        None => text.seed,
    };
    html! {
        <tr key={place}>
            <td><input type="checkbox" aria-label={(text.pick)(&entry.words)} checked={state.picked.contains(&place)} onchange={pick} /></td>
            <th scope="row">{ &entry.words }</th>
            <td><code>{ &entry.syntax }</code></td>
            <td class="meaning"><code>{ &entry.meaning }</code></td>
            <td>{ format!("{weight:.2}") }</td>
            <td>{ uses.count }</td>
            <td class="sentences">
                { for sentences.iter().filter(|(row, _)| uses.first.contains(row)).take(SENTENCES).map(|(row, said)| {
                    let row = *row;
                    html! {
                        <button type="button" class="link" data-testid="sentence" aria-label={format!("{}: {said}", (text.open_row)(row + 1))}
                            onclick={act.reform(move |_| Action::Row(row))}>{ said }</button>
                    }
                }) }
            </td>
            <td>{ from }</td>
        </tr>
    }
}
