//! Plans made of parts: one part of the goal is reached after the other, each by A* with the bound of that part alone,
//! in one order after another that may be better than the best so far (branch and bound, depth first).
//! Invariant: a plan that is found is a plan; nothing is proved.

use super::astar::{AStar, Guide, Solution};
use crate::mdp::{Mdp, Outcome, Settings, Solver};

/// States that one part may look at.
const PART: u64 = 3_000;

/// See the head of this file.
pub(super) struct Parts<P: Mdp> {
    problem: P,
    settings: Settings,
    begun: Vec<Begun<P::State, P::Action>>,
    search: Option<Box<AStar<P>>>,
    /// States looked at before the present search.
    spent: u64,
    best: Option<Solution<P::State, P::Action>>,
}

/// A beginning of plans.
struct Begun<S, A> {
    way: Solution<S, A>,
    /// The parts that may come next, the best last.
    next: Vec<usize>,
}

impl<P: Mdp + Clone> Parts<P> {
    /// Nothing done yet; plans must be shorter than the one that is known.
    pub(super) fn new(
        problem: P,
        settings: Settings,
        known: Option<Solution<P::State, P::Action>>,
    ) -> Self {
        let start = Solution { actions: Vec::new(), states: vec![problem.initial()] };
        let mut parts =
            Self { problem, settings, begun: Vec::new(), search: None, spent: 0, best: known };
        parts.open(start);
        parts
    }

    /// The shortest plan so far.
    pub(super) const fn best(&self) -> Option<&Solution<P::State, P::Action>> {
        self.best.as_ref()
    }

    /// How many states were looked at.
    pub(super) fn expanded(&self) -> u64 {
        self.spent + self.search.as_ref().map_or(0, |search| search.expanded())
    }

    /// Looks at no more than one state; whether all orders were tried that may be better.
    pub(super) fn step(&mut self) -> bool {
        if let Some(search) = &mut self.search {
            let Some(outcome) = search.step(1) else { return false };
            self.spent += search.expanded();
            let found = search.plan().filter(|_| outcome == Outcome::Solved).cloned();
            self.search = None;
            if let (Some(rest), Some(before)) = (found, self.begun.last()) {
                let mut whole = before.way.clone();
                whole.extend(&rest);
                self.open(whole);
            }
            return false;
        }
        let Some(Begun { way, next }) = self.begun.last_mut() else { return true };
        let (Some(part), Some(&state)) = (next.pop(), way.states.last()) else {
            self.begun.pop();
            return false;
        };
        let most = self.best.as_ref().map_or(usize::MAX, |best| best.actions.len() - 1);
        if let Some(most) = most.checked_sub(way.actions.len()) {
            let settings = self.settings.with_budget(PART, self.settings.budget.states);
            let problem = self.problem.clone();
            let most = u32::try_from(most).unwrap_or(u32::MAX);
            let search = AStar::guided(problem, state, settings, most, Guide::Part(part));
            self.search = Some(Box::new(search));
        }
        false
    }

    /// Notes how to get somewhere: as a plan, or as the beginning of plans.
    fn open(&mut self, way: Solution<P::State, P::Action>) {
        let Some(&state) = way.states.last() else { return };
        let most = self.best.as_ref().map_or(usize::MAX, |best| best.actions.len());
        if self.problem.is_terminal(state) {
            if way.actions.len() < most {
                self.best = Some(way);
            }
            return;
        }
        let parts = self.problem.parts(state).into_iter().rev();
        let good = parts.filter(|(guess, _)| way.actions.len() + (*guess as usize) < most);
        let next = good.map(|(_, part)| part).collect();
        self.begun.push(Begun { way, next });
    }
}
