//! One command of a corpus: its first demonstration small, and when it is open all of them.

use super::picture::Picture;
use crate::render::Theme;
use crate::ui::{Action, describe};
use crate::worker::protocol::PairText;
use std::rc::Rc;
use yew::{Callback, Html, Properties, classes, component, html};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) index: usize,
    pub(super) command: String,
    pub(super) task: Option<String>,
    pub(super) count: usize,
    pub(super) open: bool,
    pub(super) pairs: Option<Rc<Vec<PairText>>>,
    pub(super) theme: Theme,
    pub(super) act: Callback<Action>,
}

/// A row of the corpus.
#[component]
pub(super) fn Row(props: &Props) -> Html {
    let index = props.index;
    let pairs = props.pairs.as_deref();
    let first = pairs.and_then(|p| p.first()).filter(|_| !props.open);
    html! {
        <li class={classes!("row", props.open.then_some("open"))} data-testid="row">
            <button type="button" class="row-head" aria-expanded={props.open.to_string()}
                onclick={props.act.reform(move |_| Action::ToggleRow(index))}>
                <span class="row-words">
                    <span class="row-command">{ &props.command }</span>
                    <span class="dim">{ format!("{} demonstration{}", props.count,
                        if props.count == 1 { "" } else { "s" }) }
                        if let Some(task) = &props.task { {" · "}{ task } }
                    </span>
                </span>
                if let Some(pair) = first { { show(pair, 1, props.theme) } }
            </button>
            if props.open {
                <div class="pairs" data-testid="pairs">
                    if let Some(pairs) = pairs {
                        { for pairs.iter().zip(1..).map(|(pair, n)| show(pair, n, props.theme)) }
                    } else {
                        <p class="dim">{"Reading…"}</p>
                    }
                </div>
            }
        </li>
    }
}

fn show(pair: &PairText, number: usize, theme: Theme) -> Html {
    let before = format!("Demonstration {number}, before: {}", describe::robot(&pair.pre));
    let after = format!("After: {}", describe::robot(&pair.post));
    html! {
        <span class="pair">
            <Picture world={pair.pre.clone()} theme={theme} label={before} />
            <svg class="arrow" viewBox="0 0 24 24" aria-hidden="true"><path d="M4 12h14m-6-6 6 6-6 6" /></svg>
            <Picture world={pair.post.clone()} theme={theme} label={after} />
        </span>
    }
}
