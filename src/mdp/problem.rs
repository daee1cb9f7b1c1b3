//! A goal-directed Markov decision process with finitely many actions: reward 1 on entering a
//! terminal state, 0 otherwise (Williams et al., Section III).

use super::leap::{Leaps, power};
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

    /// A guess at the number of actions from `state`, nearer to it than the heuristic and no bound; `None` as there.
    fn estimate(&self, state: Self::State) -> Option<u32> {
        self.heuristic(state)
    }
    /// How many parts the goal has that can be reached one after the other; at most 64.
    fn n_parts(&self) -> usize {
        0
    }
    /// A lower bound on the actions until this part of the goal holds.
    fn part(&self, index: usize, state: Self::State) -> Option<u32> {
        let _ = index;
        self.heuristic(state)
    }
    /// The parts that do not hold in `state`, with a guess at the actions in all if it comes first; the least first.
    fn parts(&self, state: Self::State) -> Vec<(u32, usize)> {
        let _ = state;
        Vec::new()
    }
    /// Does a bounded part more of what makes the heuristic sharper, and says whether it is. Else it says what it said.
    fn sharpen(&self) -> Sharpened {
        Sharpened::Whole
    }
    /// Appends ways on from a state that is not terminal such that some best policy takes no others: each action alone,
    /// unless the problem knows longer ones. A terminal state is on the way of none.
    fn leaps(&self, state: Self::State, out: &mut Leaps<Self::State>) {
        each_action(self, state, out);
    }
    /// Appends the actions of the leap from a state that has this number, when all goes well.
    fn way(&self, from: Self::State, number: u16, out: &mut Vec<Self::Action>) {
        let _ = from;
        out.extend(self.actions().get(usize::from(number)));
    }
}

/// What came of making a heuristic sharper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sharpened {
    /// Nothing yet.
    Not,
    /// It is sharper than before.
    More,
    /// Nothing more can be done.
    Whole,
}

/// The leaps of a problem that knows none but its actions, numbered as those.
pub fn each_action<P: Mdp + ?Sized>(problem: &P, state: P::State, out: &mut Leaps<P::State>) {
    for (number, &action) in problem.actions().iter().enumerate() {
        problem.successors(state, action, &mut out.ends);
        out.close(number, 1, 0.0, state);
    }
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
            fn estimate(&self, state: Self::State) -> Option<u32> {
                (**self).estimate(state)
            }
            fn n_parts(&self) -> usize {
                (**self).n_parts()
            }
            fn part(&self, index: usize, state: Self::State) -> Option<u32> {
                (**self).part(index, state)
            }
            fn parts(&self, state: Self::State) -> Vec<(u32, usize)> {
                (**self).parts(state)
            }
            fn sharpen(&self) -> Sharpened {
                (**self).sharpen()
            }
            fn leaps(&self, state: Self::State, out: &mut Leaps<Self::State>) {
                (**self).leaps(state, out);
            }
            fn way(&self, from: Self::State, number: u16, out: &mut Vec<Self::Action>) {
                (**self).way(from, number, out);
            }
        }
    )*};
}

is_a_problem!(&P, Rc<P>);
