//! Value iteration over the ends of leaps that can be reached (Bellman 1957): all are numbered once, ordered by their
//! distance to the goal, and swept in that order with new values used at once (Gauss–Seidel), from below.
//! It ends when γ / (1 − γ) times the largest change of a sweep is at most ε. Sure worlds are solved by one sweep.
//! Values are discounted rewards in [0, 1]. A step expands, orders or backs up one state.

use super::graph::Graph;
use super::index::Id;
use super::order::Order;
use crate::mdp::{Mdp, Outcome, Policy, Progress, Settings, Solver};

/// A solver at work.
#[derive(Clone)]
pub struct ValueIteration<P: Mdp> {
    graph: Graph<P>,
    settings: Settings,
    stage: Stage,
    /// How far the stage is.
    cursor: usize,
    /// Whether the budget did not allow for all states.
    is_partial: bool,
    /// Whether that is the end.
    wants_all: bool,
    /// Kept until states are ordered.
    ordering: Order,
    /// States that can reach a terminal one, nearest first, terminal ones left out.
    order: Vec<Id>,
    /// What it is worth to arrive: 1 at a terminal state, else γ V.
    worth: Vec<f64>,
    /// The largest change of a value, in this sweep and in the last whole one.
    change: f64,
    residual: f64,
    /// What the initial state is worth at most.
    upper: f64,
    steps: u64,
    backups: u64,
    sweeps: u32,
    outcome: Option<Outcome>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Expand,
    Order,
    Sweep,
}

impl<P: Mdp> ValueIteration<P> {
    /// A solver that has done nothing yet.
    #[must_use]
    pub fn new(problem: P, settings: Settings) -> Self {
        let graph = Graph::new(problem, settings.discount);
        Self {
            upper: if graph.is_dead(0) { 0.0 } else { settings.worth(graph.bound(0)) },
            graph,
            settings,
            stage: Stage::Expand,
            cursor: 0,
            is_partial: false,
            wants_all: false,
            ordering: Order::default(),
            order: Vec::new(),
            worth: Vec::new(),
            change: 0.0,
            residual: f64::NAN,
            steps: 0,
            backups: 0,
            sweeps: 0,
            outcome: None,
        }
    }

    /// A solver that ends as soon as there are more states than the budget allows.
    #[must_use]
    pub fn whole(problem: P, settings: Settings) -> Self {
        Self { wants_all: true, ..Self::new(problem, settings) }
    }

    /// The problem that is solved.
    #[must_use]
    pub const fn problem(&self) -> &P {
        self.graph.problem()
    }

    /// Whether there were more states than the budget allows; values are then bounds from below.
    #[must_use]
    pub const fn is_partial(&self) -> bool {
        self.is_partial
    }

    /// How many times all states were backed up.
    #[must_use]
    pub const fn sweeps(&self) -> u32 {
        self.sweeps
    }

    fn advance(&mut self) -> Option<Outcome> {
        if self.graph.is_terminal(0) {
            return Some(Outcome::Solved);
        }
        if self.graph.is_dead(0) {
            return Some(Outcome::Unreachable);
        }
        if self.steps >= self.settings.budget.steps {
            return Some(Outcome::Budget);
        }
        match self.stage {
            Stage::Expand => self.expand(),
            Stage::Order => self.order(),
            Stage::Sweep => self.back_up(),
        }
    }

    /// Expands the next state.
    fn expand(&mut self) -> Option<Outcome> {
        let all = self.graph.len();
        if self.cursor == all || self.graph.is_full(self.settings.budget.states) {
            self.is_partial = self.cursor < all;
            if self.is_partial && self.wants_all {
                return Some(Outcome::Budget);
            }
            self.worth = vec![0.0; all];
            for id in (0..all as Id).filter(|&id| self.graph.is_terminal(id)) {
                self.worth[id as usize] = 1.0;
            }
            self.stage = Stage::Order;
            return None;
        }
        let id = self.cursor as Id;
        self.cursor += 1;
        if self.graph.is_terminal(id) || self.graph.is_dead(id) {
            return None;
        }
        self.steps += 1;
        self.graph.expand(id);
        self.ordering.count(&self.graph, id);
        None
    }

