//! Trials as answers: those that have a command and states, in the order of their files. The others are pages without an
//! answer, which every study has.

use super::mapping::SurveyMapping;
use super::trials::{Trials, at};
use crate::corpus::{Flaw, Wrong, cell};
use crate::study::answer::{Answer, Care, FORMAT};
use crate::study::showing::Showing;
use serde_json::{Map, Value};

/// What came of trials.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Converted {
    /// The answers.
    pub answers: Vec<Answer>,
    /// Trials without a command and states.
    pub others: usize,
    /// Answers of participants that did not finish, which are left out.
    pub unfinished: usize,
    /// What is wrong with trials that have both.
    pub flaws: Vec<Flaw>,
}

/// The answers of trials by a mapping.
///
/// # Errors
/// What the mapping lacks.
pub fn convert(trials: &Trials, mapping: &SurveyMapping) -> Result<Converted, Wrong> {
    if !mapping.is_complete() {
        let mend = "say which value is the command, and which are the states before and after";
        return Err(Wrong::with_mend("the mapping is not complete", mend));
    }
    let mut found = Converted::default();
    for (number, (line, trial)) in (1..).zip(&trials.rows) {
        let Some(Parts { command, states }) = parts(trial, mapping) else {
            found.others += 1;
            continue;
        };
        let text =
            |path: &Option<String>| path.as_ref().and_then(|path| at(trial, path)).map(plain);
        let worker = text(&mapping.worker).unwrap_or_default();
        if trials.unfinished.contains(&worker) && !mapping.with_unfinished {
            found.unfinished += 1;
            continue;
        }
        let mut pairs = Vec::new();
        for (pre, post) in states {
            let pair = cell::demonstration(&pre, &post, |_, wrong| {
                found.flaws.push(Flaw { line: *line, ..Flaw::of_file(wrong) });
            });
            pairs.extend(pair.map(Showing::from));
        }
        if pairs.len() < mapping.pairs.len() {
            continue;
        }
        let task = text(&mapping.task);
        found.answers.push(Answer {
            format: FORMAT.to_owned(),
            id: format!("trial{number}-1"),
            command,
            item: task.clone().unwrap_or_default(),
            task,
            worker,
            pairs,
            runs: Vec::new(),
            study: String::new(),
            turn: [1, 1],
            assignment: None,
            hit: None,
            at: 0.0,
            care: Care::default(),
            simulated: None,
        });
    }
    Ok(found)
}

/// The command of a trial, and its states as text.
struct Parts {
    command: String,
    states: Vec<(String, String)>,
}

/// What a trial has of an answer, if it has all of it.
fn parts(trial: &Map<String, Value>, mapping: &SurveyMapping) -> Option<Parts> {
    let command = plain(at(trial, &mapping.command)?);
    let states = mapping
        .pairs
        .iter()
        .map(|pair| Some((plain(at(trial, &pair.pre)?), plain(at(trial, &pair.post)?))));
    let states = states.collect::<Option<_>>()?;
    (!command.trim().is_empty()).then_some(Parts { command, states })
}

/// A value as text: a text itself, anything else as JSON.
fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}
