//! The answers as a table, a page of them at once, each with its flags and what can be decided of it; and how far each
//! task has come.

use super::controls::button;
use crate::corpus::Decision;
use crate::domain::State as World;
use crate::render::{Options, Theme};
use crate::study::Showing;
use crate::ui::page::view::picture::Picture;
use crate::ui::train::study::action::Action;
use crate::ui::train::study::files::PAGE;
use crate::ui::train::study::state::State;
use crate::ui::train::study::words::Text;
use crate::worker::protocol::Coverage;
use yew::{Callback, Html, html};

/// The answers on view.
pub(super) fn rows(
    state: &State,
    theme: Theme,
    text: &'static Text,
    act: &Callback<Action>,
) -> Html {
    let seen = state.seen();
    let from = state.from.min(seen.len().saturating_sub(1));
    let some: Vec<usize> = seen.iter().copied().skip(from).take(PAGE).collect();
    let to = from + some.len();
    let before = Action::From(from.saturating_sub(PAGE));
    html! {
        <>
            <div class="scroll" tabindex="0" role="group" aria-label={text.review_title}>
                <table class="entries">
                    <thead><tr>
                        <th>{ text.answer }</th><th>{ text.task }</th><th>{ text.person }</th>
                        <th>{ text.flags }</th><th>{ text.decision }</th><th><span class="unseen">{ text.approve }</span></th>
                    </tr></thead>
                    <tbody>{ for some.into_iter().map(|at| row(state, at, theme, text, act)) }</tbody>
                </table>
            </div>
            <p class="buttons">
                { button("earlier", text.earlier, from == 0, act, before) }
                { button("later", text.later, to >= seen.len(), act, Action::From(to)) }
                <span class="dim" data-testid="seen-answers">{ (text.range)(from + usize::from(to > from), to, seen.len()) }</span>
            </p>
        </>
    }
}

fn row(
    state: &State,
    at: usize,
    theme: Theme,
    text: &'static Text,
    act: &Callback<Action>,
) -> Html {
    let Some(row) = state.review.rows.get(at) else { return Html::default() };
    let id = || row.id.clone();
    let [open, approved, rejected] = text.decisions;
    let (decision, why) = match &row.decision {
        Decision::Open => (open, ""),
        Decision::Approved => (approved, ""),
        Decision::Rejected(why) => (rejected, &**why),
    };
    let is_open = row.decision == Decision::Open;
    let named = |id, words: &str, action| button(id, words, false, act, action);
    let shown = state.looked_at.as_ref().filter(|(looked_at, _)| *looked_at == row.id);
    html! {
        <>
        <tr data-testid="answer-row" data-decision={decision}>
            <td dir="auto" class="command">{ &row.command }</td>
            <td>{ row.task.clone() }</td>
            <td>{ &row.worker }</td>
            <td>{ for row.flags.iter().map(|&flag| html! { <span class="mark">{ (text.flag)(flag) }</span> }) }</td>
            <td>{ decision }if !why.is_empty() { { ": " }{ why } }</td>
            <td class="row-buttons">
                { named("look", text.look, Action::Look(id())) }
                if is_open {
                    { named("approve", text.approve, Action::Approve(id())) }
                    { named("reject", text.reject, Action::Reject(id())) }
                } else {
                    { named("reopen", text.reopen, Action::Reopen(id())) }
                }
            </td>
        </tr>
        if let Some((_, shows)) = shown {
            <tr data-testid="answer-pairs"><td colspan="6">{ pairs(shows, theme, text) }</td></tr>
        }
        </>
    }
}

/// What an answer was said of.
fn pairs(shows: &[Showing], theme: Theme, text: &'static Text) -> Html {
    let picture = |world: &World, label: String| {
        let options = Options { theme, letters: true, ..Options::default() };
        html! { <Picture world={world.clone()} {options} {label} /> }
    };
    html! {
        <div class="asked">
            { for shows.iter().zip(1..).map(|(showing, n)| {
                let (pre, post) = showing.states();
                html! {
                    <span class="pair">
                        { picture(pre, (text.before)(n)) }
                        { showing.steps().map_or("→".to_owned(), text.steps) }
                        { picture(post, (text.after)(n)) }
                    </span>
                }
            }) }
        </div>
    }
}

/// How far each task has come.
pub(super) fn tasks(state: &State, text: &'static Text) -> Html {
    let is_judged = state.review.is_judged;
    let line = |found: &Coverage| {
        let lacks = found.answers - found.rejected < state.wanted as usize;
        html! {
            <tr data-testid="coverage-row" data-lacks={lacks.to_string()}>
                <td>{ &found.task }</td><td>{ found.items }</td><td>{ found.answers }</td>
                <td>{ found.approved }</td><td>{ found.rejected }</td>
                <td>{ if is_judged { found.valid.to_string() } else { text.none.to_owned() } }</td>
                // Fewer than two have nothing to agree on.
                <td>{ if found.answers < 2 { "–".to_owned() } else { format!("{:.2}", found.agreement) } }</td>
            </tr>
        }
    };
    html! {
        <details>
            <summary>{ text.coverage }</summary>
            <div class="scroll" tabindex="0" role="group" aria-label={text.coverage}>
                <table class="entries">
                    <thead><tr>
                        <th>{ text.task }</th><th>{ text.items }</th><th>{ text.answers }</th><th>{ text.approved }</th>
                        <th>{ text.rejected }</th><th>{ text.valid }</th><th>{ text.agreement }</th>
                    </tr></thead>
                    <tbody>{ for state.review.coverage.iter().map(line) }</tbody>
                </table>
            </div>
        </details>
    }
}
