//! A goal on its way to a plan: a solver is chosen and pumped, its policy is followed once, and where the policy does
//! not know what has happened the robot thinks again. The policy that comes of it can be asked further (`watch`).

use super::course::Timed;
use super::protocol::{Instead, PlanProgress, PlanText, WorldRules};
use super::solving::{STEPS, solver};
use crate::domain::{Action, Chances, Form, Movable, NotAProbability, Packed, Rules, State};
use crate::ground::{ErrandError, Goal, GoalError, Task, TaskError, Undertaking};
use crate::logic::{ReadError, Terms, read, ty};
use crate::mdp::{Mdp, Outcome, Policy, Solver, sample};
use crate::solve::{AllStates, Planner};
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use std::cell::OnceCell;
use std::rc::Rc;

/// Actions in a step of the job.
const ACTIONS: usize = 200;
/// Steps of the job from one report to the next.
const REPORT: u32 = 16;
/// So much is spent on a plan that is to be walked soon, if there is one by then: a tenth of that.
const SOON: u64 = 25_000;
/// A run that takes more actions is given up.
const MOST_ACTIONS: usize = 2_000;
/// A robot that has thought again so often is lost.
const MOST_REPLANS: u32 = 20;

/// Why there is nothing to plan.
#[derive(Debug, thiserror::Error)]
pub(super) enum PlanError {
    /// The form cannot be read.
    #[error(transparent)]
    Form(#[from] ReadError),
    /// It is no goal and no task.
    #[error(transparent)]
    Goal(#[from] GoalError),
    /// The state is illegal or too large.
    #[error(transparent)]
    Task(#[from] TaskError),
    /// The same of a task over time, or it has too many stages.
    #[error(transparent)]
    Errand(#[from] ErrandError),
    /// The states are not of one world.
    #[error("The states before are those of another world: plan again.")]
    OtherWorld,
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
    task: Rc<Undertaking>,
    /// The task, if it is one over time.
    timed: Option<Timed>,
    /// What was since the task was said.
    before: Vec<State>,
    /// How many of its steps were done in each state of the run.
    done: Vec<u8>,
    /// What else could be done.
    instead: Option<Option<Box<Instead>>>,
    /// The solver of the beginning; its policy is what is kept.
    first: Planner,
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
    /// The stage of a task over time at each of them.
    stages: Vec<u8>,
    again: Option<Again>,
    replans: u32,
    rng: Pcg64Mcg,
    buffer: Vec<(Packed, f64)>,
}

/// A solver that thinks again.
struct Again {
    solver: Planner,
    from: Packed,
    has_ended: bool,
}

/// A policy that was found for a task.
pub(super) struct Planned {
    pub(super) task: Rc<Undertaking>,
    /// The stages of a task over time that the run came to, by how many steps were done.
    stages: Vec<(u8, u8)>,
    pub(super) solver: Planner,
    /// The values of all states, once somebody asked for them and they were not too many.
    pub(super) all: OnceCell<Option<AllStates>>,
}

impl Planning {
    /// Begins to plan for a goal of states or a task over time, from the last of the states that were since it was said,
    /// the first; in haste, if the first plan will do where nothing is left to chance.
    pub(super) fn begin(
        form: &str,
        run: &[State],
        rules: &WorldRules,
        is_hasty: bool,
    ) -> Result<Begun, PlanError> {
        let (Some(said), Some(state)) = (run.first(), run.last()) else {
            return Err(PlanError::OtherWorld);
        };
        let mut terms = Terms::new();
        let term = read(&mut terms, form)?;
        let done = |reason, instead| Ok(Begun::Done(Box::new(no_plan(state, reason, instead))));
        let begun = |task: Undertaking, timed| {
            let at = task.along(run).ok_or(PlanError::OtherWorld)?;
            let planning = Planning::new(Rc::new(task), timed, (at, run), (rules.luck, is_hasty));
            Ok(Begun::Work(Box::new(planning)))
        };
        if terms.ty(term) != ty::RUN {
            let goal = Goal::new(&terms, term, said)?;
            let task = Task::new(&goal, said, world(goal.movable(said), rules)?)?;
            if goal.denies_nothing() || task.is_impossible() {
                let is_lost = !goal.failures().is_empty();
                return done(if is_lost { "no_referent" } else { "unreachable" }, None);
            }
            return begun(Undertaking::Goal(Box::new(task)), None);
        }
        let mut timed = Timed::new(terms, term, said)?;
        if timed.course.guards().iter().any(Goal::denies_nothing) {
            return done("no_referent", None);
        }
        let world = world(timed.course.movable(said), rules)?;
        let task = Undertaking::course(&timed.course, said, world)?;
        let at = task.along(run).ok_or(PlanError::OtherWorld)?;
        let steps = timed.course.done(run);
        timed.come_to(&steps);
        if task.has_failed(at) {
            if timed.course.outline().is_never() {
                return done("unreachable", None);
            }
            let reason = if run.len() > 1 { "broken" } else { "already_broken" };
            let plan = no_plan(state, reason, timed.once_out(state));
            let done = steps.last().copied().into_iter().collect();
            return Ok(Begun::Done(Box::new(PlanText { done, ..plan })));
        }
        begun(task, Some(timed))
    }

    fn new(
        task: Rc<Undertaking>,
        timed: Option<Timed>,
        (at, run): (Packed, &[State]),
        (luck, is_hasty): (u32, bool),
    ) -> Self {
        let first = solver(&task, task.known(at));
        let (before, state) = match run.split_last() {
            Some((last, before)) => (before.to_vec(), vec![last.clone()]),
            None => (Vec::new(), Vec::new()),
        };
        let run = Run {
            at,
            actions: Vec::new(),
            states: state,
            stages: vec![at.mark()],
            again: None,
            replans: 0,
            rng: Pcg64Mcg::seed_from_u64(u64::from(luck)),
            buffer: Vec::new(),
        };
        let (done, outcome, instead) = (Vec::new(), None, None);
        Planning { task, timed, before, done, instead, first, outcome, is_hasty, run, steps: 0 }
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
            if self.outcome == Some(Outcome::Unreachable) && self.task.is_over() {
                self.outcome = Some(Outcome::Budget);
            }
            return None;
        }
        if self.outcome == Some(Outcome::Unreachable) {
            let rules = self.task.dynamics().rules();
            let Some(timed) = self.timed.as_mut().filter(|timed| !timed.is_lost()) else {
                return Some(self.text());
            };
            let [state, ..] = &self.run.states[..] else { return Some(self.text()) };
            self.instead = timed.relax(state, rules);
            return self.instead.is_some().then(|| self.text());
        }
        self.walk().then(|| self.text())
    }

    /// How far the planner is, every now and then.
    pub(super) fn news(&self) -> Option<PlanProgress> {
        let solver = || self.run.again.as_ref().map_or(&self.first, |again| &again.solver);
        self.steps.is_multiple_of(REPORT).then(|| progress(solver()))
    }

    /// What was found, to be asked further.
    pub(super) fn into_planned(mut self) -> Rc<Planned> {
        let stages = std::mem::take(&mut self.run.stages);
        let stages = self.done.drain(..).zip(stages).collect();
        Rc::new(Planned { task: self.task, stages, solver: self.first, all: OnceCell::new() })
    }

    /// Follows the policy a little further; whether the run is over.
    fn walk(&mut self) -> bool {
        let Planning { task, first, run, .. } = self;
        for _ in 0..ACTIONS {
            if let Some(again) = run.again.as_mut().filter(|again| !again.has_ended) {
                again.has_ended = again.solver.step(STEPS).is_some();
                return false;
            }
            if task.is_terminal(run.at)
                || task.has_failed(run.at)
                || run.actions.len() >= MOST_ACTIONS
            {
                return true;
            }
            let known = task.known(run.at);
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
            run.states.push(task.state(run.at));
            run.stages.push(run.at.mark());
        }
        false
    }

    fn text(&mut self) -> PlanText {
        let reason = match self.outcome {
            Some(Outcome::Solved) => None,
            Some(Outcome::Unreachable) => Some("unreachable"),
            _ => Some("budget"),
        };
        let states = std::mem::take(&mut self.run.states);
        if let Some(timed) = &self.timed {
            let before = self.before.len();
            let whole: Vec<State> = self.before.drain(..).chain(states.iter().cloned()).collect();
            self.done = timed.course.done(&whole).split_off(before);
        }
        let mut instead = self.instead.take().flatten();
        let is_broken = self.task.has_failed(self.run.at);
        if is_broken && let (Some(timed), Some(last)) = (&mut self.timed, states.last()) {
            timed.come_to(&self.done);
            instead = timed.once_out(last);
        }
        let reason = if is_broken { Some("broken") } else { reason };
        PlanText {
            actions: self.run.actions.iter().map(|action| action.name().to_owned()).collect(),
            states,
            reason: reason.map(str::to_owned),
            reached: self.task.is_terminal(self.run.at),
            sure: self.task.is_deterministic(),
            replans: self.run.replans,
            work: Some(progress(&self.first)),
            done: self.done.clone(),
            instead,
        }
    }
}

impl Planned {
    /// A state of the world when so many steps of a task over time are done.
    pub(super) fn staged(&self, state: Packed, done: u8) -> Packed {
        let stage = self.stages.iter().find(|&&(steps, _)| steps == done);
        stage.map_or(state, |&(_, stage)| state.marked(stage))
    }
}

/// No plan: the world stays as it is.
pub(super) fn no_plan(start: &State, reason: &str, instead: Option<Box<Instead>>) -> PlanText {
    PlanText {
        actions: Vec::new(),
        states: vec![start.clone()],
        reason: Some(reason.to_owned()),
        reached: false,
        sure: true,
        replans: 0,
        work: None,
        done: Vec::new(),
        instead,
    }
}

fn progress(solver: &Planner) -> PlanProgress {
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

/// The rules of the world, in which `movable` is what a command says to move.
fn world(movable: Movable, rules: &WorldRules) -> Result<Rules, NotAProbability> {
    Ok(Rules {
        pull: rules.pull,
        form: if rules.robot { Form::Robot } else { Form::Compass },
        movable: if rules.landmarks_stay { movable } else { Movable::ALL },
        chances: Chances::new(rules.slip, rules.lock, rules.loss)?,
    })
}
