//! The states of a problem that a solver has met, numbered in the order met, and the leaps from those that it has
//! expanded: flat arrays, outcomes in compressed rows. Chances to stay where one is are solved for on the way in:
//! V = R + γ p V + γ Σ p' V' is V = (R + γ Σ p' V') / (1 − γ p), so slips cost no iterations. States on the way of a leap
//! have no number; what is best there is seen by looking one leap ahead.
//! Invariant: what a state and its rows are depends on the problem and on the order of calls only.

use crate::mdp::{Leaps, Mdp};
use hashbrown::HashTable;
use rustc_hash::FxBuildHasher;
use std::hash::BuildHasher;
use std::ops::Range;

/// The number of a state.
pub(super) type Id = u32;

/// The bound of a state from which nothing terminal can be reached.
pub(super) const DEAD: u32 = u32::MAX;

/// So many outcomes need as much room as a state.
const OUTCOMES: usize = 4;
/// Most states that have numbers, whatever a budget says.
const MOST_STATES: usize = 1 << 30;

/// See the head of this file.
#[derive(Clone)]
pub(super) struct Graph<P: Mdp> {
    problem: P,
    discount: f64,
    states: Vec<P::State>,
    index: HashTable<Id>,
    /// Lower bounds on the actions to a terminal state: 0 for these alone, [`DEAD`] for never.
    bounds: Vec<u32>,
    /// The rows of each state; none before it is expanded.
    rows: Vec<Range<u32>>,
    /// What the problem knows the leap of each row by, and how many actions it takes when all goes well.
    numbers: Vec<u16>,
    costs: Vec<u16>,
    /// Where the outcomes of each row begin; one more than there are rows.
    starts: Vec<u32>,
    targets: Vec<Id>,
    /// The probability of each outcome, less what the way there costs, over what staying takes.
    weights: Vec<f64>,
    leaps: Leaps<P::State>,
}

impl<P: Mdp> Graph<P> {
    /// The initial state alone, as number 0.
    pub(super) fn new(problem: P, discount: f64) -> Self {
        let mut graph = Self {
            problem,
            discount,
            states: Vec::new(),
            index: HashTable::new(),
            bounds: Vec::new(),
            rows: Vec::new(),
            numbers: Vec::new(),
            costs: Vec::new(),
            starts: vec![0],
            targets: Vec::new(),
            weights: Vec::new(),
            leaps: Leaps::default(),
        };
        let initial = graph.problem.initial();
        graph.intern(initial);
        graph
    }

    pub(super) const fn problem(&self) -> &P {
        &self.problem
    }

    /// How many states there are.
    pub(super) const fn len(&self) -> usize {
        self.states.len()
    }

    /// Whether no more states fit a budget.
    pub(super) fn is_full(&self, most: usize) -> bool {
        self.len() + self.targets.len() / OUTCOMES >= most.min(MOST_STATES)
    }

    pub(super) fn state(&self, id: Id) -> P::State {
        self.states[id as usize]
    }

    pub(super) fn is_terminal(&self, id: Id) -> bool {
        self.bounds[id as usize] == 0
    }

    pub(super) fn is_dead(&self, id: Id) -> bool {
        self.bounds[id as usize] == DEAD
    }

    /// At least so many actions lead to a terminal state.
    pub(super) fn bound(&self, id: Id) -> u32 {
        self.bounds[id as usize]
    }

    /// What [`Graph::bound`] says of the initial state; 0 when nothing can be reached.
    pub(super) fn least(&self) -> u32 {
        if self.is_dead(0) { 0 } else { self.bound(0) }
    }

    /// What a state that is not terminal is worth at most.
    pub(super) fn most(&self, id: Id) -> f64 {
        self.problem.most(self.state(id), self.discount)
    }

    /// The number of a state that was met.
    pub(super) fn find(&self, state: P::State) -> Option<Id> {
        let key = FxBuildHasher.hash_one(state);
        self.index.find(key, |&id| self.states[id as usize] == state).copied()
    }

    /// The rows of a state; none unless it was expanded, and none that leaves it where it is or leads to death alone.
    pub(super) fn rows(&self, id: Id) -> Range<usize> {
        let Range { start, end } = self.rows[id as usize];
        start as usize..end as usize
    }

    /// The first action of a row of a state.
    pub(super) fn action(&self, id: Id, row: usize) -> Option<P::Action> {
        self.first(self.state(id), self.numbers[row])
    }

    /// The first action of a leap.
    fn first(&self, state: P::State, number: u16) -> Option<P::Action> {
        let mut way = Vec::new();
        self.problem.way(state, number, &mut way);
        way.first().copied()
    }

    /// How many actions a row takes when all goes well.
    pub(super) fn cost(&self, row: usize) -> u32 {
        u32::from(self.costs[row])
    }

    /// The outcomes of a row, as numbers of edges.
    pub(super) fn edges(&self, row: usize) -> Range<usize> {
        self.starts[row] as usize..self.starts[row + 1] as usize
    }

