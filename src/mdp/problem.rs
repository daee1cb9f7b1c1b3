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

    /// A state as a member of a family, with its number there: states that lie near each other have one family and
    /// numbers that are near. No two states have both in common.
    fn family(&self, state: Self::State) -> (Self::State, u32) {
        (state, 0)
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
    /// Does a bounded part more of what makes the heuristic sharper; whether nothing more can be done. What it says
    /// changes only when it is done.
    fn sharpen(&self) -> bool {
        true
    }
    /// Appends ways on from a state that is not terminal such that some shortest plan consists of them: each action
    /// alone, with the outcome from which least is left, unless the problem knows longer ones.
    fn leaps(&self, state: Self::State, out: &mut Vec<Leap<Self::State>>) {
        each_action(self, state, out);
    }
    /// Appends the actions of the shortest leap from one state to another.
    fn way(&self, from: Self::State, to: Self::State, out: &mut Vec<Self::Action>) {
        out.extend(action_to(self, from, to));
    }
}

/// The leaps of a problem that knows none but its actions.
pub fn each_action<P: Mdp + ?Sized>(problem: &P, state: P::State, out: &mut Vec<Leap<P::State>>) {
    let mut buffer = Vec::new();
    let leaps = problem.actions().iter();
    out.extend(leaps.filter_map(|&action| hopeful(problem, state, action, &mut buffer)));
}

/// The action that leads from one state to another when all goes well.
pub fn action_to<P: Mdp + ?Sized>(problem: &P, from: P::State, to: P::State) -> Option<P::Action> {
    let mut buffer = Vec::new();
    let leads = |action: &&P::Action| {
        hopeful(problem, from, **action, &mut buffer).is_some_and(|leap| leap.state == to)
    };
    problem.actions().iter().find(leads).copied()
}

/// An action as a leap; `None` when it changes nothing.
fn hopeful<P: Mdp + ?Sized>(
    problem: &P,
    state: P::State,
    action: P::Action,
    buffer: &mut Vec<(P::State, f64)>,
) -> Option<Leap<P::State>> {
    buffer.clear();
    problem.successors(state, action, buffer);
    let is_sure = buffer.len() == 1;
    let left = |next: P::State| match problem.is_terminal(next) {
        true => 0,
        false => problem.heuristic(next).map_or(u32::MAX, |n| n.max(1)),
    };
    let best = if let [(only, _)] = buffer[..] {
        Some(only)
    } else {
        buffer.iter().map(|o| o.0).filter(|&next| next != state).min_by_key(|&next| left(next))
    };
    best.filter(|&next| next != state).map(|state| Leap { state, cost: 1, is_sure })
}

/// A way from one state to another in a world where all goes well: one action or several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leap<S> {
    /// Where it leads.
    pub state: S,
    /// How many actions it takes, at least 1.
    pub cost: u32,
    /// Whether nothing else can come of them.
    pub is_sure: bool,
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
            fn family(&self, state: Self::State) -> (Self::State, u32) {
                (**self).family(state)
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
            fn sharpen(&self) -> bool {
                (**self).sharpen()
            }
            fn leaps(&self, state: Self::State, out: &mut Vec<Leap<Self::State>>) {
                (**self).leaps(state, out);
            }
            fn way(&self, from: Self::State, to: Self::State, out: &mut Vec<Self::Action>) {
                (**self).way(from, to, out);
            }
        }
    )*};
}

is_a_problem!(&P, Rc<P>);
