//! Upper confidence bounds applied to trees (UCT: Kocsis and Szepesvári 2006), any-time: what remains when nothing
//! can be proved within the budget. A trial goes down by UCB1 over the actions of the states met before; at a new
//! state it plays on, greedy in the problem's bounds but for some random actions; the reward is counted on the way
//! back. States met again are the same node, and a trial leaves the tree where it comes round in a circle. Values are
//! averages, not bounds. A step begins a trial or tries an action.
//! Invariant: the same problem and seed give the same tree on every machine.

use super::graph::Graph;
use super::index::Id;
use crate::mdp::{Mdp, Outcome, Policy, Progress, Settings, Solver, StepByStep, sample};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Most actions of a trial.
const DEEPEST: u32 = 200;
/// Weight of UCB1's confidence: small, since values of ways that differ by a few steps do.
const CURIOSITY: f64 = 0.02;
/// Share of random actions when a trial plays on.
const RANDOM: f64 = 0.05;
/// Bounds that lie closer are equal.
const LEVEL: f64 = 1e-9;
/// Visits from which on the policy believes what it saw.
const KNOWN: u32 = 8;

/// A solver at work.
pub struct Uct<P: Mdp> {
    /// Of actions, for what trials saw is no bound: a leap left half-way might not be taken up again.
    graph: Graph<StepByStep<P>>,
    settings: Settings,
    rng: Pcg64Mcg,
    /// Trials through each state, 0 before it is expanded.
    visits: Vec<u32>,
    /// Trials through each row, and the sum of what they earned.
    row_visits: Vec<u32>,
    row_sums: Vec<f64>,
    /// The state of a trial, with the row that it took there.
    path: Vec<(Id, usize)>,
    buffer: Vec<(P::State, f64)>,
    steps: u64,
    trials: u64,
    outcome: Option<Outcome>,
}

impl<P: Mdp> Uct<P> {
    /// A solver that has done nothing yet.
    #[must_use]
    pub fn new(problem: P, settings: Settings) -> Self {
        let graph = Graph::new(StepByStep(problem), settings.discount);
        let outcome = match (graph.is_terminal(0), graph.is_dead(0)) {
            (true, _) => Some(Outcome::Solved),
            (_, true) => Some(Outcome::Unreachable),
            _ => None,
        };
        Self {
            graph,
            settings,
            rng: Pcg64Mcg::seed_from_u64(settings.seed),
            visits: vec![0],
            row_visits: Vec::new(),
            row_sums: Vec::new(),
            path: Vec::new(),
            buffer: Vec::new(),
            steps: 0,
            trials: 0,
            outcome,
        }
    }

    /// The problem that is solved.
    #[must_use]
    pub const fn problem(&self) -> &P {
        &self.graph.problem().0
    }

    /// How many trials were made.
    #[must_use]
    pub const fn trials(&self) -> u64 {
        self.trials
    }

    /// One trial: down the tree, on at random, and back up.
    fn try_out(&mut self) {
        self.trials += 1;
        // A trial that goes nowhere is work, too: the budget must end.
        self.steps += 1;
        self.path.clear();
        let mut id = 0;
        let mut earned = loop {
            if self.graph.is_terminal(id) {
                break 1.0;
            }
            if self.graph.is_dead(id) || self.path.len() as u32 >= DEEPEST {
                break 0.0;
            }
            if self.visits[id as usize] == 0 {
                if !self.graph.is_full(self.settings.budget.states) {
                    self.expand(id);
                }
                break self.play(id);
            }
            // Round in a circle by chance, the tree has nothing more to say.
            if self.is_met(id) {
                break self.play(id);
            }
            let Some(row) = self.choose(id) else { break 0.0 };
            self.steps += 1;
            self.path.push((id, row));
            id = self.draw(row);
        };
        // Arriving at a state that is not terminal is worth γ times what it earns.
        let mut is_end = self.graph.is_terminal(id);
        while let Some((id, row)) = self.path.pop() {
            let arrived = if is_end { earned } else { self.settings.discount * earned };
            is_end = false;
            earned = self.graph.row_weight(row) * arrived;
            self.visits[id as usize] += 1;
            self.row_visits[row] += 1;
            self.row_sums[row] += earned;
        }
    }

    fn expand(&mut self, id: Id) {
        self.graph.expand(id);
        self.visits.resize(self.graph.len(), 0);
        self.visits[id as usize] = 1;
        self.row_visits.resize(self.graph.n_edges(), 0);
        self.row_sums.resize(self.graph.n_edges(), 0.0);
    }

    /// The row to follow: one that was never tried, the nearest to the goal first; else by UCB1.
    fn choose(&self, id: Id) -> Option<usize> {
        // What surely leads back is no way on.
        let ahead = |row: &usize| {
            self.graph.edges(*row).any(|edge| {
                let target = self.graph.target(edge);
                target != id && !self.is_met(target)
            })
        };
        let untried = self.graph.rows(id).filter(ahead).filter(|&row| self.row_visits[row] == 0);
        if let Some(row) = untried.min_by_key(|&row| self.nearest(row)) {
            return Some(row);
        }
        let log = libm::log(f64::from(self.visits[id as usize]));
        let mut best = None;
        for row in self.graph.rows(id).filter(ahead) {
            let n = f64::from(self.row_visits[row]);
            let score = self.row_sums[row] / n + CURIOSITY * (log / n).sqrt();
            if best.is_none_or(|(_, most)| score > most) {
                best = Some((row, score));
            }
        }
        best.map(|(row, _)| row)
    }