    /// Where an edge leads.
    pub(super) fn target(&self, edge: usize) -> Id {
        self.targets[edge]
    }

    /// The weight of an edge: a probability, less what the way there costs, over what staying takes.
    pub(super) fn weight(&self, edge: usize) -> f64 {
        self.weights[edge]
    }

    /// The outcomes of a row, each with its weight.
    #[inline]
    pub(super) fn outcomes(&self, row: usize) -> impl Iterator<Item = (Id, f64)> {
        let edges = self.edges(row);
        self.targets[edges.clone()].iter().copied().zip(self.weights[edges].iter().copied())
    }

    /// The sum of the weights of a row: 1, but for what the way costs and what staying takes.
    pub(super) fn row_weight(&self, row: usize) -> f64 {
        self.weights[self.edges(row)].iter().sum()
    }

    /// How many rows there are.
    pub(super) const fn n_rows(&self) -> usize {
        self.numbers.len()
    }

    /// What a row is worth when it is worth `worth` to arrive at a state.
    #[inline]
    pub(super) fn row_worth(&self, row: usize, worth: impl Fn(Id) -> f64) -> f64 {
        let (start, end) = (self.starts[row] as usize, self.starts[row + 1] as usize);
        let targets = &self.targets[start..end];
        let weights = &self.weights[start..end];
        let mut sum = 0.0;
        for (&target, &weight) in targets.iter().zip(weights) {
            sum += weight * worth(target);
        }
        sum
    }

    /// The best row of a state and its worth; the first of equals; `None` when no row is worth anything.
    pub(super) fn best(&self, id: Id, worth: impl Fn(Id) -> f64) -> Option<(usize, f64)> {
        let mut best = None;
        let mut most = 0.0;
        for row in self.rows(id) {
            let value = self.row_worth(row, &worth);
            if value > most {
                most = value;
                best = Some((row, value));
            }
        }
        best
    }

    /// What is best in a state without a number, or without rows: the leap whose outcomes that have numbers are worth most,
    /// by what it is worth to arrive there; its first action, and its worth. `None` when none is worth anything.
    pub(super) fn look(
        &self,
        state: P::State,
        worth: impl Fn(Id) -> f64,
    ) -> Option<(P::Action, f64)> {
        let mut leaps = Leaps::default();
        self.problem.leaps(state, &mut leaps);
        let mut best = None;
        let mut most = 0.0;
        for (leap, ends) in leaps.iter() {
            let worth = |&(end, p): &(P::State, f64)| match self.find(end) {
                Some(id) => p * worth(id),
                // The nearest terminal state is another one than from where leaps begin.
                None if self.problem.is_terminal(end) => p,
                None => 0.0,
            };
            let value = leap.scale(self.discount) * ends.iter().map(worth).sum::<f64>();
            if value > most {
                most = value;
                best = Some((leap.number, value));
            }
        }
        best.and_then(|(number, value)| Some((self.first(state, number)?, value)))
    }

    /// Works out the leaps from a state. Their outcomes are numbered on the way.
    pub(super) fn expand(&mut self, id: Id) {
        let state = self.state(id);
        let first = self.numbers.len();
        let mut leaps = std::mem::take(&mut self.leaps);
        leaps.clear();
        self.problem.leaps(state, &mut leaps);
        for (leap, ends) in leaps.iter() {
            let begin = self.targets.len();
            let scale = leap.scale(self.discount);
            let mut is_useful = false;
            for &(next, probability) in ends {
                let target = self.intern(next);
                is_useful |= !self.is_dead(target);
                self.targets.push(target);
                self.weights.push(scale * probability);
            }
            if !is_useful {
                self.targets.truncate(begin);
                self.weights.truncate(begin);
                continue;
            }
            self.numbers.push(leap.number);
            self.costs.push(u16::try_from(leap.cost).unwrap_or(u16::MAX));
            self.starts.push(self.targets.len() as u32);
        }
        self.leaps = leaps;
        self.rows[id as usize] = first as u32..self.numbers.len() as u32;
    }

    /// The number of a state, which it is given if it has none.
    fn intern(&mut self, state: P::State) -> Id {
        let hash = |s: &P::State| FxBuildHasher.hash_one(s);
        let (key, states) = (hash(&state), &self.states);
        if let Some(&id) = self.index.find(key, |&id| states[id as usize] == state) {
            return id;
        }
        let bound = if self.problem.is_terminal(state) {
            0
        } else {
            self.problem.heuristic(state).map_or(DEAD, |bound| bound.clamp(1, DEAD - 1))
        };
        let id = self.states.len() as Id;
        self.states.push(state);
        let states = &self.states;
        self.index.insert_unique(key, id, |&id| hash(&states[id as usize]));
        self.bounds.push(bound);
        self.rows.push(0..0);
        id
    }
}
