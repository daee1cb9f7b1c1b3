//! A goal-directed Markov decision process with finitely many actions: reward 1 on entering a
//! terminal state, 0 otherwise (Williams et al., Section III).

use std::hash::Hash;
use std::rc::Rc;

/// A problem that a planner can solve, knowing nothing else about it.
pub trait Mdp {
    /// A state, packed: cheap to copy, hash and compare.
    type State: Copy + Eq + Hash + Ord;
    /// An action; `Ord` fixes the order in which ties break.
    type Action: Copy + Eq + Ord;

    /// Where the problem begins.
    fn initial(&self) -> Self::State;
    /// All actions, in the order of ties. Every action is applicable in every state (it may do nothing).
    fn actions(&self) -> &[Self::Action];
    /// Appends the distribution of successors of `action` in `state`: probabilities in (0, 1] that sum to one.
    fn successors(
        &self,
        state: Self::State,
        action: Self::Action,
        out: &mut Vec<(Self::State, f64)>,
    );
    /// Whether the goal holds in `state`; such a state is terminal.
    fn is_terminal(&self, state: Self::State) -> bool;
    /// A lower bound on the number of actions from `state` to a terminal state; `None` when no terminal
    /// state can be reached. Admissible and, for the planners' speed, consistent.
    fn heuristic(&self, state: Self::State) -> Option<u32> {
        let _ = state;
        Some(0)
    }
    /// An upper bound on the discounted value of a state that is not terminal, in [0, 1]: what the heuristic says
    /// unless the problem knows better. It never grows on average along any action, so that backups only lower it.
    fn most(&self, state: Self::State, discount: f64) -> f64 {
        self.heuristic(state).map_or(0.0, |n| power(discount, n.saturating_sub(1)))
    }
}

/// `base` to the power of `n` by squaring: the same on every machine.
#[must_use]
pub fn power(base: f64, n: u32) -> f64 {
    let (mut result, mut square, mut left) = (1.0, base, n);
    while left > 0 {
        if left & 1 == 1 {
            result *= square;
        }
        square *= square;
        left >>= 1;
    }
    result
}

/// A problem that is lent, or shared, is a problem.
macro_rules! is_a_problem {
    ($($pointer:ty),*) => {$(
        impl<P: Mdp> Mdp for $pointer {
            type State = P::State;
            type Action = P::Action;

            fn initial(&self) -> Self::State {
                (**self).initial()
            }
            fn actions(&self) -> &[Self::Action] {
                (**self).actions()
            }
            fn successors(
                &self,
                state: Self::State,
                action: Self::Action,
                out: &mut Vec<(Self::State, f64)>,
            ) {
                (**self).successors(state, action, out);
            }
            fn is_terminal(&self, state: Self::State) -> bool {
                (**self).is_terminal(state)
            }
            fn heuristic(&self, state: Self::State) -> Option<u32> {
                (**self).heuristic(state)
            }
            fn most(&self, state: Self::State, discount: f64) -> f64 {
                (**self).most(state, discount)
            }
        }
    )*};
}

is_a_problem!(&P, Rc<P>);
