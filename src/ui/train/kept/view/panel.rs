//! What is kept: a list, with what can be done with each, and what can be kept besides.

use crate::ui::page::keep::ask::Place;
use crate::ui::page::keep::copies::Item;
use crate::ui::page::keep::fault::Fault;
use crate::ui::page::language::Language;
use crate::ui::page::view::fields::line;
use crate::ui::page::view::notice::notice;
use crate::ui::train::desk::Desk;
use crate::ui::train::kept::action::Action;
use crate::ui::train::kept::state::{Kind, State};
use crate::ui::train::kept::words::Text;
use js_sys::{Date, Object};
use yew::{Callback, Html, html};

/// What is kept; `can_keep` says whether there are a corpus and a model to be kept.
pub(crate) fn panel(
    state: &State,
    desk: &Desk,
    can_keep: [bool; 2],
    act: &Callback<Action>,
) -> Html {
    let text = Text::of(desk.language);
    html! {
        <div class="data">
            <section class="card" aria-labelledby="kept-title" data-testid="shelf">
                <h2 id="kept-title">{ text.title }</h2>
                <p class="dim">{ text.help }</p>
                { form(state, text, can_keep, act) }
                { notice(state.notice.as_deref(), "shelf-notice") }
                if let Some(fault) = &state.fault {
                    <p class="notice bad" role="status" data-testid="shelf-fault" data-fault={fault.name().to_owned()}>
                        { (text.fault)(fault) }
                        if *fault == Fault::Elsewhere {
                            {" "}{ press("keep-runs-here", text.keep_here, text.keep_here, act, Action::KeepHere) }
                        }
                    </p>
                }
                { list(state, desk.language, text, act) }
            </section>
        </div>
    }
}

/// What there is to say of keeping where a run is seen: that it came back, or that it is not kept; nothing as long as
/// all is as usual.
pub(crate) fn of_run(state: &State, language: Language, is_live: bool) -> Html {
    let text = Text::of(language);
    match (&state.fault, &state.came_back) {
        (Some(fault), _) if is_live => html! {
            <p class="notice bad" role="status" data-testid="run-not-kept" data-fault={fault.name().to_owned()}>
                { (text.run_fault)(fault, state.reached) }
            </p>
        },
        (_, Some(words)) => {
            html! { <p class="notice" role="status" data-testid="run-came-back">{ words }</p> }
        }
        _ => Html::default(),
    }
}

/// The same where results of experiments are seen.
pub(crate) fn of_results(state: &State, language: Language) -> Html {
    let Some(fault) = &state.fault else { return Html::default() };
    html! {
        <p class="notice bad" role="status" data-testid="results-not-kept" data-fault={fault.name().to_owned()}>
            { (Text::of(language).fault)(fault) }
        </p>
    }
}

fn form(state: &State, text: &Text, [corpus, model]: [bool; 2], act: &Callback<Action>) -> Html {
    let button = |id: &'static str, words: &'static str, can: bool, action: Action| {
        html! {
            <button type="button" class="quiet" data-testid={id} disabled={!can}
                onclick={act.reform(move |_| action.clone())}>{ words }</button>
        }
    };
    html! {
        <div class="fields">
            { line("kept-name", text.name, "text", &state.name, act.reform(Action::Name)) }
            { button("keep-corpus", text.keep_corpus, corpus, Action::KeepCorpus) }
            { button("keep-model", text.keep_model, model, Action::KeepModel) }
        </div>
    }
}

fn list(state: &State, language: Language, text: &Text, act: &Callback<Action>) -> Html {
    let rows: Vec<Html> =
        state.own().map(|(kind, item)| row(kind, item, language, text, act)).collect();
    if rows.is_empty() {
        return html! { <p class="dim" data-testid="shelf-empty">{ text.nothing }</p> };
    }
    let sum = (text.sum)(rows.len(), &size(state.own().map(|(_, item)| item.bytes).sum()));
    html! {
        <>
            <p class="dim figures" data-testid="shelf-sum">{ sum.clone() }</p>
            <div class="scroll" tabindex="0" role="region" aria-label={sum}>
                <table class="figures">
                    <thead><tr>
                        { for [text.what, text.called, text.when, text.size].into_iter().map(|head| html! { <th scope="col">{ head }</th> }) }
                        <td />
                    </tr></thead>
                    <tbody>{ for rows }</tbody>
                </table>
            </div>
        </>
    }
}

fn row(kind: Kind, item: &Item, language: Language, text: &Text, act: &Callback<Action>) -> Html {
    let Item { name, bytes, at, .. } = item;
    let when = Date::new(&(*at).into()).to_locale_string(language.code(), &Object::new());
    let button = |id: &'static str, words: &'static str, action: fn(Place) -> Action| {
        press(id, words, &format!("{words}: {name}"), act, action(kind.place(name)))
    };
    html! {
        <tr key={format!("{}/{name}", kind.name())} data-testid="shelf-item" data-kind={kind.name()}>
            <td>{ (text.kind)(kind) }</td>
            <th scope="row">{ name }</th>
            <td>{ String::from(when) }</td>
            <td>{ size(*bytes) }</td>
            <td class="row-buttons">
                { button("shelf-open", text.open, Action::Open) }
                { button("shelf-save", text.save, Action::Save) }
                { button("shelf-delete", text.delete, Action::Delete) }
            </td>
        </tr>
    }
}

fn press(
    id: &'static str,
    words: &'static str,
    label: &str,
    act: &Callback<Action>,
    action: Action,
) -> Html {
    html! {
        <button type="button" class="link" data-testid={id} aria-label={label.to_owned()}
            onclick={act.reform(move |_| action.clone())}>{ words }</button>
    }
}

/// A number of bytes as a person reads it.
fn size(bytes: usize) -> String {
    match bytes {
        0..1_000_000 => format!("{} KB", bytes.div_ceil(1_000)),
        _ => format!("{:.1} MB", bytes as f64 / 1e6),
    }
}
