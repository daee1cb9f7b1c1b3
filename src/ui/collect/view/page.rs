//! The page as it stands: what is on view, what has to be said beside it, and the way out.

use super::end::{end, over};
use super::item::{button, turn};
use super::start::{instructions, welcome};
use crate::ui::collect::action::Action;
use crate::ui::collect::state::{Stage, State};
use crate::ui::collect::words::Text;
use crate::ui::page::language::Language;
use yew::{Callback, Html, html};

/// The whole page.
pub(super) fn page(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let stage = state.stage();
    let inner = match stage {
        Stage::Loading => html! { <p role="status" class="dim">{ text.loading }</p> },
        Stage::Trouble => html! {
            <section class="card" aria-labelledby="heading" data-testid="trouble">
                <h1 id="heading" tabindex="-1">{ text.no_study }</h1>
                <p>{ state.trouble.as_ref().map(|trouble| (text.trouble)(trouble)) }</p>
            </section>
        },
        Stage::Elsewhere => html! {
            <section class="card" aria-labelledby="heading" data-testid="elsewhere">
                <h1 id="heading" tabindex="-1">{ state.study.as_ref().map(|(study, _)| study.name.clone()) }</h1>
                <p>{ text.elsewhere }</p>
                <p class="buttons">{ button("take", "primary", text.take, act, Action::Take) }</p>
            </section>
        },
        Stage::Refused => html! {
            <section class="card" aria-labelledby="heading" data-testid="refused">
                <h1 id="heading" tabindex="-1">{ text.no_study }</h1>
                <p>{ text.refused }</p>
            </section>
        },
        Stage::Welcome => welcome(state, act),
        Stage::Instructions => instructions(state, act),
        Stage::Turn(at) => turn(state, at, act),
        Stage::End(at) => end(state, at, act),
        Stage::Over => over(state, act),
    };
    let other = match state.language {
        Language::English => Language::German,
        Language::German => Language::English,
    };
    let is_marked = state.is_preview() || state.script.is_some();
    html! {
        <div class="collect" data-stage={name(stage)} data-sitting={state.notes.to_string()}>
            <header>
                <span class="name">{ "Groundling" }</span>
                <button type="button" class="link" lang={other.code()} data-testid="language"
                    onclick={act.reform(move |_| Action::Speak(other))}>{ text.other_language }</button>
            </header>
            <main>
                if is_marked {
                    <p class="notice" data-testid="mark">
                        { if state.is_preview() { text.preview } else { text.simulated } }
                    </p>
                }
                if let Some(fault) = &state.fault {
                    <p class="notice bad" role="alert" data-testid="fault">{ (text.fault)(fault) }</p>
                }
                { inner }
            </main>
            <footer>{ way_out(state, stage, act) }</footer>
        </div>
    }
}

/// What is kept, and how to withdraw.
fn way_out(state: &State, stage: Stage, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    if !matches!(stage, Stage::Instructions | Stage::Turn(_) | Stage::End(_)) {
        return Html::default();
    }
    if state.leaves {
        return html! {
            <p role="alertdialog" aria-label={text.sure} class="buttons">
                <span>{ text.sure }</span>
                { button("withdraw-yes", "quiet", text.withdraw_yes, act, Action::Withdrawn) }
                { button("withdraw-no", "quiet", text.withdraw_no, act, Action::Stay) }
            </p>
        };
    }
    let kept = if state.keeping.is_some() { text.keeping } else { text.kept };
    html! {
        <p>
            if !state.is_preview() && state.fault.is_none() { <span>{ kept }{ " " }</span> }
            { button("withdraw", "link", text.withdraw, act, Action::Withdraw) }
        </p>
    }
}

/// What a stage is called in the page's code.
fn name(stage: Stage) -> &'static str {
    match stage {
        Stage::Loading => "loading",
        Stage::Trouble => "trouble",
        Stage::Elsewhere => "elsewhere",
        Stage::Refused => "refused",
        Stage::Welcome => "welcome",
        Stage::Instructions => "instructions",
        Stage::Turn(_) => "turn",
        Stage::End(_) => "end",
        Stage::Over => "over",
    }
}
