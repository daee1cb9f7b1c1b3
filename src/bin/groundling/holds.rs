//! `holds`: JSON lines `{goal, initial, current}` in, `{"holds"}` out.

use super::command::{Blank, Command, Done, Failure, answer_lines, only_files};
use groundling::corpus::cell;
use groundling::domain::State;
use groundling::ground::Goal;
use groundling::logic::{Terms, read};
use serde::Deserialize;
use serde_json::value::RawValue;

pub(crate) const COMMAND: Command = Command {
    name: "holds",
    about: "Tell whether a goal holds in a state",
    usage: "[FILE…]",
    details: "In:  a JSON object a line: {\"goal\": a term of type t, \"initial\": the state in which it is\n\
              \x20    said and its phrases are bound, \"current\": the state in question}\n\
              Out: {\"holds\": true or false}; a bad line is answered by {\"error\", \"line\"} in its place",
    run,
};

#[derive(Deserialize)]
#[serde(expecting = "a question: {goal, initial, current}")]
struct Question<'a> {
    goal: String,
    #[serde(borrow)]
    initial: &'a RawValue,
    #[serde(borrow)]
    current: &'a RawValue,
}

fn run(arguments: lexopt::Parser) -> Result<Done, Failure> {
    answer_lines(&only_files(arguments)?, Blank::IsAMistake, answer)
}

fn answer(line: &str) -> Result<String, String> {
    let question: Question<'_> = serde_json::from_str(line).map_err(|error| error.to_string())?;
    // An arena a line: a long stream must not grow without end.
    let mut terms = Terms::new();
    let term = read(&mut terms, &question.goal).map_err(|error| format!("goal: {error}"))?;
    let initial = state("initial", question.initial)?;
    let current = state("current", question.current)?;
    let goal = Goal::new(&terms, term, &initial).map_err(|error| format!("goal: {error}"))?;
    Ok(serde_json::json!({ "holds": goal.holds(&current) }).to_string())
}

/// Things may share a cell: a goal can be asked of any state that people's data holds.
fn state(side: &str, text: &RawValue) -> Result<State, String> {
    let (state, _) = cell::after(text.get()).map_err(|error| format!("{side}: {error}"))?;
    Ok(state)
}
