//! A goal on its way to a plan: a solver is chosen and pumped, its policy is followed once, and where the policy does
//! not know what has happened the robot thinks again. The policy that comes of it can be asked further (`watch`).

use super::protocol::{PlanProgress, PlanText, WorldRules};
use crate::domain::{Action, Chances, Form, Movable, NotAProbability, Packed, Rules, State};
use crate::ground::{Goal, Task, TaskError};
use crate::mdp::{Mdp, Outcome, Policy, Settings, Solver, StartingAt, sample};
use crate::plan::{Auto, ValueIteration};
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use std::cell::OnceCell;
use std::rc::Rc;

/// Steps of the solver in a step of the job.
const STEPS: usize = 500;
/// Actions in a step of the job.
const ACTIONS: usize = 200;
/// Steps of the job from one report to the next.
const REPORT: u32 = 16;
/// What the page's planner may spend: some tens of seconds, and a few hundred megabytes at most.
const BUDGET: (u64, usize) = (20_000_000, 1_500_000);
/// The same where nothing is left to chance, and a plan is there at once: about a second.
const SURE: u64 = 250_000;
/// So much is spent on a plan that is to be walked soon, if there is one by then: a tenth of that.
const SOON: u64 = 25_000;
/// A run that takes more actions is given up.
const MOST_ACTIONS: usize = 2_000;
/// A robot that has thought again so often is lost.
const MOST_REPLANS: u32 = 20;

/// A task, shared by its solvers.
pub(super) type Problem = StartingAt<Rc<Task>>;

