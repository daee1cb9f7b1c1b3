//! `plan`: a goal and a world a line in, a shortest plan out.

use super::command::{Blank, Command, Done, Failure, answer_lines, only_files};
use groundling::domain::{Rules, State};
use groundling::ground::{Goal, Task};
use groundling::logic::{Terms, read};
use groundling::mdp::{Outcome, Settings, Solver};
use groundling::plan::AStar;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use std::time::Instant;

pub(crate) const COMMAND: Command = Command {
    name: "plan",
    about: "Plan how to reach goals",
    usage: "[FILE…]",
    details: "In:  a JSON line {\"goal\", \"initial\", \"pull\"?: false, \"solver\"?: \"auto\" | \"astar\"}\n\
              Out: {\"length\", \"actions\", \"value\", \"states\", \"seconds\", \"solver\", \"reason\"?,\n\
              \x20    \"message\"?}; `states` counts those expanded, `reason` is no_referent, unreachable,\n\
              \x20    budget or bad_goal. A bad line is answered by {\"error\", \"line\"} in its place.",
    run,
};

/// The discount of a step.
const GAMMA: f64 = 0.99;

/// A line of input; what else it holds is not looked at.
#[derive(Deserialize)]
struct Question<'a> {
    goal: String,
    #[serde(borrow)]
    initial: &'a RawValue,
    pull: Option<bool>,
    robot: Option<bool>,
    landmarks: Option<String>,
    lock_probability: Option<f64>,
    loss_probability: Option<f64>,
    slip_probability: Option<f64>,
    solver: Option<String>,
}

/// A line of output.
#[derive(Serialize)]
struct Answer {
    length: Option<usize>,
    actions: Option<Vec<&'static str>>,
    value: Option<f64>,
    states: usize,
    seconds: f64,
    solver: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    message: Option<String>,
}

fn run(arguments: lexopt::Parser) -> Result<Done, Failure> {
    answer_lines(&only_files(arguments)?, Blank::IsAMistake, |line| {
        let started = Instant::now();
        let mut answer = answer(line)?;
        answer.seconds = started.elapsed().as_secs_f64();
        serde_json::to_string(&answer).map_err(|e| e.to_string())
    })
}

fn answer(line: &str) -> Result<Answer, String> {
    let question: Question<'_> = serde_json::from_str(line).map_err(|e| e.to_string())?;
    let rules = rules(&question)?;
    let initial = State::read(question.initial.get()).map_err(|e| format!("initial: {e}"))?;
    let mut terms = Terms::new();
    let bound = read(&mut terms, &question.goal)
        .map_err(|e| e.to_string())
        .and_then(|term| Goal::new(&terms, term, &initial).map_err(|e| e.to_string()));
    let goal = match bound {
        Ok(goal) => goal,
        Err(message) => return Ok(Answer { message: Some(message), ..none("bad_goal", None, 0) }),
    };
    let task = Task::new(&goal, &initial, rules).map_err(|e| format!("initial: {e}"))?;
    if task.is_impossible() {
        let is_lost = !goal.failures().is_empty();
        return Ok(none(if is_lost { "no_referent" } else { "unreachable" }, Some(0.0), 0));
    }
    let mut search = AStar::new(&task, Settings::default());
    let outcome = search.run();
    let states = usize::try_from(search.expanded()).unwrap_or(usize::MAX);
    match (outcome, search.plan()) {
        (Outcome::Solved, Some(plan)) => Ok(Answer {
            length: Some(plan.actions.len()),
            value: Some(plan.actions.iter().skip(1).fold(1.0, |value, _| value * GAMMA)),
            actions: Some(plan.actions.iter().map(|a| a.name()).collect()),
            reason: None,
            ..none("", None, states)
        }),
        (Outcome::Unreachable, _) => Ok(none("unreachable", Some(0.0), states)),
        _ => Ok(none("budget", None, states)),
    }
}

/// The answer without a plan.
fn none(reason: &'static str, value: Option<f64>, states: usize) -> Answer {
    let (length, actions, message) = (None, None, None);
    let reason = Some(reason);
    Answer { length, actions, value, states, seconds: 0.0, solver: "astar", reason, message }
}

/// The rules that a question asks for, or what is asked that there is not.
fn rules(question: &Question<'_>) -> Result<Rules, String> {
    for (field, probability) in [
        ("lock_probability", question.lock_probability),
        ("loss_probability", question.loss_probability),
        ("slip_probability", question.slip_probability),
    ] {
        match probability {
            None | Some(0.0) => {}
            Some(p) if !(0.0..=1.0).contains(&p) => {
                return Err(format!("{field}: {p} is no probability, which lies between 0 and 1"));
            }
            Some(_) => {
                return Err(format!(
                    "{field}: only deterministic worlds can be planned in: leave it at 0"
                ));
            }
        }
    }
    if question.robot == Some(true) {
        return Err("robot: the robot form of the world is not there: leave it at false".into());
    }
    match question.landmarks.as_deref() {
        None | Some("free") => {}
        Some("fixed") => {
            return Err("landmarks: they cannot be held fixed here: leave it at \"free\"".into());
        }
        Some(other) => return Err(format!("landmarks: `{other}` is unknown: use free or fixed")),
    }
    match question.solver.as_deref() {
        None | Some("auto" | "astar") => {}
        Some(known @ ("vi" | "lrtdp" | "uct")) => {
            return Err(format!("solver: `{known}` is not there: use auto or astar"));
        }
        Some(other) => {
            return Err(format!("solver: `{other}` is unknown: use auto, astar, vi, lrtdp or uct"));
        }
    }
    Ok(Rules { pull: question.pull.unwrap_or(false), ..Rules::default() })
}
