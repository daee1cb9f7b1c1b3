//! What a solver of any [`Mdp`](super::Mdp) is and what it gives: a policy, with bounds on what it is worth. A solver is pumped
//! in steps of bounded work and is itself the best policy that it knows so far.
//! Values are discounted: V(s) = max over a of Σ p(s') · (1 if s' is terminal, else γ V(s')), so a plan of n sure
//! actions is worth γ^(n−1); the initial state is worth 1 when it is terminal.

use super::leap::power;

/// The discount of a step in Williams et al.'s planner.
pub const DISCOUNT: f64 = 0.99;

/// When to give up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Most steps: states of which all actions were looked at, however often; for UCT, trials that were begun and actions that were tried.
    pub steps: u64,
    /// Most states to keep: what bounds the memory.
    pub states: usize,
}

impl Default for Budget {
    /// Ten million states kept: some 600 MB for A*, and tens of seconds.
    fn default() -> Self {
        Self { steps: 1_000_000_000, states: 10_000_000 }
    }
}

/// What every solver is told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// γ, in (0, 1).
    pub discount: f64,
    /// ε: how far from V a value may be that is called solved.
    pub epsilon: f64,
    /// When to give up.
    pub budget: Budget,
    /// The seed of what is drawn, if anything is.
    pub seed: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Self { discount: DISCOUNT, epsilon: 1e-6, budget: Budget::default(), seed: 0 }
    }
}

impl Settings {
    /// These settings with another budget.
    #[must_use]
    pub const fn with_budget(self, steps: u64, states: usize) -> Self {
        Self { budget: Budget { steps, states }, ..self }
    }

    /// What reaching the goal in at least so many actions can be worth at most: γ^(n−1), and 1 for none.
    #[must_use]
    pub fn worth(&self, n_actions: u32) -> f64 {
        power(self.discount, n_actions.saturating_sub(1))
    }
}

/// How a solver ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The policy is optimal from the initial state, to within ε.
    Solved,
    /// It is proved that no policy ever reaches a terminal state from the initial one.
    Unreachable,
    /// The budget ran out first; the policy is the best so far.
    Budget,
    /// The problem is none for this solver: it is stochastic.
    Unfit,
}

/// How far a solver is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Progress {
    /// States kept.
    pub states: usize,
    /// States of which all actions were looked at, counted each time.
    pub steps: u64,
    /// Pairs of a state and an action whose worth was computed, counted each time.
    pub backups: u64,
    /// The largest change of a value lately; not a number where that means nothing.
    pub residual: f64,
    /// Proved bounds on the value of the initial state; 0 and 1 always hold.
    pub lower: f64,
    /// See `lower`.
    pub upper: f64,
    /// No plan from the initial state is shorter, as far as is proved.
    pub least: u32,
}

/// What to do where.
pub trait Policy<S, A> {
    /// What to do in a state; `None` where the policy does not know, or nothing helps.
    fn action(&self, state: S) -> Option<A>;
    /// What a state is worth, as far as is known; 0 without an action is proof that nothing helps.
    fn value(&self, state: S) -> Option<f64>;
}

/// A solver at work; as a policy, the best so far.
pub trait Solver<S, A>: Policy<S, A> {
    /// Its name on the command line.
    fn name(&self) -> &'static str;
    /// Does at most `n` steps more, each bounded; `Some` when it has ended, which it then stays.
    fn step(&mut self, n: usize) -> Option<Outcome>;
    /// How far it is.
    fn progress(&self) -> Progress;

    /// Runs until it ends.
    fn run(&mut self) -> Outcome {
        loop {
            if let Some(outcome) = self.step(usize::MAX) {
                return outcome;
            }
        }
    }
}

impl<S, A, T: Policy<S, A> + ?Sized> Policy<S, A> for Box<T> {
    fn action(&self, state: S) -> Option<A> {
        (**self).action(state)
    }
    fn value(&self, state: S) -> Option<f64> {
        (**self).value(state)
    }
}

impl<S, A, T: Solver<S, A> + ?Sized> Solver<S, A> for Box<T> {
    fn name(&self) -> &'static str {
        (**self).name()
    }
    fn step(&mut self, n: usize) -> Option<Outcome> {
        (**self).step(n)
    }
    fn progress(&self) -> Progress {
        (**self).progress()
    }
}
