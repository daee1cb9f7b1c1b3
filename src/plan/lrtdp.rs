//! Labelled real-time dynamic programming (LRTDP: Bonet and Geffner 2003), whose trials follow every outcome of the
//! best action, depth first (their HDP), and whose labels are bounds from both sides (BRTDP: McMahan, Likhachev and
//! Gordon 2005): a state is solved when these lie within ε. Both are backed up on the way down and on the way up.
//! Only states that a good policy might meet are numbered, so it works where there are too many to enumerate.
//! Invariants: lower ≤ V ≤ upper always; the policy is greedy in the lower bounds, so it earns at least those.
//! Nothing is drawn at random. A step backs up one state.

use super::astar::AStar;
use super::graph::{Graph, Id};
use crate::mdp::{Mdp, Outcome, Policy, Progress, Settings, Solver};
use std::ops::Range;

/// A state is solved when its gap is at most this share of ε, so that rounding cannot keep ε itself out of reach.
const STRICTER: f64 = 0.9;

/// Steps after which a way is looked for on which all goes well, if none was found: a policy that may get there.
const LOST: u64 = 2_000;
/// States that this looks at.
const SCOUTED: u64 = 50_000;

/// A solver at work.
#[derive(Clone)]
pub struct Lrtdp<P: Mdp> {
    graph: Graph<P>,
    settings: Settings,
    /// Bounds on what it is worth to arrive: 1 at a terminal state, else γ V.
    upper: Vec<f64>,
    lower: Vec<f64>,
    is_expanded: Vec<bool>,
    /// How many states are still to be expanded, were it needed, and whether a terminal one was met.
    n_open: usize,
    has_end: bool,
    /// The last trial that met each state.
    met: Vec<u32>,
    /// The states that this trial is in, each with the outcomes of its best action that are still to be followed.
    path: Vec<(Id, Range<usize>)>,
    trials: u32,
    /// The largest fall of an upper bound in this trial, and in the last one.
    change: f64,
    residual: f64,
    steps: u64,
    backups: u64,
    /// Looks for a way on which all goes well.
    scout: Option<Box<AStar<P>>>,
    has_scouted: bool,
    outcome: Option<Outcome>,
}

impl<P: Mdp + Clone> Lrtdp<P> {
    /// A solver that has done nothing yet.
    #[must_use]
    pub fn new(problem: P, settings: Settings) -> Self {
        let mut solver = Self {
            graph: Graph::new(problem, settings.discount),
            settings,
            upper: Vec::new(),
            lower: Vec::new(),
            is_expanded: Vec::new(),
            n_open: 0,
            has_end: false,
            met: Vec::new(),
            path: Vec::new(),
            trials: 0,
            change: 0.0,
            residual: f64::NAN,
            steps: 0,
            backups: 0,
            scout: None,
            has_scouted: false,
            outcome: None,
        };
        solver.bound_new_states();
        solver
    }

    /// The problem that is solved.
    #[must_use]
    pub const fn problem(&self) -> &P {
        self.graph.problem()
    }

    /// How many trials were begun.
    #[must_use]
    pub const fn trials(&self) -> u32 {
        self.trials
    }

    /// Gives the states that were numbered since their first bounds.
    fn bound_new_states(&mut self) {
        for id in self.upper.len()..self.graph.len() {
            let id = id as Id;
            let (lower, upper) = if self.graph.is_terminal(id) {
                self.has_end = true;
                (1.0, 1.0)
            } else if self.graph.is_dead(id) {
                (0.0, 0.0)
            } else {
                self.n_open += 1;
                (0.0, self.settings.discount * self.graph.most(id))
            };
            self.lower.push(lower);
            self.upper.push(upper);
        }
        self.is_expanded.resize(self.graph.len(), false);
        self.met.resize(self.graph.len(), 0);
    }

    /// How far the bounds on V lie apart.
    fn gap(&self, id: Id) -> f64 {
        let gap = self.upper[id as usize] - self.lower[id as usize];
        if self.graph.is_terminal(id) { 0.0 } else { gap / self.settings.discount }
    }

    fn advance(&mut self) -> Option<Outcome> {
        if self.steps >= self.settings.budget.steps {
            return Some(if self.path.is_empty() && self.is_solved(0) {
                self.ended()
            } else {
                Outcome::Budget
            });
        }
        if let Some(scout) = &mut self.scout {
            self.steps += 1;
            if scout.step(1).is_some() {
                self.follow();
            }
            return None;
        }
        let Some((id, rest)) = self.path.last_mut() else {
            if self.is_solved(0) {
                return Some(self.ended());
            }
            if self.steps >= LOST && self.lower[0] == 0.0 && !self.has_scouted {
                self.has_scouted = true;
                let budget = self.settings.budget;
                let settings = self.settings.with_budget(SCOUTED, budget.states);
                self.scout = Some(Box::new(AStar::hopeful(self.graph.problem().clone(), settings)));
                return None;
            }
            self.residual = if self.trials > 0 { self.change } else { f64::NAN };
            self.change = 0.0;
            self.trials += 1;
            return self.go_down(0);
        };
        if let Some(edge) = rest.next() {
            let next = self.graph.target(edge);
            if self.met[next as usize] < self.trials && !self.is_solved(next) {
                return self.go_down(next);
            }
            return None;
        }
        let id = *id;
        self.path.pop();
        self.back_up(id);
        None
    }

