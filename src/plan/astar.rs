//! A* (Hart, Nilsson and Raphael 1968) over deterministic problems, as a search that can be pumped.
//! Every action costs 1. Nodes are structure of arrays, found through one hash index of u32; an edge
//! allocates nothing of its own. Invariants: with an admissible bound the plan is shortest; ties fall to
//! the node found last among those of the least bound, so the same problem gives the same plan.

use crate::mdp::{Mdp, Outcome, Policy, Progress, Settings, Solver};
use hashbrown::HashTable;
use rustc_hash::FxBuildHasher;
use std::hash::BuildHasher;

/// A plan: one state more than actions, from the initial to a terminal one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Solution<S, A> {
    /// What to do, in order.
    pub actions: Vec<A>,
    /// Where that leads, the initial state first.
    pub states: Vec<S>,
}

/// A search at work.
#[derive(Clone, Debug)]
pub struct AStar<P: Mdp> {
    problem: P,
    settings: Settings,
    /// Plans that need more actions are not looked for.
    most_actions: u32,
    nodes: Nodes<P::State>,
    index: HashTable<u32>,
    open: Open,
    expanded: u64,
    /// The node with the least bound among those expanded.
    nearest: u32,
    buffer: Vec<(P::State, f64)>,
    plan: Option<Solution<P::State, P::Action>>,
    outcome: Option<Outcome>,
}

/// All states met, in the order met.
#[derive(Clone, Debug)]
struct Nodes<S> {
    state: Vec<S>,
    /// Actions from the initial state, as far as is known.
    cost: Vec<u32>,
    /// The problem's bound on the rest.
    bound: Vec<Option<u32>>,
    /// The node it was reached from, by which action; itself for the first.
    parent: Vec<u32>,
    action: Vec<u8>,
}

/// Open nodes with their cost when they were put in, in one stack for every sum of cost and bound.
#[derive(Clone, Debug, Default)]
struct Open {
    stacks: Vec<Vec<(u32, u32)>>,
    least: usize,
}

impl Open {
    fn push(&mut self, sum: usize, node: u32, cost: u32) {
        if self.stacks.len() <= sum {
            self.stacks.resize_with(sum + 1, Vec::new);
        }
        self.stacks[sum].push((node, cost));
        self.least = self.least.min(sum);
    }

