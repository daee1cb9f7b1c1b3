//! The command box, and commands to try.
use crate::ui::page::shared::Shared;
use crate::ui::page::view::host::element;
use crate::ui::page::view::notice::notice;
use crate::ui::page::view::sends::sends;
use crate::ui::talk::action::Action;
use crate::ui::talk::command::ask::is_asking;
use crate::ui::talk::command::offer::{Examples, KINDS};
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use wasm_bindgen::JsCast;
use web_sys::{HtmlInputElement, SubmitEvent};
use yew::{Callback, Html, InputEvent, KeyboardEvent, TargetCast, classes, html};

/// Empties the box of what the page typed by itself, at once: what was pressed comes into it before the page is drawn again.
pub(crate) fn give_back() {
    if let Some(input) = input().filter(|input| input.has_attribute("data-shown")) {
        input.set_value("");
    }
}

fn input() -> Option<HtmlInputElement> {
    element("command")?.dyn_into().ok()
}

/// The command box.
pub(super) fn command(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let send = act.reform(|event: SubmitEvent| {
        event.prevent_default();
        // What is typed next takes its place.
        if let Some(input) = input() {
            input.select();
        }
        Action::Ask
    });
    let typed = act.reform(|event: InputEvent| {
        let input = event.target_dyn_into::<HtmlInputElement>();
        Action::Typed(input.map(|i| i.value()).unwrap_or_default())
    });
    let recall = {
        let act = act.clone();
        Callback::from(move |event: KeyboardEvent| {
            let back = match event.key().as_str() {
                "ArrowUp" => true,
                "ArrowDown" => false,
                _ => return,
            };
            event.prevent_default();
            act.emit(Action::Recall(back));
        })
    };
    let said =
        shared.document.said.as_ref().map_or_else(String::new, |said| said.answer.command.clone());
    html! {
        <>
            <form class="say main" onsubmit={send} aria-busy={(!shared.can_ask()).to_string()}>
                <label class="unseen" for="command">{ text.what_to_do }</label>
                <input id="command" type="text" lang="en" autocomplete="off" autocapitalize="off"
                    spellcheck="false" enterkeyhint="send" data-testid="command" value={state.command.input.clone()}
                    data-said={said} data-shown={state.demo.is_typing().then_some("")} oninput={typed} onkeydown={recall} aria-describedby="say-hint" placeholder={text.what_to_do} />
                if is_asking(shared) {
                    <button type="button" class="primary" data-testid="stop"
                        onclick={sends(act, Action::StopPlanning)}>{ text.stop }</button>
                } else {
                    <button type="submit" class="primary" data-testid="ask" disabled={!shared.can_ask_soon()}>
                        { text.tell }
                    </button>
                }
            </form>
            { notice(state.command.notice.as_deref(), "ask-notice") }
            if let Some(words) = &shared.model_notice {
                <div class="notice" role="alert" data-testid="model-notice">
                    <p>{ words }</p>
                    <p class="buttons">
                        <button type="button" class="quiet" data-testid="fetch-model"
                            onclick={sends(act, Action::FetchModel)}>{ text.try_again }</button>
                        <a class="quiet" href="#train">{ text.train_one }</a>
                    </p>
                </div>
            }
        </>
    }
}

/// The order that commands to try are shown in: what is to be taught comes early, lest it be out of sight.
const SHOWN: [usize; KINDS] = [0, 1, Examples::TAUGHT, 2, 3, 4];

/// Commands to try; one is there to be taught.
pub(super) fn examples(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let can_ask = shared.can_ask();
    let Examples { found, of, is_behind, .. } = &state.command_examples;
    html! {
        // What scrolls can be reached by keyboard, also while its buttons cannot.
        <div class="chips" id="say-hint" aria-busy={(*is_behind || of.is_none()).to_string()} tabindex={(!can_ask).then_some("0")}>
            <span class="dim">{ if can_ask { text.try_this } else { text.getting_ready } }</span>
            { for SHOWN.iter().filter_map(|&place| Some((place, found.get(place)?.clone()?))).map(|(place, command)| {
                let is_new = place == Examples::TAUGHT;
                html! {
                    <button type="button" class={classes!("chip", is_new.then_some("new"))} lang="en" disabled={!can_ask}
                        title={is_new.then_some(text.unknown_example)} data-testid={format!("example-{place}")}
                        onclick={act.reform({ let command = command.clone(); move |_| Action::AskExample(command.clone()) })}>
                        { command }
                    </button>
                }
            }) }
        </div>
    }
}
