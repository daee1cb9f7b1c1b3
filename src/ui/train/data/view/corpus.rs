//! What it learns from: the commands of the open corpus with their rooms before and after, and another file.

use super::problems::problems;
use super::row::row;
use crate::render::Theme;
use crate::ui::page::view::files::open_file;
use crate::ui::train::data::action::Action;
use crate::ui::train::data::corpus::Corpus;
use crate::ui::train::data::state::State;
use crate::ui::train::desk::Desk;
use crate::ui::train::words::Text;
use yew::{Callback, Html, html};

/// Reading so many bytes takes long enough to be shown.
const LONG: u64 = 1 << 18;

/// The corpus panel.
pub(crate) fn corpus(state: &State, desk: &Desk, act: &Callback<Action>) -> Html {
    let text = Text::of(desk.language);
    let State { corpus, file_notice: notice, .. } = state;
    let accept = ".csv,.tsv,.json,.jsonl,.txt";
    let use_rejected = || {
        html! {
            <button type="button" class="link" data-testid="use-rejected"
                onclick={act.reform(|_| Action::UseRejected)}>{ text.use_rejected }</button>
        }
    };
    html! {
        <section class="card corpus" aria-labelledby="corpus-title">
            <div class="card-head">
                <h2 id="corpus-title">{ text.corpus }</h2>
                if let Some(corpus) = corpus {
                    <span class="tag" data-testid="corpus-name">{ &corpus.report.name }</span>
                }
            </div>
            { open_file("corpus-file", text.open_corpus, accept, Some(text.corpus_hint), &act.reform(Action::Offered)) }
            if let Some((done, of)) = state.reading.filter(|(_, of)| *of > LONG) {
                <p class="dim" data-testid="reading">
                    { format!("{} {} % ", text.reading_row, done * 100 / of) }
                    <button type="button" class="link" data-testid="stop-reading"
                        onclick={act.reform(|_| Action::StopReading)}>{ text.cancel }</button>
                </p>
            }
            if let Some(notice) = notice {
                <div class="notice bad" role="alert" data-testid="file-notice">
                    <p><strong>{ &notice.message }</strong></p>
                    { problems(text, &notice.problems) }
                    if !notice.rejected.is_empty() { { use_rejected() } }
                </div>
            }
            if let Some(corpus) = corpus { { list(text, corpus, desk.preferences.theme, act, use_rejected) } }
        </section>
    }
}

fn list(
    text: &Text,
    corpus: &Corpus,
    theme: Theme,
    act: &Callback<Action>,
    use_rejected: impl Fn() -> Html,
) -> Html {
    let report = &corpus.report;
    let left = report.rows.len().saturating_sub(corpus.shown);
    html! {
        <>
            <p class="dim" data-testid="corpus-count">
                { (text.commands)(report.rows.len()) }
                if report.left_out > 0 { { (text.left_out)(report.left_out) } }
                if report.rejected > 0 { { (text.rejected)(report.rejected) } {" ("} { use_rejected() } {")"} }
                if !report.problems.is_empty() { { (text.problems)(report.problems.len()) } }
                {". "}
                <button type="button" class="link" onclick={act.reform(|_| Action::SaveCorpus)}
                    data-testid="save-corpus">{ text.save_corpus }</button>
                if !corpus.is_demo() {
                    {" "}<button type="button" class="link" onclick={act.reform(|_| Action::OpenDemo)}
                        data-testid="open-demo">{ text.six_sentences }</button>
                }
            </p>
            if !report.problems.is_empty() {
                <details class="problems-box" open={report.problems.len() <= 5}>
                    <summary>{ (text.rows_to_look_at)(report.problems.len()) }</summary>
                    { problems(text, &report.problems) }
                </details>
            }
            <ol class="rows" data-testid="rows">
                { for (0..corpus.shown).map(|index| row(text, corpus, index, theme, act)) }
            </ol>
            if left > 0 {
                <button type="button" class="plain" data-testid="more-rows"
                    onclick={act.reform(|_| Action::MoreRows)}>{ (text.more_rows)(left) }</button>
            }
        </>
    }
}
