//! Plans for tasks over time are shortest: against the conformance file, and on random worlds against a breadth-first
//! search over plain states and residuals; with chance the solvers agree.

use super::commands::{in_room, reach};
use crate::command::{answers, run};
use crate::planning::{step, world};
use groundling::domain::{Action, Chances, Rules, State};
use groundling::ground::{Course, Monitor, Residual, Undertaking, errand};
use groundling::logic::{Terms, read};
use groundling::mdp::{Mdp, Outcome, Policy, Settings, Solver};
use groundling::plan::{Auto, ValueIteration};
use proptest::prelude::{ProptestConfig, TestCaseError, prop_assert, prop_assert_eq, proptest};
use serde_json::{Value, json};
use std::collections::{BTreeSet, VecDeque};

const PLANS: &str = include_str!("../../data/conformance/plans-time.jsonl");

#[test]
fn every_plan_of_the_conformance_file_has_its_length() {
    let output = run("plan", PLANS);
    assert!(output.status.success(), "{output:?}");
    for (case, answer) in PLANS.lines().zip(answers(&output)) {
        let case: Value = serde_json::from_str(case).unwrap();
        let reason = |value: &Value| value.get("reason").cloned();
        assert_eq!(
            (&answer["length"], reason(&answer)),
            (&case["length"], reason(&case)),
            "{case}"
        );
        let Some(length) = case["length"].as_u64() else { continue };
        let actions = answer["actions"].as_array().unwrap();
        assert_eq!(actions.len() as u64, length);
        assert!(satisfies(&case, actions), "{case}");
    }
}

/// Whether the run of these actions satisfies a case's goal at its last state and not before.
fn satisfies(case: &Value, actions: &[Value]) -> bool {
    let mut terms = Terms::new();
    let term = read(&mut terms, case["goal"].as_str().unwrap()).unwrap();
    let mut states = vec![State::read(&case["initial"].to_string()).unwrap()];
    for name in actions {
        let action =
            Action::ALL.iter().find(|action| action.name() == name.as_str().unwrap()).unwrap();
        states.push(step(states.last().unwrap(), *action));
    }
    let course = Course::new(&terms, term, &states[0]).unwrap();
    course.beginnings(&states).first() == Some(actions.len())
}

/// The length of a shortest way, by breadth-first search.
fn oracle(course: &Course, initial: &State) -> Option<usize> {
    type Key = (i32, i32, Vec<(i32, i32)>, Residual);
    let key = |s: &State, left: Residual| -> Key {
        (s.agent.x, s.agent.y, s.objects.iter().map(|o| (o.x, o.y)).collect(), left)
    };
    let mut monitor = Monitor::new(course.outline()).unwrap();
    let first = monitor.step(Monitor::START, course.valuation(initial)).unwrap();
    let mut seen = BTreeSet::from([key(initial, first)]);
    let mut queue = VecDeque::from([(initial.clone(), first, 0)]);
    while let Some((state, left, depth)) = queue.pop_front() {
        if monitor.satisfies(left) {
            return Some(depth);
        }
        if monitor.fails(left) {
            continue;
        }
        for &action in &Action::ALL[..4] {
            let next = step(&state, action);
            let left = monitor.step(left, course.valuation(&next)).unwrap();
            if seen.insert(key(&next, left)) {
                queue.push_back((next, left, depth + 1));
            }
        }
    }
    None
}

/// Tasks about the rooms of a world, by their colours, and its first object.
fn tasks(state: &State) -> Vec<String> {
    let rooms: Vec<String> = state.rooms.iter().map(|room| in_room(room.color.name())).collect();
    let at = |index: usize| rooms[index % rooms.len()].clone();
    let (a, b, c) = (at(0), at(1), at(2));
    let never = |what: &str| format!("(always:<t,p> (not:<t,t> {what}))");
    let all = |one: &str, other: &str| format!("(all:<p*,p> {one} {other})");
    let sequence = reach(&a, &reach(&b, "done:p"));
    let mut tasks = vec![
        sequence.clone(),
        reach(&a, &reach(&b, &reach(&c, "done:p"))),
        all(&never(&c), &reach(&b, "done:p")),
        all(&never(&c), &sequence),
        format!("(any:<p*,p> {} {})", reach(&a, "done:p"), reach(&b, &reach(&c, "done:p"))),
        format!("(until:<t,<t,<p,p>>> (not:<t,t> {c}) {b} {})", reach(&c, "done:p")),
    ];
    if let Some(object) = state.objects.first() {
        let near = format!(
            "(near:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) (the:<<e,t>,e> {}:<e,t>))",
            object.shape.name()
        );
        tasks.push(reach(&near, &reach(&a, "done:p")));
        tasks.push(all(&never(&near), &sequence));
    }
    tasks
}

/// Plans for a world's tasks are as short as the search's, and their bound never grows by more than an action.
fn are_shortest(seed: u64, objects: u32) -> Result<(), TestCaseError> {
    let initial = world(seed, objects);
    for text in tasks(&initial) {
        let mut terms = Terms::new();
        let term = read(&mut terms, &text).unwrap();
        is_shortest(&Course::new(&terms, term, &initial).unwrap(), &initial, &text)?;
    }
    Ok(())
}

