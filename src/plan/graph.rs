//! The states of a problem that a solver has met, numbered in the order met, and what actions do in those that it has
//! expanded: flat arrays, successors in compressed rows. Chances to stay where one is are solved for on the way in:
//! V = R + γ p V + γ Σ p' V' is V = (R + γ Σ p' V') / (1 − γ p), so slips cost no iterations.
//! Invariant: what a state and its rows are depends on the problem and on the order of calls only.

use super::numbers::{Id, Numbers};
use crate::mdp::Mdp;
use std::ops::Range;

/// The bound of a state from which nothing terminal can be reached.
pub(super) const DEAD: u32 = u32::MAX;

/// Most states that have numbers, whatever a budget says.
const MOST_STATES: usize = 1 << 30;

/// See the head of this file.
#[derive(Clone)]
pub(super) struct Graph<P: Mdp> {
    problem: P,
    discount: f64,
    states: Vec<P::State>,
    numbers: Numbers<P>,
    /// Lower bounds on the actions to a terminal state: 0 for these alone, [`DEAD`] for never.
    bounds: Vec<u32>,
    /// The rows of each state; none before it is expanded.
    rows: Vec<Range<u32>>,
    /// The action of each row, by its number.
    actions: Vec<u8>,
    /// Where the outcomes of each row begin; one more than there are rows.
    starts: Vec<u32>,
    targets: Vec<Id>,
    /// The probability of each outcome, over what staying takes.
    weights: Vec<f64>,
    buffer: Vec<(P::State, f64)>,
}

impl<P: Mdp> Graph<P> {
    /// The initial state alone, as number 0. For who meets nearly all states, numbers are in blocks of 2 to the power of
    /// `bits`.
    pub(super) fn new(problem: P, discount: f64, bits: u32) -> Self {
        let mut graph = Self {
            problem,
            discount,
            states: Vec::new(),
            numbers: Numbers::new(bits),
            bounds: Vec::new(),
            rows: Vec::new(),
            actions: Vec::new(),
            starts: vec![0],
            targets: Vec::new(),
            weights: Vec::new(),
            buffer: Vec::new(),
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
        self.len() >= most.min(MOST_STATES)
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
        self.numbers.find(&self.problem, state)
    }

    /// The rows of a state; none unless it was expanded, and none that leaves it where it is or leads to death alone.
    pub(super) fn rows(&self, id: Id) -> Range<usize> {
        let Range { start, end } = self.rows[id as usize];
        start as usize..end as usize
    }

    /// The action of a row.
    pub(super) fn action(&self, row: usize) -> P::Action {
        self.problem.actions()[usize::from(self.actions[row])]
    }

    /// The outcomes of a row, as numbers of edges.
    pub(super) fn edges(&self, row: usize) -> Range<usize> {
        self.starts[row] as usize..self.starts[row + 1] as usize
    }

    /// Where an edge leads.
    pub(super) fn target(&self, edge: usize) -> Id {
        self.targets[edge]
    }

    /// The weight of an edge: a probability, over what staying takes.
    pub(super) fn weight(&self, edge: usize) -> f64 {
        self.weights[edge]
    }

    /// The sum of the weights of a row: 1, or less where staying takes a part.
    pub(super) fn row_weight(&self, row: usize) -> f64 {
        self.weights[self.edges(row)].iter().sum()
    }

    /// How many rows there are.
    pub(super) const fn n_rows(&self) -> usize {
        self.actions.len()
    }

    /// How many edges there are.
    pub(super) const fn n_edges(&self) -> usize {
        self.targets.len()
    }

    /// What a row is worth when arriving at each state is worth `worth`.
    #[inline]
    pub(super) fn row_worth(&self, row: usize, worth: &[f64]) -> f64 {
        let (start, end) = (self.starts[row] as usize, self.starts[row + 1] as usize);
        let targets = &self.targets[start..end];
        let weights = &self.weights[start..end];
        let mut sum = 0.0;
        for (&target, &weight) in targets.iter().zip(weights) {
            sum += weight * worth[target as usize];
        }
        sum
    }

    /// The best row of a state and its worth; the first of equals; `None` when no row is worth anything.
    pub(super) fn best(&self, id: Id, worth: &[f64]) -> Option<(usize, f64)> {
        let mut best = None;
        let mut most = 0.0;
        for row in self.rows(id) {
            let value = self.row_worth(row, worth);
            if value > most {
                most = value;
                best = Some((row, value));
            }
        }
        best
    }

    /// Works out what actions do in a state. Its successors are numbered on the way.
    pub(super) fn expand(&mut self, id: Id) {
        let state = self.state(id);
        let first = self.actions.len();
        let mut buffer = std::mem::take(&mut self.buffer);
        for number in 0..self.problem.actions().len() {
            buffer.clear();
            self.problem.successors(state, self.problem.actions()[number], &mut buffer);
            let mut stay = 0.0;
            let mut is_useful = false;
            let begin = self.targets.len();
            for &(next, probability) in &buffer {
                if next == state {
                    stay += probability;
                    continue;
                }
                let target = self.intern(next);
                is_useful |= !self.is_dead(target);
                self.targets.push(target);
                self.weights.push(probability);
            }
            if !is_useful {
                self.targets.truncate(begin);
                self.weights.truncate(begin);
                continue;
            }
            if stay > 0.0 {
                let scale = 1.0 - self.discount * stay;
                self.weights[begin..].iter_mut().for_each(|weight| *weight /= scale);
            }
            self.actions.push(number as u8);
            self.starts.push(self.targets.len() as u32);
        }
        self.buffer = buffer;
        self.rows[id as usize] = first as u32..self.actions.len() as u32;
    }

    /// The number of a state, which it is given if it has none.
    fn intern(&mut self, state: P::State) -> Id {
        let next = self.states.len() as Id;
        let id = self.numbers.number(&self.problem, state, next);
        if id < next {
            return id;
        }
        let bound = if self.problem.is_terminal(state) {
            0
        } else {
            self.problem.heuristic(state).map_or(DEAD, |bound| bound.clamp(1, DEAD - 1))
        };
        self.states.push(state);
        self.bounds.push(bound);
        self.rows.push(0..0);
        id
    }
}
