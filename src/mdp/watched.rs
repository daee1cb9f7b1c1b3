//! A problem that is watched while it is being solved: beside each state stands the stage that a watch has come to, and
//! the goal is what the watch says. It is how a goal of runs becomes one of states (Bacchus, Boutilier and Grove 1996);
//! solvers need not know.

use super::problem::Mdp;

/// What follows the states of a run: where it is, by a number, and what that means.
pub trait Watch<S> {
    /// The stage once the first state is seen.
    fn begin(&self, state: S) -> u8;
    /// The stage once another state is seen.
    fn step(&self, stage: u8, state: S) -> u8;
    /// Whether a run that has come to this stage is what was wanted.
    fn is_satisfied(&self, stage: u8) -> bool;
    /// A lower bound on the actions until it is; `None` when it cannot be any more. Admissible and consistent.
    fn least(&self, stage: u8, state: S) -> Option<u32>;
}

/// A problem with a watch, whose goal it is to satisfy it.
#[derive(Clone, Copy, Debug)]
pub struct Watched<P, W> {
    problem: P,
    watch: W,
}

impl<P: Mdp, W: Watch<P::State>> Watched<P, W> {
    /// A problem, whose own goal does not count, with a watch.
    pub const fn new(problem: P, watch: W) -> Self {
        Self { problem, watch }
    }

    /// The problem.
    pub const fn problem(&self) -> &P {
        &self.problem
    }

    /// The watch.
    pub const fn watch(&self) -> &W {
        &self.watch
    }
}

impl<P: Mdp, W: Watch<P::State>> Mdp for Watched<P, W> {
    type State = (P::State, u8);
    type Action = P::Action;

    fn initial(&self) -> Self::State {
        let state = self.problem.initial();
        (state, self.watch.begin(state))
    }

    fn actions(&self) -> &[P::Action] {
        self.problem.actions()
    }

    fn successors(
        &self,
        (state, stage): Self::State,
        action: P::Action,
        out: &mut Vec<(Self::State, f64)>,
    ) {
        let mut ends = Vec::new();
        self.problem.successors(state, action, &mut ends);
        out.extend(ends.into_iter().map(|(next, p)| ((next, self.watch.step(stage, next)), p)));
    }

    fn is_terminal(&self, (_, stage): Self::State) -> bool {
        self.watch.is_satisfied(stage)
    }

    fn heuristic(&self, (state, stage): Self::State) -> Option<u32> {
        self.watch.least(stage, state)
    }
}
