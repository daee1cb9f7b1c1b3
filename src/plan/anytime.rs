//! Shortest plans where nothing is left to chance, and some plan at once where the shortest is far: any-time search
//! (after Likhachev, Gordon and Thrun 2003, begun anew for each weight: Richter, Thayer and Ruml 2010). A short A*
//! first; then a plan made of parts, or found greedily by the problem's guess; then A* with sharper bounds, left now and
//! then for shorter plans by parts and under weights that fall, until there is none or enough was tried.
//! Invariants: no plan is shorter than `least`; plans only grow shorter; whatever ends a stage is looked at after every
//! step, so that what is found does not depend on how many are asked for at once.

use super::astar::{AStar, Guide, Solution};
use super::parts::Parts;
use crate::mdp::{Mdp, Outcome, Policy, Progress, Settings, Sharpened, Solver};

/// What is done in turn, and how many steps it may take.
const STAGES: [(Stage, u64); 12] = [
    (Stage::Prove, SHORT),
    (Stage::First, 30_000),
    (Stage::Greedy, 100_000),
    // Small tables are soon made; before large ones the plan that is there is made shorter.
    (Stage::Sharpen, 8_000),
    (Stage::Parts, 3_000),
    (Stage::Sharpen, u64::MAX),
    (Stage::Prove, 150_000),
    (Stage::Parts, 100_000),
    (Stage::Improve(1, 2), 20_000),
    (Stage::Improve(2, 3), 40_000),
    (Stage::Improve(1, 1), 40_000),
    (Stage::Prove, u64::MAX),
];
/// So many states are looked at by A* under each new bound.
const SHORT: u64 = 500;
/// A plan that is no longer than the bound times this is near enough, after so many steps.
const NEAR: (u64, u64) = (6, 5);
const TRIED: u64 = 300_000;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    /// A* goes on.
    Prove,
    /// Plans made of parts, until there is one.
    First,
    /// Shorter plans made of parts.
    Parts,
    /// For some plan, if there is none.
    Greedy,
    /// The bounds are made sharper, and A* begins anew under each.
    Sharpen,
    /// For a shorter plan, the cost and the guess counted so often.
    Improve(u32, u32),
}

/// What the present stage works with, besides A*.
enum Work<P: Mdp> {
    None,
    Parts(Box<Parts<P>>),
    Search(Box<AStar<P>>),
}

/// A solver at work.
pub struct AnyTime<P: Mdp> {
    problem: P,
    settings: Settings,
    stage: usize,
    proof: AStar<P>,
    work: Work<P>,
    /// Steps of what is over, and of all before this stage.
    spent: u64,
    begun: u64,
    /// No plan is shorter.
    least: u32,
    plan: Option<Solution<P::State, P::Action>>,
    /// Where to go when there is no plan.
    toward: Option<Solution<P::State, P::Action>>,
    outcome: Option<Outcome>,
}

impl<P: Mdp + Clone> AnyTime<P> {
    /// A solver that has done nothing yet. The problem is cloned: lend or share it.
    #[must_use]
    pub fn new(problem: P, settings: Settings) -> Self {
        Self {
            proof: AStar::new(problem.clone(), within(settings, settings.budget.states)),
            problem,
            settings,
            stage: 0,
            work: Work::None,
            spent: 0,
            begun: 0,
            least: 0,
            plan: None,
            toward: None,
            outcome: None,
        }
    }

    /// The shortest plan so far.
    #[must_use]
    pub fn plan(&self) -> Option<&Solution<P::State, P::Action>> {
        if let Work::Parts(parts) = &self.work { parts.best() } else { self.plan.as_ref() }
    }

    /// A plan needs at least so many actions, as far as is proved.
    #[must_use]
    pub fn least(&self) -> u32 {
        self.least.max(self.proof.least())
    }

    /// How many steps were done.
    fn steps(&self) -> u64 {
        let work = match &self.work {
            Work::None => 0,
            Work::Parts(parts) => parts.expanded(),
            Work::Search(search) => search.expanded(),
        };
        self.spent + self.proof.expanded() + work
    }

    fn length(&self) -> Option<u32> {
        self.plan().and_then(|plan| u32::try_from(plan.actions.len()).ok())
    }

