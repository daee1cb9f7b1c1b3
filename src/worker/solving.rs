//! How the page solves what there is to plan: the solver that suits it, and what that may spend.

use crate::domain::Packed;
use crate::ground::Undertaking;
use crate::mdp::Settings;
use crate::solve::Planner;
use std::rc::Rc;

/// Steps of the solver in a step of the job.
pub(super) const STEPS: usize = 500;
/// What the page's planner may spend: some tens of seconds, and a few hundred megabytes at most.
const BUDGET: (u64, usize) = (20_000_000, 1_500_000);
/// The same where nothing is left to chance, and a plan is there at once: about a second.
const SURE: u64 = 250_000;

/// A solver for the task begun in a state.
pub(super) fn solver(task: &Rc<Undertaking>, start: Packed) -> Planner {
    let steps = if task.is_deterministic() { SURE } else { BUDGET.0 };
    let settings = Settings::default().with_budget(steps, BUDGET.1);
    Planner::new(task.clone(), start, settings)
}
