//! Best-first search over leaps (A*: Hart, Nilsson and Raphael 1968; weighted: Pohl 1970), as a search that can be pumped.
//! Successors are kept when their turn comes and not before (partial expansion: Yoshizumi, Miura and Ishida 2000): a
//! state is looked at once more for each sum of cost and bound that its successors have. Flat arrays, found through one
//! index. Invariants: led by an admissible and consistent bound the plan is shortest, and what was looked at proves how
//! long it is at least; ties fall to the state found last, so the same problem gives the same plan.

use super::index::{Id, Index};
use crate::mdp::{Leaps, Mdp, Outcome, Policy, Progress, Settings, Solver};
use std::collections::BTreeMap;

/// A plan: one state more than actions, from the initial to a terminal one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Solution<S, A> {
    /// What to do, in order.
    pub actions: Vec<A>,
    /// Where that leads, the initial state first.
    pub states: Vec<S>,
}

/// What leads a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Guide {
    /// Cost and the problem's bound, each once.
    Bound,
    /// The cost so many times, the problem's guess so many times.
    Guess(u32, u32),
    /// The cost and so many times the bound of this part of the goal, until it holds and what held at first does.
    Part(usize, u32),
}

/// A search at work.
#[derive(Clone, Debug)]
pub struct AStar<P: Mdp> {
    problem: P,
    settings: Settings,
    guide: Guide,
    /// Plans that need more actions are not looked for.
    most_actions: u32,
    /// The parts of the goal that hold at first.
    held: u64,
    nodes: Nodes<P::State>,
    index: Index,
    open: Open,
    expanded: u64,
    /// The node with the least to go among those expanded.
    nearest: u32,
    leaps: Leaps<P::State>,
    /// Whether actions count that may go wrong, as if they did not.
    takes_chances: bool,
    plan: Option<Solution<P::State, P::Action>>,
    outcome: Option<Outcome>,
}

/// All states met, in the order met.
#[derive(Clone, Debug)]
struct Nodes<S> {
    state: Vec<S>,
    facts: Vec<Facts>,
}

#[derive(Clone, Copy, Debug)]
struct Facts {
    /// The node it was reached from; itself for the first.
    parent: u32,
    /// Actions from the initial state, as far as is known.
    cost: u16,
    /// What is left, as the guide has it.
    left: u16,
    /// The stack that it waits in, or [`DONE`].
    waits: u16,
}

/// Waits no more; also what no number of actions reaches.
const DONE: u16 = u16::MAX;

/// Open nodes, in one stack for every score. A node stands in the stack that it says it waits in, others are stale.
#[derive(Clone, Debug, Default)]
struct Open {
    stacks: Vec<Vec<u32>>,
    least: usize,
}

impl Open {
    fn push(&mut self, score: u16, node: u32) {
        let score = usize::from(score);
        if self.stacks.len() <= score {
            self.stacks.resize_with(score + 1, Vec::new);
        }
        self.stacks[score].push(node);
        self.least = self.least.min(score);
    }

    fn pop(&mut self) -> Option<u32> {
        while let Some(stack) = self.stacks.get_mut(self.least) {
            if let Some(top) = stack.pop() {
                return Some(top);
            }
            *stack = Vec::new();
            self.least += 1;
        }
        None
    }
}

impl<P: Mdp> AStar<P> {
    /// A search that has done nothing yet.
    #[must_use]
    pub fn new(problem: P, settings: Settings) -> Self {
        Self::within(problem, settings, u32::MAX)
    }

    /// A search for a plan of at most so many actions; when there is none, it ends as [`Outcome::Unreachable`].
    #[must_use]
    pub fn within(problem: P, settings: Settings, most_actions: u32) -> Self {
        let start = problem.initial();
        Self::guided(problem, start, settings, most_actions, Guide::Bound)
    }

