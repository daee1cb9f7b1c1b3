//! What a command was taken to mean: its words, the goal in plain words, and why nothing came of it, with help.
use super::choices::choices;
use super::course::course;
use super::teach::not_taught;
use crate::ui::page::language::Language;
use crate::ui::page::preferences::Depth;
use crate::ui::page::shared::Shared;
use crate::ui::page::view::sends::sends;
use crate::ui::talk::action::Action;
use crate::ui::talk::command::ask::question;
use crate::ui::talk::command::link::{Link, holds};
use crate::ui::talk::room::state::Mode;
use crate::ui::talk::state::State;
use crate::ui::talk::teach::learn::{answered, is_teaching};
use crate::ui::talk::teach::unlike::{Unlike, is_planned};
use crate::ui::talk::why::help::Help;
use crate::ui::talk::why::message::Message;
use crate::ui::talk::why::messages::messages;
use crate::ui::talk::words::Text;
use crate::worker::protocol::{Fate, Word};
use yew::{Callback, Html, classes, html};

/// The answer to the command.
pub(super) fn answer(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    if let Some(reply) = &state.command.reply {
        return html! {
            <div class="answer" data-testid="answer" data-live="false">
                <p class="understood"><strong data-testid="reply">{ &reply.words }</strong></p>
            </div>
        };
    }
    let Some(answer) = state.heard(shared) else {
        let words = if state.command.early { text.soon } else { text.hello };
        return html! {
            <>
                <p class="answer hello" data-testid="hello">{ words }</p>
                if state.room.mode == Mode::Watch { { not_taught(state, shared, act) } }
            </>
        };
    };
    let words = &answer.words;
    // Whether this is of a command that is being typed.
    let live = state.command.live.is_some();
    let link = state.command.link;
    let asks = question(state, shared).is_some();
    let is_half = answer.reason.as_deref() == Some("left_out");
    let is_offered = is_half && (live || shared.document.plan().is_none());
    let label = match (is_offered, live) {
        (true, _) => text.it_could,
        (false, true) => text.it_would_mean,
        (false, false) => text.it_means,
    };
    html! {
        <div class="answer" data-testid="answer" data-live={live.to_string()}>
            if !words.is_empty() {
                <p class={classes!("words", is_half.then_some("half"))} lang="en" aria-label={text.the_words}>
                    { for words.iter().enumerate().map(|(place, word)| show(shared.language, place, word, link, act)) }
                </p>
            }
            if let Some(reading) = state.heard_reading(shared).filter(|_| !asks) {
                <p class="understood" data-testid="understood">
                    <span data-testid="plain">{ set_off(&text.intention(label, &reading.claim)) }</span>
                    if let Some(playback) = state.watch.playback.as_ref().filter(|playback| !live && playback.ended()) {
                        <span class="dim" data-testid="done">{ (text.done_in)(playback.steps()) }</span>
                    }
                    if !live { { deeper(text, shared.depth, act) } }
                    if is_planned(state, shared) {
                        <button type="button" class="link deeper" data-testid="unlike-plan"
                            onclick={sends(act, Action::Unlike(Unlike::Planned))}>{ text.unlike }</button>
                    }
                </p>
            }
            if !asks { { course(state, shared) } }
            if !live { { for told(messages(state, shared)).iter().map(|message| tell(text, message, words, act)) } }
            { choices(state, shared, act) }
            if !live && answered(shared).is_some() {
                <button type="button" class="quiet remember" data-testid="remember" disabled={is_teaching(shared)}
                    onclick={sends(act, Action::Remember)}>{ text.remember }</button>
            }
            if state.room.mode == Mode::Watch { { not_taught(state, shared, act) } }
        </div>
    }
}

/// What was taken for something else, and one thing that is wrong: the first, with which the rest may well go.
fn told(all: Vec<Message>) -> Vec<Message> {
    let (mut told, wrong): (Vec<_>, Vec<_>) = all.into_iter().partition(|one| one.kind == "taken");
    told.extend(wrong.into_iter().next());
    told
}

/// A sentence with the names in it set off, which stand between asterisks.
fn set_off(words: &str) -> Html {
    let parts = words.split('*').enumerate();
    html! { <>{ for parts.map(|(at, part)| if at % 2 == 0 { html! { part } } else { html! { <b>{ part }</b> } }) }</> }
}

/// What is behind the answer: the readings and what they are worth, then how the words made them.
fn deeper(text: &'static Text, depth: Depth, act: &Callback<Action>) -> Html {
    let (to, words, id) = match depth {
        Depth::Say => (Depth::See, text.ask_why, "ask-why"),
        Depth::See => (Depth::Study, text.show_grammar, "show-grammar"),
        Depth::Study => (Depth::Say, text.less, "less"),
    };
    html! {
        <button type="button" class="link deeper" data-testid={id}
            onclick={sends(act, Action::Deepen(to))}>{ words }</button>
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
        <div class={if message.kind == "taken" { "dim" } else { "notice" }} data-testid="why" data-kind={message.kind}>
            <p><strong>{ &message.what }</strong>{" "}{ &message.fix }</p>
            if !message.helps.is_empty() {
                <p class="buttons">
                    { for message.helps.iter().map(|help| {
                        if *help == Help::Guide {
                            return html! { <a class="quiet" href="#help" data-testid="help" data-help="guide">{ text.help(help, words) }</a> };
                        }
                        let done = help.clone();
                        html! {
                            <button type="button" class="quiet" data-testid="help" data-help={kind(help)}
                                onclick={sends(act, Action::Help(done.clone()))}>
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
        Help::Just(_) => "just",
        Help::Teach => "teach",
        Help::Show(_) => "show",
        Help::Instead(..) => "instead",
        Help::Add(_) => "add",
        Help::Edit => "edit",
        Help::FreeLandmarks => "free-landmarks",
        Help::Pull => "pull",
        Help::Unlock => "unlock",
        Help::NoChance => "no-chance",
        Help::OtherWorld => "other-world",
        Help::Guide => "guide",
    }
}
