//! Which solver for which problem, by chance and by size: A* while every action met has one outcome; else value
//! iteration when all states can be numbered, else LRTDP; when that shows no way to the goal, value iteration of as many
//! states as fit, which may prove that there is none; UCT when the budget ran out.
//! A plan that A* finds before it meets chance is optimal all the same: every state that it left unexplored is bounded.

use super::{AnyTime, Lrtdp, Uct, ValueIteration};
use crate::mdp::{Mdp, Outcome, Policy, Progress, Settings, Solver};
use serde::{Deserialize, Serialize};
use std::fmt;

/// Most states that are numbered at once: a few milliseconds natively, for a plan should seem to be there at once.
const ENUMERABLE: usize = 10_000;
/// Most states that are numbered to prove that there is no way to the goal: some hundred megabytes.
const PROVABLE: usize = 1_000_000;
/// The share of the steps that is kept for trying things out when nothing could be proved.
const LAST_RESORT: u64 = 8;

/// Names of solvers, as on the command line.
pub const SOLVERS: [&str; 4] = ["astar", "vi", "lrtdp", "uct"];

/// One of the solvers.
#[expect(missing_docs, reason = "the names say it")]
pub enum AnySolver<P: Mdp> {
    AStar(Box<AnyTime<P>>),
    ValueIteration(Box<ValueIteration<P>>),
    Lrtdp(Box<Lrtdp<P>>),
    Uct(Box<Uct<P>>),
}

impl<P: Mdp + Clone> AnySolver<P> {
    /// The solver of this name (see [`SOLVERS`]); `None` when there is none.
    pub fn named(name: &str, problem: P, settings: Settings) -> Option<Self> {
        Some(match name {
            "astar" => Self::AStar(Box::new(AnyTime::new(problem, settings))),
            "vi" => Self::ValueIteration(Box::new(ValueIteration::new(problem, settings))),
            "lrtdp" => Self::Lrtdp(Box::new(Lrtdp::new(problem, settings))),
            "uct" => Self::Uct(Box::new(Uct::new(problem, settings))),
            _ => return None,
        })
    }

    fn solver(&self) -> &dyn Solver<P::State, P::Action> {
        match self {
            Self::AStar(solver) => &**solver,
            Self::ValueIteration(solver) => &**solver,
            Self::Lrtdp(solver) => &**solver,
            Self::Uct(solver) => &**solver,
        }
    }

    fn solver_mut(&mut self) -> &mut dyn Solver<P::State, P::Action> {
        match self {
            Self::AStar(solver) => &mut **solver,
            Self::ValueIteration(solver) => &mut **solver,
            Self::Lrtdp(solver) => &mut **solver,
            Self::Uct(solver) => &mut **solver,
        }
    }
}

impl<P: Mdp + Clone> Policy<P::State, P::Action> for AnySolver<P> {
    fn action(&self, state: P::State) -> Option<P::Action> {
        self.solver().action(state)
    }
    fn value(&self, state: P::State) -> Option<f64> {
        self.solver().value(state)
    }
}

impl<P: Mdp + Clone> Solver<P::State, P::Action> for AnySolver<P> {
    fn name(&self) -> &'static str {
        self.solver().name()
    }
    fn step(&mut self, n: usize) -> Option<Outcome> {
        self.solver_mut().step(n)
    }
    fn progress(&self) -> Progress {
        self.solver().progress()
    }
}

/// Why a solver was chosen; its `Display` says so to a person.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Why {
    /// Every action met so far has one outcome.
    Sure,
    /// Chance plays a part, and all states can be numbered.
    Small,
    /// Chance plays a part, and there are more states than this.
    Large(usize),
    /// Half of the budget showed no way to the goal: it may be that there is none.
    Undecided,
    /// What could be proved within the budget is no way to the goal.
    Spent,
}

impl fmt::Display for Why {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sure => f.write_str("nothing is left to chance, so the shortest plan is looked for"),
            Self::Small => f.write_str(
                "things may go wrong, and few enough situations can come about to work all of them out",
            ),
            Self::Large(most) => write!(
                f,
                "things may go wrong, and more than {most} situations can come about, so only those are worked out that a good policy may meet"
            ),
            Self::Undecided => f.write_str(
                "half of the budget showed no way to the goal, so all situations are worked out to see whether there is one",
            ),
            Self::Spent => f.write_str(
                "the budget ran out before a way was proved, so the rest of it went into trying things out",
            ),
        }
    }
}

