//! Shortest plans where nothing is left to chance, and some plan at once where the shortest is far: any-time search
//! (after Likhachev, Gordon and Thrun 2003, begun anew for each weight: Richter, Thayer and Ruml 2010). A short A*
//! first; then a plan made of parts, or found greedily by the problem's guess; then A* with sharper bounds for plans that
//! are shorter still, and for shorter plans under weights that fall, until there is none or enough was tried.
//! Invariants: no plan is shorter than `least`; plans only grow shorter.

use super::astar::{AStar, Guide, Solution};
use super::parts::Parts;
use crate::mdp::{Mdp, Outcome, Policy, Progress, Settings, Solver};

/// What is done in turn, and how many steps it may take.
const STAGES: [(Stage, u64); 10] = [
    (Stage::Search(Guide::Bound), 500),
    (Stage::Parts, 20_000),
    (Stage::Greedy, 100_000),
    (Stage::Sharpen, u64::MAX),
    (Stage::Search(Guide::Bound), 50_000),
    (Stage::Parts, 100_000),
    (Stage::Search(Guide::Guess(1, 2)), 20_000),
    (Stage::Search(Guide::Guess(2, 3)), 40_000),
    (Stage::Search(Guide::Guess(1, 1)), 40_000),
    (Stage::Search(Guide::Bound), u64::MAX),
];
/// A plan that is no longer than the bound times this is near enough, once A* has tried for so many states.
const NEAR: (u64, u64) = (6, 5);
const TRIED: u64 = 100_000;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// For a plan that is shorter than the one that is known.
    Search(Guide),
    /// For some plan, if there is none.
    Greedy,
    /// Plans made of parts.
    Parts,
    /// The bounds are made sharper.
    Sharpen,
}

/// A solver at work.
pub struct AnyTime<P: Mdp> {
    problem: P,
    settings: Settings,
    stage: usize,
    search: AStar<P>,
    parts: Option<Box<Parts<P>>>,
    /// Steps of the stages before, and of this one but for searches.
    spent: u64,
    begun: u64,
    /// No plan is shorter.
    least: u32,
    plan: Option<Solution<P::State, P::Action>>,
    outcome: Option<Outcome>,
}

impl<P: Mdp + Clone> AnyTime<P> {
    /// A solver that has done nothing yet. The problem is cloned: lend or share it.
    #[must_use]
    pub fn new(problem: P, settings: Settings) -> Self {
        let mut solver = Self {
            search: AStar::new(problem.clone(), settings),
            problem,
            settings,
            stage: 0,
            parts: None,
            spent: 0,
            begun: 0,
            least: 0,
            plan: None,
            outcome: None,
        };
        solver.begin();
        solver
    }

    /// The shortest plan so far.
    #[must_use]
    pub fn plan(&self) -> Option<&Solution<P::State, P::Action>> {
        self.parts.as_ref().map_or(self.plan.as_ref(), |parts| parts.best())
    }

    /// A plan needs at least so many actions, as far as is proved.
    #[must_use]
    pub fn least(&self) -> u32 {
        self.least.max(self.search.least())
    }

    /// How many steps were done.
    fn steps(&self) -> u64 {
        self.spent
            + self.search.expanded()
            + self.parts.as_ref().map_or(0, |parts| parts.expanded())
    }

    fn left(&self) -> u64 {
        self.settings.budget.steps.saturating_sub(self.steps())
    }

    fn length(&self) -> Option<u32> {
        self.plan().and_then(|plan| u32::try_from(plan.actions.len()).ok())
    }

    /// Does one step more. All that ends a stage is looked at after each, so that it does not matter how many are asked
    /// for at once.
    fn advance(&mut self) -> Option<Outcome> {
        let (stage, most) = STAGES[self.stage];
        let is_spent = self.steps() - self.begun >= most || self.left() == 0;
        match (stage, &mut self.parts) {
            (Stage::Parts, Some(parts)) => {
                let is_over = is_spent || parts.step();
                if !is_over {
                    return None;
                }
                self.plan = parts.best().cloned();
                self.go_on()
            }
            (Stage::Sharpen, _) => {
                let is_over = is_spent || self.problem.sharpen();
                self.spent += u64::from(!is_over);
                if is_over { self.go_on() } else { None }
            }
            _ => match self.search.step(1) {
                Some(outcome) => self.ended(outcome),
                None => self.is_near().then_some(Outcome::Budget),
            },
        }
    }