    /// The same from any state, led by something else than the bound: then plans need not be shortest.
    pub(super) fn guided(
        problem: P,
        start: P::State,
        settings: Settings,
        most_actions: u32,
        guide: Guide,
    ) -> Self {
        let mut search = Self {
            problem,
            settings,
            guide,
            most_actions,
            held: 0,
            nodes: Nodes { state: Vec::new(), facts: Vec::new() },
            index: Index::new(),
            open: Open::default(),
            expanded: 0,
            nearest: 0,
            leaps: Leaps::default(),
            takes_chances: false,
            plan: None,
            outcome: None,
        };
        let holds = |part: &usize| search.problem.part(*part, start) == Some(0);
        search.held = (0..search.problem.n_parts()).filter(holds).fold(0, |set, i| set | 1 << i);
        if let Some((left, score)) = search.judge(start, 0) {
            search.reach(start, Facts { parent: 0, cost: 0, left, waits: score });
        }
        search
    }

    /// A search for some way to the end on which all goes well, whatever may go wrong: led by the guess more than by the
    /// cost.
    pub(super) fn hopeful(problem: P, settings: Settings) -> Self {
        let start = problem.initial();
        let guided = Self::guided(problem, start, settings, u32::MAX, Guide::Guess(1, 5));
        Self { takes_chances: true, ..guided }
    }

    /// The problem that is searched.
    #[must_use]
    pub const fn problem(&self) -> &P {
        &self.problem
    }

    /// Looks for no plans from here on that need more actions.
    pub(super) fn limit(&mut self, most_actions: u32) {
        self.most_actions = self.most_actions.min(most_actions);
    }

    /// How many states were expanded so far, counted each time.
    #[must_use]
    pub const fn expanded(&self) -> u64 {
        self.expanded
    }

    /// How many states are kept.
    #[must_use]
    pub const fn kept(&self) -> usize {
        self.nodes.state.len()
    }

    /// A plan needs at least so many actions, as far as is proved; what is more than the most actions, for no plan.
    #[must_use]
    pub fn least(&self) -> u32 {
        let most = self.most_actions.saturating_add(1);
        match (self.guide, self.outcome) {
            (Guide::Bound | Guide::Guess(..), Some(Outcome::Unreachable)) => most,
            (Guide::Bound, _) => u32::try_from(self.open.least).unwrap_or(u32::MAX).min(most),
            _ => 0,
        }
    }

    /// The plan, when the search has ended as [`Outcome::Solved`]; when it ran out of its budget, the way to the state
    /// that seemed nearest to a terminal one.
    #[must_use]
    pub const fn plan(&self) -> Option<&Solution<P::State, P::Action>> {
        self.plan.as_ref()
    }

    fn expand(&mut self, n: usize) -> Option<Outcome> {
        let budget = self.settings.budget;
        for _ in 0..n {
            let Some(node) = self.open.pop() else { return Some(Outcome::Unreachable) };
            let score = self.open.least as u16;
            let facts = self.nodes.facts[node as usize];
            // Reached more cheaply since it was put here: it waits elsewhere, or is done.
            if facts.waits != score {
                continue;
            }
            // Nor is any other that is left.
            if self.guide == Guide::Bound && u32::from(score) > self.most_actions {
                return Some(Outcome::Unreachable);
            }
            let state = self.nodes.state[node as usize];
            if self.is_end(state) {
                self.plan = Some(self.plan_to(node));
                return Some(Outcome::Solved);
            }
            if self.expanded >= budget.steps || self.kept() >= budget.states {
                self.open.push(score, node);
                self.plan = self.toward();
                return Some(Outcome::Budget);
            }
            self.expanded += 1;
            if facts.left < self.nodes.facts[self.nearest as usize].left {
                self.nearest = node;
            }
            let Some(later) = self.leap(node, state, facts) else { return Some(Outcome::Unfit) };
            self.nodes.facts[node as usize].waits = later;
            if later != DONE {
                self.open.push(later, node);
            }
        }
        None
    }

    /// Whether this is what was looked for.
    fn is_end(&self, state: P::State) -> bool {
        let Guide::Part(index, _) = self.guide else { return self.problem.is_terminal(state) };
        let holds = |part: usize| self.problem.part(part, state) == Some(0);
        let held = (0..self.problem.n_parts()).filter(|part| self.held >> part & 1 == 1);
        holds(index) && held.into_iter().all(holds)
    }

