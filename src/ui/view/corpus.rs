//! What it learns from: the commands of the open corpus with their rooms before and after, and another file.

use super::files::OpenFile;
use super::notice::Problems;
use super::row::Row;
use super::words::use_text;
use crate::render::Theme;
use crate::ui::Action;
use crate::ui::corpus::Corpus;
use crate::ui::text::Text;
use crate::ui::train::FileNotice;
use yew::{Callback, Html, Properties, component, html};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) corpus: Option<Corpus>,
    pub(super) notice: Option<FileNotice>,
    pub(super) theme: Theme,
    pub(super) act: Callback<Action>,
}

/// The corpus panel.
#[component]
pub(super) fn CorpusPanel(props: &Props) -> Html {
    let text = use_text();
    let Props { corpus, notice, theme, act } = props;
    html! {
        <section class="card corpus" aria-labelledby="corpus-title">
            <div class="card-head">
                <h2 id="corpus-title">{ text.corpus }</h2>
                if let Some(corpus) = corpus {
                    <span class="tag" data-testid="corpus-name">{ &corpus.report.name }</span>
                }
            </div>
            <OpenFile id="corpus-file" label={text.open_corpus} accept=".csv,.tsv,.jsonl,.txt"
                hint={text.corpus_hint} act={act.clone()} />
            if let Some(notice) = notice {
                <div class="notice bad" role="alert" data-testid="file-notice">
                    <p><strong>{ &notice.message }</strong></p>
                    <Problems problems={notice.problems.clone()} />
                </div>
            }
            if let Some(corpus) = corpus { { list(text, corpus, *theme, act) } }
        </section>
    }
}

fn list(text: &Text, corpus: &Corpus, theme: Theme, act: &Callback<Action>) -> Html {
    let report = &corpus.report;
    let left = report.rows.len().saturating_sub(corpus.shown);
    html! {
        <>
            <p class="dim" data-testid="corpus-count">
                { (text.commands)(report.rows.len()) }
                if report.rejected > 0 { { (text.rejected)(report.rejected) } }
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
                    <Problems problems={report.problems.clone()} />
                </details>
            }
            <ol class="rows" data-testid="rows">
                { for report.rows.iter().take(corpus.shown).enumerate().map(|(i, row)| html! {
                    <Row key={i} index={i} command={row.command.clone()} task={row.task.clone()}
                        count={row.pairs} open={corpus.open == Some(i)} pairs={corpus.pairs.get(&i).cloned()}
                        theme={theme} act={act.clone()} />
                }) }
            </ol>
            if left > 0 {
                <button type="button" class="plain" data-testid="more-rows"
                    onclick={act.reform(|_| Action::MoreRows)}>{ (text.more_rows)(left) }</button>
            }
        </>
    }
}
