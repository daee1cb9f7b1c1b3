//! A problem drawn at random, and the plainest ways to solve it.

use groundling::mdp::Mdp;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::collections::BTreeMap;

/// States 0 to n−1, of which the last few are terminal; three actions with one to three outcomes each.
pub(crate) struct Toy {
    moves: Vec<[Vec<(u32, f64)>; 3]>,
    first_terminal: u32,
    /// Whether every action has one outcome.
    pub(crate) is_sure: bool,
    /// What it says of the actions to a terminal state: half of them.
    bounds: Vec<Option<u32>>,
}

impl Toy {
    /// The problem that `seed` stands for.
    pub(crate) fn new(seed: u64, n: u32, is_sure: bool) -> Self {
        let mut rng = Pcg64Mcg::seed_from_u64(seed);
        // Steps are short, so that there is some way to go; now and then nothing leads to the end.
        let reach: u32 = rng.random_range(2..6);
        let wall = if seed.is_multiple_of(9) { n - 2 } else { n };
        let mut one = |from: u32| {
            let to = (from + rng.random_range(0..2 * reach + 3)).saturating_sub(reach);
            if to >= wall { from } else { to.min(n - 1) }
        };
        let mut moves = Vec::new();
        for from in 0..n {
            moves.push([(); 3].map(|()| {
                let (a, b, c) = (one(from), one(from), one(from));
                if is_sure { vec![(a, 1.0)] } else { merged([(a, 0.5), (b, 0.375), (c, 0.125)]) }
            }));
        }
        let mut toy = Self { moves, first_terminal: n - 1, is_sure, bounds: Vec::new() };
        toy.bounds = (0..n).map(|s| toy.steps(s).map(|n| n.div_ceil(2))).collect();
        toy
    }

    /// The least number of actions that may lead from a state to a terminal one.
    pub(crate) fn steps(&self, from: u32) -> Option<u32> {
        let mut layer = vec![from];
        let mut seen = vec![false; self.moves.len()];
        for n in 0.. {
            if layer.iter().any(|&s| self.is_terminal(s)) {
                return Some(n);
            }
            let mut next = Vec::new();
            for s in layer {
                for (t, _) in self.moves[s as usize].iter().flatten() {
                    if !std::mem::replace(&mut seen[*t as usize], true) {
                        next.push(*t);
                    }
                }
            }
            if next.is_empty() {
                return None;
            }
            layer = next;
        }
        None
    }
}

/// Equal outcomes as one.
fn merged(all: [(u32, f64); 3]) -> Vec<(u32, f64)> {
    let mut out: Vec<(u32, f64)> = Vec::new();
    for (state, probability) in all {
        match out.iter_mut().find(|o| o.0 == state) {
            Some(known) => known.1 += probability,
            None => out.push((state, probability)),
        }
    }
    out
}

impl Mdp for Toy {
    type State = u32;
    type Action = u8;

    fn initial(&self) -> u32 {
        0
    }
    fn actions(&self) -> &[u8] {
        &[0, 1, 2]
    }
    fn successors(&self, state: u32, action: u8, out: &mut Vec<(u32, f64)>) {
        out.extend_from_slice(&self.moves[state as usize][usize::from(action)]);
    }
    fn is_terminal(&self, state: u32) -> bool {
        state >= self.first_terminal
    }
    fn heuristic(&self, state: u32) -> Option<u32> {
        self.bounds[state as usize]
    }
}

/// What every state is worth, by as many plain sweeps as it takes.
pub(crate) fn values(toy: &Toy, discount: f64) -> Vec<f64> {
    let mut values = vec![0.0; toy.moves.len()];
    for _ in 0..20_000 {
        let mut change: f64 = 0.0;
        for s in 0..toy.moves.len() {
            let best = (0..3).map(|a| worth(toy, &values, discount, s, a)).fold(0.0, f64::max);
            let new = if toy.is_terminal(s as u32) { 1.0 } else { best };
            change = change.max((new - values[s]).abs());
            values[s] = new;
        }
        if change < 1e-13 {
            break;
        }
    }
    values
}

/// What a policy earns from the initial state, by plain sweeps.
pub(crate) fn earned(toy: &Toy, discount: f64, action: impl Fn(u32) -> Option<u8>) -> f64 {
    let mut values = vec![0.0; toy.moves.len()];
    for _ in 0..3_000 {
        for s in 0..toy.moves.len() {
            if let Some(a) = action(s as u32) {
                values[s] = worth(toy, &values, discount, s, usize::from(a));
            }
        }
    }
    values[0]
}

fn worth(toy: &Toy, values: &[f64], discount: f64, state: usize, action: usize) -> f64 {
    let arrive = |t: u32| if toy.is_terminal(t) { 1.0 } else { discount * values[t as usize] };
    toy.moves[state][action].iter().map(|&(t, p)| p * arrive(t)).sum()
}

/// What the initial state of any problem is worth, by plain sweeps over all states within reach.
pub(crate) fn plain_value<P: Mdp>(problem: &P, discount: f64) -> f64 {
    let mut index = BTreeMap::from([(problem.initial(), 0)]);
    let mut states = vec![problem.initial()];
    let mut rows: Vec<Vec<Vec<(usize, f64)>>> = Vec::new();
    while rows.len() < states.len() {
        let state = states[rows.len()];
        let actions = if problem.is_terminal(state) { &[] } else { problem.actions() };
        let row = |action: &P::Action| {
            let mut out = Vec::new();
            problem.successors(state, *action, &mut out);
            let mut numbered = Vec::new();
            for (next, probability) in out {
                let id = *index.entry(next).or_insert_with(|| {
                    states.push(next);
                    states.len() - 1
                });
                numbered.push((id, probability));
            }
            numbered
        };
        rows.push(actions.iter().map(row).collect());
    }
    let is_end: Vec<bool> = states.iter().map(|&s| problem.is_terminal(s)).collect();
    let mut values: Vec<f64> = is_end.iter().map(|&end| f64::from(u8::from(end))).collect();
    for _ in 0..20_000 {
        let mut change: f64 = 0.0;
        for (s, rows) in rows.iter().enumerate().rev().filter(|(s, _)| !is_end[*s]) {
            let arrive = |t: usize| if is_end[t] { 1.0 } else { discount * values[t] };
            let worth = |row: &Vec<(usize, f64)>| row.iter().map(|&(t, p)| p * arrive(t)).sum();
            let new: f64 = rows.iter().map(worth).fold(0.0, f64::max);
            change = change.max(new - values[s]);
            values[s] = new;
        }
        if change < 1e-10 {
            break;
        }
    }
    values[0]
}
