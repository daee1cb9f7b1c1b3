//! What stands before the first item: what it is about, consent, what is to be done, a worked example.

use super::item::{button, showings};
use crate::study::Showing;
use crate::study::ends::hosts;
use crate::ui::collect::action::Action;
use crate::ui::collect::state::State;
use crate::ui::collect::words::Text;
use yew::{Callback, Html, html};

/// What it is about, and consent. The hosts that answers go to are named here.
pub(super) fn welcome(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let Some((study, source)) = &state.study else { return Html::default() };
    let hosts = hosts(study, *source, &state.link);
    let words = &study.words;
    html! {
        <section class="card" aria-labelledby="heading">
            <h1 id="heading" tabindex="-1">{ &study.name }</h1>
            { paragraphs(words.welcome.as_deref().unwrap_or(text.welcome)) }
            <h2>{ text.consent_title }</h2>
            { paragraphs(words.consent.as_deref().unwrap_or(text.consent)) }
            <p class="notice" data-testid="hosts">
                { if hosts.is_empty() { text.posts_nowhere.to_owned() } else { (text.posts_to)(&hosts) } }
            </p>
            <p class="buttons">{ button("agree", "primary", text.agree, act, Action::Agree) }</p>
        </section>
    }
}

/// What is to be done, and a worked example.
pub(super) fn instructions(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let Some((study, _)) = &state.study else { return Html::default() };
    let words = &study.words;
    let mut shows = study.items.iter().flat_map(|item| &item.shows);
    let has_runs = shows.any(|showing| showing.steps().is_some());
    let usual = if has_runs { text.instructions_runs } else { text.instructions };
    html! {
        <section class="card" aria-labelledby="heading">
            <h1 id="heading" tabindex="-1">{ text.instructions_title }</h1>
            { paragraphs(words.instructions.as_deref().unwrap_or(usual)) }
            if let Some(example) = &words.example {
                <h2 class="example">{ text.example }</h2>
                { showings(state, &example.shows.iter().collect::<Vec<&Showing>>(), act) }
                <p>{ text.example_said }</p>
                <p class="said" data-testid="example">{ &example.command }</p>
            }
            <p class="buttons">{ button("ready", "primary", text.begin, act, Action::Ready) }</p>
        </section>
    }
}

/// Words with empty lines between paragraphs.
pub(super) fn paragraphs(words: &str) -> Html {
    let parts = words.split("\n\n").map(str::trim).filter(|part| !part.is_empty());
    html! { <>{ for parts.map(|part| html! { <p class="prose" dir="auto">{ part }</p> }) }</> }
}
