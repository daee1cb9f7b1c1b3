//! How many steps are asked for at once changes nothing: a solver that is pumped by one step, by seven or by a thousand
//! ends at the same place with the same plan, bounds and states.

use super::anytime::bring;
use super::world;
use groundling::domain::{Action, Chances, Packed, Plan, Rules, State, generate};
use groundling::ground::{Goal, Task};
use groundling::mdp::{Mdp, Settings, Solver};
use groundling::plan::{AnySolver, Auto, SOLVERS};

/// Runs a solver by so many steps at once, and says all that came of it.
fn told(task: &Task, mut solver: impl Solver<Packed, Action>, n: usize) -> String {
    let outcome = loop {
        if let Some(outcome) = solver.step(n) {
            break outcome;
        }
    };
    let mut state = task.initial();
    let mut actions = Vec::new();
    let mut out = Vec::new();
    while let Some(action) = solver.action(state).filter(|_| actions.len() < 300) {
        actions.push(action);
        out.clear();
        task.successors(state, action, &mut out);
        state = out.iter().fold((state, 0.0), |best, &o| if o.1 > best.1 { o } else { best }).0;
    }
    let value = solver.value(task.initial()).map(f64::to_bits);
    format!("{} {outcome:?} {actions:?} {value:?} {:?}", solver.name(), solver.progress())
}

/// Sees that a solver says the same of a goal by whichever steps it is pumped. Each run has its own task, for bounds that
/// one makes sharper would be there for the next.
fn check(goal: &Goal, state: &State, rules: Rules, budget: (u64, usize), name: Option<&str>) {
    let settings = Settings { epsilon: 1e-4, ..Settings::default() };
    let settings = settings.with_budget(budget.0, budget.1);
    let by = |n| {
        let task = Task::new(goal, state, rules).unwrap();
        match name.and_then(|name| AnySolver::named(name, &task, settings)) {
            Some(solver) => told(&task, solver, n),
            None => told(&task, Auto::new(&task, settings), n),
        }
    };
    let one = by(1);
    for n in [7, 1_000] {
        assert_eq!(by(n), one, "{name:?}, {budget:?}, {n} at once");
    }
}

#[test]
fn searches_end_where_they_end() {
    let pull = Rules { pull: true, ..Rules::default() };
    for (seed, n) in [(3, 2), (5, 3), (8, 5)] {
        let state = generate(&Plan { side: (8, 9), objects: (n, n) }, seed);
        let goal = bring(&state, n as usize);
        for steps in [0, 1, 333, 501, 1_777, 23_456, 60_000] {
            for states in [100, 1_000_000] {
                check(&goal, &state, pull, (steps, states), Some("astar"));
            }
            check(&goal, &state, Rules::default(), (steps, 1_000_000), None);
        }
    }
}

#[test]
fn a_plan_near_enough_ends_a_search_at_the_same_state() {
    let rules = Rules { pull: true, ..Rules::default() };
    let state = generate(&Plan { side: (10, 11), objects: (5, 5) }, 3);
    check(&bring(&state, 5), &state, rules, (400_000, 1_000_000), Some("astar"));
}

#[test]
fn policies_end_where_they_end() {
    for seed in [2, 9, 14] {
        let state = world(seed, 2);
        let chances = Chances::new(0.1, 0.3, 0.05).unwrap();
        let rules = Rules { pull: seed % 2 == 0, chances, ..Rules::default() };
        for goal in [bring(&state, 1), bring(&state, 2)] {
            for budget in [(100, 50), (5_000, 700), (40_000, 12_000)] {
                check(&goal, &state, rules, budget, None);
                for name in SOLVERS.into_iter().skip(1) {
                    check(&goal, &state, rules, budget, Some(name));
                }
            }
        }
    }
}