    /// Whether the plan is as good as proved.
    fn is_near(&self) -> bool {
        let is_last = self.stage + 1 == STAGES.len();
        is_last
            && self.search.expanded() >= TRIED
            && self.length().is_some_and(|length| {
                u64::from(length) * NEAR.1 <= u64::from(self.least()) * NEAR.0
            })
    }

    /// What comes of a search that has ended.
    fn ended(&mut self, outcome: Outcome) -> Option<Outcome> {
        match (STAGES[self.stage].0, outcome) {
            (_, Outcome::Unfit) => return Some(outcome),
            (Stage::Search(Guide::Bound), Outcome::Solved) => {
                self.plan = self.search.plan().cloned();
                return Some(outcome);
            }
            (_, Outcome::Solved) => self.plan = self.search.plan().cloned(),
            (_, Outcome::Unreachable) if self.plan.is_none() => return Some(outcome),
            _ => {}
        }
        self.go_on()
    }

    /// Begins the next stage that there is something to do in.
    fn go_on(&mut self) -> Option<Outcome> {
        self.least = self.least();
        if self.length().is_some_and(|length| length <= self.least) {
            return Some(Outcome::Solved);
        }
        if self.left() == 0 || self.stage + 1 == STAGES.len() {
            return Some(Outcome::Budget);
        }
        self.stage += 1;
        self.begin();
        None
    }

    fn begin(&mut self) {
        self.spent = self.steps();
        self.begun = self.spent;
        let (stage, most) = STAGES[self.stage];
        let settings =
            self.settings.with_budget(most.min(self.left()), self.settings.budget.states);
        let shorter = self.length().map_or(u32::MAX, |length| length - 1);
        self.parts = None;
        let (guide, settings) = match stage {
            Stage::Search(guide) => (guide, settings),
            Stage::Greedy if self.plan.is_none() => (Guide::Guess(0, 1), settings),
            Stage::Parts => {
                let most = self.settings;
                let known = self.plan.clone();
                self.parts = Some(Box::new(Parts::new(self.problem.clone(), most, known)));
                (Guide::Bound, settings.with_budget(0, 0))
            }
            Stage::Greedy | Stage::Sharpen => (Guide::Bound, settings.with_budget(0, 0)),
        };
        let start = self.problem.initial();
        self.search = AStar::guided(self.problem.clone(), start, settings, shorter, guide);
    }
}

impl<P: Mdp + Clone> Policy<P::State, P::Action> for AnyTime<P> {
    fn action(&self, state: P::State) -> Option<P::Action> {
        self.plan().or(self.search.plan())?.action(state)
    }

    fn value(&self, state: P::State) -> Option<f64> {
        match (self.outcome, self.plan()) {
            (Some(Outcome::Solved), Some(plan)) if !self.problem.is_terminal(state) => {
                Some(self.settings.worth(plan.left(state)?))
            }
            _ => self.search.value(state),
        }
    }
}

impl<P: Mdp + Clone> Solver<P::State, P::Action> for AnyTime<P> {
    fn name(&self) -> &'static str {
        "astar"
    }

    /// A step takes a state in its turn, or does a part of what makes bounds sharper.
    fn step(&mut self, n: usize) -> Option<Outcome> {
        for _ in 0..n {
            if self.outcome.is_some() {
                break;
            }
            self.outcome = self.advance();
        }
        self.outcome
    }

    fn progress(&self) -> Progress {
        let worth = |n| self.settings.worth(n);
        let (lower, upper) = match self.outcome {
            Some(Outcome::Unreachable) => (0.0, 0.0),
            _ => (self.length().map_or(0.0, worth), worth(self.least())),
        };
        let steps = self.steps();
        Progress { steps, lower, upper, least: self.least(), ..self.search.progress() }
    }
}
