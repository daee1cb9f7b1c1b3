//! A* (Hart, Nilsson and Raphael 1968) over deterministic problems, as a search that can be pumped.
//! Every action costs 1. Nodes are structure of arrays, found through one hash index of u32; an edge
//! allocates nothing of its own. Invariants: with an admissible bound the plan is shortest; ties fall to
//! the node found last among those of the least bound, so the same problem gives the same plan.

use crate::mdp::Mdp;
use hashbrown::HashTable;
use rustc_hash::FxBuildHasher;
use std::hash::BuildHasher;

/// When to give up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Most states to expand.
    pub expanded: usize,
    /// Most states to keep.
    pub kept: usize,
}

impl Default for Budget {
    /// Ten million states kept: some 600 MB, and tens of seconds.
    fn default() -> Self {
        Self { expanded: 10_000_000, kept: 10_000_000 }
    }
}

/// How a search ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome<S, A> {
    /// A shortest plan.
    Plan(Solution<S, A>),
    /// There is no plan (of the length allowed): everything within reach was looked at.
    Unreachable,
    /// The budget ran out first.
    Budget,
    /// An action has several outcomes: this is a problem for another solver.
    Stochastic,
}

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
    budget: Budget,
    /// Plans that need more actions are not looked for.
    most_actions: u32,
    nodes: Nodes<P::State>,
    index: HashTable<u32>,
    open: Open,
    expanded: usize,
    buffer: Vec<(P::State, f64)>,
    outcome: Option<Outcome<P::State, P::Action>>,
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
    fn push(&mut self, sum: u32, node: u32, cost: u32) {
        let sum = sum as usize;
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
    pub fn new(problem: P, budget: Budget) -> Self {
        Self::within(problem, budget, u32::MAX)
    }

    /// A search for a plan of at most so many actions; when there is none, it ends as [`Outcome::Unreachable`].
    #[must_use]
    pub fn within(problem: P, budget: Budget, most_actions: u32) -> Self {
        let nodes = Nodes {
            state: Vec::new(),
            cost: Vec::new(),
            bound: Vec::new(),
            parent: Vec::new(),
            action: Vec::new(),
        };
        let mut search = Self {
            problem,
            budget,
            most_actions,
            nodes,
            index: HashTable::new(),
            open: Open::default(),
            expanded: 0,
            buffer: Vec::new(),
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
    pub const fn expanded(&self) -> usize {
        self.expanded
    }

    /// How many states are kept.
    #[must_use]
    pub const fn kept(&self) -> usize {
        self.nodes.state.len()
    }

    /// Runs until the search ends.
    pub fn run(&mut self) -> Outcome<P::State, P::Action> {
        loop {
            if let Some(outcome) = self.step(usize::MAX) {
                return outcome;
            }
        }
    }

    /// Expands at most `n` states more; `Some` when the search has ended, which it then stays.
    pub fn step(&mut self, n: usize) -> Option<Outcome<P::State, P::Action>> {
        if self.outcome.is_none() {
            self.outcome = self.expand(n);
        }
        self.outcome.clone()
    }

    fn expand(&mut self, n: usize) -> Option<Outcome<P::State, P::Action>> {
        for _ in 0..n {
            let Some((node, cost)) = self.open.pop() else { return Some(Outcome::Unreachable) };
            // Reached more cheaply since it was put here: that entry stands elsewhere.
            if self.nodes.cost[node as usize] < cost {
                continue;
            }
            let state = self.nodes.state[node as usize];
            if self.problem.is_terminal(state) {
                return Some(Outcome::Plan(self.plan_to(node)));
            }
            if self.expanded >= self.budget.expanded || self.kept() >= self.budget.kept {
                return Some(Outcome::Budget);
            }
            self.expanded += 1;
            for number in 0..self.problem.actions().len() {
                let action = self.problem.actions()[number];
                self.buffer.clear();
                self.problem.successors(state, action, &mut self.buffer);
                let [(next, _)] = self.buffer[..] else { return Some(Outcome::Stochastic) };
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
            self.open.push(cost + bound, node, cost);
        }
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
