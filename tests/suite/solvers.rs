//! Solvers agree with each other and with plain oracles of the tests' own, on problems of no particular world.

#[path = "solvers/toy.rs"]
pub(crate) mod toy;

use groundling::mdp::{Mdp, Outcome, Policy, Settings, Solver, StartingAt};
use groundling::plan::{AStar, Auto, Lrtdp, ValueIteration, Why};
use toy::{Toy, values};

/// The solvers that prove what they say, at a problem.
fn provers(toy: &Toy) -> Vec<Box<dyn Solver<u32, u8> + '_>> {
    let settings = Settings::default();
    vec![
        Box::new(AStar::new(toy, settings)),
        Box::new(ValueIteration::new(toy, settings)),
        Box::new(Lrtdp::new(toy, settings)),
    ]
}

#[test]
fn values_are_those_of_plain_value_iteration() {
    let epsilon = Settings::default().epsilon;
    let (mut reached, mut vain) = (0, 0);
    for seed in 0..300 {
        let toy = Toy::new(seed, 4 + seed as u32 % 40, seed % 3 > 0);
        let values = values(&toy, Settings::default().discount);
        let wanted = values[0];
        for mut solver in provers(&toy) {
            let name = solver.name();
            let outcome = solver.run();
            if outcome == Outcome::Unfit {
                assert_eq!((name, toy.is_sure), ("astar", false), "seed {seed}");
                continue;
            }
            let progress = solver.progress();
            if wanted == 0.0 {
                vain += 1;
                assert_eq!(outcome, Outcome::Unreachable, "{name}, seed {seed}");
                assert_eq!(progress.upper, 0.0, "{name}, seed {seed}");
                continue;
            }
            reached += 1;
            assert_eq!(outcome, Outcome::Solved, "{name}, seed {seed}");
            let value = solver.value(0).unwrap();
            assert!(
                (value - wanted).abs() <= epsilon,
                "{name}, seed {seed}: {value}, not {wanted}"
            );
            assert!(progress.lower <= wanted + epsilon && wanted - epsilon <= progress.upper);
            assert!(progress.upper - progress.lower <= epsilon * 1.01, "{name}: {progress:?}");
        }
    }
    assert!(reached > 400 && vain > 20, "{reached} reached, {vain} in vain");
}

#[test]
fn a_policy_earns_its_value() {
    for seed in 0..100 {
        let toy = Toy::new(seed, 30, seed % 2 == 0);
        for mut solver in provers(&toy) {
            if solver.run() != Outcome::Solved || toy.is_terminal(0) {
                continue;
            }
            let (name, value) = (solver.name(), solver.value(0).unwrap());
            let earned = toy::earned(&toy, Settings::default().discount, |s| solver.action(s));
            assert!((earned - value).abs() < 1e-5, "{name}, seed {seed}: {earned}, not {value}");
        }
    }
}

#[test]
fn sure_problems_have_the_length_of_a_breadth_first_search() {
    for seed in 0..200 {
        let toy = Toy::new(seed, 60, true);
        let length = toy.steps(0);
        let wanted = length.map_or(0.0, |n| Settings::default().worth(n));
        for mut solver in provers(&toy) {
            solver.run();
            let value = solver.value(0).unwrap_or(0.0);
            assert!((value - wanted).abs() < 1e-9, "{}: {value}, not {wanted}", solver.name());
        }
    }
}

#[test]
fn solvers_can_be_pumped_and_stay_ended() {
    for seed in 0..20 {
        let toy = Toy::new(seed, 30, seed % 2 == 0);
        for (mut whole, mut pumped) in provers(&toy).into_iter().zip(provers(&toy)) {
            let outcome = whole.run();
            let mut bounds = pumped.progress();
            let end = loop {
                if let Some(outcome) = pumped.step(1) {
                    break outcome;
                }
                let now = pumped.progress();
                assert!(now.lower >= bounds.lower - 1e-12 && now.upper <= bounds.upper + 1e-12);
                bounds = now;
            };
            assert_eq!(end, outcome, "{}", whole.name());
            assert_eq!(pumped.step(1), Some(outcome));
            assert_eq!(format!("{:?}", pumped.progress()), format!("{:?}", whole.progress()));
        }
    }
}

#[test]
fn a_budget_that_runs_out_is_said_and_bounds_hold() {
    for seed in 0..60 {
        let toy = Toy::new(seed, 40, seed % 2 == 0);
        let wanted = values(&toy, Settings::default().discount)[0];
        for (steps, states) in [(0, 100), (100, 0), (1, 100), (7, 100), (100, 5), (30, 30)] {
            let settings = Settings::default().with_budget(steps, states);
            let solvers: [Box<dyn Solver<u32, u8> + '_>; 3] = [
                Box::new(AStar::new(&toy, settings)),
                Box::new(ValueIteration::new(&toy, settings)),
                Box::new(Lrtdp::new(&toy, settings)),
            ];
            for mut solver in solvers {
                let outcome = solver.run();
                let progress = solver.progress();
                let said =
                    format!("{} {outcome:?} {progress:?} {wanted} seed {seed}", solver.name());
                assert!(
                    progress.lower <= wanted + 1e-6 && wanted <= progress.upper + 1e-6,
                    "{said}"
                );
                if (steps == 0 || states == 0) && !toy.is_terminal(0) && toy.heuristic(0).is_some()
                {
                    assert_ne!(outcome, Outcome::Solved, "{said}");
                }
                if outcome == Outcome::Unreachable {
                    assert_eq!(wanted, 0.0, "{said}");
                }
            }
        }
    }
}

