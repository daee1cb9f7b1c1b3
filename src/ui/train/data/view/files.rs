//! The files: opened, read, refused, saved.

use super::faults::faults;
use crate::ui::page::view::files::open_file;
use crate::ui::train::data::action::{Action, Map};
use crate::ui::train::data::sheet::Sheet;
use crate::ui::train::data::state::{Refused, State};
use crate::ui::train::data::words::Text;
use crate::worker::protocol::Form;
use yew::{Callback, Html, html};

/// Reading so many bytes takes long enough to be shown.
const LONG: u64 = 1 << 18;

/// What is chosen from.
const ACCEPT: &str = ".csv,.tsv,.json,.jsonl,.txt,.gz";

/// The files.
pub(super) fn files(state: &State, text: &Text, act: &Callback<Action>) -> Html {
    let State { sheet, refused, reading, .. } = state;
    html! {
        <section class="card corpus" aria-labelledby="corpus-title">
            <div class="card-head">
                <h2 id="corpus-title">{ text.corpus }</h2>
                if let Some(sheet) = sheet {
                    <span class="tag" data-testid="corpus-name">{ &sheet.name }</span>
                }
            </div>
            { open_file("corpus-file", text.open_corpus, ACCEPT, Some(text.corpus_hint), &act.reform(Action::Offered)) }
            if let Some((done, of)) = reading.filter(|(_, of)| *of > LONG) {
                <div class="bar" data-testid="reading">
                    <progress aria-label={text.reading} max={of.to_string()} value={done.to_string()} />
                    <p class="dim">
                        { format!("{} {} % ", text.reading, done * 100 / of) }
                        { link(text.cancel, "stop-reading", act.reform(|_| Action::Stop)) }
                    </p>
                </div>
            }
            if let Some(refused) = refused { { notice(refused, text, act) } }
            if let Some(sheet) = sheet { { stands(sheet, text, act) } }
        </section>
    }
}

fn notice(refused: &Refused, text: &Text, act: &Callback<Action>) -> Html {
    html! {
        <div class="notice bad" role="alert" data-testid="file-notice">
            <p><strong>{ &refused.message }</strong></p>
            { faults(text, &refused.reports, &refused.faults, act) }
            if refused.can_be_mapped() {
                { link(text.map, "map", act.reform(|_| Action::Map(Map::Begin))) }
            }
        </div>
    }
}

fn stands(sheet: &Sheet, text: &Text, act: &Callback<Action>) -> Html {
    let care = &sheet.care;
    let count = |n: u32, words: fn(u32) -> String| if n > 0 { words(n) } else { String::new() };
    let problems = sheet.faults().len();
    let use_words = if sheet.with_rejected { text.leave_rejected } else { text.use_rejected };
    let save = |id, words, form| link(words, id, act.reform(move |_| Action::SaveCorpus(form)));
    html! {
        <>
            <p class="dim figures" data-testid="corpus-count">
                { (text.commands)(care.rows) }
                { count(sheet.left_out(), text.left_out) }
                { count(care.rejected, text.rejected) }
                { count(care.held_out, text.held_out) }
                if problems > 0 { { (text.problems)(problems) } }
                {". "}
                if care.rejected > 0 || sheet.with_rejected {
                    { link(use_words, "use-rejected", act.reform(|_| Action::UseRejected)) }{" "}
                }
                { text.save_as }{": "}
                { save("save-corpus", text.save_csv, Some(Form::Csv)) }{" "}
                { save("save-json", text.save_json, Some(Form::JsonLines)) }{" "}
                if !sheet.is_demo() {
                    { link(text.map, "map-open", act.reform(|_| Action::Map(Map::Begin))) }{" "}
                    { link(text.six_sentences, "open-demo", act.reform(|_| Action::OpenDemo)) }
                }
            </p>
            if problems > 0 {
                <details class="problems-box" open={problems <= 5}>
                    <summary>{ (text.rows_to_look_at)(problems) }</summary>
                    { faults(text, &sheet.report.files, sheet.faults(), act) }
                </details>
            }
        </>
    }
}

/// A button that reads as a link.
pub(super) fn link(words: &'static str, id: &'static str, press: Callback<()>) -> Html {
    html! {
        <button type="button" class="link" data-testid={id} onclick={press.reform(|_| ())}>{ words }</button>
    }
}
