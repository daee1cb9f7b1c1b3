//! A command on its way from words to a plan: parse, ground, plan, each in steps.

use super::choose::choices;
use super::plan::{Begun, PlanError, Planned, Planning, no_plan};
use super::protocol::{Answer, PlanProgress, Reading, WorldRules};
use super::read::{parsed, reading, shown, taken, words};
use crate::ccg::{Model, Parse, probability};
use crate::domain::State;
use crate::ground::forbids_idly;
use crate::logic::print;
use std::rc::Rc;

/// A command being answered.
pub(super) struct Asking {
    command: String,
    state: State,
    rules: WorldRules,
    stage: Stage,
}

enum Stage {
    Words,
    Plan(Box<Answer>, Box<Planning>),
    Over,
}

/// What a step of answering comes to.
pub(super) enum Asked {
    /// It is still parsing or planning; how far the planner is.
    Working(Option<PlanProgress>),
    /// The answer, and the policy behind its plan.
    Answered(Box<Answer>, Option<Rc<Planned>>),
    /// This world cannot be planned in.
    Failed(PlanError),
}

impl Asking {
    pub(super) fn new(command: String, state: State, rules: WorldRules) -> Self {
        Asking { command, state, rules, stage: Stage::Words }
    }

    /// Goes on.
    pub(super) fn step(&mut self, model: &mut Model) -> Asked {
        match std::mem::replace(&mut self.stage, Stage::Over) {
            Stage::Words => self.read(model),
            Stage::Plan(mut answer, mut planning) => match planning.step() {
                Some(plan) => {
                    answer.plan = Some(plan);
                    Asked::Answered(answer, Some(planning.into_planned()))
                }
                None => {
                    let news = planning.news();
                    self.stage = Stage::Plan(answer, planning);
                    Asked::Working(news)
                }
            },
            Stage::Over => Asked::Working(None),
        }
    }

    /// Parses, and begins to plan for the best reading, unless there is something to ask first.
    fn read(&mut self, model: &mut Model) -> Asked {
        let parse = parsed(model, &self.command);
        let mut answer = Box::new(answer(model, &parse, &self.command, &self.state));
        let best = parse.answer().filter(|_| answer.asks.is_empty());
        let Some(best) = best else { return Asked::Answered(answer, None) };
        let form = print(&model.grammar.terms, best.form);
        match Planning::begin(&form, std::slice::from_ref(&self.state), &self.rules, true) {
            Ok(Begun::Work(planning)) => {
                self.stage = Stage::Plan(answer, planning);
                Asked::Working(None)
            }
            Ok(Begun::Done(plan)) => {
                answer.plan = Some(*plan);
                Asked::Answered(answer, None)
            }
            Err(PlanError::Form(_) | PlanError::Goal(_)) => {
                answer.plan = Some(no_plan(&self.state, "bad_goal", None));
                Asked::Answered(answer, None)
            }
            Err(error) => Asked::Failed(error),
        }
    }
}

/// Everything but the plan.
pub(super) fn answer(model: &mut Model, parse: &Parse, command: &str, state: &State) -> Answer {
    let doubt = probability(model, parse);
    let readings: Vec<Reading> =
        shown(parse).map(|one| reading(model, parse, one, state)).collect();
    let (words, taken) = (words(model, parse, Some(state)), taken(parse));
    let best = parse.answer().map(|best| best.form);
    let is_idle = best.is_some_and(|best| forbids_idly(&model.grammar.terms, best));
    Answer {
        command: command.to_owned(),
        asks: choices(parse, &readings, &words, &taken, doubt, is_idle),
        words,
        taken,
        readings,
        probability: doubt.map(|(probability, _)| probability),
        reason: parse.reason.map(|reason| reason.name().to_owned()),
        plan: None,
    }
}