    /// Does one step more.
    fn advance(&mut self) -> Option<Outcome> {
        let (stage, most) = STAGES[self.stage];
        let steps = self.steps();
        if steps >= self.settings.budget.steps || (steps >= TRIED && self.is_near()) {
            return self.end();
        }
        let is_found = stage == Stage::First && self.plan().is_some();
        if is_found || steps - self.begun >= most {
            return self.go_on();
        }
        match (stage, &mut self.work) {
            (Stage::Sharpen, Work::None) if self.proof.expanded() >= SHORT => {
                match self.problem.sharpen() {
                    Sharpened::Not => self.spent += 1,
                    Sharpened::More => return self.begin_anew(),
                    Sharpened::Whole => return self.go_on(),
                }
                None
            }
            (_, Work::Parts(parts)) => {
                if parts.step() {
                    self.go_on()
                } else {
                    None
                }
            }
            (_, Work::Search(search)) => {
                let outcome = search.step(1)?;
                match outcome {
                    Outcome::Unfit => return Some(outcome),
                    Outcome::Unreachable if self.plan.is_none() => return Some(outcome),
                    Outcome::Unreachable => self.least = self.least.max(search.least()),
                    Outcome::Solved => self.plan = search.plan().cloned(),
                    Outcome::Budget => {}
                }
                self.go_on()
            }
            (_, Work::None) => match self.proof.step(1)? {
                Outcome::Solved => {
                    self.plan = self.proof.plan().cloned();
                    Some(Outcome::Solved)
                }
                Outcome::Budget => self.go_on(),
                // There is none that is shorter.
                Outcome::Unreachable if self.plan.is_some() => Some(Outcome::Solved),
                outcome => Some(outcome),
            },
        }
    }

    /// Begins A* anew, led by a sharper bound.
    fn begin_anew(&mut self) -> Option<Outcome> {
        self.least = self.least();
        self.spent += self.proof.expanded();
        let settings = within(self.settings, self.settings.budget.states);
        self.proof = AStar::new(self.problem.clone(), settings);
        let length = self.length()?;
        self.proof.limit(length.saturating_sub(1));
        (length <= self.least()).then_some(Outcome::Solved)
    }

    /// Whether the plan is as good as proved.
    fn is_near(&self) -> bool {
        let is_near = |length| u64::from(length) * NEAR.1 <= u64::from(self.least()) * NEAR.0;
        self.length().is_some_and(is_near)
    }

    /// Begins the next stage that there is something to do in.
    fn go_on(&mut self) -> Option<Outcome> {
        self.put_away();
        loop {
            if self.length().is_some_and(|length| length <= self.least()) {
                return Some(Outcome::Solved);
            }
            self.stage += 1;
            let Some(&(stage, _)) = STAGES.get(self.stage) else { return self.end() };
            if stage != Stage::Greedy || self.plan.is_none() {
                self.begin(stage);
                return None;
            }
        }
    }

    /// Ends with what is known.
    fn end(&mut self) -> Option<Outcome> {
        if let (None, Work::Search(search)) = (&self.plan, &self.work) {
            self.toward = search.toward();
        }
        self.put_away();
        if self.plan.is_none() && self.toward.is_none() {
            self.toward = self.proof.toward();
        }
        Some(Outcome::Budget)
    }

    /// Keeps what the work of this stage has found.
    fn put_away(&mut self) {
        self.spent = self.steps() - self.proof.expanded();
        self.plan = self.plan().cloned();
        self.work = Work::None;
        if let Some(length) = self.length() {
            self.proof.limit(length.saturating_sub(1));
        }
    }

    fn begin(&mut self, stage: Stage) {
        self.begun = self.steps();
        let states = self.settings.budget.states.saturating_sub(self.proof.kept());
        let settings = within(self.settings, states);
        let problem = self.problem.clone();
        let guide = match stage {
            Stage::Prove | Stage::Sharpen => return,
            Stage::First | Stage::Parts => {
                let parts = Parts::new(problem, settings, self.plan.clone());
                self.work = Work::Parts(Box::new(parts));
                return;
            }
            Stage::Greedy => Guide::Guess(0, 1),
            Stage::Improve(costs, guesses) => Guide::Guess(costs, guesses),
        };
        let shorter = self.length().map_or(u32::MAX, |length| length.saturating_sub(1));
        let start = problem.initial();
        let search = AStar::guided(problem, start, settings, shorter, guide);
        self.work = Work::Search(Box::new(search));
    }
}

/// Steps are counted here, states where they are kept.
const fn within(settings: Settings, states: usize) -> Settings {
    settings.with_budget(u64::MAX, states)
}

impl<P: Mdp + Clone> Policy<P::State, P::Action> for AnyTime<P> {
    fn action(&self, state: P::State) -> Option<P::Action> {
        self.plan().or(self.toward.as_ref())?.action(state)
    }

    fn value(&self, state: P::State) -> Option<f64> {
        match (self.outcome, self.plan()) {
            (Some(Outcome::Solved), Some(plan)) if !self.problem.is_terminal(state) => {
                Some(self.settings.worth(plan.left(state)?))
            }
            _ => self.proof.value(state),
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
        let kept = match &self.work {
            Work::None => 0,
            Work::Parts(parts) => parts.kept(),
            Work::Search(search) => search.kept(),
        };
        let steps = self.steps();
        Progress {
            states: self.proof.kept() + kept,
            steps,
            backups: steps * self.problem.actions().len() as u64,
            residual: f64::NAN,
            lower,
            upper,
            least: self.least(),
        }
    }
}
