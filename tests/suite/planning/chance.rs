//! Planning where things go wrong: solvers agree with each other and with plain sweeps over the world as it is, what
//! runs of a policy earn is what the policy is worth, and a plan is made anew when the world does not follow it.

use super::{far_goal, goal, goals, oracle, world};
use crate::solvers::toy;
use groundling::domain::{Chances, Rules, text};
use groundling::ground::Task;
use groundling::mdp::{
    self, Mdp, Outcome, Policy, RolloutSettings, Rollouts, Settings, Solver, StartingAt,
};
use groundling::plan::{AStar, AnySolver, Auto, Uct, ValueIteration, Why};

/// Tasks in random worlds under random rules, with at most so many states.
fn tasks(seeds: std::ops::Range<u64>, most: usize) -> Vec<(String, Task)> {
    let mut tasks = Vec::new();
    for seed in seeds {
        let (state, rules) = crate::dynamics::chances::random(seed);
        let all = goals(&state);
        let text = &all[seed as usize * 7 % all.len()];
        let task = Task::new(&goal(text, &state), &state, rules).unwrap();
        if mdp::check(&task, most, |_| true).unwrap() < most {
            tasks.push((format!("{text} {rules:?}\n{}", text::print(&state)), task));
        }
    }
    tasks
}

#[test]
fn solvers_agree_with_plain_sweeps_over_the_world() {
    let settings = Settings { epsilon: 1e-7, ..Settings::default() };
    let (mut solved, mut vain) = (0, 0);
    for (name, task) in tasks(0..400, 4_000) {
        let wanted = toy::plain_value(&task, settings.discount);
        for solver in ["astar", "vi", "lrtdp", "auto"] {
            let mut solver: Box<dyn Solver<_, _>> = match solver {
                "auto" => Box::new(Auto::new(&task, settings)),
                named => Box::new(AnySolver::named(named, &task, settings).unwrap()),
            };
            match solver.run() {
                Outcome::Solved => {
                    solved += 1;
                    let value = solver.value(task.initial()).unwrap();
                    let said = format!("{}: {value}, not {wanted}: {name}", solver.name());
                    assert!((value - wanted).abs() < 1e-6, "{said}");
                }
                Outcome::Unreachable => {
                    vain += 1;
                    assert_eq!(wanted, 0.0, "{}: {name}", solver.name());
                }
                Outcome::Unfit => assert!(!task.is_deterministic(), "{name}"),
                // Worth next to nothing, or nothing: bounds alone do not tell.
                Outcome::Budget => assert!(wanted < 1e-6, "{}: {name}", solver.name()),
            }
        }
    }
    assert!(solved > 400 && vain > 40, "{solved} solved, {vain} in vain");
}

#[test]
fn the_world_without_quotient_is_worth_the_same() {
    for (name, task) in tasks(1_000..1_060, 1_500) {
        let settings = Settings::default();
        let mut plain = ValueIteration::new(task.world(), settings);
        let mut folded = ValueIteration::new(&task, settings);
        assert_eq!(plain.run(), folded.run(), "{name}");
        let (a, b) = (plain.progress().lower, folded.progress().lower);
        assert!((a - b).abs() < 2e-6, "{a} and {b}: {name}");
    }
}

#[test]
fn runs_earn_what_the_policy_is_worth() {
    let (mut held, mut all) = (0, 0);
    for (name, task) in tasks(2_000..2_080, 3_000) {
        let mut solver = Auto::new(&task, Settings::default());
        if solver.run() != Outcome::Solved || task.is_terminal(task.initial()) {
            continue;
        }
        let value = solver.value(task.initial()).unwrap();
        let settings = RolloutSettings { runs: 1_000, ..RolloutSettings::default() };
        let make = |_| -> Auto<&Task> { panic!("the policy knows all that it may meet") };
        let report = Rollouts::new(&task, settings, solver, make).run();
        all += 1;
        let off = (report.mean_return - value).abs();
        held += u32::from(off <= report.return_margin + 1e-9);
        assert!(off <= 2.5 * report.return_margin + 1e-9, "{report:?}, not {value}: {name}");
        assert!(report.interval.0 <= 1.0 && report.interval.0 <= report.interval.1);
    }
    // 95 % of the intervals hold the value, give or take.
    assert!(all > 25 && held * 100 >= all * 85, "{held} of {all}");
}

