//! Files that are brought to the part about studies, and those that it makes.

use super::action::Saved;
use super::state::State;
use super::words::Text;
use crate::study::export::{Style, write};
use crate::study::survey::{SurveyMapping, convert, trials};
use crate::study::{Merged, Review, coverage, merge, pay};
use crate::ui::page::files::Offered;

/// Answers on view at once.
pub const PAGE: usize = 25;

/// The texts of files, of which those that are none are told by their names.
pub(super) fn texts(files: Vec<Offered>) -> (Vec<(String, String)>, Vec<String>) {
    let (mut good, mut bad) = (Vec::new(), Vec::new());
    for Offered { name, bytes } in files {
        match bytes.ok().and_then(|bytes| crate::corpus::text_of(bytes).ok()) {
            Some(text) => good.push((name, text)),
            None => bad.push(name),
        }
    }
    (good, bad)
}

/// Takes in files of answers; what is none of ours may be another program's trials.
pub(super) fn bring(state: &mut State, files: Vec<Offered>) {
    let (texts, unreadable) = texts(files);
    state.flaws = unreadable;
    let names = |texts: &[(String, String)]| -> Merged {
        merge(texts.iter().map(|(name, text)| (name.as_str(), text.as_str())))
    };
    let new = names(&texts);
    if new.answers.is_empty() && !texts.is_empty() {
        let found = trials(texts.iter().map(|(name, text)| (name.as_str(), text.as_str())));
        if !found.rows.is_empty() {
            let mapping = SurveyMapping::propose(&found);
            state.survey = Some((found, mapping));
            return;
        }
        state.flaws.extend(found.flaws.iter().map(|(name, flaw)| format!("{name}: {flaw}")));
        if found.flaws.is_empty() {
            state.flaws.extend(new.flaws.iter().map(|(name, flaw)| format!("{name}: {flaw}")));
        }
        return;
    }
    state.files.extend(texts);
    let merged = names(&state.files);
    take(state, merged);
}

/// Takes merged answers in.
pub(super) fn take(state: &mut State, merged: Merged) {
    let doubles = merged.doubles;
    state.flaws.extend(merged.flaws.iter().map(|(name, flaw)| format!("{name}: {flaw}")));
    let (review, others) = Review::new(&state.against(), merged);
    (state.review, state.left_out, state.from) = (review, [doubles, others], 0);
}

/// Takes another program's trials as answers.
pub(super) fn converted(state: &mut State, text: &Text) {
    let Some((trials, mapping)) = &state.survey else { return };
    match convert(trials, mapping) {
        Ok(found) => {
            let told = (text.converted)(found.answers.len(), found.others, found.unfinished);
            let answers: String = crate::study::answer::lines(&found.answers);
            let flaws = found.flaws.iter().map(ToString::to_string).collect();
            (state.survey, state.flaws) = (None, flaws);
            state.files.push(("trials".to_owned(), answers));
            let merged =
                merge(state.files.iter().map(|(name, text)| (name.as_str(), text.as_str())));
            take(state, merged);
            state.notice = Some(told);
        }
        Err(wrong) => state.notice = Some(wrong.to_string()),
    }
}

/// A file to save: its name and its text.
///
/// # Errors
/// In words, why there is none.
pub(super) fn made(state: &State, what: Saved, text: &Text) -> Result<(String, String), String> {
    let study = state.against();
    let named = |name: &str, text: String| Ok((name.to_owned(), text));
    match what {
        Saved::Study => match &state.study {
            Some(study) => named("study.json", study.write()),
            None => Err(text.no_study.to_owned()),
        },
        Saved::Table | Saved::Lines => {
            let is_json = what == Saved::Lines;
            let name = if is_json { "answers.jsonl" } else { "answers.csv" };
            named(name, answers(state, is_json, state.approved_only)?)
        }
        Saved::Pay => named("pay.csv", pay::sheet(&study, &state.review)),
        Saved::TopUp => match coverage::top_up(&study, &state.review, state.wanted as usize) {
            Some(more) => named("top-up.json", more.write()),
            None => Err(text.enough.to_owned()),
        },
        Saved::Mapping => match &state.survey {
            Some((_, mapping)) => named("survey-mapping.json", mapping.write()),
            None => Err(String::new()),
        },
    }
}

/// The answers as a file.
///
/// # Errors
/// When they cannot be written.
pub(super) fn answers(state: &State, is_json: bool, approved_only: bool) -> Result<String, String> {
    let pseudonyms = Some(state.key.clone()).filter(|key| !key.is_empty());
    let style = Style { is_json, pseudonyms, approved_only };
    let mut bytes = Vec::new();
    write(&state.review, &style, &mut bytes).map_err(|error| error.to_string())?;
    String::from_utf8(bytes).map_err(|error| error.to_string())
}
