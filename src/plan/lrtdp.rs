//! Labelled real-time dynamic programming (LRTDP: Bonet and Geffner 2003), whose trials follow every outcome of the
//! best action, depth first (their HDP), and whose labels are bounds from both sides (BRTDP: McMahan, Likhachev and
//! Gordon 2005). How far these may lie apart is ε at the initial state and grows on the way as what comes of it counts
//! less there (HSVI: Smith and Simmons 2004); of several outcomes that which counts most is followed first, and no more
//! of them than need be. Where nothing is left to chance a trial goes on from a state by whatever seems best now, until
//! that promises less than when it came (as RBFS does: Korf 1993).
//! Only states that a good policy might meet are numbered, so it works where there are too many to enumerate.
//! Invariants: lower ≤ V ≤ upper always; the policy is greedy in the lower bounds, so it earns at least those.
//! Nothing is drawn at random. A step backs up one state.

use super::astar::AStar;
use super::graph::Graph;
use super::index::Id;
use crate::mdp::{Mdp, Outcome, Policy, Progress, Settings, Solver};

/// A state is solved when its gap is at most this share of ε, so that rounding cannot keep ε itself out of reach.
const STRICTER: f64 = 0.9;

/// Steps after which a way is looked for on which all goes well, if none was found: a policy that may get there.
const LOST: u64 = 2_000;
/// States that this looks at.
const SCOUTED: u64 = 50_000;

/// A state that a trial is in.
#[derive(Clone, Copy)]
struct Met {
    id: Id,
    /// How far the bounds on what it is worth to arrive may lie apart.
    slack: f64,
    /// The upper one when the trial came.
    hoped: f64,
    /// The row that it went on by, if that leaves something to chance: it goes on by no other.
    row: Option<usize>,
}

/// Bounds on what it is worth to arrive at a state: 1 at a terminal one, else γ V.
#[derive(Clone, Copy)]
struct Worth {
    upper: f64,
    lower: f64,
}

impl Worth {
    fn gap(self) -> f64 {
        self.upper - self.lower
    }
}

