//! Plans made of parts: one part of the goal is reached after the other, each by A* with the bound of that part alone,
//! in one order after another that may be better than the best so far (branch and bound, depth first).
//! Invariant: a plan that is found is a plan; nothing is proved.

use super::astar::{AStar, Guide, Solution};
use crate::mdp::{Mdp, Outcome, Settings, Solver};

/// How often a part's bound counts, and how many states that may look at: to be short, then to get there at all.
const TRIES: [(u32, u64); 2] = [(1, 1_000), (4, 5_000)];

/// See the head of this file.
pub(super) struct Parts<P: Mdp> {
    problem: P,
    settings: Settings,
    begun: Vec<Begun<P::State, P::Action>>,
    search: Option<Search<P>>,
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

/// A part that is looked for from the last beginning, and which try it is.
struct Search<P: Mdp> {
    by: Box<AStar<P>>,
    part: usize,
    tried: usize,
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
        self.spent + self.search.as_ref().map_or(0, |search| search.by.expanded())
    }

    /// How many states are kept.
    pub(super) fn kept(&self) -> usize {
        self.search.as_ref().map_or(0, |search| search.by.kept())
    }

    /// Looks at no more than one state; whether all orders were tried that may be better.
    pub(super) fn step(&mut self) -> bool {
        if let Some(Search { by, .. }) = &mut self.search {
            if let Some(outcome) = by.step(1) {
                self.ended(outcome);
            }
            return false;
        }
        let Some(last) = self.begun.last_mut() else { return true };
        match last.next.pop() {
            Some(part) => self.look_for(part, 0),
            None => drop(self.begun.pop()),
        }
        false
    }

    /// What comes of a search that has ended.
    fn ended(&mut self, outcome: Outcome) {
        let Some(Search { by, part, tried }) = self.search.take() else { return };
        self.spent += by.expanded();
        match (outcome, by.plan(), self.begun.last()) {
            (Outcome::Solved, Some(rest), Some(before)) => {
                let mut whole = before.way.clone();
                whole.extend(rest);
                self.open(whole);
            }
            (Outcome::Budget, ..) if tried + 1 < TRIES.len() => self.look_for(part, tried + 1),
            _ => {}
        }
    }

    /// Begins to look for a part from the last beginning, unless that cannot be better.
    fn look_for(&mut self, part: usize, tried: usize) {
        let Some(Begun { way, .. }) = self.begun.last() else { return };
        let most = self.best.as_ref().map_or(usize::MAX, |best| best.actions.len() - 1);
        let (Some(most), Some(&state)) = (most.checked_sub(way.actions.len()), way.states.last())
        else {
            return;
        };
        let (weight, steps) = TRIES[tried];
        let settings = self.settings.with_budget(steps, self.settings.budget.states);
        let most = u32::try_from(most).unwrap_or(u32::MAX);
        let guide = Guide::Part(part, weight);
        let by = Box::new(AStar::guided(self.problem.clone(), state, settings, most, guide));
        self.search = Some(Search { by, part, tried });
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
