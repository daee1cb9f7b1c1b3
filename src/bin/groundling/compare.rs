//! `compare`: what tells two models apart.

use super::arguments::Arguments;
use super::command::{Command, Done, print};
use super::corpora::model;
use super::failure::Failure;
use groundling::ccg::EntryText;
use groundling::learn::inspect::{Difference, Entries, difference};
use std::path::PathBuf;

/// Lines of each part that are told to a person.
const MOST_LINES: usize = 20;

pub(crate) const COMMAND: Command = Command {
    name: "compare",
    about: "Tell what tells two models apart: facts, entries, weights",
    usage: "MODEL MODEL [--json]",
    details: "  --json              print one JSON object: facts, common, first_alone, second_alone, entries, features",
    run,
};

fn run(mut arguments: Arguments) -> Result<Done, Failure> {
    use lexopt::Arg::{Long, Value};
    let (mut files, mut as_json) = (Vec::<PathBuf>::new(), false);
    while let Some(argument) = arguments.next()? {
        match argument {
            Value(file) if files.len() < 2 => files.push(file.into()),
            Long("json") => as_json = true,
            other => return Err(other.unexpected().into()),
        }
    }
    let [first, second] = files.as_slice() else {
        return Err(Failure::Usage("two models are held against each other".to_owned()));
    };
    let found = difference(&model(first)?, &model(second)?);
    // A difference always has a JSON form: it is made of texts and finite numbers.
    let text =
        if as_json { serde_json::to_string(&found).unwrap_or_default() } else { text(&found) };
    print(&text)
}

fn text(found: &Difference) -> String {
    let mut lines: Vec<String> = Vec::new();
    for (name, first, second) in &found.facts {
        let [first, second] = [first, second].map(|value| value.as_deref().unwrap_or("(none)"));
        lines.push(format!("{name}: {first} → {second}"));
    }
    let entry =
        |entry: &EntryText| format!("{} :- {} : {}", entry.words, entry.syntax, entry.meaning);
    for (what, Entries { count, first }) in
        [("first", &found.first_alone), ("second", &found.second_alone)]
    {
        lines.push(format!("{count} entries that the {what} alone has"));
        let told = first.iter().take(MOST_LINES);
        lines.extend(told.map(|(one, weight)| format!("  {weight:>8.3}  {}", entry(one))));
    }
    lines.push(format!(
        "{} entries of both, {} with other weights",
        found.common,
        found.entries.len()
    ));
    let moved = |(what, a, b): (String, f64, f64)| format!("  {a:>8.3} → {b:>8.3}  {what}");
    let told = found.entries.iter().take(MOST_LINES);
    lines.extend(told.map(|(one, a, b)| moved((entry(one), *a, *b))));
    lines.push(format!("{} other features with other weights", found.features.len()));
    lines.extend(found.features.iter().take(MOST_LINES).cloned().map(moved));
    lines.join("\n")
}