/// A solver that chooses.
pub struct Auto<P: Mdp> {
    problem: P,
    settings: Settings,
    why: Why,
    chosen: AnySolver<P>,
    /// Steps of the solvers before.
    spent: u64,
    /// What they proved of the value of the initial state, and of the length of plans from there.
    proved: (f64, f64),
    least: u32,
    outcome: Option<Outcome>,
}

impl<P: Mdp + Clone> Auto<P> {
    /// A solver that has chosen nothing but to see whether there is chance. The problem is cloned: lend or share it.
    #[must_use]
    pub fn new(problem: P, settings: Settings) -> Self {
        let search = AnyTime::new(problem.clone(), reserved(settings, LAST_RESORT));
        let chosen = AnySolver::AStar(Box::new(search));
        Self {
            problem,
            settings,
            why: Why::Sure,
            chosen,
            spent: 0,
            proved: (0.0, 1.0),
            least: 0,
            outcome: None,
        }
    }

    /// Why the present solver was chosen.
    #[must_use]
    pub const fn why(&self) -> Why {
        self.why
    }

    /// The present solver.
    #[must_use]
    pub const fn chosen(&self) -> &AnySolver<P> {
        &self.chosen
    }

    /// The settings with the steps that are left.
    fn left(&self) -> Settings {
        let budget = self.settings.budget;
        self.settings.with_budget(budget.steps.saturating_sub(self.spent), budget.states)
    }

    fn change(&mut self, why: Why) {
        let progress = self.progress();
        self.spent = progress.steps;
        (self.proved, self.least) = ((progress.lower, progress.upper), progress.least);
        let left = self.left();
        let problem = self.problem.clone();
        self.why = why;
        self.chosen = match why {
            Why::Sure => return,
            Why::Small => {
                let states = left.budget.states.min(ENUMERABLE);
                let small = reserved(left.with_budget(left.budget.steps, states), LAST_RESORT);
                AnySolver::ValueIteration(Box::new(ValueIteration::whole(problem, small)))
            }
            Why::Large(_) => AnySolver::Lrtdp(Box::new(Lrtdp::new(problem, reserved(left, 2)))),
            Why::Undecided => {
                let states = left.budget.states.min(PROVABLE);
                let all = reserved(left.with_budget(left.budget.steps, states), LAST_RESORT);
                AnySolver::ValueIteration(Box::new(ValueIteration::whole(problem, all)))
            }
            Why::Spent => AnySolver::Uct(Box::new(Uct::new(problem, left))),
        };
    }

    /// What comes after the present solver, if it is not the last.
    fn next(&self, outcome: Option<Outcome>) -> Option<Why> {
        let is_partial = match &self.chosen {
            AnySolver::ValueIteration(solver) => solver.is_partial(),
            _ => false,
        };
        match outcome? {
            Outcome::Unfit => Some(Why::Small),
            Outcome::Budget if is_partial && self.why == Why::Small => {
                Some(Why::Large(ENUMERABLE.min(self.settings.budget.states)))
            }
            Outcome::Budget if self.why != Why::Spent && self.progress().lower == 0.0 => {
                Some(if matches!(self.why, Why::Large(_)) { Why::Undecided } else { Why::Spent })
            }
            _ => None,
        }
    }
}

/// The settings without a share of the steps.
const fn reserved(settings: Settings, share: u64) -> Settings {
    let budget = settings.budget;
    settings.with_budget(budget.steps - budget.steps / share, budget.states)
}

impl<P: Mdp + Clone> Policy<P::State, P::Action> for Auto<P> {
    fn action(&self, state: P::State) -> Option<P::Action> {
        self.chosen.action(state)
    }
    fn value(&self, state: P::State) -> Option<f64> {
        self.chosen.value(state)
    }
}

impl<P: Mdp + Clone> Solver<P::State, P::Action> for Auto<P> {
    /// The name of the present solver.
    fn name(&self) -> &'static str {
        self.chosen.name()
    }

    /// A choice that proves wrong ends the step.
    fn step(&mut self, n: usize) -> Option<Outcome> {
        if self.outcome.is_none() {
            let outcome = self.chosen.step(n);
            match self.next(outcome) {
                Some(why) => self.change(why),
                None => self.outcome = outcome,
            }
        }
        self.outcome
    }

    fn progress(&self) -> Progress {
        let progress = self.chosen.progress();
        let (lower, upper) = self.proved;
        Progress {
            steps: progress.steps + self.spent,
            lower: progress.lower.max(lower),
            upper: progress.upper.min(upper),
            least: progress.least.max(self.least),
            ..progress
        }
    }
}
