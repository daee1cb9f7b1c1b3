//! One command of a corpus: its first demonstration small, and when it is open all of them.

use crate::render::{Options, Theme};
use crate::ui::page::view::picture::Picture;
use crate::ui::train::data::action::Action;
use crate::ui::train::data::corpus::Corpus;
use crate::ui::train::words::Text;
use crate::worker::protocol::{PairText, RowSummary};
use yew::{Callback, Html, classes, html};

/// A row of the corpus.
pub(super) fn row(
    text: &Text,
    corpus: &Corpus,
    index: usize,
    theme: Theme,
    act: &Callback<Action>,
) -> Html {
    let Some(RowSummary { command, task, pairs: count }) = corpus.report.rows.get(index) else {
        return Html::default();
    };
    let open = corpus.open == Some(index);
    let pairs = corpus.pairs.get(&index);
    let first = pairs.and_then(|pairs| pairs.first()).filter(|_| !open);
    html! {
        <li key={index} class={classes!("row", open.then_some("open"))} data-testid="row">
            <button type="button" class="row-head" aria-expanded={open.to_string()}
                onclick={act.reform(move |_| Action::ToggleRow(index))}>
                <span class="row-words">
                    <span class="row-command">{ command }</span>
                    <span class="dim">{ (text.demonstrations)(*count) }
                        if let Some(task) = task { {" · "}{ task } }
                    </span>
                </span>
                if let Some(pair) = first { { show(text, pair, 1, theme) } }
            </button>
            if open {
                <div class="pairs" data-testid="pairs">
                    if let Some(pairs) = pairs {
                        { for pairs.iter().zip(1..).map(|(pair, n)| show(text, pair, n, theme)) }
                    } else {
                        <p class="dim">{ text.reading_row }</p>
                    }
                </div>
            }
        </li>
    }
}

fn show(text: &Text, pair: &PairText, number: usize, theme: Theme) -> Html {
    let before = format!("{} {}", (text.demonstration)(number), text.phrases.robot(&pair.pre));
    let after = format!("{} {}", text.after, text.phrases.robot(&pair.post));
    let options = || Options { theme, ..Options::default() };
    html! {
        <span class="pair">
            <Picture world={pair.pre.clone()} options={options()} label={before} />
            <svg class="arrow" viewBox="0 0 24 24" aria-hidden="true"><path d="M4 12h14m-6-6 6 6-6 6" /></svg>
            <Picture world={pair.post.clone()} options={options()} label={after} />
        </span>
    }
}