#[test]
fn a_problem_can_begin_elsewhere() {
    for seed in 0..40 {
        let toy = Toy::new(seed, 20, false);
        let values = values(&toy, Settings::default().discount);
        for start in 0..20 {
            let there = StartingAt::new(&toy, start);
            assert_eq!(there.initial(), start);
            let mut solver = ValueIteration::new(&there, Settings::default());
            solver.run();
            let value = solver.value(start).unwrap_or(0.0);
            assert!((value - values[start as usize]).abs() < 1e-6);
        }
    }
}

/// A problem that knows no bounds.
struct Blind(Toy);

impl Mdp for Blind {
    type State = u32;
    type Action = u8;

    fn initial(&self) -> u32 {
        self.0.initial()
    }
    fn actions(&self) -> &[u8] {
        self.0.actions()
    }
    fn successors(&self, state: u32, action: u8, out: &mut Vec<(u32, f64)>) {
        self.0.successors(state, action, out);
    }
    fn is_terminal(&self, state: u32) -> bool {
        self.0.is_terminal(state)
    }
}

#[test]
fn without_bounds_values_are_the_same_and_what_cannot_be_reached_is_proved_so() {
    let settings = Settings::default();
    let (mut solved, mut vain) = (0, 0);
    for seed in 0..120 {
        let blind = Blind(Toy::new(seed, 30, seed % 2 == 0));
        let wanted = values(&blind.0, settings.discount)[0];
        let solvers: [Box<dyn Solver<u32, u8> + '_>; 3] = [
            Box::new(AStar::new(&blind, settings)),
            Box::new(ValueIteration::new(&blind, settings)),
            Box::new(Lrtdp::new(&blind, settings)),
        ];
        for mut solver in solvers {
            let outcome = solver.run();
            let said = format!("{} {outcome:?} seed {seed}", solver.name());
            match outcome {
                Outcome::Solved => {
                    solved += 1;
                    let value = solver.value(0).unwrap();
                    assert!((value - wanted).abs() < 1e-6, "{said}: {value}, not {wanted}");
                }
                Outcome::Unreachable => {
                    vain += 1;
                    assert_eq!((wanted, solver.progress().upper), (0.0, 0.0), "{said}");
                }
                Outcome::Unfit => assert!(!blind.0.is_sure, "{said}"),
                Outcome::Budget => panic!("{said}"),
            }
        }
    }
    assert!(solved > 100 && vain > 20, "{solved} solved, {vain} in vain");
}

/// A square of cells with nowhere to arrive: any step may slip, and nothing says how far the goal is.
#[derive(Clone, Copy)]
struct Nowhere {
    side: u32,
}

impl Mdp for Nowhere {
    type State = u32;
    type Action = u8;

    fn initial(&self) -> u32 {
        0
    }
    fn actions(&self) -> &[u8] {
        &[0, 1, 2, 3]
    }
    fn successors(&self, state: u32, action: u8, out: &mut Vec<(u32, f64)>) {
        let (x, y) = (state % self.side, state / self.side);
        let last = self.side - 1;
        let (x, y) = match action {
            0 => ((x + 1).min(last), y),
            1 => (x.saturating_sub(1), y),
            2 => (x, (y + 1).min(last)),
            _ => (x, y.saturating_sub(1)),
        };
        let next = y * self.side + x;
        if next == state {
            out.push((state, 1.0));
        } else {
            out.extend([(next, 0.75), (state, 0.25)]);
        }
    }
    fn is_terminal(&self, _: u32) -> bool {
        false
    }
}

#[test]
fn the_chooser_proves_that_there_is_no_way_or_says_that_it_does_not_know() {
    // More states than are numbered at once, and few enough to look at each.
    let mut auto =
        Auto::new(Nowhere { side: 110 }, Settings::default().with_budget(60_000, 50_000));
    assert_eq!(auto.run(), Outcome::Unreachable);
    let progress = auto.progress();
    assert_eq!((progress.lower, progress.upper), (0.0, 0.0));
    // Too many for the budget: nothing is proved, and nothing is said to be.
    let mut auto =
        Auto::new(Nowhere { side: 400 }, Settings::default().with_budget(60_000, 50_000));
    assert_eq!(auto.run(), Outcome::Budget);
    assert_eq!((auto.why(), auto.value(0)), (Why::Spent, None));
    assert!(auto.progress().upper > 0.0);
}
