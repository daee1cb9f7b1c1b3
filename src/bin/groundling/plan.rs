//! `plan`: a goal and a world a line in, a plan or what a policy is worth out.

use super::arguments::Arguments;
use super::command::{Blank, Command, Done, answer_lines, only_files};
use super::failure::Failure;
use groundling::corpus::json::whole_json;
use groundling::domain::{Action, Chances, Form, Movable, Rules, State};
use groundling::ground::{Constraint, Course, ErrandError, Goal, Task, Undertaking};
use groundling::logic::ty::RUN;
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
              \x20    unreachable, budget, bad_goal or already_broken. When the budget ran out no plan is shorter than\n\
              \x20    `least`, and `bounds` hold the value.\n\
              \x20    A bad line is answered by {\"error\", \"line\"} in its place.",
    run,
};

/// What a solver may spend when a line does not say: seconds where nothing is left to chance, else minutes; and some
/// hundred megabytes.
const SURE_STEPS: u64 = 500_000;
const STEPS: u64 = 100_000_000;
const STATES: usize = 1_800_000;
/// The same for UCT, which always spends it all: seconds.
const TRIALS: u64 = 2_000_000;
/// Constraints of a task of which all selections are tried.
const MOST_CONSTRAINTS: usize = 6;
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
    /// The smallest set of constraints without which there is a way.
    #[serde(skip_serializing_if = "Option::is_none")]
    blocked_by: Option<Vec<String>>,
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

fn run(arguments: Arguments) -> Result<Done, Failure> {
    answer_lines(&only_files(arguments)?, Blank::IsAMistake, |line| {
        let started = Instant::now();
        let mut answer = answer(line)?;
        answer.seconds = started.elapsed().as_secs_f64();
        serde_json::to_string(&answer).map_err(|e| e.to_string())
    })
}

