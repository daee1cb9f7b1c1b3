//! The command box, with commands to try.

use super::notice::Notice;
use crate::ui::Action;
use web_sys::{HtmlInputElement, SubmitEvent};
use yew::{Callback, Html, InputEvent, Properties, TargetCast, component, html};

/// Commands to try; none of them is in the page's own corpus.
const EXAMPLES: [&str; 3] =
    ["go to the blue room", "walk into the red room", "walk near the block"];

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) command: String,
    pub(super) can_ask: bool,
    pub(super) asking: bool,
    pub(super) taught: bool,
    pub(super) notice: Option<String>,
    pub(super) act: Callback<Action>,
}

/// The command box.
#[component]
pub(super) fn Talk(props: &Props) -> Html {
    let Props { command, can_ask, asking, taught, notice, act } = props;
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
            <div class="card-head"><h2 id="talk-title">{"Tell it"}</h2></div>
            <form class="say" onsubmit={send}>
                <label class="unseen" for="command">{"What should the robot do?"}</label>
                <input id="command" type="text" autocomplete="off" autocapitalize="off" spellcheck="false"
                    enterkeyhint="send" data-testid="command" value={command.clone()} oninput={typed}
                    aria-describedby="say-hint"
                    placeholder={if *taught { "go to the blue room" } else { "Teach it first" }} />
                <button type="submit" class="primary" data-testid="ask" disabled={!can_ask}>
                    { if *asking { "Thinking…" } else { "Tell" } }
                </button>
            </form>
            <div class="chips" id="say-hint">
                <span class="dim">{ if *taught { "Try" } else { "Once it is taught, try" } }</span>
                { for EXAMPLES.iter().enumerate().map(|(i, example)| html! {
                    <button type="button" class="chip" disabled={!can_ask} data-testid={format!("example-{i}")}
                        onclick={act.reform(move |_| Action::AskExample((*example).to_owned()))}>
                        { *example }
                    </button>
                }) }
            </div>
            <Notice text={notice.clone()} id="ask-notice" />
        </>
    }
}
