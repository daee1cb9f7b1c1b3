//! Which rows are looked at.

use super::files::link;
use crate::ui::page::view::fields::{choice, line};
use crate::ui::train::data::action::{Action, Look};
use crate::ui::train::data::sheet::Sheet;
use crate::ui::train::data::words::Text;
use crate::worker::protocol::{Facet, View};
use yew::{Callback, Html, html};

/// The fields that rows are looked for by.
pub(super) fn filters(sheet: &Sheet, text: &'static Text, act: &Callback<Action>) -> Html {
    let act = act.reform(Action::Look);
    let (view, facets) = (&sheet.table.view, &sheet.facets);
    let is_all = View { sort: view.sort, descending: view.descending, ..View::default() } == *view;
    html! {
        <div class="fields filters" role="search">
            { line("search", text.search, "search", &view.text, act.reform(Look::Text)) }
            { named("filter-task", text, text.filter_task, &facets.tasks, view.task.as_deref(), act.reform(Look::Task)) }
            { named("filter-worker", text, text.filter_worker, &facets.workers, view.worker.as_deref(),
                act.reform(Look::Worker)) }
            { known("filter-status", text, text.filter_status, &facets.statuses, view.status, text.status,
                act.reform(Look::Status)) }
            { known("filter-half", text, text.filter_half, &facets.halves, view.half, text.half, act.reform(Look::Half)) }
            { known("filter-outcome", text, text.filter_outcome, &facets.outcomes, view.outcome, text.outcome,
                act.reform(Look::Outcome)) }
            { known("filter-rule", text, text.filter_rule, &facets.rules, view.rule, text.rule, act.reform(Look::Rule)) }
            <p class="seen figures" role="status" data-testid="rows-seen">
                { (text.seen)(sheet.table.total(), sheet.care.rows) }
                if !is_all { {" "}{ link(text.show_all, "show-all", act.reform(|()| Look::All)) } }
            </p>
        </div>
    }
}

/// A choice among the values that rows have.
fn named(
    id: &'static str,
    text: &Text,
    label: &'static str,
    facet: &Facet,
    chosen: Option<&str>,
    choose: Callback<Option<String>>,
) -> Html {
    if facet.values.iter().all(|(value, _)| value.is_empty()) {
        return Html::default();
    }
    let name = |value: &str| if value.is_empty() { text.none.to_owned() } else { value.to_owned() };
    let names = facet.values.iter().map(|(value, rows)| format!("{} ({rows})", name(value)));
    let names: Vec<String> = std::iter::once(text.any.to_owned()).chain(names).collect();
    let values: Vec<String> = facet.values.iter().map(|(value, _)| value.clone()).collect();
    let place = chosen.and_then(|chosen| values.iter().position(|value| value == chosen));
    let choose = choose.reform(move |place: usize| values.get(place.checked_sub(1)?).cloned());
    choice(id.into(), label.into(), &names, place.map_or(0, |place| place + 1), choose)
}

/// A choice among a few kinds, of those that rows are of.
fn known<T: Copy + PartialEq + 'static>(
    id: &'static str,
    text: &Text,
    label: &'static str,
    kinds: &[(T, u32)],
    chosen: Option<T>,
    name: fn(T) -> &'static str,
    choose: Callback<Option<T>>,
) -> Html {
    if kinds.iter().all(|(_, rows)| *rows == 0) {
        return Html::default();
    }
    let names = kinds.iter().map(|(kind, rows)| format!("{} ({rows})", name(*kind)));
    let names: Vec<String> = std::iter::once(text.any.to_owned()).chain(names).collect();
    let kinds: Vec<T> = kinds.iter().map(|(kind, _)| *kind).collect();
    let place = chosen.and_then(|chosen| kinds.iter().position(|kind| *kind == chosen));
    let choose = choose.reform(move |place: usize| kinds.get(place.checked_sub(1)?).copied());
    choice(id.into(), label.into(), &names, place.map_or(0, |place| place + 1), choose)
}
