//! A problem taken action by action, whatever leaps it knows: for who must be able to go on from every state on the way.

use super::problem::Mdp;

/// See the head of this file.
#[derive(Clone, Copy, Debug)]
pub struct StepByStep<P>(pub P);

impl<P: Mdp> Mdp for StepByStep<P> {
    type State = P::State;
    type Action = P::Action;

    fn initial(&self) -> P::State {
        self.0.initial()
    }
    fn actions(&self) -> &[P::Action] {
        self.0.actions()
    }
    fn successors(&self, state: P::State, action: P::Action, out: &mut Vec<(P::State, f64)>) {
        self.0.successors(state, action, out);
    }
    fn is_terminal(&self, state: P::State) -> bool {
        self.0.is_terminal(state)
    }
    fn heuristic(&self, state: P::State) -> Option<u32> {
        self.0.heuristic(state)
    }
    fn most(&self, state: P::State, discount: f64) -> f64 {
        self.0.most(state, discount)
    }
}
