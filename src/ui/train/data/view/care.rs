//! Deciding of rows: of those that were picked, or of all in view; one by one or by rule; all of it can be undone.

use super::files::link;
use super::grid::Words;
use crate::ui::page::view::sign::{Sign, sign};
use crate::ui::train::data::action::{Action, Care, Look};
use crate::ui::train::data::sheet::Sheet;
use crate::ui::train::data::state::State;
use crate::ui::train::data::words::Text;
use crate::worker::protocol::{Half, Rule};
use web_sys::HtmlInputElement;
use yew::{Callback, Html, Properties, component, html, use_node_ref};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    /// The rows, in words.
    pub(super) rows: String,
    pub(super) n_picked: usize,
    /// The rule that the view is of.
    pub(super) rule: Option<Rule>,
    pub(super) undo: bool,
    pub(super) redo: bool,
    pub(super) words: Words,
    pub(super) act: Callback<Action>,
}

/// What can be decided of the rows in view.
#[component]
pub(super) fn Decide(props: &Props) -> Html {
    let Props { rows, n_picked, rule, undo, redo, words: Words(text), act } = props;
    let reason = use_node_ref();
    let care = act.reform(Action::Care);
    let press = |id: &'static str, words: &'static str, what: Care| {
        let care = care.reform(move |_| what.clone());
        html! { <button type="button" class="quiet" data-testid={id} onclick={care}>{ words }</button> }
    };
    let reject = {
        let (care, reason) = (care.clone(), reason.clone());
        let usual = rule.map_or("", text.rule);
        Callback::from(move |_| {
            let written = reason.cast::<HtmlInputElement>().map(|input| input.value());
            let written = written.filter(|words| !words.trim().is_empty());
            care.emit(Care::Reject(written.unwrap_or_else(|| usual.to_owned())));
        })
    };
    html! {
        <div class="decide" role="group" aria-label={text.care}>
            <p class="figures" data-testid="with-rows">
                { (text.with_rows)(rows) }
                if *n_picked > 0 { {" "}{ link(text.pick_none, "pick-none", act.reform(|()| Action::Look(Look::PickNone))) } }
            </p>
            <div class="fields">
                { press("approve", text.approve, Care::Approve) }
                <span class="joined">
                    <input ref={reason} type="text" data-testid="reason" aria-label={text.reason}
                        placeholder={rule.map_or(text.reason, text.rule)} />
                    <button type="button" class="quiet" data-testid="reject" onclick={reject}>{ text.reject }</button>
                </span>
                { press("reopen", text.reopen, Care::Reopen) }
                { for [Half::Train, Half::HeldOut, Half::Aside].into_iter().map(|half| {
                    let id = match half { Half::Train => "put-train", Half::HeldOut => "put-held-out", Half::Aside => "put-aside" };
                    press(id, (text.put)(half), Care::Put(half))
                }) }
                { sign("undo-care", text.undo, Sign::Undo, !undo, care.reform(|()| Care::Undo)) }
                { sign("redo-care", text.redo, Sign::Redo, !redo, care.reform(|()| Care::Redo)) }
            </div>
        </div>
    }
}

/// The rules, and how many rows each marks; and asking a model.
pub(super) fn rules(
    state: &State,
    sheet: &Sheet,
    can_audit: bool,
    text: &'static Text,
    act: &Callback<Action>,
) -> Html {
    let care = act.reform(Action::Care);
    html! {
        <section class="card" aria-labelledby="rules-title">
            <h2 id="rules-title">{ text.rules }</h2>
            <ul class="rules">
                { for sheet.facets.rules.iter().filter(|(_, rows)| *rows > 0).map(|(rule, rows)| {
                    let rule = *rule;
                    html! {
                        <li><button type="button" class="link" data-testid={format!("rule-{rule:?}").to_ascii_lowercase()}
                            onclick={act.reform(move |_| Action::Look(Look::Rule(Some(rule))))}>{ (text.rule)(rule) }</button>
                            {" "}<span class="figures">{ (text.marked)(*rows) }</span></li>
                    }
                }) }
            </ul>
            <p class="buttons">
                <button type="button" class="quiet" data-testid="find" onclick={care.reform(|_| Care::Mark)}>{ text.find }</button>
                <button type="button" class="quiet" data-testid="audit" disabled={!can_audit}
                    onclick={care.reform(|_| Care::Audit)}>{ text.audit }</button>
            </p>
            if let Some((done, of)) = state.auditing {
                <div class="bar" data-testid="auditing">
                    <progress aria-label={text.audit} max={of.to_string()} value={done.to_string()} />
                    <p class="dim">{ (text.auditing)(done, of) }{" "}{ link(text.cancel, "stop-audit", act.reform(|()| Action::Stop)) }</p>
                </div>
            }
        </section>
    }
}