    /// Whether this trial has been in a state.
    fn is_met(&self, id: Id) -> bool {
        self.path.iter().any(|&(met, _)| met == id)
    }

    /// The least bound among the outcomes of a row.
    fn nearest(&self, row: usize) -> u32 {
        let bounds = self.graph.edges(row).map(|edge| self.graph.bound(self.graph.target(edge)));
        bounds.min().unwrap_or(u32::MAX)
    }

    /// An outcome of a row, drawn by its weight.
    fn draw(&mut self, row: usize) -> Id {
        let edges = self.graph.edges(row);
        if edges.len() == 1 {
            return self.graph.target(edges.start);
        }
        let mut left = self.rng.random::<f64>() * self.graph.row_weight(row);
        let last = edges.end - 1;
        for edge in edges {
            if left < self.graph.weight(edge) {
                return self.graph.target(edge);
            }
            left -= self.graph.weight(edge);
        }
        self.graph.target(last)
    }

    /// What playing on from a state earns, once.
    fn play(&mut self, id: Id) -> f64 {
        let mut state = self.graph.state(id);
        let mut reward = 1.0;
        for _ in self.path.len() as u32..DEEPEST {
            self.steps += 1;
            let Some(action) = self.guess(state) else { return 0.0 };
            let problem = self.graph.problem();
            state = sample(problem, state, action, &mut self.buffer, &mut self.rng);
            if problem.is_terminal(state) {
                return reward;
            }
            reward *= self.settings.discount;
        }
        0.0
    }

    /// The action after which the bound on values is highest; now and then a random one.
    fn guess(&mut self, state: P::State) -> Option<P::Action> {
        let problem = self.graph.problem();
        let actions = problem.actions();
        if self.rng.random::<f64>() < RANDOM {
            let n = u32::try_from(actions.len()).ok()?;
            return actions.get(self.rng.random_range(0..n) as usize).copied();
        }
        let discount = self.settings.discount;
        let mut best = None;
        let mut n_equal = 1_u32;
        for &action in actions {
            self.buffer.clear();
            problem.successors(state, action, &mut self.buffer);
            let (mut worth, mut stay) = (0.0, 0.0);
            for &(next, probability) in &self.buffer {
                if problem.is_terminal(next) {
                    worth += probability;
                } else if next == state {
                    stay += probability;
                } else {
                    worth += probability * discount * problem.most(next, discount);
                }
            }
            // As where it is tried until it moves.
            worth /= 1.0 - discount * stay;
            // Among equals, each as likely: what is equal by the bounds may differ.
            let most = best.map_or(0.0, |(_, most)| most);
            if worth > most + LEVEL {
                n_equal = 1;
                best = Some((action, worth));
            } else if worth > most - LEVEL && best.is_some() {
                n_equal += 1;
                if self.rng.random_range(0..n_equal) == 0 {
                    best = Some((action, worth));
                }
            }
        }
        best.map(|(action, _)| action)
    }

    /// The row that most trials took.
    fn favourite(&self, id: Id) -> Option<usize> {
        let mut best = None;
        for row in self.graph.rows(id) {
            let n = self.row_visits[row];
            if n > 0 && best.is_none_or(|(_, most)| n > most) {
                best = Some((row, n));
            }
        }
        best.map(|(row, _)| row)
    }
}

impl<P: Mdp> Policy<P::State, P::Action> for Uct<P> {
    fn action(&self, state: P::State) -> Option<P::Action> {
        let id = self.graph.find(state).filter(|&id| self.visits[id as usize] >= KNOWN)?;
        self.favourite(id).and_then(|row| self.graph.action(id, row))
    }

    /// What trials through its best action earned on average.
    fn value(&self, state: P::State) -> Option<f64> {
        let id = self.graph.find(state)?;
        if self.graph.is_terminal(id) {
            return Some(1.0);
        }
        if self.graph.is_dead(id) {
            return Some(0.0);
        }
        let row = self.favourite(id)?;
        let worth = self.row_sums[row] / f64::from(self.row_visits[row]);
        // That no trial came to anything proves nothing.
        (worth > 0.0).then_some(worth)
    }
}

impl<P: Mdp> Solver<P::State, P::Action> for Uct<P> {
    fn name(&self) -> &'static str {
        "uct"
    }

    /// A step begins a trial or tries an action; the last trial is always brought to its end, which takes some hundred steps at most.
    fn step(&mut self, n: usize) -> Option<Outcome> {
        let most = self.steps.saturating_add(n as u64).min(self.settings.budget.steps);
        while self.outcome.is_none() && self.steps < most {
            self.try_out();
        }
        if self.steps >= self.settings.budget.steps {
            self.outcome = self.outcome.or(Some(Outcome::Budget));
        }
        self.outcome
    }

    /// Its bounds are the problem's own: trials prove nothing.
    fn progress(&self) -> Progress {
        let (lower, upper) = match self.outcome {
            Some(Outcome::Solved) => (1.0, 1.0),
            Some(Outcome::Unreachable) => (0.0, 0.0),
            _ => (0.0, self.settings.worth(self.graph.bound(0))),
        };
        let (states, residual) = (self.graph.len(), f64::NAN);
        Progress {
            states,
            steps: self.steps,
            backups: self.steps,
            residual,
            lower,
            upper,
            least: self.graph.least(),
        }
    }
}
