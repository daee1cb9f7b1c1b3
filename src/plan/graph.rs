//! The states of a problem that a solver has met, numbered in the order met, and the leaps from those that it has
//! expanded: flat arrays, a row of outcomes for each leap. Chances to stay where one is are solved for on the way in:
//! V = R + γ p V + γ Σ p' V' is V = (R + γ Σ p' V') / (1 − γ p), so slips cost no iterations. States on the way of a leap
//! have no number; what is best there is seen by looking one leap ahead.
//! Invariant: what a state and its rows are depends on the problem and on the order of calls only.

use super::index::{Id, Index, Probe};
use super::weights::{Edge, Weights};
use crate::mdp::{Leaps, Mdp};
use std::ops::Range;

/// The bound of a state from which nothing terminal can be reached.
pub(super) const DEAD: u32 = u32::MAX;

/// So many outcomes need as much room as a state.
const OUTCOMES: usize = 4;
/// Most states that have numbers, whatever a budget says.
const MOST_STATES: usize = 1 << 30;

/// See the head of this file. A row is known by the number of its first outcome.
#[derive(Clone)]
pub(super) struct Graph<P: Mdp> {
    problem: P,
    discount: f64,
    states: Vec<P::State>,
    index: Index,
    /// Lower bounds on the actions to a terminal state: 0 for these alone, [`DEAD`] for never.
    bounds: Vec<u32>,
    /// The outcomes of each state, row by row; none before it is expanded.
    rows: Vec<Range<u32>>,
    edges: Vec<Edge>,
    /// By outcome, what the problem knows its leap by.
    numbers: Vec<u16>,
    weights: Weights,
    /// Room for what is looked up.
    leaps: Leaps<P::State>,
    probes: Vec<Probe>,
}

impl<P: Mdp> Graph<P> {
    /// The initial state alone, as number 0.
    pub(super) fn new(problem: P, discount: f64) -> Self {
        let mut graph = Self {
            problem,
            discount,
            states: Vec::new(),
            index: Index::new(),
            bounds: Vec::new(),
            rows: Vec::new(),
            edges: Vec::new(),
            numbers: Vec::new(),
            weights: Weights::new(discount),
            leaps: Leaps::default(),
            probes: Vec::new(),
        };
        let initial = graph.problem.initial();
        graph.intern(initial, graph.index.probe(initial));
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
        self.len() + self.edges.len() / OUTCOMES >= most.min(MOST_STATES)
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
        self.index.find(state, self.index.probe(state), &self.states)
    }

    /// The rows of a state; none unless it was expanded, and none that leaves it where it is or leads to death alone.
    pub(super) fn rows(&self, id: Id) -> impl Iterator<Item = usize> {
        self.rows_with_outcomes(id).map(|(row, _)| row)
    }

    /// The same, each with its outcomes and their weights.
    #[inline]
    pub(super) fn rows_with_outcomes(
        &self,
        id: Id,
    ) -> impl Iterator<Item = (usize, impl Iterator<Item = (Id, f64)>)> {
        let all = self.row_range(id);
        let mut next = all.start;
        self.edges[all].split_inclusive(|edge| edge.is_last()).map(move |outcomes| {
            let row = next;
            next += outcomes.len();
            (row, self.weighed(outcomes))
        })
    }

    #[inline]
    fn weighed(&self, outcomes: &[Edge]) -> impl Iterator<Item = (Id, f64)> {
        outcomes.iter().map(|&edge| (edge.target, self.weights.get(edge)))
    }

    /// The outcomes of all rows of a state.
    fn row_range(&self, id: Id) -> Range<usize> {
        let Range { start, end } = self.rows[id as usize];
        start as usize..end as usize
    }

    /// Whether a state has rows.
    pub(super) fn has_rows(&self, id: Id) -> bool {
        !self.rows[id as usize].is_empty()
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

    /// Where the outcomes of a state lead, each with how many actions it takes when all goes well.
    pub(super) fn ways(&self, id: Id) -> impl Iterator<Item = (Id, u32)> {
        let edges = &self.edges[self.row_range(id)];
        edges.iter().map(|&edge| (edge.target, self.weights.cost(edge)))
    }

    /// The outcomes of a row, by their numbers.
    pub(super) fn edges(&self, row: usize) -> Range<usize> {
        let rest = self.edges[row..].iter().position(|edge| edge.is_last());
        row..row + rest.map_or(0, |last| last + 1)
    }

    /// Where an outcome leads.
    pub(super) fn target(&self, edge: usize) -> Id {
        self.edges[edge].target
    }

    /// The weight of an outcome: a probability, less what the way there costs, over what staying takes.
    pub(super) fn weight(&self, edge: usize) -> f64 {
        self.weights.get(self.edges[edge])
    }

    /// The outcomes of a row, each with its weight.
    #[inline]
    pub(super) fn outcomes(&self, row: usize) -> impl Iterator<Item = (Id, f64)> {
        self.weighed(&self.edges[self.edges(row)])
    }

    /// The sum of the weights of a row: 1, but for what the way costs and what staying takes.
    pub(super) fn row_weight(&self, row: usize) -> f64 {
        self.outcomes(row).map(|(_, weight)| weight).sum()
    }

    /// How many outcomes there are.
    pub(super) const fn n_edges(&self) -> usize {
        self.edges.len()
    }

    /// The best row of a state and its worth, by what it is worth to arrive at a state; the first of equals; `None` when no
    /// row is worth anything.
    pub(super) fn best(&self, id: Id, worth: impl Fn(Id) -> f64) -> Option<(usize, f64)> {
        let mut best = None;
        let mut most = 0.0;
        for (row, outcomes) in self.rows_with_outcomes(id) {
            let mut sum = 0.0;
            for (target, weight) in outcomes {
                sum += weight * worth(target);
            }
            if sum > most {
                most = sum;
                best = Some((row, sum));
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
        let first = self.edges.len();
        let mut leaps = std::mem::take(&mut self.leaps);
        let mut probes = std::mem::take(&mut self.probes);
        leaps.clear();
        self.problem.leaps(state, &mut leaps);
        self.index.reserve(leaps.ends.len(), &self.states);
        probes.clear();
        probes.extend(leaps.ends.iter().map(|&(end, _)| self.index.probe(end)));
        for (leap, ends) in leaps.iter() {
            let begin = self.edges.len();
            let mut is_useful = false;
            for (&(next, probability), &probe) in ends.iter().zip(&probes[leap.ends.clone()]) {
                let target = self.intern(next, probe);
                is_useful |= !self.is_dead(target);
                let weight = self.weights.of(leap, probability);
                self.edges.push(Edge::new(target, weight));
                self.numbers.push(leap.number);
            }
            if !is_useful {
                self.edges.truncate(begin);
                self.numbers.truncate(begin);
            } else if let Some(last) = self.edges.last_mut() {
                last.end_row();
            }
        }
        (self.leaps, self.probes) = (leaps, probes);
        self.rows[id as usize] = first as u32..self.edges.len() as u32;
    }

    /// The number of a state, which it is given if it has none; there must be room for it in the index.
    fn intern(&mut self, state: P::State, probe: Probe) -> Id {
        if let Some(id) = self.index.find(state, probe, &self.states) {
            return id;
        }
        let bound = if self.problem.is_terminal(state) {
            0
        } else {
            self.problem.heuristic(state).map_or(DEAD, |bound| bound.clamp(1, DEAD - 1))
        };
        let id = self.states.len() as Id;
        self.states.push(state);
        self.index.add(probe, &self.states);
        self.bounds.push(bound);
        self.rows.push(0..0);
        id
    }
}
