//! Trials as sets of named values, whichever program wrote them and in which form. A trial's value may be a JSON object;
//! what is inside is named by its path: `response.command`.

use super::python::value;
use crate::corpus::{Flaw, Wrong};
use serde_json::{Map, Value};
use std::collections::BTreeSet;

/// What some files hold.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trials {
    /// The trials, each with the line where it begins.
    pub rows: Vec<(u64, Map<String, Value>)>,
    /// Participants that did not finish, as far as the files tell.
    pub unfinished: BTreeSet<String>,
    /// What is wrong or odd, by file.
    pub flaws: Vec<(String, Flaw)>,
}

/// What psiTurk calls who takes part.
pub(super) const UNIQUE: &str = "uniqueid";

/// Which of psiTurk's downloads a table without a header is.
#[derive(Clone, Copy, PartialEq)]
enum Download {
    Trials,
    Questions,
    Events,
}

/// The trials of files, each a name and a text.
pub fn trials<'a>(files: impl IntoIterator<Item = (&'a str, &'a str)>) -> Trials {
    let mut found = Trials::default();
    let mut questions: Vec<(String, String, Value)> = Vec::new();
    let mut asked = false;
    for (name, text) in files {
        let text = text.trim_start_matches('\u{feff}');
        let mut wrong = |line: u64, wrong: Wrong| {
            found.flaws.push((name.to_owned(), Flaw { line, ..Flaw::of_file(wrong) }));
        };
        if text.trim_start().starts_with(['[', '{']) {
            match json(text) {
                Ok(rows) => found.rows.extend((1..).zip(rows)),
                Err(why) => wrong(0, why),
            }
            continue;
        }
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .from_reader(text.as_bytes());
        let mut records = Vec::new();
        for record in reader.records() {
            match record {
                Ok(record) => records.push(record),
                Err(error) => wrong(0, Wrong::from(format!("the table is damaged: {error}"))),
            }
        }
        match records.first().and_then(download) {
            Some(Download::Trials) => {
                found.rows.extend(records.iter().filter_map(psiturk_trial));
            }
            Some(Download::Questions) => {
                asked = true;
                questions.extend(records.iter().filter_map(|record| {
                    let (who, key) = (record.get(0)?, record.get(1)?);
                    Some((who.to_owned(), key.to_owned(), value(record.get(2)?)))
                }));
            }
            Some(Download::Events) => {
                wrong(0, Wrong::from("these are events, of which nothing is needed".to_owned()));
            }
            None => found.rows.extend(table(&records)),
        }
    }
    if asked {
        with_questions(&mut found, &questions);
    }
    found
}

/// JSON as jsPsych writes it: a list of trials, or trials one after another.
fn json(text: &str) -> Result<Vec<Map<String, Value>>, Wrong> {
    let mut rows = Vec::new();
    for value in serde_json::Deserializer::from_str(text).into_iter::<Value>() {
        match value.map_err(|error| Wrong::from(format!("this is no JSON: {error}")))? {
            Value::Array(all) => {
                for one in all {
                    let Value::Object(trial) = one else {
                        let mend = "give a list of objects, one a trial";
                        return Err(Wrong::with_mend("a trial of the list is no object", mend));
                    };
                    rows.push(trial);
                }
            }
            Value::Object(trial) if !trial.is_empty() && trial.values().all(Value::is_array) => {
                let what = "this goes by column, with the gaps left out: its rows no longer belong together";
                let mend = "save the data by trial: jsPsych.data.get().csv() or .json()";
                return Err(Wrong::with_mend(what, mend));
            }
            Value::Object(trial) => rows.push(trial),
            _ => {
                return Err(Wrong::with_mend(
                    "this is no list of trials",
                    "give one object a trial",
                ));
            }
        }
    }
    Ok(rows)
}

/// Which of psiTurk's downloads begins with this record, which is no header: psiTurk writes none.
fn download(record: &csv::StringRecord) -> Option<Download> {
    let is_object =
        |at: usize| record.get(at).is_some_and(|cell| cell.trim_start().starts_with('{'));
    let is_number =
        |at: usize| record.get(at).is_some_and(|cell| cell.trim().parse::<f64>().is_ok());
    let who = record.get(0).is_some_and(|who| who.contains(':'));
    match record.len() {
        4 if is_object(3) && is_number(1) => Some(Download::Trials),
        3 if who => Some(Download::Questions),
        5 if who && is_number(4) => Some(Download::Events),
        _ => None,
    }
}

/// A trial of psiTurk: who, its number, when, and JSON.
fn psiturk_trial(record: &csv::StringRecord) -> Option<(u64, Map<String, Value>)> {
    let line = record.position().map_or(0, csv::Position::line);
    let data: Value = serde_json::from_str(record.get(3)?).ok()?;
    let Value::Object(mut trial) = data else { return None };
    trial.insert(UNIQUE.to_owned(), Value::String(record.get(0)?.to_owned()));
    Some((line, trial))
}

/// Adds what each participant answered besides to their trials; who answered nothing has not finished.
fn with_questions(found: &mut Trials, questions: &[(String, String, Value)]) {
    for (_, trial) in &mut found.rows {
        let Some(Value::String(who)) = trial.get(UNIQUE).cloned() else { continue };
        let mut finished = false;
        for (_, key, value) in questions.iter().filter(|(other, ..)| *other == who) {
            finished = true;
            trial.insert(format!("question.{key}"), value.clone());
        }
        if !finished {
            found.unfinished.insert(who);
        }
    }
}

/// A table with a header, a trial a row; `null` stands for nothing, and a column may have no name.
fn table(records: &[csv::StringRecord]) -> Vec<(u64, Map<String, Value>)> {
    let Some(header) = records.first() else { return Vec::new() };
    let row = |record: &csv::StringRecord| {
        let named = header.iter().zip(record.iter()).filter(|(name, _)| !name.trim().is_empty());
        let trial = named.map(|(name, cell)| (name.trim().to_owned(), self::cell(cell))).collect();
        (record.position().map_or(0, csv::Position::line), trial)
    };
    records.iter().skip(1).map(row).collect()
}

fn cell(text: &str) -> Value {
    match text.trim_start().chars().next() {
        None => Value::Null,
        _ if text == "null" => Value::Null,
        Some('{' | '[') => {
            serde_json::from_str(text).unwrap_or_else(|_| Value::String(text.to_owned()))
        }
        _ => Value::String(text.to_owned()),
    }
}

/// The paths of all values of some trials, in the order in which they are met; objects are named as a whole and by what
/// is in them.
pub fn paths(rows: &[(u64, Map<String, Value>)]) -> Vec<String> {
    const ENOUGH: usize = 200;
    let mut found: Vec<String> = Vec::new();
    let mut add = |path: String| {
        if !found.contains(&path) && found.len() < ENOUGH {
            found.push(path);
        }
    };
    for (_, trial) in rows.iter().take(ENOUGH) {
        for (name, value) in trial {
            add(name.clone());
            // A state is an object, too, and nobody names a part of one.
            let inner = value.as_object().filter(|inner| !inner.contains_key("agent"));
            inner
                .iter()
                .flat_map(|inner| inner.keys())
                .for_each(|key| add(format!("{name}.{key}")));
        }
    }
    found
}

/// The value at a path.
pub(super) fn at<'a>(trial: &'a Map<String, Value>, path: &str) -> Option<&'a Value> {
    let whole = trial.get(path);
    let inner = || {
        let (name, rest) = path.split_once('.')?;
        trial.get(name)?.as_object()?.get(rest)
    };
    whole.or_else(inner).filter(|value| !value.is_null())
}