/// The same of one task; the length of its plan, if there is one.
pub(super) fn is_shortest(
    course: &Course,
    initial: &State,
    text: &str,
) -> Result<Option<usize>, TestCaseError> {
    let task = Undertaking::course(course, initial, Rules::default()).unwrap();
    let mut solver = Auto::new(&task, Settings::default());
    let outcome = solver.run();
    let expected = oracle(course, initial);
    prop_assert_eq!(outcome == Outcome::Solved, expected.is_some(), "{}", text);
    let Some(length) = expected else { return Ok(None) };
    let (mut state, mut out, mut taken) = (task.initial(), Vec::new(), 0);
    while !task.is_terminal(state) {
        prop_assert!(taken < length, "{}", text);
        out.clear();
        task.successors(state, solver.action(state).unwrap(), &mut out);
        let (here, there) = (task.heuristic(state).unwrap(), task.heuristic(out[0].0));
        let is_consistent = there.is_some_and(|there| here <= there + 1);
        prop_assert!(is_consistent, "{} then {:?}: {}", here, there, text);
        (state, taken) = (out[0].0, taken + 1);
    }
    prop_assert_eq!(taken, length, "{}", text);
    Ok(Some(length))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]
    #[test]
    fn plans_are_as_short_as_breadth_first_search_finds(seed in 0_u64..10_000, objects in 0_u32..2) {
        are_shortest(seed, objects)?;
    }
}

/// A way whose last two steps are reached at once.
#[test]
fn bounds_hold_where_steps_coincide() {
    are_shortest(8975, 1).unwrap();
}

#[test]
fn solvers_agree_where_actions_slip() {
    let case: Value = serde_json::from_str(PLANS.lines().next().unwrap()).unwrap();
    let ask = |solver: &str| {
        json!({ "goal": case["goal"], "initial": case["initial"], "slip_probability": 0.2, "solver": solver, "rollouts": 50 })
            .to_string()
            + "\n"
    };
    let output = run("plan", &["vi", "lrtdp", "auto"].map(ask).concat());
    assert!(output.status.success(), "{output:?}");
    let answers = answers(&output);
    let values: Vec<f64> = answers.iter().map(|answer| answer["value"].as_f64().unwrap()).collect();
    assert!(
        values.iter().all(|value| (value - values[0]).abs() < 1e-5 && *value > 0.0),
        "{values:?}"
    );
    // A run never breaks what was to hold all along, whatever slips; so all that end are successes.
    assert!(
        answers.iter().all(|answer| answer["rollouts"]["successes"].as_u64().unwrap() > 0),
        "{answers:?}"
    );
    // What runs earn is what the values say: within twice what 95 % of samples leave open.
    for (answer, value) in answers.iter().zip(&values) {
        let runs = |name: &str| answer["rollouts"][name].as_f64().unwrap();
        let off = (runs("mean_return") - value).abs();
        assert!(off <= 2.0 * runs("return_margin") + 1e-9, "{answer}");
    }
}

/// Plans are made of walks to where the stage changes; what a state is worth does not hang on it.
fn are_worth_what_actions_alone_earn(seed: u64, pull: bool) -> Result<(), TestCaseError> {
    let initial = world(seed, 1);
    let chances = Chances::new(0.2, 0.0, 0.1).unwrap();
    let rules = Rules { pull, chances, ..Rules::default() };
    for text in tasks(&initial) {
        let mut terms = Terms::new();
        let term = read(&mut terms, &text).unwrap();
        let course = Course::new(&terms, term, &initial).unwrap();
        let leaping = Undertaking::course(&course, &initial, rules).unwrap();
        let mut leaping = ValueIteration::new(&leaping, Settings::default());
        let stepping = errand(&course, &initial, rules).unwrap();
        let mut stepping = ValueIteration::new(&stepping, Settings::default());
        prop_assert_eq!(leaping.run(), stepping.run(), "{}", text);
        let [most, worth] = [leaping.progress().upper, stepping.progress().upper];
        prop_assert!((most - worth).abs() < 1e-4, "{} or {}: {}", most, worth, text);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 6, ..ProptestConfig::default() })]
    #[test]
    fn states_are_worth_what_actions_alone_earn(seed in 0_u64..10_000, pull in proptest::bool::ANY) {
        are_worth_what_actions_alone_earn(seed, pull)?;
    }
}

#[test]
fn what_is_in_the_way_is_told() {
    let goals = PLANS.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
    let case = goals.into_iter().find(|case| case["reason"] == "unreachable").unwrap();
    let output = run("plan", &(case.to_string() + "\n"));
    let answer = &answers(&output)[0];
    let blocked = answer["blocked_by"].as_array().unwrap();
    assert_eq!(blocked.len(), 1, "{answer}");
    assert!(blocked[0].as_str().unwrap().starts_with("(always:<t,p>"), "{answer}");
    // What is never so has nothing in its way.
    let failed = json!({ "goal": "failed:p", "initial": case["initial"] }).to_string();
    let output = run("plan", &(failed + "\n"));
    assert_eq!(answers(&output)[0]["reason"], "unreachable");
}