    /// Keeps the successors whose turn it is; the score of the next ones, or `None` when it is the turn of what is not sure.
    fn leap(&mut self, node: u32, state: P::State, facts: Facts) -> Option<u16> {
        let is_first = self.score(facts.cost, facts.left) == facts.waits;
        let mut later = DONE;
        let mut leaps = std::mem::take(&mut self.leaps);
        leaps.clear();
        self.problem.leaps(state, &mut leaps);
        for (leap, ends) in leaps.iter() {
            let Some(cost) = u16::try_from(u32::from(facts.cost) + leap.cost).ok() else {
                continue;
            };
            // As if all went well.
            let judged = |end: &(P::State, f64)| {
                self.judge(end.0, cost).map(|(left, score)| (score, left, end.0))
            };
            let best = ends.iter().filter_map(judged).min_by_key(|&(score, left, _)| (score, left));
            let Some((score, left, end)) = best else { continue };
            if score > facts.waits {
                later = later.min(score);
            } else if !self.takes_chances && !leap.is_sure() {
                return None;
            } else if is_first || score == facts.waits {
                self.reach(end, Facts { parent: node, cost, left, waits: score });
            }
        }
        self.leaps = leaps;
        Some(later)
    }

    /// What is left from a state that costs so much to reach, and its score; `None` when it leads to no plan wanted.
    fn judge(&self, state: P::State, cost: u16) -> Option<(u16, u16)> {
        let bound = self.problem.heuristic(state)?;
        if u32::from(cost).saturating_add(bound) > self.most_actions {
            return None;
        }
        let left = match self.guide {
            Guide::Bound => bound,
            Guide::Guess(..) => self.problem.estimate(state)?,
            Guide::Part(index, _) => self.problem.part(index, state)?,
        };
        let left = u16::try_from(left).ok()?;
        Some((left, self.score(cost, left))).filter(|(_, score)| *score != DONE)
    }

    fn score(&self, cost: u16, left: u16) -> u16 {
        let (cost, left) = (u32::from(cost), u32::from(left));
        let score = match self.guide {
            Guide::Bound => cost + left,
            Guide::Part(_, bounds) => cost + bounds * left,
            Guide::Guess(costs, guesses) => costs * cost + guesses * left,
        };
        u16::try_from(score).unwrap_or(DONE)
    }

    /// Notes that `state` can be reached so, and opens it if that is news.
    fn reach(&mut self, state: P::State, facts: Facts) {
        let nodes = &mut self.nodes;
        let probe = self.index.probe(state);
        let node = match self.index.find(state, probe, &nodes.state) {
            Some(node) if facts.cost >= nodes.facts[node as usize].cost => return,
            Some(node) => {
                nodes.facts[node as usize] = facts;
                node
            }
            None => {
                let node = nodes.state.len() as Id;
                nodes.state.push(state);
                nodes.facts.push(facts);
                self.index.add(probe, &nodes.state);
                node
            }
        };
        self.open.push(facts.waits, node);
    }

    /// Whether a state was met.
    fn is_met(&self, state: P::State) -> bool {
        self.index.find(state, self.index.probe(state), &self.nodes.state).is_some()
    }

    /// Appends the actions of the shortest leap from one state to another.
    fn way(&self, from: P::State, to: P::State, out: &mut Vec<P::Action>) {
        let mut leaps = Leaps::default();
        self.problem.leaps(from, &mut leaps);
        let leads = |ends: &[(P::State, f64)]| ends.iter().any(|end| end.0 == to);
        let leading = leaps.iter().filter(|(_, ends)| leads(ends));
        if let Some((leap, _)) = leading.min_by_key(|(leap, _)| leap.cost) {
            self.problem.way(from, leap.number, out);
        }
    }

    /// The way to the state that seemed nearest to a terminal one.
    pub(super) fn toward(&self) -> Option<Solution<P::State, P::Action>> {
        (self.kept() > 0).then(|| self.plan_to(self.nearest))
    }

