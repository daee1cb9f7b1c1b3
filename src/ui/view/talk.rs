//! The command box, with commands to try.

use super::notice::Notice;
use super::words::use_text;
use crate::ui::Action;
use crate::ui::talk::EXAMPLES;
use web_sys::{HtmlInputElement, SubmitEvent};
use yew::{Callback, Html, InputEvent, Properties, TargetCast, component, html};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) command: String,
    pub(super) can_ask: bool,
    pub(super) asking: bool,
    pub(super) notice: Option<String>,
    pub(super) model_notice: Option<String>,
    pub(super) act: Callback<Action>,
}

/// The command box.
#[component]
pub(super) fn Talk(props: &Props) -> Html {
    let text = use_text();
    let Props { command, can_ask, asking, notice, model_notice, act } = props;
    let send = act.reform(|event: SubmitEvent| {
        event.prevent_default();
        Action::Ask
    });
    let typed = act.reform(|event: InputEvent| {
        let input = event.target_dyn_into::<HtmlInputElement>();
        Action::Typed(input.map(|i| i.value()).unwrap_or_default())
    });
    html! {
        <>
            <form class="say" onsubmit={send}>
                <label class="unseen" for="command">{ text.what_to_do }</label>
                <input id="command" type="text" lang="en" autocomplete="off" autocapitalize="off"
                    spellcheck="false" enterkeyhint="send" data-testid="command" value={command.clone()}
                    oninput={typed} aria-describedby="say-hint" placeholder={EXAMPLES[0]} />
                if *asking {
                    <button type="button" class="primary" data-testid="stop"
                        onclick={act.reform(|_| Action::StopPlanning)}>{ text.stop }</button>
                } else {
                    <button type="submit" class="primary" data-testid="ask" disabled={!can_ask}>
                        { text.tell }
                    </button>
                }
            </form>
            <div class="chips" id="say-hint">
                <span class="dim">{ if *can_ask { text.try_this } else { text.getting_ready } }</span>
                { for EXAMPLES.iter().enumerate().map(|(i, example)| html! {
                    <button type="button" class="chip" lang="en" disabled={!can_ask}
                        data-testid={format!("example-{i}")}
                        onclick={act.reform(move |_| Action::AskExample((*example).to_owned()))}>
                        { *example }
                    </button>
                }) }
            </div>
            <Notice text={notice.clone()} id="ask-notice" />
            if let Some(words) = model_notice {
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