/// A solver at work.
#[derive(Clone)]
pub struct Lrtdp<P: Mdp> {
    graph: Graph<P>,
    settings: Settings,
    worth: Vec<Worth>,
    is_expanded: Vec<bool>,
    /// How many states are still to be expanded, were it needed, and whether a terminal one was met.
    n_open: usize,
    has_end: bool,
    /// The last trial that met each state.
    met: Vec<u32>,
    /// The states that this trial is in.
    path: Vec<Met>,
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
            worth: Vec::new(),
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
        for id in self.worth.len()..self.graph.len() {
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
            self.worth.push(Worth { upper, lower });
        }
        self.is_expanded.resize(self.graph.len(), false);
        self.met.resize(self.graph.len(), 0);
    }

    /// How far the bounds on V lie apart.
    fn gap(&self, id: Id) -> f64 {
        let gap = self.worth[id as usize].gap();
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
        let Some(&met) = self.path.last() else {
            if self.is_solved(0) {
                return Some(self.ended());
            }
            if self.steps >= LOST && self.worth[0].lower == 0.0 && !self.has_scouted {
                self.has_scouted = true;
                let budget = self.settings.budget;
                let settings = self.settings.with_budget(SCOUTED, budget.states);
                self.scout = Some(Box::new(AStar::hopeful(self.graph.problem().clone(), settings)));
                return None;
            }
            self.residual = if self.trials > 0 { self.change } else { f64::NAN };
            self.change = 0.0;
            self.trials += 1;
            let slack = self.settings.discount * STRICTER * self.settings.epsilon;
            return self.go_down(0, slack);
        };
        let row = self.back_up(met.id);
        if let Some((next, slack, row)) = row.and_then(|row| self.next(met, row)) {
            if let Some(last) = self.path.last_mut() {
                last.row = Some(row).filter(|&row| self.graph.edges(row).len() > 1);
            }
            return self.go_down(next, slack);
        }
        self.path.pop();
        None
    }

    /// Where a trial goes on from a state by its best action, how far the bounds may lie apart there, and the row of that
    /// action: to the outcome that counts most of those that leave too much open, unless all together leave little
    /// enough. None when the state promises less than when the trial came: then another may be better.
    fn next(&self, met: Met, row: usize) -> Option<(Id, f64, usize)> {
        let Worth { upper, lower } = self.worth[met.id as usize];
        let is_done = upper - lower <= met.slack || upper < met.hoped - met.slack;
        if is_done || met.row.is_some_and(|begun| begun != row) {
            return None;
        }
        let slack = met.slack / (self.settings.discount * self.graph.row_weight(row));
        let mut best = None;
        let mut most = 0.0;
        for (next, weight) in self.graph.outcomes(row) {
            let gap = self.worth[next as usize].gap();
            if gap > slack && weight * gap > most && self.met[next as usize] < self.trials {
                most = weight * gap;
                best = Some((next, slack, row));
            }
        }
        best
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

    /// Meets a state.
    fn go_down(&mut self, id: Id, slack: f64) -> Option<Outcome> {
        if !self.is_expanded[id as usize] {
            if self.graph.is_full(self.settings.budget.states) {
                return Some(Outcome::Budget);
            }
            self.open(id);
            if self.n_open == 0 && !self.has_end {
                // That was all that can be reached.
                self.worth.fill(Worth { upper: 0.0, lower: 0.0 });
                return Some(Outcome::Unreachable);
            }
        }
        self.met[id as usize] = self.trials;
        self.path.push(Met { id, slack, hoped: self.worth[id as usize].upper, row: None });
        None
    }

    /// The number of a state that was expanded, is terminal, or is worth nothing.
    fn known(&self, state: P::State) -> Option<Id> {
        let is_known = |&id: &Id| {
            let most = self.worth[id as usize].upper;
            self.is_expanded[id as usize] || self.graph.is_terminal(id) || most <= 0.0
        };
        self.graph.find(state).filter(is_known)
    }

    fn is_solved(&self, id: Id) -> bool {
        self.gap(id) <= STRICTER * self.settings.epsilon
    }

    /// How it ends once the bounds on the initial state meet.
    fn ended(&self) -> Outcome {
        if self.worth[0].upper <= 0.0 {
            Outcome::Unreachable
        } else if self.worth[0].lower > 0.0 {
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
        let mut best = None;
        let mut most = Worth { upper: 0.0, lower: 0.0 };
        for (row, outcomes) in self.graph.rows_with_outcomes(id) {
            self.backups += 1;
            let mut sum = Worth { upper: 0.0, lower: 0.0 };
            for (target, weight) in outcomes {
                let Worth { upper, lower } = self.worth[target as usize];
                sum.upper += weight * upper;
                sum.lower += weight * lower;
            }
            if sum.upper > most.upper {
                most.upper = sum.upper;
                best = Some(row);
            }
            most.lower = most.lower.max(sum.lower);
        }
        let worth = &mut self.worth[id as usize];
        let (upper, lower) = (discount * most.upper, discount * most.lower);
        self.change = self.change.max((worth.upper - upper) / discount);
        worth.upper = worth.upper.min(upper);
        worth.lower = worth.lower.max(lower);
        best
    }
}

impl<P: Mdp + Clone> Policy<P::State, P::Action> for Lrtdp<P> {
    fn action(&self, state: P::State) -> Option<P::Action> {
        if let Some(id) = self.known(state) {
            let best = self.graph.best(id, |id| self.worth[id as usize].lower);
            let best = best.or_else(|| self.graph.best(id, |id| self.worth[id as usize].upper));
            return best.and_then(|(row, _)| self.graph.action(id, row));
        }
        let lower = self.graph.look(state, |id| self.worth[id as usize].lower);
        let ahead = lower.or_else(|| self.graph.look(state, |id| self.worth[id as usize].upper));
        ahead.map(|(action, _)| action)
    }

    /// What the policy earns at least.
    fn value(&self, state: P::State) -> Option<f64> {
        if let Some(id) = self.known(state) {
            let worth = self.worth[id as usize].lower;
            return Some(if self.graph.is_terminal(id) {
                worth
            } else {
                worth / self.settings.discount
            });
        }
        let ahead = self.graph.look(state, |id| self.worth[id as usize].lower);
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
