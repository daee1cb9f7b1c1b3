//! What a command was taken to mean: its words, the goal in plain words, and why nothing came of it, with help.

use crate::ui::page::language::Language;
use crate::ui::page::shared::Shared;
use crate::ui::talk::action::Action;
use crate::ui::talk::command::link::{Link, holds};
use crate::ui::talk::state::State;
use crate::ui::talk::why::help::Help;
use crate::ui::talk::why::messages::{Message, messages};
use crate::ui::talk::words::Text;
use crate::worker::protocol::{Answer, Fate, Word};
use yew::{Callback, Html, classes, html};

/// The answer to the command.
pub(super) fn answer(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let Some(Answer { words, .. }) = state.heard(shared) else { return Html::default() };
    // Whether this is of a command that is being typed.
    let live = state.command.live.is_some();
    let link = state.command.link;
    html! {
        <div class="answer" data-testid="answer" data-live={live.to_string()}>
            if !words.is_empty() {
                <p class="words" lang="en" aria-label={text.the_words}>
                    { for words.iter().enumerate().map(|(place, word)| show(shared.language, place, word, link, act)) }
                </p>
            }
            if let Some(reading) = state.heard_reading(shared) {
                <p class="understood" data-testid="understood">
                    <span class="dim">{ if live { text.it_would_mean } else { text.it_means } }</span>
                    <strong data-testid="plain">{ text.phrases.sentence(&reading.claim) }</strong>
                </p>
            }
            { for messages(state, shared).iter().map(|message| tell(text, message, words, act)) }
        </div>
    }
}

fn show(
    language: Language,
    place: usize,
    word: &Word,
    link: Option<Link>,
    act: &Callback<Action>,
) -> Html {
    let text = Text::of(language);
    let (fate, help) = match word.fate {
        Fate::Meant => ("meant", None),
        Fate::Empty => ("empty", Some(text.fate_empty)),
        Fate::Skipped => ("skipped", Some(text.fate_skipped)),
        Fate::Unknown => ("unknown", Some(text.fate_unknown)),
        Fate::Idle => ("idle", None),
    };
    let on = act.reform(move |_: yew::MouseEvent| Action::Link(Some((place, place + 1))));
    let off = act.reform(|_: yew::MouseEvent| Action::Link(None));
    let focus = act.reform(move |_: yew::FocusEvent| Action::Link(Some((place, place + 1))));
    let blur = act.reform(|_: yew::FocusEvent| Action::Link(None));
    let heard = word.heard.as_ref().map(|heard| (text.heard_as)(heard));
    html! {
        <span class={classes!("word", fate, holds(link, place).then_some("linked"))} tabindex="0"
            title={heard.clone().or(help.map(str::to_owned))} data-testid="word" data-fate={fate}
            onmouseenter={on} onmouseleave={off} onfocus={focus} onblur={blur}>
            { &word.text }
            if let Some(heard) = &word.heard { <span class="heard">{"→ "}{ heard }</span> }
            if let Some(help) = help { <span class="unseen" lang={language.code()}>{ format!(" ({help})") }</span> }
        </span>
    }
}

fn tell(text: &Text, message: &Message, words: &[Word], act: &Callback<Action>) -> Html {
    html! {
        <div class="notice" data-testid="why" data-kind={message.kind}>
            <p><strong>{ &message.what }</strong>{" "}{ &message.fix }</p>
            if !message.helps.is_empty() {
                <p class="buttons">
                    { for message.helps.iter().map(|help| {
                        let done = help.clone();
                        html! {
                            <button type="button" class="quiet" data-testid="help" data-help={kind(help)}
                                onclick={act.reform(move |_| Action::Help(done.clone()))}>
                                { text.help(help, words) }
                            </button>
                        }
                    }) }
                </p>
            }
        </div>
    }
}

/// What a button does, for tests.
const fn kind(help: &Help) -> &'static str {
    match help {
        Help::Say(..) => "say",
        Help::Teach => "teach",
        Help::Show(_) => "show",
        Help::Add(_) => "add",
        Help::Edit => "edit",
        Help::FreeLandmarks => "free-landmarks",
        Help::Pull => "pull",
        Help::Unlock => "unlock",
        Help::NoChance => "no-chance",
        Help::OtherWorld => "other-world",
    }
}
