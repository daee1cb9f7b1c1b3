//! The command box, with commands to try.

use crate::ui::page::shared::Shared;
use crate::ui::page::view::notice::notice;
use crate::ui::talk::action::Action;
use crate::ui::talk::command::ask::is_asking;
use crate::ui::talk::command::state::EXAMPLES;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use web_sys::{HtmlInputElement, SubmitEvent};
use yew::{Callback, Html, InputEvent, KeyboardEvent, TargetCast, html};

/// The command box.
pub(super) fn command(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let can_ask = shared.can_ask();
    let send = act.reform(|event: SubmitEvent| {
        event.prevent_default();
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
            <form class="say" onsubmit={send}>
                <label class="unseen" for="command">{ text.what_to_do }</label>
                <input id="command" type="text" lang="en" autocomplete="off" autocapitalize="off"
                    spellcheck="false" enterkeyhint="send" data-testid="command" value={state.command.input.clone()}
                    data-said={said} oninput={typed} onkeydown={recall} aria-describedby="say-hint" placeholder={EXAMPLES[0]} />
                if is_asking(shared) {
                    <button type="button" class="primary" data-testid="stop"
                        onclick={act.reform(|_| Action::StopPlanning)}>{ text.stop }</button>
                } else {
                    <button type="submit" class="primary" data-testid="ask" disabled={!can_ask}>
                        { text.tell }
                    </button>
                }
            </form>
            <div class="chips" id="say-hint">
                <span class="dim">{ if can_ask { text.try_this } else { text.getting_ready } }</span>
                { for EXAMPLES.iter().enumerate().map(|(i, example)| html! {
                    <button type="button" class="chip" lang="en" disabled={!can_ask}
                        data-testid={format!("example-{i}")}
                        onclick={act.reform(move |_| Action::AskExample((*example).to_owned()))}>
                        { *example }
                    </button>
                }) }
            </div>
            { notice(state.command.notice.as_deref(), "ask-notice") }
            if let Some(words) = &shared.model_notice {
                <div class="notice" role="alert" data-testid="model-notice">
                    <p>{ words }</p>
                    <p class="buttons">
                        <button type="button" class="quiet" data-testid="fetch-model"
                            onclick={act.reform(|_| Action::FetchModel)}>{ text.try_again }</button>
                        <a class="quiet" href="#train">{ text.train_one }</a>
                    </p>
                </div>
            }
        </>
    }
}
