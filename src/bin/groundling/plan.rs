//! `plan`: a goal and a world a line in, a plan or what a policy is worth out.

use super::command::{Blank, Command, Done, Failure, answer_lines, only_files};
use groundling::domain::{Action, Chances, Form, Movable, Packed, Rules, State};
use groundling::ground::{Goal, Task};
use groundling::logic::{Terms, read};
use groundling::mdp::{
    DISCOUNT, Mdp, Outcome, Policy, Progress, RolloutReport, RolloutSettings, Rollouts, Settings,
    Solver, StartingAt,
};
use groundling::plan::{AnySolver, Auto, SOLVERS};
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use std::time::Instant;

pub(crate) const COMMAND: Command = Command {
    name: "plan",
    about: "Plan how to reach goals",
    usage: "[FILE…]",
    details: "In:  a JSON line {\"goal\", \"initial\", \"pull\"?: false, \"robot\"?: false,\n\
              \x20    \"landmarks\"?: \"free\" | \"fixed\", \"lock_probability\"?: 0, \"loss_probability\"?: 0,\n\
              \x20    \"slip_probability\"?: 0, \"solver\"?: \"auto\" | \"astar\" | \"vi\" | \"lrtdp\" | \"uct\",\n\
              \x20    \"steps\"?: most steps of the solver, \"epsilon\"?: 1e-6, \"rollouts\"?: runs of the policy, \"seed\"?: 0}\n\
              Out: {\"length\", \"actions\", \"value\", \"states\", \"seconds\", \"solver\", \"reason\"?,\n\
              \x20    \"message\"?, \"why\"?, \"least\"?, \"bounds\"?, \"rollouts\"?}. Length and actions where\n\
              \x20    nothing is left to chance; `states` counts those kept; `reason` is no_referent,\n\
              \x20    unreachable, budget or bad_goal. When the budget ran out no plan is shorter than\n\
              \x20    `least`, and `bounds` hold the value.\n\
              \x20    A bad line is answered by {\"error\", \"line\"} in its place.",
    run,
};

/// What a solver may spend when a line does not say: seconds where nothing is left to chance, else minutes; and some
/// hundred megabytes.
const SURE_STEPS: u64 = 600_000;
const STEPS: u64 = 100_000_000;
const STATES: usize = 1_800_000;
/// The same for UCT, which always spends it all: seconds.
const TRIALS: u64 = 2_000_000;
/// Most rollouts of a line.
const MOST_ROLLOUTS: u32 = 100_000;
/// A policy that takes more actions where nothing is left to chance does not get there.
const MOST_ACTIONS: usize = 100_000;

/// A line of input; what else it holds is not looked at.
#[derive(Deserialize)]
#[serde(expecting = "a question: {goal, initial}")]
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
    steps: Option<u64>,
    epsilon: Option<f64>,
    rollouts: Option<u32>,
    seed: Option<u64>,
}

/// A line of output.
#[derive(Default, Serialize)]
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
    #[serde(skip_serializing_if = "Option::is_none")]
    why: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    least: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bounds: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rollouts: Option<Runs>,
}

/// What came of rollouts.
#[derive(Serialize)]
struct Runs {
    runs: u32,
    successes: u32,
    interval: [f64; 2],
    mean_steps: Option<f64>,
    mean_return: f64,
    return_margin: f64,
    replans: u32,
}

impl From<RolloutReport> for Runs {
    fn from(report: RolloutReport) -> Self {
        let RolloutReport { runs, successes, mean_steps, mean_return, .. } = report;
        let RolloutReport { interval, return_margin, replans, .. } = report;
        let interval = [interval.0, interval.1];
        Self { runs, successes, interval, mean_steps, mean_return, return_margin, replans }
    }
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
    let (mut rules, landmarks_stay) = rules(&question)?;
    let solver = solver(&question)?;
    let runs = question.rollouts.unwrap_or(0);
    if runs > MOST_ROLLOUTS {
        return Err(format!("rollouts: {runs} are too many: ask for {MOST_ROLLOUTS} at most"));
    }
    let initial = State::read(question.initial.get()).map_err(|e| format!("initial: {e}"))?;
    let mut terms = Terms::new();
    let bound = read(&mut terms, &question.goal)
        .map_err(|e| e.to_string())
        .and_then(|term| Goal::new(&terms, term, &initial).map_err(|e| e.to_string()));
    let without = |reason| Answer {
        solver: solver.unwrap_or(SOLVERS[0]),
        reason: Some(reason),
        ..Answer::default()
    };
    let goal = match bound {
        Ok(goal) => goal,
        Err(message) => return Ok(Answer { message: Some(message), ..without("bad_goal") }),
    };
    if landmarks_stay {
        rules.movable = goal.movable(&initial);
    }
    let task = Task::new(&goal, &initial, rules).map_err(|e| format!("initial: {e}"))?;
    if goal.denies_nothing() || task.is_impossible() {
        let is_lost = !goal.failures().is_empty();
        let reason = if is_lost { "no_referent" } else { "unreachable" };
        return Ok(Answer { value: Some(0.0), ..without(reason) });
    }
    let steps = question.steps.unwrap_or(match solver {
        Some("uct") => TRIALS,
        None | Some("astar") if task.is_deterministic() => SURE_STEPS,
        _ => STEPS,
    });
    let seed = question.seed.unwrap_or(0);
    let epsilon = question.epsilon.unwrap_or(Settings::default().epsilon);
    if !(epsilon > 0.0 && epsilon < 1.0) {
        return Err(format!("epsilon: {epsilon} does not lie between 0 and 1"));
    }
    let settings = Settings { seed, epsilon, ..Settings::default() }.with_budget(steps, STATES);
    let make = |state| Making::new(solver, StartingAt::new(&task, state), settings);
    let mut first = make(task.initial());
    let outcome = first.run();
    if outcome == Outcome::Unfit {
        return Err("solver: astar plans only where nothing is left to chance: use another".into());
    }
    let mut answer = found(&task, &first, outcome, rules.chances == Chances::default());
    if runs > 0 {
        let settings = RolloutSettings { runs, seed, ..RolloutSettings::default() };
        answer.rollouts = Some(Rollouts::new(&task, settings, first, make).run().into());
    }
    Ok(answer)
}