#[test]
fn a_plan_is_made_anew_when_the_world_does_not_follow_it() {
    let mut replans = 0;
    for seed in 0..12 {
        let mut state = world(seed, 1);
        for door in &mut state.doors {
            door.lock = groundling::domain::Lock::Unlocked;
        }
        let goal = goal(&goals(&state)[14], &state);
        let expected = Task::new(&goal, &state, Rules::default()).unwrap();
        let mut plan =
            AStar::new(StartingAt::new(&expected, expected.initial()), Settings::default());
        if plan.run() != Outcome::Solved {
            continue;
        }
        // Of what the plan knows nothing: slips leave it where it is, losses leave the object behind.
        let chances = Chances::new(0.2, 0.0, 0.3).unwrap();
        let real = Task::new(&goal, &state, Rules { chances, ..Rules::default() }).unwrap();
        let settings = RolloutSettings { runs: 50, ..RolloutSettings::default() };
        let anew = |from| AStar::new(StartingAt::new(&expected, from), Settings::default());
        let mut rollouts = Rollouts::new(&real, settings, plan, anew);
        let mut pumped = Rollouts::new(&real, settings, anew(real.initial()), anew);
        let report = rollouts.run();
        assert_eq!((report.runs, report.successes), (50, 50));
        assert!(report.interval.0 > 0.9);
        replans += report.replans;
        while pumped.step(3).is_none() {}
        assert_eq!(pumped.report().mean_steps, report.mean_steps);
    }
    assert!(replans < 12 * 50, "{replans}");
}

#[test]
fn what_trials_suggest_is_good_and_the_same_each_time() {
    let (mut earned, mut best) = (0.0, 0.0);
    for (name, task) in tasks(3_000..3_080, 2_000) {
        let settings = Settings { seed: 7, ..Settings::default() }.with_budget(40_000, 100_000);
        let mut optimal = ValueIteration::new(&task, Settings::default());
        if optimal.run() != Outcome::Solved || task.is_terminal(task.initial()) {
            continue;
        }
        let from = |state| Uct::new(StartingAt::new(&task, state), settings);
        let (mut first, mut again) = (from(task.initial()), from(task.initial()));
        assert_eq!(first.run(), Outcome::Budget, "{name}");
        while again.step(100).is_none() {}
        assert_eq!(first.value(task.initial()), again.value(task.initial()));
        assert_eq!(first.trials(), again.trials());
        let settings = RolloutSettings { runs: 30, ..RolloutSettings::default() };
        earned += Rollouts::new(&task, settings, first, from).run().mean_return;
        best += optimal.value(task.initial()).unwrap();
    }
    assert!(earned > 0.75 * best, "{earned} of {best}");
}

#[test]
fn the_chooser_goes_by_chance_and_size_and_says_so() {
    let (state, far) = far_goal();
    let rules = |slip| Rules { chances: Chances::new(slip, 0.0, 0.0).unwrap(), ..Rules::default() };
    let sure = Task::new(&far, &state, rules(0.0)).unwrap();
    let odd = Task::new(&far, &state, rules(0.1)).unwrap();
    let run = |task, settings| {
        let mut auto = Auto::new(task, settings);
        let outcome = auto.run();
        (auto.name(), auto.why(), outcome)
    };
    let settings = Settings::default();
    assert_eq!(run(&sure, settings), ("astar", Why::Sure, Outcome::Solved));
    assert_eq!(run(&odd, settings), ("vi", Why::Small, Outcome::Solved));
    let state = world(1, 2);
    let rooms = goals(&state).into_iter().skip(10).map(|text| goal(&text, &state));
    let near = rooms.into_iter().find(|goal| oracle(goal, &state, false) > Some(2)).unwrap();
    let large = Task::new(&near, &state, rules(0.1)).unwrap();
    let few = settings.with_budget(1_000_000, 60);
    assert_eq!(run(&large, few), ("lrtdp", Why::Large(60), Outcome::Solved));
    assert_eq!(run(&odd, settings.with_budget(50, 1_000)), ("uct", Why::Spent, Outcome::Budget));
    assert_eq!(run(&sure, settings.with_budget(0, 0)), ("uct", Why::Spent, Outcome::Budget));
    let words = [Why::Sure, Why::Small, Why::Large(9), Why::Spent].map(|why| why.to_string());
    assert!(words.iter().all(|words| words.len() > 40) && words[2].contains('9'));
}

#[test]
fn intervals_are_wilsons() {
    let near =
        |(a, b): (f64, f64), (c, d): (f64, f64)| (a - c).abs() < 5e-4 && (b - d).abs() < 5e-4;
    assert!(near(mdp::wilson(0, 10), (0.0, 0.2775)));
    assert!(near(mdp::wilson(5, 10), (0.2366, 0.7634)));
    assert!(near(mdp::wilson(10, 10), (0.7225, 1.0)));
    assert_eq!(mdp::wilson(0, 0), (0.0, 1.0));
}
