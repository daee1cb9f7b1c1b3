//! One command of a corpus: its first demonstration small, and when it is open all of them.

use super::picture::Picture;
use super::words::use_text;
use crate::render::{Options, Theme};
use crate::ui::Action;
use crate::ui::text::Text;
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
    let text = use_text();
    let index = props.index;
    let pairs = props.pairs.as_deref();
    let first = pairs.and_then(|p| p.first()).filter(|_| !props.open);
    html! {
        <li class={classes!("row", props.open.then_some("open"))} data-testid="row">
            <button type="button" class="row-head" aria-expanded={props.open.to_string()}
                onclick={props.act.reform(move |_| Action::ToggleRow(index))}>
                <span class="row-words">
                    <span class="row-command">{ &props.command }</span>
                    <span class="dim">{ (text.demonstrations)(props.count) }
                        if let Some(task) = &props.task { {" · "}{ task } }
                    </span>
                </span>
                if let Some(pair) = first { { show(text, pair, 1, props.theme) } }
            </button>
            if props.open {
                <div class="pairs" data-testid="pairs">
                    if let Some(pairs) = pairs {
                        { for pairs.iter().zip(1..).map(|(pair, n)| show(text, pair, n, props.theme)) }
                    } else {
                        <p class="dim">{ text.reading_row }</p>
                    }
                </div>
            }
        </li>
    }
}

fn show(text: &Text, pair: &PairText, number: usize, theme: Theme) -> Html {
    let before = format!("{} {}", (text.demonstration)(number), text.robot(&pair.pre));
    let after = format!("{} {}", text.after, text.robot(&pair.post));
    let options = || Options { theme, ..Options::default() };
    html! {
        <span class="pair">
            <Picture world={pair.pre.clone()} options={options()} label={before} />
            <svg class="arrow" viewBox="0 0 24 24" aria-hidden="true"><path d="M4 12h14m-6-6 6 6-6 6" /></svg>
            <Picture world={pair.post.clone()} options={options()} label={after} />
        </span>
    }
}
