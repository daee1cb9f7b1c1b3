//! Answers from many files as one list, in any order and however they came: lines of JSON, what an endpoint received (an
//! object with `answers`), or batch results with a column `Answer.answers`. Invariant: the same answers give the same
//! list, in whichever order and how often their files come.

use super::answer::{Answer, FORMAT};
use super::file::Showing;
use crate::corpus::{Decision, Example, Flaw, Options, Wrong, read};
use serde_json::Value;
use serde_json::value::RawValue;

/// Answers that were merged.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Merged {
    /// Each once, by sitting and turn.
    pub answers: Vec<Answer>,
    /// What files say was decided of them.
    pub decided: Vec<Decision>,
    /// How often one came again.
    pub doubles: usize,
    /// What is wrong with files, each with its file's name.
    pub flaws: Vec<(String, Flaw)>,
}

/// The column of a form in which all answers of a sitting are posted.
pub const COLUMN: &str = "Answer.answers";

/// Merges files, each a name and a text.
pub fn merge<'a>(files: impl IntoIterator<Item = (&'a str, &'a str)>) -> Merged {
    let mut merged = Merged::default();
    let mut found: Vec<(Answer, Decision)> = Vec::new();
    for (name, text) in files {
        let text = text.trim_start_matches('\u{feff}');
        let flaws = &mut merged.flaws;
        match text.trim_start().chars().next() {
            Some('{' | '[') => {
                objects(text, &mut found, |flaw| flaws.push((name.to_owned(), flaw)))
            }
            _ => table(text, &mut found, |flaw| flaws.push((name.to_owned(), flaw))),
        }
    }
    let key = |answer: &Answer| (answer.sitting().to_owned(), answer.turn, answer.id.clone());
    // Of two of one name the one with most said of it stands first, and then by its letters.
    let weight = |(answer, decision): &(Answer, Decision)| {
        (key(answer), *decision == Decision::Open, answer.line())
    };
    found.sort_by_cached_key(weight);
    for (answer, decision) in found {
        if merged.answers.last().is_some_and(|last| last.id == answer.id) {
            merged.doubles += 1;
        } else {
            merged.answers.push(answer);
            merged.decided.push(decision);
        }
    }
    merged
}

/// The answers of a text of JSON: objects one after another, or lists of them.
fn objects(text: &str, found: &mut Vec<(Answer, Decision)>, mut flaw: impl FnMut(Flaw)) {
    let mut stream = serde_json::Deserializer::from_str(text).into_iter::<&RawValue>();
    let mut before = 0;
    while let Some(next) = stream.next() {
        let line = 1 + text.get(..before).unwrap_or_default().matches('\n').count() as u64;
        match next {
            Ok(value) => value_answers(value.get(), line, found, &mut flaw),
            Err(error) => {
                let line = error.line() as u64;
                let what = format!("this is no JSON: {error}");
                let wrong = Wrong::with_mend(what, "mend the line, or give the file again");
                flaw(Flaw { line, ..Flaw::of_file(wrong) });
                // What follows on the next line may be whole.
                let rest = text.get(before..).unwrap_or_default();
                let skip = rest.trim_start().find('\n');
                if let Some(skip) = skip {
                    let start = before + (rest.len() - rest.trim_start().len()) + skip + 1;
                    return objects(
                        text.get(start..).unwrap_or_default(),
                        found,
                        flaw_at(line, &mut flaw),
                    );
                }
                return;
            }
        }
        before = stream.byte_offset();
    }
}

/// Flaws of what stands behind so many lines.
fn flaw_at(line: u64, flaw: &mut dyn FnMut(Flaw)) -> Box<dyn FnMut(Flaw) + '_> {
    Box::new(move |found| flaw(Flaw { line: found.line + line, ..found }))
}

fn value_answers(
    text: &str,
    line: u64,
    found: &mut Vec<(Answer, Decision)>,
    flaw: &mut dyn FnMut(Flaw),
) {
    if let Ok(list) = serde_json::from_str::<Vec<&RawValue>>(text) {
        return list.iter().for_each(|one| value_answers(one.get(), line, found, flaw));
    }
    let fields: Value = serde_json::from_str(text).unwrap_or_default();
    if fields["format"] == FORMAT {
        match serde_json::from_str::<Answer>(text) {
            Ok(answer) => found.push((answer, decided(&fields))),
            Err(error) => {
                flaw(Flaw { line, ..Flaw::of_file(format!("the answer is damaged: {error}")) });
            }
        }
        return;
    }
    match &fields["answers"] {
        Value::String(inner) => {
            objects(inner, found, |wrong| flaw(Flaw { line, ..wrong }));
        }
        Value::Array(all) => {
            for one in all {
                value_answers(&one.to_string(), line, found, flaw);
            }
        }
        _ => {
            let what = "this is no answer to a study";
            let mend =
                "give the files that the study's page made, or map the file of another program";
            flaw(Flaw { line, ..Flaw::of_file(Wrong::with_mend(what, mend)) });
        }
    }
}

/// What a line of answers says was decided of it.
fn decided(fields: &Value) -> Decision {
    match (fields["AssignmentStatus"].as_str(), fields["Reject"].as_str()) {
        (Some("Rejected"), why) => Decision::Rejected(why.unwrap_or_default().into()),
        (_, Some(why)) if !why.is_empty() => Decision::Rejected(why.into()),
        (Some("Approved"), _) => Decision::Approved,
        _ => Decision::Open,
    }
}

/// The answers of batch results: what a frame's form posted, or rows that this page wrote.
fn table(text: &str, found: &mut Vec<(Answer, Decision)>, mut flaw: impl FnMut(Flaw)) {
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(text.as_bytes());
    let column = reader.headers().ok().and_then(|h| h.iter().position(|name| name == COLUMN));
    if let Some(column) = column {
        for record in reader.records() {
            match record {
                Ok(record) => {
                    let line = record.position().map_or(0, csv::Position::line);
                    let cell = record.get(column).unwrap_or_default();
                    objects(cell, found, |wrong| flaw(Flaw { line, ..wrong }));
                }
                Err(error) => flaw(Flaw::of_file(format!("the table is damaged: {error}"))),
            }
        }
        return;
    }
    let options = Options { with_rejected: true, ..Options::default() };
    let (corpus, flaws) = read(text.as_bytes(), options);
    flaws.into_iter().for_each(&mut flaw);
    found.extend(corpus.examples.into_iter().map(of_example));
}

/// An example of a corpus as an answer of which nothing more is known.
pub fn of_example(example: Example) -> (Answer, Decision) {
    let worker = example.worker.unwrap_or_default();
    let answer = Answer {
        format: FORMAT.to_owned(),
        id: format!("{}-1", example.id),
        command: example.command,
        item: example.task.clone().unwrap_or_default(),
        task: example.task,
        worker,
        pairs: example.pairs.into_iter().map(Showing::from).collect(),
        study: String::new(),
        turn: [1, 1],
        assignment: Some(example.id),
        hit: None,
        at: 0.0,
        care: super::answer::Care::default(),
        simulated: None,
    };
    (answer, example.decision)
}