    fn pop(&mut self) -> Option<(u32, u32)> {
        while let Some(stack) = self.stacks.get_mut(self.least) {
            if let Some(top) = stack.pop() {
                return Some(top);
            }
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
        let nodes = Nodes {
            state: Vec::new(),
            cost: Vec::new(),
            bound: Vec::new(),
            parent: Vec::new(),
            action: Vec::new(),
        };
        let mut search = Self {
            problem,
            settings,
            most_actions,
            nodes,
            index: HashTable::new(),
            open: Open::default(),
            expanded: 0,
            nearest: 0,
            buffer: Vec::new(),
            plan: None,
            outcome: None,
        };
        let initial = search.problem.initial();
        search.reach(initial, 0, 0, 0);
        search
    }

    /// The problem that is searched.
    #[must_use]
    pub const fn problem(&self) -> &P {
        &self.problem
    }

    /// How many states were expanded so far.
    #[must_use]
    pub const fn expanded(&self) -> u64 {
        self.expanded
    }

    /// How many states are kept.
    #[must_use]
    pub const fn kept(&self) -> usize {
        self.nodes.state.len()
    }

    /// The shortest plan, when the search has ended as [`Outcome::Solved`]; when it ran out of its budget, the way to
    /// the state that seemed nearest to a terminal one.
    #[must_use]
    pub const fn plan(&self) -> Option<&Solution<P::State, P::Action>> {
        self.plan.as_ref()
    }

    fn expand(&mut self, n: usize) -> Option<Outcome> {
        for _ in 0..n {
            let Some((node, cost)) = self.open.pop() else { return Some(Outcome::Unreachable) };
            // Reached more cheaply since it was put here: that entry stands elsewhere.
            if self.nodes.cost[node as usize] < cost {
                continue;
            }
            let state = self.nodes.state[node as usize];
            if self.problem.is_terminal(state) {
                self.plan = Some(self.plan_to(node));
                return Some(Outcome::Solved);
            }
            let budget = self.settings.budget;
            if self.expanded >= budget.steps || self.kept() >= budget.states {
                self.open.push(self.open.least, node, cost);
                self.plan = Some(self.plan_to(self.nearest));
                return Some(Outcome::Budget);
            }
            self.expanded += 1;
            if self.nodes.bound[node as usize] < self.nodes.bound[self.nearest as usize] {
                self.nearest = node;
            }
            for number in 0..self.problem.actions().len() {
                let action = self.problem.actions()[number];
                self.buffer.clear();
                self.problem.successors(state, action, &mut self.buffer);
                let [(next, _)] = self.buffer[..] else { return Some(Outcome::Unfit) };
                if next != state {
                    self.reach(next, cost + 1, node, number as u8);
                }
            }
        }
        None
    }

    /// Notes that `state` can be reached at `cost`, and opens it if that is news.
    fn reach(&mut self, state: P::State, cost: u32, parent: u32, action: u8) {
        let hash = |s: &P::State| FxBuildHasher.hash_one(s);
        let nodes = &mut self.nodes;
        let key = hash(&state);
        if let Some(&node) = self.index.find(key, |&n| nodes.state[n as usize] == state) {
            let i = node as usize;
            if let Some(bound) = nodes.bound[i]
                && cost < nodes.cost[i]
            {
                nodes.cost[i] = cost;
                nodes.parent[i] = parent;
                nodes.action[i] = action;
                self.open(node, cost, bound);
            }
            return;
        }
        let Ok(node) = u32::try_from(nodes.state.len()) else { return };
        let bound = self.problem.heuristic(state);
        nodes.state.push(state);
        nodes.cost.push(cost);
        nodes.bound.push(bound);
        nodes.parent.push(parent);
        nodes.action.push(action);
        self.index.insert_unique(key, node, |&n| hash(&nodes.state[n as usize]));
        if let Some(bound) = bound {
            self.open(node, cost, bound);
        }
    }

    /// Puts a node among the open ones, unless every plan through it is too long.
    fn open(&mut self, node: u32, cost: u32, bound: u32) {
        if cost + bound <= self.most_actions {
            self.open.push((cost + bound) as usize, node, cost);
        }
    }

    /// Whether a state was met.
    fn is_met(&self, state: P::State) -> bool {
        let key = FxBuildHasher.hash_one(state);
        self.index.find(key, |&n| self.nodes.state[n as usize] == state).is_some()
    }

    fn plan_to(&self, node: u32) -> Solution<P::State, P::Action> {
        let mut states = vec![self.nodes.state[node as usize]];
        let mut actions = Vec::new();
        let mut i = node as usize;
        while self.nodes.cost[i] > 0 {
            actions.push(self.problem.actions()[usize::from(self.nodes.action[i])]);
            i = self.nodes.parent[i] as usize;
            states.push(self.nodes.state[i]);
        }
        actions.reverse();
        states.reverse();
        Solution { actions, states }
    }
}

impl<P: Mdp> Policy<P::State, P::Action> for AStar<P> {
    fn action(&self, state: P::State) -> Option<P::Action> {
        let plan = self.plan.as_ref()?;
        let at = plan.states.iter().position(|&s| s == state)?;
        plan.actions.get(at).copied()
    }

    fn value(&self, state: P::State) -> Option<f64> {
        if self.problem.is_terminal(state) {
            return Some(1.0);
        }
        if self.outcome == Some(Outcome::Unreachable) && self.most_actions == u32::MAX {
            return self.is_met(state).then_some(0.0);
        }
        let plan = self.plan.as_ref().filter(|_| self.outcome == Some(Outcome::Solved))?;
        let at = plan.states.iter().position(|&s| s == state)?;
        Some(self.settings.worth(u32::try_from(plan.actions.len() - at).ok()?))
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
            _ => (0.0, self.settings.worth(u32::try_from(self.open.least).unwrap_or(u32::MAX))),
        };
        Progress {
            states: self.kept(),
            steps: self.expanded,
            backups: self.expanded * self.problem.actions().len() as u64,
            residual: f64::NAN,
            lower,
            upper,
        }
    }
}