    /// Puts the next state in order.
    fn order(&mut self) -> Option<Outcome> {
        self.order = self.ordering.step(&self.graph)?;
        self.ordering = Order::default();
        (self.stage, self.cursor) = (Stage::Sweep, 0);
        if self.order.contains(&0) {
            return None;
        }
        if self.is_partial {
            return Some(Outcome::Budget);
        }
        self.upper = 0.0;
        Some(Outcome::Unreachable)
    }

    /// The number of a state that was expanded, or of which nothing more is to be known.
    fn known(&self, state: P::State) -> Option<Id> {
        let is_end = |id| self.graph.is_terminal(id) || self.graph.is_dead(id);
        let is_whole = !self.is_partial && self.stage != Stage::Expand;
        let id = self.graph.find(state)?;
        (is_whole || is_end(id) || self.graph.has_rows(id)).then_some(id)
    }

    /// What is best in a state on the way of a leap, and its worth.
    fn ahead(&self, state: P::State) -> Option<(P::Action, f64)> {
        let is_known = self.stage == Stage::Sweep;
        is_known.then(|| self.graph.look(state, |id| self.worth[id as usize])).flatten()
    }

    /// Backs up the next state in order; at the end of a sweep, sees whether that was the last one.
    fn back_up(&mut self) -> Option<Outcome> {
        let discount = self.settings.discount;
        if let Some(&id) = self.order.get(self.cursor) {
            self.cursor += 1;
            self.steps += 1;
            self.backups += self.graph.rows(id).count() as u64;
            let best =
                self.graph.best(id, |id| self.worth[id as usize]).map_or(0.0, |(_, worth)| worth);
            let worth = &mut self.worth[id as usize];
            self.change = self.change.max((best - *worth / discount).abs());
            *worth = discount * best;
            return None;
        }
        self.sweeps += 1;
        self.residual = self.change;
        (self.cursor, self.change) = (0, 0.0);
        // How far values may be from those of the states that were numbered.
        let error = discount / (1.0 - discount) * self.residual;
        if !self.is_partial {
            self.upper = self.upper.min(self.worth[0] / discount + error);
        }
        if error > self.settings.epsilon {
            return None;
        }
        Some(if self.is_partial { Outcome::Budget } else { Outcome::Solved })
    }
}

impl<P: Mdp> Policy<P::State, P::Action> for ValueIteration<P> {
    fn action(&self, state: P::State) -> Option<P::Action> {
        if self.stage != Stage::Sweep {
            return None;
        }
        match self.known(state) {
            Some(id) => {
                let best = self.graph.best(id, |id| self.worth[id as usize]);
                best.and_then(|(row, _)| self.graph.action(id, row))
            }
            None => self.ahead(state).map(|(action, _)| action),
        }
    }

    fn value(&self, state: P::State) -> Option<f64> {
        let Some(id) = self.known(state) else {
            return self.ahead(state).map(|(_, worth)| worth);
        };
        if self.graph.is_terminal(id) {
            return Some(1.0);
        }
        let is_known = self.stage == Stage::Sweep || self.outcome.is_some();
        let worth = self.worth.get(id as usize).map_or(0.0, |w| w / self.settings.discount);
        // That nothing helps is known when it is proved, and not when sweeps have not come there yet.
        let is_proved = self.graph.is_dead(id)
            || matches!(self.outcome, Some(Outcome::Solved | Outcome::Unreachable));
        (is_known && (worth > 0.0 || is_proved)).then_some(worth)
    }
}

impl<P: Mdp> Solver<P::State, P::Action> for ValueIteration<P> {
    fn name(&self) -> &'static str {
        "vi"
    }

    /// A step expands a state, puts it in order, or backs it up.
    fn step(&mut self, n: usize) -> Option<Outcome> {
        for _ in 0..n {
            if self.outcome.is_some() {
                break;
            }
            self.outcome = self.advance();
        }
        self.outcome
    }

    fn progress(&self) -> Progress {
        Progress {
            states: self.graph.len(),
            steps: self.steps,
            backups: self.backups,
            residual: self.residual,
            lower: self.value(self.graph.state(0)).unwrap_or(0.0),
            upper: self.upper,
            least: self.graph.least(),
        }
    }
}