fn answer(line: &str) -> Result<Answer, String> {
    let question: Question<'_> = whole_json(line).map_err(|wrong| wrong.to_string())?;
    let (mut rules, landmarks_stay) = rules(&question)?;
    let solver = solver(&question)?;
    let runs = question.rollouts.unwrap_or(0);
    if runs > MOST_ROLLOUTS {
        return Err(format!("rollouts: {runs} are too many: ask for {MOST_ROLLOUTS} at most"));
    }
    let initial = State::read(question.initial.get()).map_err(|e| format!("initial: {e}"))?;
    let mut terms = Terms::new();
    let without = |reason| Answer {
        solver: solver.unwrap_or(SOLVERS[0]),
        reason: Some(reason),
        ..Answer::default()
    };
    let bad = |message: String| Ok(Answer { message: Some(message), ..without("bad_goal") });
    let term = match read(&mut terms, &question.goal) {
        Ok(term) => term,
        Err(error) => return bad(error.to_string()),
    };
    if terms.ty(term) == RUN {
        let course = match Course::new(&terms, term, &initial) {
            Ok(course) => course,
            Err(error) => return bad(error.to_string()),
        };
        if landmarks_stay {
            rules.movable = course.movable(&initial);
        }
        return in_time(&question, &terms, &course, &initial, rules, without);
    }
    let goal = match Goal::new(&terms, term, &initial) {
        Ok(goal) => goal,
        Err(error) => return bad(error.to_string()),
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
    let steps = most_steps(&question, solver, task.is_deterministic());
    solved(&question, &task, steps, rules.chances == Chances::default())
}

/// What a solver may spend, where a line does not say.
fn most_steps(question: &Question<'_>, solver: Option<&str>, is_deterministic: bool) -> u64 {
    question.steps.unwrap_or(match solver {
        Some("uct") => TRIALS,
        None | Some("astar") if is_deterministic => SURE_STEPS,
        _ => STEPS,
    })
}

/// Plans for a task over time.
fn in_time(
    question: &Question<'_>,
    terms: &Terms,
    course: &Course,
    initial: &State,
    rules: Rules,
    without: impl Fn(&'static str) -> Answer,
) -> Result<Answer, String> {
    let lost = |reason| Ok(Answer { value: Some(0.0), ..without(reason) });
    if course.guards().iter().any(Goal::denies_nothing) {
        return lost("no_referent");
    }
    let is_sure = rules.chances == Chances::default();
    let set_out = |course: &Course| Undertaking::course(course, initial, rules);
    let task = match set_out(course) {
        Ok(task) => task,
        Err(ErrandError::TooMany(_)) => return Ok(without("budget")),
        Err(ErrandError::Task(error)) => return Err(format!("initial: {error}")),
    };
    if task.has_failed(task.initial()) {
        let is_never = course.outline().is_never();
        return lost(if is_never { "unreachable" } else { "already_broken" });
    }
    let steps = most_steps(question, solver(question)?, task.is_deterministic());
    let mut answer = solved(question, &task, steps, is_sure)?;
    if task.is_over() {
        (answer.reason, answer.value) = (Some("budget"), None);
    }
    if answer.reason == Some("unreachable") {
        if course.guards().iter().any(|goal| !goal.failures().is_empty()) {
            return lost("no_referent");
        }
        let constraints = course.constraints(terms);
        let is_way = |some: &[Constraint]| {
            let free = course.without(terms, some, initial);
            let answer = set_out(&free).map(|task| solved(question, &task, steps, is_sure));
            matches!(answer, Ok(Ok(Answer { reason: None, .. })))
        };
        let blocked = smallest(&constraints, is_way);
        answer.blocked_by =
            blocked.map(|some| some.iter().map(|&one| course.says(terms, one)).collect());
    }
    Ok(answer)
}

/// The smallest selection that will do, the first of equals.
fn smallest(
    of: &[Constraint],
    mut will_do: impl FnMut(&[Constraint]) -> bool,
) -> Option<Vec<Constraint>> {
    let of = &of[..of.len().min(MOST_CONSTRAINTS)];
    let select = |set: u32| -> Vec<Constraint> {
        of.iter().enumerate().filter(|(at, _)| set >> at & 1 == 1).map(|(_, one)| *one).collect()
    };
    let mut sets: Vec<u32> = (1..1 << of.len()).collect();
    sets.sort_by_key(|set| set.count_ones());
    sets.into_iter().map(select).find(|some| will_do(some))
}

/// Plans, and follows the plan as often as is wanted.
fn solved<P>(
    question: &Question<'_>,
    problem: &P,
    steps: u64,
    is_sure: bool,
) -> Result<Answer, String>
where
    P: Mdp<Action = Action>,
{
    let solver = solver(question)?;
    let runs = question.rollouts.unwrap_or(0);
    let seed = question.seed.unwrap_or(0);
    let epsilon = question.epsilon.unwrap_or(Settings::default().epsilon);
    if !(epsilon > 0.0 && epsilon < 1.0) {
        return Err(format!("epsilon: {epsilon} does not lie between 0 and 1"));
    }
    let settings = Settings { seed, epsilon, ..Settings::default() }.with_budget(steps, STATES);
    let make = |state| Making::new(solver, StartingAt::new(problem, state), settings);
    let mut first = make(problem.initial());
    let outcome = first.run();
    if outcome == Outcome::Unfit {
        return Err("solver: astar plans only where nothing is left to chance: use another".into());
    }
    let mut answer = found(problem, &first, outcome, is_sure);
    if runs > 0 {
        let settings = RolloutSettings { runs, seed, ..RolloutSettings::default() };
        answer.rollouts = Some(Rollouts::new(problem, settings, first, make).run().into());
    }
    Ok(answer)
}

/// A solver that was asked for by name, or one that chooses.
enum Making<'t, P: Mdp> {
    Auto(Auto<StartingAt<&'t P>>),
    Named(AnySolver<StartingAt<&'t P>>),
}

impl<'t, P: Mdp> Making<'t, P> {
    fn new(name: Option<&str>, problem: StartingAt<&'t P>, settings: Settings) -> Self {
        match name.and_then(|name| AnySolver::named(name, problem, settings)) {
            Some(solver) => Self::Named(solver),
            None => Self::Auto(Auto::new(problem, settings)),
        }
    }

    fn solver(&self) -> &dyn Solver<P::State, P::Action> {
        match self {
            Self::Auto(solver) => solver,
            Self::Named(solver) => solver,
        }
    }
}

impl<P: Mdp> Policy<P::State, P::Action> for Making<'_, P> {
    fn action(&self, state: P::State) -> Option<P::Action> {
        self.solver().action(state)
    }
    fn value(&self, state: P::State) -> Option<f64> {
        self.solver().value(state)
    }
}

impl<P: Mdp> Solver<P::State, P::Action> for Making<'_, P> {
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
fn found<P>(task: &P, solver: &Making<'_, P>, outcome: Outcome, is_sure: bool) -> Answer
where
    P: Mdp<Action = Action>,
{
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
fn followed<P>(task: &P, policy: &Making<'_, P>) -> Option<Vec<Action>>
where
    P: Mdp<Action = Action>,
{
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
