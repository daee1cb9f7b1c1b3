//! The same problem begun elsewhere: what a robot plans in when the world did not do what it expected.

use super::leap::Leaps;
use super::problem::{Mdp, Sharpened};

/// A problem that begins in another state.
#[derive(Clone, Copy, Debug)]
pub struct StartingAt<P: Mdp> {
    problem: P,
    start: P::State,
}

impl<P: Mdp> StartingAt<P> {
    /// The problem, begun in `start`.
    pub const fn new(problem: P, start: P::State) -> Self {
        Self { problem, start }
    }
}

impl<P: Mdp> Mdp for StartingAt<P> {
    type State = P::State;
    type Action = P::Action;

    fn initial(&self) -> P::State {
        self.start
    }
    fn actions(&self) -> &[P::Action] {
        self.problem.actions()
    }
    fn successors(&self, state: P::State, action: P::Action, out: &mut Vec<(P::State, f64)>) {
        self.problem.successors(state, action, out);
    }
    fn is_terminal(&self, state: P::State) -> bool {
        self.problem.is_terminal(state)
    }
    fn heuristic(&self, state: P::State) -> Option<u32> {
        self.problem.heuristic(state)
    }
    fn most(&self, state: P::State, discount: f64) -> f64 {
        self.problem.most(state, discount)
    }
    fn estimate(&self, state: P::State) -> Option<u32> {
        self.problem.estimate(state)
    }
    fn n_parts(&self) -> usize {
        self.problem.n_parts()
    }
    fn part(&self, index: usize, state: P::State) -> Option<u32> {
        self.problem.part(index, state)
    }
    fn parts(&self, state: P::State) -> Vec<(u32, usize)> {
        self.problem.parts(state)
    }
    fn sharpen(&self) -> Sharpened {
        self.problem.sharpen()
    }
    fn leaps(&self, state: P::State, out: &mut Leaps<P::State>) {
        self.problem.leaps(state, out);
    }
    fn way(&self, from: P::State, number: u16, out: &mut Vec<P::Action>) {
        self.problem.way(from, number, out);
    }
}