/// A solver that was asked for by name, or one that chooses.
enum Making<'t> {
    Auto(Auto<StartingAt<&'t Task>>),
    Named(AnySolver<StartingAt<&'t Task>>),
}

impl<'t> Making<'t> {
    fn new(name: Option<&str>, problem: StartingAt<&'t Task>, settings: Settings) -> Self {
        match name.and_then(|name| AnySolver::named(name, problem, settings)) {
            Some(solver) => Self::Named(solver),
            None => Self::Auto(Auto::new(problem, settings)),
        }
    }

    fn solver(&self) -> &dyn Solver<Packed, Action> {
        match self {
            Self::Auto(solver) => solver,
            Self::Named(solver) => solver,
        }
    }
}

impl Policy<Packed, Action> for Making<'_> {
    fn action(&self, state: Packed) -> Option<Action> {
        self.solver().action(state)
    }
    fn value(&self, state: Packed) -> Option<f64> {
        self.solver().value(state)
    }
}

impl Solver<Packed, Action> for Making<'_> {
    fn name(&self) -> &'static str {
        self.solver().name()
    }
    fn step(&mut self, n: usize) -> Option<Outcome> {
        match self {
            Self::Auto(solver) => solver.step(n),
            Self::Named(solver) => solver.step(n),
        }
    }
    fn progress(&self) -> Progress {
        self.solver().progress()
    }
}

/// What a solver that has ended found.
fn found(task: &Task, solver: &Making<'_>, outcome: Outcome, is_sure: bool) -> Answer {
    let progress = solver.progress();
    let mut answer = Answer {
        states: progress.states,
        solver: solver.name(),
        why: match solver {
            Making::Auto(auto) => Some(auto.why().to_string()),
            Making::Named(_) => None,
        },
        ..Answer::default()
    };
    let value = solver.value(task.initial()).filter(|&value| value > 0.0);
    match outcome {
        Outcome::Unreachable => {
            (answer.value, answer.reason) = (Some(0.0), Some("unreachable"));
            return answer;
        }
        Outcome::Solved => answer.value = value,
        Outcome::Budget | Outcome::Unfit => {
            answer.value = value;
            answer.reason = Some("budget");
            answer.bounds = Some([progress.lower, progress.upper]);
        }
    }
    if is_sure && let Some(actions) = followed(task, solver) {
        answer.length = Some(actions.len());
        if outcome != Outcome::Solved {
            answer.least = Some(progress.least);
            answer.value = Some(actions.iter().skip(1).fold(1.0, |value, _| value * DISCOUNT));
        }
        answer.actions = Some(actions.iter().map(|action| action.name()).collect());
    }
    answer
}

/// The actions that a policy takes where nothing is left to chance, if they lead to the goal.
fn followed(task: &Task, policy: &Making<'_>) -> Option<Vec<Action>> {
    let mut state = task.initial();
    let mut actions = Vec::new();
    let mut out = Vec::new();
    while !task.is_terminal(state) {
        if actions.len() == MOST_ACTIONS {
            return None;
        }
        let action = policy.action(state)?;
        actions.push(action);
        out.clear();
        task.successors(state, action, &mut out);
        state = out.first()?.0;
    }
    Some(actions)
}

/// The rules that a question asks for, and whether landmarks stay where they are.
fn rules(question: &Question<'_>) -> Result<(Rules, bool), String> {
    let chance = |probability: Option<f64>| probability.unwrap_or(0.0);
    let chances = Chances::new(
        chance(question.slip_probability),
        chance(question.lock_probability),
        chance(question.loss_probability),
    );
    let landmarks_stay = match question.landmarks.as_deref() {
        None | Some("free") => false,
        Some("fixed") => true,
        Some(other) => return Err(format!("landmarks: `{other}` is unknown: use free or fixed")),
    };
    let rules = Rules {
        pull: question.pull.unwrap_or(false),
        form: if question.robot == Some(true) { Form::Robot } else { Form::Compass },
        movable: Movable::ALL,
        chances: chances.map_err(|e| e.to_string())?,
    };
    Ok((rules, landmarks_stay))
}

/// The solver that a question names; `None` for the one that chooses.
fn solver(question: &Question<'_>) -> Result<Option<&'static str>, String> {
    match question.solver.as_deref() {
        None | Some("auto") => Ok(None),
        Some(name) => match SOLVERS.into_iter().find(|known| *known == name) {
            Some(known) => Ok(Some(known)),
            None => Err(format!("solver: `{name}` is unknown: use auto, astar, vi, lrtdp or uct")),
        },
    }
}