    fn plan_to(&self, node: u32) -> Solution<P::State, P::Action> {
        let mut ends = vec![node];
        let mut at = node;
        while self.nodes.facts[at as usize].cost > 0 {
            at = self.nodes.facts[at as usize].parent;
            ends.push(at);
        }
        ends.reverse();
        let state = |node: u32| self.nodes.state[node as usize];
        let mut plan = Solution { actions: Vec::new(), states: vec![state(ends[0])] };
        let mut outcomes = Vec::new();
        for leap in ends.windows(2) {
            let (mut from, to) = (state(leap[0]), state(leap[1]));
            let begun = plan.actions.len();
            self.way(from, to, &mut plan.actions);
            for &action in &plan.actions[begun..plan.actions.len().max(begun + 1) - 1] {
                outcomes.clear();
                self.problem.successors(from, action, &mut outcomes);
                from = outcomes.first().map_or(from, |outcome| outcome.0);
                plan.states.push(from);
            }
            plan.states.push(to);
        }
        plan.straighten();
        plan
    }
}

impl<P: Mdp> Policy<P::State, P::Action> for AStar<P> {
    fn action(&self, state: P::State) -> Option<P::Action> {
        self.plan.as_ref()?.action(state)
    }

    fn value(&self, state: P::State) -> Option<f64> {
        if self.problem.is_terminal(state) {
            return Some(1.0);
        }
        if self.problem.heuristic(state).is_none() {
            return Some(0.0);
        }
        if self.outcome == Some(Outcome::Unreachable) && self.most_actions == u32::MAX {
            return self.is_met(state).then_some(0.0);
        }
        let plan = self.plan.as_ref().filter(|_| self.outcome == Some(Outcome::Solved))?;
        Some(self.settings.worth(plan.left(state)?))
    }
}

impl<S: Copy + Ord, A: Copy> Solution<S, A> {
    /// Leaves out what leads back to where it was.
    fn straighten(&mut self) {
        let last: BTreeMap<S, usize> = self.states.iter().copied().zip(0..).collect();
        let (mut states, mut actions) = (Vec::new(), Vec::new());
        let mut at = 0;
        while let Some(&state) = self.states.get(at) {
            at = last.get(&state).map_or(at, |&last| last);
            states.push(state);
            actions.extend(self.actions.get(at));
            at += 1;
        }
        *self = Solution { actions, states };
    }

    /// The same, gone on with by another that begins where it ends.
    pub(super) fn extend(&mut self, other: &Self) {
        self.actions.extend_from_slice(&other.actions);
        self.states.extend(other.states.iter().skip(1));
        self.straighten();
    }

    /// What to do in a state on the way.
    pub fn action(&self, state: S) -> Option<A> {
        let at = self.states.iter().position(|s| *s == state)?;
        self.actions.get(at).copied()
    }

    /// The actions that are left from a state on the way.
    pub fn left(&self, state: S) -> Option<u32> {
        let at = self.states.iter().position(|s| *s == state)?;
        u32::try_from(self.actions.len() - at).ok()
    }
}

impl<P: Mdp> Solver<P::State, P::Action> for AStar<P> {
    fn name(&self) -> &'static str {
        "astar"
    }

    /// A step expands a state.
    fn step(&mut self, n: usize) -> Option<Outcome> {
        if self.outcome.is_none() {
            self.outcome = self.expand(n);
        }
        self.outcome
    }

    fn progress(&self) -> Progress {
        let (lower, upper) = match self.outcome {
            Some(Outcome::Solved) => {
                let value = self.value(self.problem.initial()).unwrap_or(0.0);
                (value, value)
            }
            Some(Outcome::Unreachable) => (0.0, 0.0),
            _ => (0.0, self.settings.worth(self.least())),
        };
        Progress {
            states: self.kept(),
            steps: self.expanded,
            backups: self.expanded * self.problem.actions().len() as u64,
            residual: f64::NAN,
            lower,
            upper,
            least: self.least(),
        }
    }
}
