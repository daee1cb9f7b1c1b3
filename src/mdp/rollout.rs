//! Runs of a problem under a policy, drawn with a seed: how often the goal is reached, with Wilson's interval (1927),
//! in how many steps, and what is earned. Where the policy does not know a state, another is made that begins there:
//! the world need not do what the plan expected.
//! Invariant: the same problem, policies and seed give the same report on every machine.

use super::problem::Mdp;
use super::simulate::sample;
use super::solver::Solver;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use rustc_hash::FxHashMap;

/// What is run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RolloutSettings {
    /// How many runs.
    pub runs: u32,
    /// A run that takes more steps is given up.
    pub most_steps: u32,
    /// γ, as for the solver.
    pub discount: f64,
    /// The seed of all draws.
    pub seed: u64,
}

impl Default for RolloutSettings {
    fn default() -> Self {
        Self { runs: 100, most_steps: 1_000, discount: super::solver::DISCOUNT, seed: 0 }
    }
}

/// What came of the runs so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RolloutReport {
    /// Runs that ended.
    pub runs: u32,
    /// Those that reached a terminal state.
    pub successes: u32,
    /// The share of successes that 95 % confidence leaves open, lowest and highest.
    pub interval: (f64, f64),
    /// Steps of a successful run, on average; `None` when there is none.
    pub mean_steps: Option<f64>,
    /// Discounted reward of a run, on average.
    pub mean_return: f64,
    /// The half width of its 95 % interval.
    pub return_margin: f64,
    /// How often a new policy had to be made.
    pub replans: u32,
}

/// Policies that are kept besides the first.
const MOST_KEPT: usize = 32;
/// Most states of which is kept what policies said.
const MOST_SAID: usize = 100_000;
/// Standard deviations that 95 % of a normal distribution lie within.
const Z: f64 = 1.959_963_984_540_054;

/// Runs at work.
pub struct Rollouts<P: Mdp, S, F> {
    problem: P,
    settings: RolloutSettings,
    /// What is known: the first policy, then those made on the way.
    policies: Vec<S>,
    make: F,
    /// The policy that is being made for the state.
    making: Option<S>,
    /// What policies said where runs have been, for they may look ahead to say it.
    said: FxHashMap<P::State, P::Action>,
    rng: Pcg64Mcg,
    buffer: Vec<(P::State, f64)>,
    state: P::State,
    steps: u32,
    /// What reaching a terminal state with the next step earns.
    reward: f64,
    sum_of_steps: u64,
    returns: f64,
    squares: f64,
    report: RolloutReport,
}

impl<P, S, F> Rollouts<P, S, F>
where
    P: Mdp,
    S: Solver<P::State, P::Action>,
    F: FnMut(P::State) -> S,
{
    /// Runs from the initial state under `policy`, which was solved; `make` begins another for a state that it does
    /// not know.
    pub fn new(problem: P, settings: RolloutSettings, policy: S, make: F) -> Self {
        let state = problem.initial();
        Self {
            problem,
            settings,
            policies: vec![policy],
            make,
            making: None,
            said: FxHashMap::default(),
            rng: Pcg64Mcg::seed_from_u64(settings.seed),
            buffer: Vec::new(),
            state,
            steps: 0,
            reward: 1.0,
            sum_of_steps: 0,
            returns: 0.0,
            squares: 0.0,
            report: RolloutReport::default(),
        }
    }

    /// What came of it so far.
    #[must_use]
    pub const fn report(&self) -> RolloutReport {
        self.report
    }

    /// Where the present run is.
    #[must_use]
    pub const fn state(&self) -> P::State {
        self.state
    }

    /// Takes at most `n` steps more, or steps of the solver that makes a policy; the report when all runs have ended.
    pub fn step(&mut self, n: usize) -> Option<RolloutReport> {
        let mut left = n;
        while left > 0 && self.report.runs < self.settings.runs {
            if let Some(making) = &mut self.making {
                let used = left.min(1_000);
                left -= used;
                if making.step(used).is_some() {
                    self.policies.truncate(MOST_KEPT);
                    self.policies.extend(self.making.take());
                    match self.known_action(self.policies.len() - 1) {
                        Some(action) => self.take(action),
                        None => self.end(false),
                    }
                }
                continue;
            }
            left -= 1;
            self.go_on();
        }
        (self.report.runs >= self.settings.runs).then_some(self.report)
    }

    /// Runs until all runs have ended.
    pub fn run(&mut self) -> RolloutReport {
        loop {
            if let Some(report) = self.step(usize::MAX) {
                return report;
            }
        }
    }

    fn go_on(&mut self) {
        if self.problem.is_terminal(self.state) {
            return self.end(true);
        }
        if self.steps >= self.settings.most_steps {
            return self.end(false);
        }
        let known = self.said.get(&self.state).copied();
        match known.or_else(|| (0..self.policies.len()).find_map(|i| self.known_action(i))) {
            Some(action) => {
                if known.is_none() && self.said.len() < MOST_SAID {
                    self.said.insert(self.state, action);
                }
                self.take(action);
            }
            None if self.policies.iter().any(|p| p.value(self.state) == Some(0.0)) => {
                self.end(false)
            }
            None => {
                self.report.replans += 1;
                self.making = Some((self.make)(self.state));
            }
        }
    }

    fn known_action(&self, policy: usize) -> Option<P::Action> {
        self.policies.get(policy)?.action(self.state)
    }

    fn take(&mut self, action: P::Action) {
        self.state = sample(&self.problem, self.state, action, &mut self.buffer, &mut self.rng);
        if self.steps > 0 {
            self.reward *= self.settings.discount;
        }
        self.steps += 1;
    }

    /// Counts the run, and begins the next.
    fn end(&mut self, is_success: bool) {
        let report = &mut self.report;
        report.runs += 1;
        if is_success {
            report.successes += 1;
            self.sum_of_steps += u64::from(self.steps);
            self.returns += self.reward;
            self.squares += self.reward * self.reward;
        }
        let runs = f64::from(report.runs);
        report.interval = wilson(report.successes, report.runs);
        let successes = f64::from(report.successes);
        report.mean_steps = (report.successes > 0).then(|| self.sum_of_steps as f64 / successes);
        report.mean_return = self.returns / runs;
        let variance = (self.squares / runs - report.mean_return * report.mean_return).max(0.0);
        report.return_margin = Z * (variance / (runs - 1.0).max(1.0)).sqrt();
        (self.state, self.steps, self.reward) = (self.problem.initial(), 0, 1.0);
    }
}

/// The shares of successes that 95 % confidence leaves open after so many of so many runs (Wilson 1927).
#[must_use]
pub fn wilson(successes: u32, runs: u32) -> (f64, f64) {
    if runs == 0 {
        return (0.0, 1.0);
    }
    let n = f64::from(runs);
    let share = f64::from(successes) / n;
    let scale = 1.0 + Z * Z / n;
    let middle = (share + Z * Z / (2.0 * n)) / scale;
    let margin = Z * (share * (1.0 - share) / n + Z * Z / (4.0 * n * n)).sqrt() / scale;
    ((middle - margin).max(0.0), (middle + margin).min(1.0))
}
