//! Shortest plans in the robot form and with landmarks that stay, against a breadth-first search over the plain
//! telling of the rules; and which objects a goal says to move.

use super::{goal, goals, world};
use crate::dynamics::plain::outcomes;
use groundling::domain::{Form, Movable, Rules, State, text};
use groundling::ground::{Goal, Task};
use groundling::mdp::{Outcome, Settings, Solver};
use groundling::plan::AStar;
use std::collections::{HashSet, VecDeque};

/// The length of a shortest plan in a world without chance.
fn oracle(goal: &Goal, initial: &State, rules: &Rules) -> Option<usize> {
    let mut seen = HashSet::from([initial.clone()]);
    let mut queue = VecDeque::from([(initial.clone(), 0)]);
    while let Some((state, depth)) = queue.pop_front() {
        if goal.holds(&state) {
            return Some(depth);
        }
        for &action in rules.actions() {
            let mut all = outcomes(&state, rules, action);
            assert_eq!(all.len(), 1);
            let next = all.swap_remove(0).0;
            if !seen.contains(&next) {
                seen.insert(next.clone());
                queue.push_back((next, depth + 1));
            }
        }
    }
    None
}

/// The length of a shortest plan by the planner, after the plain world has followed it.
fn planned(goal: &Goal, initial: &State, rules: Rules) -> Option<usize> {
    let task = Task::new(goal, initial, rules).unwrap();
    let mut search = AStar::new(&task, Settings::default());
    match (search.run(), search.plan()) {
        (Outcome::Solved, Some(plan)) => {
            let end = plan.actions.iter().fold(initial.clone(), |state, &action| {
                outcomes(&state, &rules, action).swap_remove(0).0
            });
            assert!(goal.holds(&end), "the plan does not reach the goal");
            Some(plan.actions.len())
        }
        (Outcome::Unreachable, None) => None,
        other => panic!("{other:?}"),
    }
}

#[test]
fn plans_are_shortest_in_every_form_of_the_world() {
    let (mut reached, mut unreachable) = (0, 0);
    for seed in 0..90 {
        let n = if seed % 5 == 0 { 2 } else { 1 };
        let state = world(seed, n);
        let all = goals(&state);
        let form = if seed % 3 == 0 { Form::Compass } else { Form::Robot };
        for i in 0..2 {
            let text = &all[(seed as usize * 5 + i * 3) % all.len()];
            let goal = goal(text, &state);
            let movable = if i == 0 { goal.movable(&state) } else { Movable::ALL };
            if n == 2 && movable == Movable::ALL {
                continue;
            }
            let rules = Rules { pull: seed % 4 == 0, form, movable, ..Rules::default() };
            let expected = oracle(&goal, &state, &rules);
            let found = planned(&goal, &state, rules);
            assert_eq!(found, expected, "{text}, {rules:?}\n{}", text::print(&state));
            match found {
                Some(_) => reached += 1,
                None => unreachable += 1,
            }
        }
    }
    assert!(reached > 80 && unreachable > 15, "{reached} reached, {unreachable} not");
}

/// A chair, a block beside the robot, a red block, two rooms.
const WORLD: &str = "###########\n#rrrrr+bbb#\n#r>Brr#bbb#\n#rrrCr#bRb#\n###########\n\n\
    r room red at 0 0 6 4\nb room blue at 6 0 10 4\n+ door unlocked\n\
    B block tan\nC chair green\nR block red\n";

fn the(what: &str) -> String {
    format!("(the:<<e,t>,e> {what})")
}

fn is(property: &str) -> String {
    the(&format!("{property}:<e,t>"))
}

fn tan() -> String {
    the("(lambda $0:e (and:<t*,t> (block:<e,t> $0) (tan:<e,t> $0)))")
}

#[test]
fn a_goal_says_what_may_be_moved() {
    let state = text::read_legal(WORLD).unwrap();
    let says = |r: &str, a: &str, b: &str| format!("({r}:<e,<e,t>> {a} {b})");
    let some = |body: &str| format!("(exists:<<e,t>,t> (lambda $0:e (and:<t*,t> {body})))");
    let blue = the("(lambda $0:e (and:<t*,t> (room:<e,t> $0) (blue:<e,t> $0)))");
    let (agent, chair, tan) = (is("agent"), is("chair"), tan());
    let here =
        the(&format!("(lambda $0:e (and:<t*,t> (room:<e,t> $0) {}))", says("in", &tan, "$0")));
    let order: Vec<&str> = state.objects.iter().map(|o| o.color.name()).collect();
    assert_eq!(order, ["tan", "green", "red"]);
    for (text, expected) in [
        (says("right", &agent, &tan), ""),
        (says("near", &tan, &chair), "tan"),
        (says("near", &chair, &agent), "green"),
        (
            format!("(and:<t*,t> {} {})", says("in", &tan, &blue), says("in", &chair, &blue)),
            "tan green",
        ),
        (
            format!("(or:<t*,t> {} {})", says("in", &tan, &blue), says("near", &agent, &chair)),
            "tan",
        ),
        // What shall not be so is undone only where it is so.
        (format!("(not:<t,t> {})", says("in", &tan, &blue)), ""),
        (format!("(not:<t,t> {})", says("in", &tan, &here)), "tan"),
        (some(&format!("(block:<e,t> $0) {}", says("in", "$0", &blue))), "tan red"),
        (some(&format!("(block:<e,t> $0) {}", says("near", &chair, "$0"))), "green"),
        (some(&format!("(room:<e,t> $0) {}", says("in", &chair, "$0"))), "green"),
        (some(&format!("(not:<t,t> (block:<e,t> $0)) {}", says("near", "$0", &tan))), "green"),
        (some(&format!("(object:<e,t> $0) {}", says("near", "$0", &tan))), "green red"),
        (some(&format!("(eq:<e,<e,t>> $0 {chair}) {}", says("near", "$0", &tan))), "green"),
    ] {
        let movable = goal(&text, &state).movable(&state);
        let found: Vec<&str> = (0..3).filter(|&i| movable.allows(i)).map(|i| order[i]).collect();
        assert_eq!(found.join(" "), expected, "{text}");
    }
}

#[test]
fn a_robot_walks_round_a_landmark() {
    let state = text::read_legal(WORLD).unwrap();
    let right = goal(&format!("(right:<e,<e,t>> {} {})", is("agent"), tan()), &state);
    let fixed = Rules { movable: right.movable(&state), ..Rules::default() };
    assert_eq!(planned(&right, &state, fixed), Some(4), "over the top, and down on its right");
    let free = Rules { pull: true, ..Rules::default() };
    assert_eq!(planned(&right, &state, free), Some(1), "pulls the block to its left");
    let robot = Rules { form: Form::Robot, ..fixed };
    assert_eq!(planned(&right, &state, robot), Some(7), "three quarter turns more");
}
