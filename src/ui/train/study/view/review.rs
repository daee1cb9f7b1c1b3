//! Reviewing answers: bringing them, asking a model, deciding, and taking them out.

use super::controls::{bar, button};
use super::rows::{rows, tasks};
use super::survey::survey;
use crate::corpus::Decision;
use crate::study::Flag;
use crate::ui::page::view::fields::{choice, line, number, tick};
use crate::ui::page::view::files::open_file;
use crate::ui::train::desk::Desk;
use crate::ui::train::study::action::{Action, Saved};
use crate::ui::train::study::state::State;
use crate::ui::train::study::words::Text;
use yew::{Callback, Html, html};

/// Answers under review.
pub(super) fn review(
    state: &State,
    desk: &Desk,
    text: &'static Text,
    act: &Callback<Action>,
) -> Html {
    let flaws: Vec<&String> = state.unreadable.iter().chain(&state.review.flaws).collect();
    html! {
        <section class="card" aria-labelledby="review-title">
            <h2 id="review-title">{ text.review_title }</h2>
            <p class="dim">{ text.review_help }</p>
            { open_file("answers-file", text.bring, ".jsonl,.json,.csv,.txt", None, &act.reform(Action::Answers)) }
            { bar("bringing", text.bringing, bringing(state)) }
            { bar("judging", text.judging, state.judging) }
            if state.bringing.is_some() || state.judging.is_some() {
                <p class="buttons">{ button("stop-review", text.stop, false, act, Action::Stop) }</p>
            }
            if !flaws.is_empty() {
                <details class="problems-box" data-testid="answer-flaws">
                    <summary>{ text.flaws }</summary>
                    <ul class="problems">{ for flaws.iter().take(50).map(|flaw| html! { <li>{ flaw }</li> }) }</ul>
                </details>
            }
            { survey(state, text, act) }
            if !state.review.rows.is_empty() {
                { judged(state, desk, text, act) }
                { rows(state, desk.preferences.theme, text, act) }
                { rule(state, text, act) }
                { tasks(state, text) }
                { out(state, text, act) }
            }
        </section>
    }
}

/// Kilobytes of the files that are read, and in all.
fn bringing(state: &State) -> Option<(u32, u32)> {
    let (done, of) = state.bringing?;
    Some(((done + state.in_file) / 1000, of / 1000 + 1))
}

/// How many there are, a model's word on them, and which are seen.
fn judged(state: &State, desk: &Desk, text: &'static Text, act: &Callback<Action>) -> Html {
    let n = |is: fn(&Decision) -> bool| {
        state.review.rows.iter().filter(|row| is(&row.decision)).count()
    };
    let decided = [
        n(|decision| *decision == Decision::Open),
        n(|decision| *decision == Decision::Approved),
        n(|decision| matches!(decision, Decision::Rejected(_))),
    ];
    let left_out = state.review.left_out.map(|n| n as usize);
    let names: Vec<String> = std::iter::once(text.all)
        .chain(Flag::ALL.map(|flag| (text.flag)(flag)))
        .map(str::to_owned)
        .collect();
    let place = state.only.and_then(|only| Flag::ALL.iter().position(|flag| *flag == only));
    let choose = act.reform(|at: usize| {
        Action::Only(at.checked_sub(1).and_then(|at| Flag::ALL.get(at)).copied())
    });
    html! {
        <>
            <p class="figures" data-testid="answer-counts">
                { (text.counts)(state.review.rows.len(), decided, left_out) }
            </p>
            <p class="buttons">
                { button("judge", text.judge, !desk.is_ready() || desk.in_use.is_none(), act, Action::Judge) }
            </p>
            { open_file("judge-file", text.judge_by, ".model,.txt", None, &act.reform(Action::JudgeBy)) }
            <div class="fields">
                { choice("only-flag".into(), text.only.into(), &names, place.map_or(0, |at| at + 1), choose) }
                { line("why", text.why, "text", &state.why, act.reform(Action::Why)) }
            </div>
        </>
    }
}

/// The rule by which all that is open is decided.
fn rule(state: &State, text: &'static Text, act: &Callback<Action>) -> Html {
    let flag = |flag: Flag| {
        let id = format!("rule-{}", flag.name());
        tick(
            id.into(),
            (text.flag)(flag).into(),
            state.rule.contains(&flag),
            false,
            act.reform(move |_| Action::Rule(flag)),
        )
    };
    html! {
        <fieldset class="kinds">
            <legend>{ text.rule_title }{ ". " }{ text.rule }</legend>
            { for Flag::ALL.map(flag) }
            { button("decide", text.decide, false, act, Action::Decide) }
        </fieldset>
    }
}

/// What is made of the answers.
fn out(state: &State, text: &'static Text, act: &Callback<Action>) -> Html {
    let save = |id, what| button(id, (text.saved)(what), false, act, Action::Save(what));
    let wanted = [f64::from(state.wanted), 1.0, 1000.0, 1.0];
    html! {
        <>
            <h3>{ text.out_title }</h3>
            <div class="fields">
                { line("pseudonyms", text.key, "text", &state.key, act.reform(Action::Key)) }
                { tick("approved-only".into(), text.approved_only.into(), state.approved_only, false, act.reform(Action::ApprovedOnly)) }
                { number("wanted".into(), text.wanted.into(), wanted, false, act.reform(|n: f64| Action::Wanted(n as u32))) }
            </div>
            <p class="buttons">
                <button type="button" class="primary" data-testid="train-on-answers"
                    onclick={act.reform(|_| Action::Train)}>{ text.train }</button>
                { save("save-table", Saved::Table) }
                { save("save-lines", Saved::Lines) }
                { save("save-pay", Saved::Pay) }
                { save("save-top-up", Saved::TopUp) }
            </p>
        </>
    }
}