/// Why there is nothing to plan.
#[derive(Debug, thiserror::Error)]
pub(super) enum PlanError {
    /// The state is illegal or too large.
    #[error(transparent)]
    Task(#[from] TaskError),
    /// The rules are none.
    #[error("the {} lies between 0 and 1, as a probability does", .0.name)]
    Rules(#[from] NotAProbability),
}

/// What there is to plan, or the plan where nothing needs to be searched.
pub(super) enum Begun {
    /// There is work to do.
    Work(Box<Planning>),
    /// There is not.
    Done(Box<PlanText>),
}

/// A plan at work.
pub(super) struct Planning {
    task: Rc<Task>,
    /// The solver of the beginning; its policy is what is kept.
    first: Auto<Problem>,
    outcome: Option<Outcome>,
    is_hasty: bool,
    run: Run,
    steps: u32,
}

/// The run that is shown, as far as it is.
struct Run {
    at: Packed,
    actions: Vec<Action>,
    states: Vec<State>,
    again: Option<Again>,
    replans: u32,
    rng: Pcg64Mcg,
    buffer: Vec<(Packed, f64)>,
}

/// A solver that thinks again.
struct Again {
    solver: Auto<Problem>,
    from: Packed,
    has_ended: bool,
}

/// A policy that was found for a task.
pub(super) struct Planned {
    pub(super) task: Rc<Task>,
    pub(super) solver: Auto<Problem>,
    /// The values of all states, once somebody asked for them and they were not too many.
    pub(super) all: OnceCell<Option<ValueIteration<Problem>>>,
}

impl Planning {
    /// Begins to plan for a goal that was bound to `state`; in haste, if the first plan will do where nothing is left to
    /// chance.
    pub(super) fn begin(
        goal: &Goal,
        state: &State,
        rules: &WorldRules,
        is_hasty: bool,
    ) -> Result<Begun, PlanError> {
        let task = Rc::new(Task::new(goal, state, world(goal, state, rules)?)?);
        if goal.denies_nothing() || task.is_impossible() {
            let is_lost = !goal.failures().is_empty();
            let reason = if is_lost { "no_referent" } else { "unreachable" };
            return Ok(Begun::Done(Box::new(no_plan(state, reason))));
        }
        let at = task.world().initial();
        Ok(Begun::Work(Box::new(Planning::new(task, (at, state), rules.luck, is_hasty))))
    }

    /// Begins to plan for a task from another state; nothing if that is a state of another world.
    pub(super) fn go_on(task: Rc<Task>, state: &State) -> Option<Planning> {
        let at = packed(&task, state)?;
        Some(Planning::new(task, (at, state), 0, false))
    }

    fn new(task: Rc<Task>, (at, state): (Packed, &State), luck: u32, is_hasty: bool) -> Self {
        let first = solver(&task, task.dynamics().quotient(at));
        let run = Run {
            at,
            actions: Vec::new(),
            states: vec![state.clone()],
            again: None,
            replans: 0,
            rng: Pcg64Mcg::seed_from_u64(u64::from(luck)),
            buffer: Vec::new(),
        };
        Planning { task, first, outcome: None, is_hasty, run, steps: 0 }
    }

    /// Does a bounded part; the plan when it is there.
    pub(super) fn step(&mut self) -> Option<PlanText> {
        self.steps = self.steps.wrapping_add(1);
        if self.outcome.is_none() {
            self.outcome = self.first.step(STEPS);
            let progress = || self.first.progress();
            if self.is_hasty && self.task.is_deterministic() && progress().steps >= SOON {
                // A plan that is known is worth something.
                self.outcome = self.outcome.or((progress().lower > 0.0).then_some(Outcome::Budget));
            }
            return None;
        }
        if self.outcome == Some(Outcome::Unreachable) || self.walk() {
            return Some(self.text());
        }
        None
    }

    /// How far the planner is, every now and then.
    pub(super) fn news(&self) -> Option<PlanProgress> {
        let solver = || self.run.again.as_ref().map_or(&self.first, |again| &again.solver);
        self.steps.is_multiple_of(REPORT).then(|| progress(solver()))
    }

    /// What was found, to be asked further.
    pub(super) fn into_planned(self) -> Rc<Planned> {
        Rc::new(Planned { task: self.task, solver: self.first, all: OnceCell::new() })
    }

    /// Follows the policy a little further; whether the run is over.
    fn walk(&mut self) -> bool {
        let Planning { task, first, run, .. } = self;
        for _ in 0..ACTIONS {
            if let Some(again) = run.again.as_mut().filter(|again| !again.has_ended) {
                again.has_ended = again.solver.step(STEPS).is_some();
                return false;
            }
            if task.is_terminal(run.at) || run.actions.len() >= MOST_ACTIONS {
                return true;
            }
            let known = task.dynamics().quotient(run.at);
            let again = run.again.as_ref();
            let policies = || again.map(|again| &again.solver).into_iter().chain([&*first]);
            let Some(action) = policies().find_map(|policy| policy.action(known)) else {
                let is_lost = policies().any(|policy| policy.value(known) == Some(0.0));
                let has_thought = again.is_some_and(|again| again.from == known);
                if is_lost || has_thought || run.replans == MOST_REPLANS {
                    return true;
                }
                run.replans += 1;
                let solver = solver(task, known);
                run.again = Some(Again { solver, from: known, has_ended: false });
                return false;
            };
            run.at = sample(&task.world(), run.at, action, &mut run.buffer, &mut run.rng);
            run.actions.push(action);
            run.states.push(task.dynamics().unpack(run.at));
        }
        false
    }

    fn text(&mut self) -> PlanText {
        let reason = match self.outcome {
            Some(Outcome::Solved) => None,
            Some(Outcome::Unreachable) => Some("unreachable"),
            _ => Some("budget"),
        };
        PlanText {
            actions: self.run.actions.iter().map(|action| action.name().to_owned()).collect(),
            states: std::mem::take(&mut self.run.states),
            reason: reason.map(str::to_owned),
            reached: self.task.is_terminal(self.run.at),
            sure: self.task.is_deterministic(),
            replans: self.run.replans,
            work: Some(progress(&self.first)),
        }
    }
}

/// A state of the task's world; nothing if it is one of another.
pub(super) fn packed(task: &Task, state: &State) -> Option<Packed> {
    let dynamics = task.dynamics();
    dynamics.pack(state).ok().filter(|&packed| dynamics.unpack(packed) == *state)
}

/// A solver for the task begun in a state.
pub(super) fn solver(task: &Rc<Task>, start: Packed) -> Auto<Problem> {
    let steps = if task.is_deterministic() { SURE } else { BUDGET.0 };
    let settings = Settings::default().with_budget(steps, BUDGET.1);
    Auto::new(StartingAt::new(task.clone(), start), settings)
}

/// No plan: the world stays as it is.
pub(super) fn no_plan(start: &State, reason: &str) -> PlanText {
    PlanText {
        actions: Vec::new(),
        states: vec![start.clone()],
        reason: Some(reason.to_owned()),
        reached: false,
        sure: true,
        replans: 0,
        work: None,
    }
}

fn progress(solver: &Auto<Problem>) -> PlanProgress {
    let progress = solver.progress();
    PlanProgress {
        solver: solver.name().to_owned(),
        why: solver.why(),
        states: progress.states,
        steps: progress.steps,
        residual: if progress.residual.is_finite() { progress.residual } else { 0.0 },
        bounds: [progress.lower, progress.upper],
        least: progress.least,
    }
}

fn world(goal: &Goal, state: &State, rules: &WorldRules) -> Result<Rules, NotAProbability> {
    Ok(Rules {
        pull: rules.pull,
        form: if rules.robot { Form::Robot } else { Form::Compass },
        movable: if rules.landmarks_stay { goal.movable(state) } else { Movable::ALL },
        chances: Chances::new(rules.slip, rules.lock, rules.loss)?,
    })
}
