//! `equivalent`: JSON lines `{a, b, initial?}` in, `{"equivalent", "run"?}` out.

use super::arguments::Arguments;
use super::command::{Blank, Command, Done, answer_lines, only_files};
use super::failure::Failure;
use groundling::corpus::json::whole_json;
use groundling::domain::State;
use groundling::ground::{Comparison, compare};
use groundling::logic::{Terms, read};
use serde::Deserialize;
use serde_json::json;
use serde_json::value::RawValue;

pub(crate) const COMMAND: Command = Command {
    name: "equivalent",
    about: "Tell whether two tasks ask the same of every run",
    usage: "[FILE…]",
    details: "In:  a JSON object a line: {\"a\": a term of type t or p, \"b\": another, \"initial\"?: the state in\n\
              \x20    which both are said}. Without it closed atoms that differ are independent; with it phrases\n\
              \x20    are resolved there, and a body is in one room at a time.\n\
              Out: {\"equivalent\": whether every run satisfies both first at the same state}, and, where not,\n\
              \x20    \"run\": a shortest that does not, as the atoms that are true in each of its states.\n\
              \x20    A bad line is answered by {\"error\", \"line\"} in its place",
    run,
};

#[derive(Deserialize)]
#[serde(expecting = "a question: {a, b}")]
struct Question<'a> {
    a: String,
    b: String,
    #[serde(borrow)]
    initial: Option<&'a RawValue>,
}

fn run(arguments: Arguments) -> Result<Done, Failure> {
    answer_lines(&only_files(arguments)?, Blank::IsAMistake, answer)
}

fn answer(line: &str) -> Result<String, String> {
    let question: Question<'_> = whole_json(line).map_err(|wrong| wrong.to_string())?;
    let mut terms = Terms::new();
    let a = read(&mut terms, &question.a).map_err(|error| format!("a: {error}"))?;
    let b = read(&mut terms, &question.b).map_err(|error| format!("b: {error}"))?;
    let world = question.initial.map(|text| State::read(text.get())).transpose();
    let world = world.map_err(|error| format!("initial: {error}"))?;
    let comparison = compare(&terms, a, b, world.as_ref()).map_err(|error| error.to_string())?;
    let answer = match comparison {
        Comparison::Equivalent => json!({ "equivalent": true }),
        Comparison::Apart(run) => json!({ "equivalent": false, "run": run }),
    };
    Ok(answer.to_string())
}
