//! What a policy that was found can be asked: what every cell is worth, and what comes of following it many times.

use super::plan::Planned;
use super::protocol::{CellValue, Runs, ValueMap};
use super::solving::{STEPS, solver};
use crate::domain::layout::Place;
use crate::domain::{Action, Direction, Packed, State};
use crate::ground::Undertaking;
use crate::mdp::{
    Mdp, Outcome, Policy, Progress, RolloutReport, RolloutSettings, Rollouts, Settings, Solver,
};
use crate::solve::{AllStates, Planner};
use std::rc::Rc;

/// Most states that are worked out: some twenty megabytes, and a fraction of a second in a page.
const STATES: usize = 100_000;
/// Places of the map in a step of the job.
const CELLS: usize = 100;
/// Actions of runs in a step of the job.
const ACTIONS: usize = 500;

/// A value map at work. A search for a shortest plan knows little but the plan, so all states are worked out once, where
/// they are few enough; else the policy says what it knows.
pub(super) struct Valuing {
    planned: Rc<Planned>,
    around: Packed,
    /// All states on their way, unless they were worked out before.
    all: Option<AllStates>,
    /// The cells of the map so far, and how many places were looked at.
    cells: Vec<CellValue>,
    seen: usize,
}

impl Valuing {
    /// A map of the world as it is in `state`, when so many steps of a task over time are done; nothing if that is a
    /// state of another world.
    pub(super) fn new(planned: Rc<Planned>, state: &State, done: u8) -> Option<Valuing> {
        let around = planned.staged(planned.task.packed(state)?, done);
        let all = planned.all.get().is_none().then(|| {
            let settings = Settings::default().with_budget(u64::MAX, STATES);
            let start = planned.task.initial();
            AllStates::new(planned.task.clone(), start, settings)
        });
        Some(Valuing { planned, around, all, cells: Vec::new(), seen: 0 })
    }

    /// Does a bounded part; the map when it is there.
    pub(super) fn step(&mut self) -> Option<ValueMap> {
        if let Some(mut all) = self.all.take() {
            if all.step(STEPS).is_none() {
                self.all = Some(all);
                return None;
            }
            // Nothing is kept of states that were too many.
            let kept = self.planned.all.set((!all.is_partial()).then_some(all));
            debug_assert!(kept.is_ok(), "the engine does one thing at a time");
        }
        let planned = self.planned.clone();
        let places = planned.task.dynamics().layout().places();
        let next = places.skip(self.seen).take(CELLS);
        self.seen += CELLS;
        let found: Vec<CellValue> = match planned.all.get() {
            Some(Some(all)) => next.filter_map(|place| self.cell(place, all)).collect(),
            _ => next.filter_map(|place| self.cell(place, &planned.solver)).collect(),
        };
        self.cells.extend(found);
        let is_last = self.seen >= planned.task.dynamics().layout().len();
        is_last.then(|| ValueMap { cells: std::mem::take(&mut self.cells) })
    }

    fn cell(&self, place: Place, policy: &impl Policy<Packed, Action>) -> Option<CellValue> {
        let task = &self.planned.task;
        let dynamics = task.dynamics();
        let there = |heading: Direction| self.planned.task.moved(self.around, place, heading);
        let worth = |(i, &heading): (usize, &Direction)| {
            let state = there(heading)?;
            // Facing another way is mostly the same state.
            if Direction::ALL[..i].iter().any(|&before| there(before) == Some(state)) {
                return None;
            }
            let goal = task.is_terminal(state);
            let value = match task.heuristic(state) {
                _ if goal => 1.0,
                None => 0.0,
                Some(_) => policy.value(state)?,
            };
            Some((value, goal, heading, policy.action(state).filter(|_| !goal && value > 0.0)))
        };
        let all = Direction::ALL.iter().enumerate().filter_map(worth);
        let (value, goal, facing, action) =
            all.reduce(|best, one| if one.0 > best.0 { one } else { best })?;
        let (x, y) = dynamics.layout().cell(place);
        Some(CellValue { x, y, facing, value, action: action.map(|a| a.name().to_owned()), goal })
    }
}

/// Runs at work.
pub(super) struct Rolling {
    rollouts: Rollouts<Rc<Undertaking>, Follower, Make>,
    said: u32,
}

/// Makes a policy for a state that none is known for.
type Make = Box<dyn FnMut(Packed) -> Follower>;

/// The policy that was found, or one that was made on the way.
enum Follower {
    Found(Rc<Planned>),
    Made(Box<Planner>),
}

impl Follower {
    fn policy(&self) -> &Planner {
        match self {
            Follower::Found(planned) => &planned.solver,
            Follower::Made(solver) => solver,
        }
    }
}

impl Policy<Packed, Action> for Follower {
    fn action(&self, state: Packed) -> Option<Action> {
        self.policy().action(state)
    }

    fn value(&self, state: Packed) -> Option<f64> {
        self.policy().value(state)
    }
}

impl Solver<Packed, Action> for Follower {
    fn name(&self) -> &'static str {
        self.policy().name()
    }

    fn step(&mut self, n: usize) -> Option<Outcome> {
        match self {
            // It was solved before.
            Follower::Found(_) => Some(Outcome::Solved),
            Follower::Made(solver) => solver.step(n),
        }
    }

    fn progress(&self) -> Progress {
        self.policy().progress()
    }
}

impl Rolling {
    pub(super) fn new(planned: Rc<Planned>, runs: u32, seed: u32) -> Rolling {
        let settings =
            RolloutSettings { runs, seed: u64::from(seed), ..RolloutSettings::default() };
        let task = planned.task.clone();
        let make: Make = Box::new(move |state| Follower::Made(Box::new(solver(&task, state))));
        let task = planned.task.clone();
        Rolling { rollouts: Rollouts::new(task, settings, Follower::Found(planned), make), said: 0 }
    }

    /// Does a bounded part: what came of the runs, when one more has ended, and whether it was the last.
    pub(super) fn step(&mut self) -> Option<(Runs, bool)> {
        let last = self.rollouts.step(ACTIONS).is_some();
        let report = self.rollouts.report();
        let news = last || report.runs > self.said;
        self.said = report.runs;
        news.then(|| (runs(report), last))
    }
}

fn runs(report: RolloutReport) -> Runs {
    Runs {
        runs: report.runs,
        successes: report.successes,
        interval: [report.interval.0, report.interval.1],
        mean_steps: report.mean_steps,
        mean_return: [report.mean_return, report.return_margin],
        replans: report.replans,
    }
}
