//! `holds`: JSON lines `{goal, initial, current}` or `{goal, run}` in, `{"holds", "at"?}` out.

use super::arguments::Arguments;
use super::command::{Blank, Command, Done, answer_lines, only_files};
use super::failure::Failure;
use groundling::corpus::cell;
use groundling::corpus::json::whole_json;
use groundling::domain::State;
use groundling::ground::{Course, Goal};
use groundling::logic::ty::RUN;
use groundling::logic::{TermId, Terms, read};
use serde::Deserialize;
use serde_json::json;
use serde_json::value::RawValue;

pub(crate) const COMMAND: Command = Command {
    name: "holds",
    about: "Tell whether a goal holds in a state, or a run satisfies it",
    usage: "[FILE…]",
    details: "In:  a JSON object a line: {\"goal\": a term, \"initial\": the state in which it is said and its\n\
              \x20    phrases are bound, \"current\": the state in question}, or {\"goal\", \"run\": [states]}.\n\
              \x20    A goal of type t is asked of the last state; one of type p, which speaks of time, of\n\
              \x20    the whole run (initial and current are a run of two states).\n\
              Out: {\"holds\": true or false}, for a run with \"at\", the first state at which it does (from 0,\n\
              \x20    null where there is none); a bad line is answered by {\"error\", \"line\"} in its place",
    run,
};

/// States that a run may have.
const MOST_STATES: usize = 10_000;

#[derive(Deserialize)]
#[serde(expecting = "a question: {goal, initial, current} or {goal, run}")]
struct Question<'a> {
    goal: String,
    #[serde(borrow)]
    initial: Option<&'a RawValue>,
    #[serde(borrow)]
    current: Option<&'a RawValue>,
    #[serde(borrow)]
    run: Option<Vec<&'a RawValue>>,
}

fn run(arguments: Arguments) -> Result<Done, Failure> {
    answer_lines(&only_files(arguments)?, Blank::IsAMistake, answer)
}

fn answer(line: &str) -> Result<String, String> {
    let question: Question<'_> = whole_json(line).map_err(|wrong| wrong.to_string())?;
    // An arena a line: a long stream must not grow without end.
    let mut terms = Terms::new();
    let term = read(&mut terms, &question.goal).map_err(|error| format!("goal: {error}"))?;
    let judge = if terms.ty(term) == RUN { satisfied } else { reached };
    match (question.run, question.initial, question.current) {
        (Some(run), None, None) => {
            let run = states(&run)?;
            let (holds, at) = judge(&terms, term, &run)?;
            Ok(json!({ "holds": holds, "at": at }).to_string())
        }
        (None, Some(initial), Some(current)) => {
            let run = [state("initial", initial)?, state("current", current)?];
            let (holds, _) = judge(&terms, term, &run)?;
            Ok(json!({ "holds": holds }).to_string())
        }
        _ => Err("give either initial and current, or run".to_owned()),
    }
}

/// Whether a run satisfies a task, and the last state of its shortest beginning that does.
fn satisfied(terms: &Terms, term: TermId, run: &[State]) -> Result<(bool, Option<usize>), String> {
    let (first, last) = (run.first().ok_or("run: there is no state")?, run.len() - 1);
    let course = Course::new(terms, term, first).map_err(|error| format!("goal: {error}"))?;
    let beginnings = course.beginnings(run);
    Ok((beginnings.holds(last), beginnings.first()))
}

/// Whether a goal holds in a run's last state, and the first in which it does.
fn reached(terms: &Terms, term: TermId, run: &[State]) -> Result<(bool, Option<usize>), String> {
    let (first, last) = (run.first(), run.last());
    let (Some(first), Some(last)) = (first, last) else {
        return Err("run: there is no state".into());
    };
    let goal = Goal::new(terms, term, first).map_err(|error| format!("goal: {error}"))?;
    Ok((goal.holds(last), run.iter().position(|state| goal.holds(state))))
}

fn states(run: &[&RawValue]) -> Result<Vec<State>, String> {
    if run.len() > MOST_STATES {
        return Err(format!("run: {} states are too many: give {MOST_STATES} at most", run.len()));
    }
    let places = (0..).zip(run);
    places.map(|(place, text)| state(&format!("run: state {place}"), text)).collect()
}

/// Things may share a cell: a goal can be asked of any state that people's data holds.
fn state(side: &str, text: &RawValue) -> Result<State, String> {
    let (state, _) = cell::after(text.get()).map_err(|error| format!("{side}: {error}"))?;
    Ok(state)
}
