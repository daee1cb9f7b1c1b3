//! Planning up to a horizon: the bounded search, and the validator of Table III that asks it, against the
//! breadth-first oracle. The horizon is the number of actions: a plan of just so many is found.

use super::{goals, oracle, world};
use groundling::domain::{Rules, State};
use groundling::ground::{Goal, Task, Validator};
use groundling::learn::{Config, PlannerCost, Planning, Trainer, Validation};
use groundling::logic::{TermId, Terms, read};
use groundling::mdp::{Outcome, Settings, Solver};
use groundling::plan::AStar;

/// A goal that is not reached yet: its term, the length of a shortest plan, and where one ends.
struct Case {
    world: State,
    form: TermId,
    length: Option<u32>,
    end: State,
}

/// Cases over small worlds, those that no plan reaches among them.
fn cases(terms: &mut Terms) -> Vec<Case> {
    let mut cases = Vec::new();
    for seed in 0..40 {
        let world = world(seed, 1);
        let all = goals(&world);
        let text = &all[seed as usize * 5 % all.len()];
        let form = read(terms, text).unwrap();
        let goal = Goal::new(terms, form, &world).unwrap();
        let length = oracle(&goal, &world, false).map(|n| u32::try_from(n).unwrap());
        if length == Some(0) {
            continue;
        }
        let task = Task::new(&goal, &world, Rules::default()).unwrap();
        let mut search = AStar::new(&task, Settings::default());
        let end = match (search.run(), search.plan()) {
            (Outcome::Solved, Some(plan)) => task.replay(&plan.actions).pop().unwrap(),
            _ => world.clone(),
        };
        cases.push(Case { world, form, length, end });
    }
    let reached = cases.iter().filter(|case| case.length.is_some()).count();
    assert!(reached > 20 && cases.len() - reached > 3, "{reached} of {}", cases.len());
    cases
}

#[test]
fn a_search_within_a_horizon_finds_plans_of_just_so_many_actions() {
    let mut terms = Terms::new();
    for Case { world, form, length, .. } in cases(&mut terms) {
        let goal = Goal::new(&terms, form, &world).unwrap();
        let task = Task::new(&goal, &world, Rules::default()).unwrap();
        let within = |n| {
            let mut search = AStar::within(&task, Settings::default(), n);
            match (search.run(), search.plan()) {
                (Outcome::Solved, Some(plan)) => Some(plan.actions.len() as u32),
                (Outcome::Unreachable, None) => None,
                other => panic!("{other:?}"),
            }
        };
        for n in 0..20 {
            assert_eq!(within(n), length.filter(|&length| length <= n), "within {n}");
        }
    }
}

/// Whether a planner of a horizon takes a form to explain a demonstration.
fn valid(terms: &Terms, form: TermId, (pre, post): (&State, &State), horizon: u32) -> bool {
    let mut validation = Validation::new(Some(Planning { horizon, ..Planning::default() }));
    let pair = validation.pair(pre, post);
    validation.valid(terms, form, &[pair])
}

#[test]
fn a_form_is_valid_when_a_plan_within_the_horizon_reaches_it() {
    let mut terms = Terms::new();
    for Case { world, form, length, end } in cases(&mut terms) {
        let valid_within = |n| valid(&terms, form, (&world, &end), n);
        match length {
            Some(length) => {
                assert!(valid_within(length) && valid_within(20), "{length} actions");
                assert!(!valid_within(length - 1), "one too few for {length} actions");
                // What was shown has to agree, and what holds already is not what was asked for.
                assert!(!valid(&terms, form, (&world, &world), 20), "not true after");
                assert!(!valid(&terms, form, (&end, &end), 20), "true before");
            }
            None => assert!(!valid_within(200), "nothing leads there"),
        }
    }
}

#[test]
fn with_a_far_horizon_the_planner_agrees_with_the_states_where_plans_exist() {
    let mut terms = Terms::new();
    for Case { world, form, length, end } in cases(&mut terms) {
        let mut validator = Validator::new();
        let pair = validator.pair(&world, &end);
        let by_states = validator.valid(&terms, form, &[pair]);
        assert_eq!(by_states, length.is_some());
        assert_eq!(valid(&terms, form, (&world, &end), 1_000), by_states);
    }
}

#[test]
fn a_memo_saves_calls_and_changes_no_answer() {
    let mut terms = Terms::new();
    let cases = cases(&mut terms);
    let ask = |memo| -> (Vec<bool>, PlannerCost) {
        let planning = Planning { horizon: 10, memo, ..Planning::default() };
        let mut validation = Validation::new(Some(planning));
        let mut answers = Vec::new();
        for _ in 0..3 {
            for Case { world, form, end, .. } in &cases {
                let pair = validation.pair(world, end);
                answers.push(validation.valid(&terms, *form, &[pair]));
            }
        }
        (answers, validation.cost().unwrap())
    };
    let ((with, kept), (without, anew)) = (ask(true), ask(false));
    assert_eq!(with, without);
    let n = cases.len() as u64;
    assert_eq!((kept.calls, kept.saved), (n, 2 * n));
    assert_eq!((anew.calls, anew.saved), (3 * n, 0));
    assert_eq!(anew.expanded, 3 * kept.expanded);
    assert_eq!((kept.given_up, anew.given_up), (0, 0));
}

#[test]
fn a_budget_that_is_spent_leaves_nothing_valid_and_is_told() {
    let mut terms = Terms::new();
    let cases = cases(&mut terms);
    let planning = Planning { budget: 0, ..Planning::default() };
    let mut validation = Validation::new(Some(planning));
    for Case { world, form, end, .. } in &cases {
        let pair = validation.pair(world, end);
        assert!(!validation.valid(&terms, *form, &[pair]));
    }
    let cost = validation.cost().unwrap();
    assert_eq!((cost.calls, cost.given_up), (cases.len() as u64, cases.len() as u64));
    assert_eq!(cost.expanded, 0);
}

#[test]
fn learning_calls_no_planner_unless_told_to() {
    let run = |planning| {
        let seed = groundling::learn::seed_model(groundling::learn::DEMONSTRATION_LEXICON).unwrap();
        let config = Config { planning, epochs: 2, ..Config::default() };
        let mut trainer = Trainer::new(seed, &crate::learn::six(), config);
        while !trainer.is_done() {
            trainer.step();
        }
        (trainer.planner_cost(), trainer.averaged())
    };
    let (cost, model) = run(None);
    assert_eq!(cost, None);
    assert_eq!(model.facts.get("horizon"), None);
    let (cost, planned) = run(Some(Planning::default()));
    assert!(cost.unwrap().calls > 0);
    assert_eq!(planned.facts.get("horizon").map(String::as_str), Some("20"));
    // Whatever the six ask can be reached in twenty steps: planning adds nothing but its cost.
    let entries = |model: &groundling::ccg::Model| model.lexicon.len();
    assert_eq!(entries(&model), entries(&planned));
    // In one step it cannot.
    let (_, short) = run(Some(Planning { horizon: 1, ..Planning::default() }));
    assert_eq!(short.facts.get("valid").map(String::as_str), Some("0"));
}