    /// Expands the states of the way that was found, and backs them up from its end.
    fn follow(&mut self) {
        let Some(plan) = self.scout.take().and_then(|scout| scout.plan().cloned()) else { return };
        let mut way = Vec::new();
        for state in plan.states {
            // On the way of a leap there are no numbers.
            let Some(id) = self.graph.find(state) else { continue };
            if self.graph.is_full(self.settings.budget.states) || self.graph.is_terminal(id) {
                break;
            }
            if !self.is_expanded[id as usize] {
                self.open(id);
            }
            way.push(id);
        }
        for id in way.into_iter().rev() {
            self.back_up(id);
        }
    }

    /// Expands a state.
    fn open(&mut self, id: Id) {
        self.graph.expand(id);
        self.bound_new_states();
        self.is_expanded[id as usize] = true;
        self.n_open -= 1;
    }

    /// Meets a state: backs it up and sets out along its best action.
    fn go_down(&mut self, id: Id) -> Option<Outcome> {
        self.met[id as usize] = self.trials;
        if !self.is_expanded[id as usize] {
            if self.graph.is_full(self.settings.budget.states) {
                return Some(Outcome::Budget);
            }
            self.open(id);
            if self.n_open == 0 && !self.has_end {
                // That was all that can be reached.
                self.upper.fill(0.0);
                return Some(Outcome::Unreachable);
            }
        }
        let best = self.back_up(id);
        self.path.push((id, best.map_or(0..0, |row| self.graph.edges(row))));
        None
    }

    /// The number of a state that was expanded, is terminal, or is worth nothing.
    fn known(&self, state: P::State) -> Option<Id> {
        let is_known = |&id: &Id| {
            let most = self.upper[id as usize];
            self.is_expanded[id as usize] || self.graph.is_terminal(id) || most <= 0.0
        };
        self.graph.find(state).filter(is_known)
    }

    fn is_solved(&self, id: Id) -> bool {
        self.gap(id) <= STRICTER * self.settings.epsilon
    }

    /// How it ends once the bounds on the initial state meet.
    fn ended(&self) -> Outcome {
        if self.upper[0] <= 0.0 {
            Outcome::Unreachable
        } else if self.lower[0] > 0.0 {
            Outcome::Solved
        } else {
            // It may be worth less than ε, or nothing at all: neither is proved.
            Outcome::Budget
        }
    }

    /// Backs up both bounds of a state; the row of the best upper one.
    fn back_up(&mut self, id: Id) -> Option<usize> {
        let discount = self.settings.discount;
        self.steps += 1;
        self.backups += self.graph.rows(id).len() as u64;
        let upper = self.graph.best(id, &self.upper);
        let lower = self.graph.best(id, &self.lower);
        let i = id as usize;
        let most = discount * upper.map_or(0.0, |(_, worth)| worth);
        self.change = self.change.max((self.upper[i] - most) / discount);
        self.upper[i] = self.upper[i].min(most);
        self.lower[i] = self.lower[i].max(discount * lower.map_or(0.0, |(_, worth)| worth));
        upper.map(|(row, _)| row)
    }
}

impl<P: Mdp + Clone> Policy<P::State, P::Action> for Lrtdp<P> {
    fn action(&self, state: P::State) -> Option<P::Action> {
        if let Some(id) = self.known(state) {
            let best = self.graph.best(id, &self.lower);
            let best = best.or_else(|| self.graph.best(id, &self.upper));
            return best.map(|(row, _)| self.graph.action(row));
        }
        let ahead = |worth: &[f64]| self.graph.look(state, |id| worth[id as usize]);
        ahead(&self.lower).or_else(|| ahead(&self.upper)).map(|(action, _)| action)
    }

    /// What the policy earns at least.
    fn value(&self, state: P::State) -> Option<f64> {
        if let Some(id) = self.known(state) {
            let worth = self.lower[id as usize];
            return Some(if self.graph.is_terminal(id) {
                worth
            } else {
                worth / self.settings.discount
            });
        }
        let ahead = self.graph.look(state, |id| self.lower[id as usize]);
        ahead.map(|(_, worth)| worth)
    }
}

impl<P: Mdp + Clone> Solver<P::State, P::Action> for Lrtdp<P> {
    fn name(&self) -> &'static str {
        "lrtdp"
    }

    /// A step backs up a state.
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
        let lower = self.value(self.graph.state(0)).unwrap_or(0.0);
        Progress {
            states: self.graph.len(),
            steps: self.steps,
            backups: self.backups,
            residual: self.residual,
            lower,
            upper: lower + self.gap(0),
            least: self.graph.least(),
        }
    }
}
