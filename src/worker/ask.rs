//! A command on its way from words to a plan: parse, ground, search, each in steps.

use super::protocol::{Answer, PlanText, Reading};
use crate::ccg::{self, ChartConfig, Explanation, Model, Parse, parse};
use crate::domain::{Rules, State};
use crate::ground::{Goal, Task, TaskError, explain};
use crate::logic::{print, print_human};
use crate::mdp::{Outcome, Settings, Solver};
use crate::plan::AStar;

/// Readings that an answer shows, unless more are tied for best.
const MAX_READINGS: usize = 10;
/// States that a step of the search expands.
const EXPANSIONS_A_STEP: usize = 2_000;
/// What the page's planner may spend: a few hundred megabytes at most.
const BUDGET: (u64, usize) = (2_000_000, 2_000_000);

/// A command being answered.
pub(super) struct Asking {
    command: String,
    state: State,
    pull: bool,
    stage: Stage,
}

enum Stage {
    Words,
    Search(Box<(Answer, AStar<Task>)>),
}

impl Asking {
    pub(super) fn new(command: String, state: State, pull: bool) -> Self {
        Asking { command, state, pull, stage: Stage::Words }
    }

    /// Goes on; the answer when it is there, or why this world cannot be planned in.
    pub(super) fn step(&mut self, model: &mut Model) -> Option<Result<Answer, TaskError>> {
        match &mut self.stage {
            Stage::Words => {
                let parse = parse(model, &self.command, ChartConfig::of(model));
                let mut answer = self.answer(model, &parse);
                let Some(best) = parse.answer() else { return Some(Ok(answer)) };
                let goal = match Goal::new(&model.grammar.terms, best.form, &self.state) {
                    Ok(goal) => goal,
                    Err(_) => {
                        answer.plan = Some(no_plan(&self.state, "bad_goal", 0));
                        return Some(Ok(answer));
                    }
                };
                let task = match Task::new(
                    &goal,
                    &self.state,
                    Rules { pull: self.pull, ..Rules::default() },
                ) {
                    Ok(task) => task,
                    Err(error) => return Some(Err(error)),
                };
                if task.is_impossible() {
                    let is_lost = !goal.failures().is_empty();
                    let reason = if is_lost { "no_referent" } else { "unreachable" };
                    answer.plan = Some(no_plan(&self.state, reason, 0));
                    return Some(Ok(answer));
                }
                let settings = Settings::default().with_budget(BUDGET.0, BUDGET.1);
                self.stage = Stage::Search(Box::new((answer, AStar::new(task, settings))));
                None
            }
            Stage::Search(work) => {
                let (answer, search) = &mut **work;
                let outcome = search.step(EXPANSIONS_A_STEP)?;
                answer.plan = Some(plan(&self.state, search, outcome));
                Some(Ok(answer.clone()))
            }
        }
    }

    /// Everything but the plan.
    fn answer(&self, model: &Model, parse: &Parse) -> Answer {
        let unknown = parse.words.iter().filter(|word| !model.lexicon.knows(word));
        let readings = shown(parse).map(|reading| {
            let terms = &model.grammar.terms;
            let failures = match explain(terms, reading.form, &self.state) {
                Ok(found) => found.into_iter().map(|failure| failure.sentence).collect(),
                Err(error) => vec![error.to_string()],
            };
            Reading {
                form: print(terms, reading.form),
                human: print_human(terms, reading.form),
                score: Explanation::of(model, parse, reading).score,
                derivation: parse.derivation(reading).print(model, &parse.words),
                failures,
            }
        });
        Answer {
            command: self.command.clone(),
            words: parse.words.clone(),
            readings: readings.collect(),
            skipped: parse.skipped.clone(),
            unknown: unknown.cloned().collect(),
            reason: parse.reason.map(|reason| reason.name().to_owned()),
            plan: None,
        }
    }
}

/// The readings that an answer shows.
fn shown(parse: &Parse) -> impl Iterator<Item = ccg::Reading> {
    parse.readings.iter().take(MAX_READINGS.max(parse.tied())).copied()
}

/// What the scores of the readings that an answer shows are made of.
pub(super) fn explanations(model: &mut Model, command: &str) -> Vec<Explanation> {
    let parse = parse(model, command, ChartConfig::of(model));
    shown(&parse).map(|reading| Explanation::of(model, &parse, reading)).collect()
}

fn plan(start: &State, search: &AStar<Task>, outcome: Outcome) -> PlanText {
    let expanded = usize::try_from(search.expanded()).unwrap_or(usize::MAX);
    match (outcome, search.plan()) {
        (Outcome::Solved, Some(found)) => PlanText {
            actions: found.actions.iter().map(|action| action.name().to_owned()).collect(),
            states: search.problem().replay(&found.actions),
            expanded,
            reason: None,
        },
        (Outcome::Unreachable, _) => no_plan(start, "unreachable", expanded),
        _ => no_plan(start, "budget", expanded),
    }
}

/// No plan: the world stays as it is.
fn no_plan(start: &State, reason: &str, expanded: usize) -> PlanText {
    PlanText {
        actions: Vec::new(),
        states: vec![start.clone()],
        expanded,
        reason: Some(reason.to_owned()),
    }
}
