//! The any-time search: whenever it is stopped it knows a plan, or none yet, and how long plans are at least; leaps are
//! what their actions do; pairs of objects make bounds sharper and keep their promises.

use super::{goal, planned, step, world};
use groundling::domain::{Action, Packed, Plan, Rules, State, generate};
use groundling::ground::{Goal, Task};
use groundling::mdp::{self, Leaps, Mdp, Outcome, Settings, Sharpened, Solver};
use groundling::plan::AnyTime;

/// The first objects of a world, each to be in another room.
pub(crate) fn bring(state: &State, n: usize) -> Goal {
    let the = |a: &str, b: &str| {
        format!("(the:<<e,t>,e> (lambda $0:e (and:<t*,t> ({a}:<e,t> $0) ({b}:<e,t> $0))))")
    };
    let part = |(i, object): (usize, &groundling::domain::Object)| {
        let room = &state.rooms[(i + 1) % state.rooms.len()];
        let object = the(object.shape.name(), object.color.name());
        format!("(in:<e,<e,t>> {object} {})", the("room", room.color.name()))
    };
    let parts: Vec<String> = state.objects.iter().take(n).enumerate().map(part).collect();
    goal(&format!("(and:<t*,t> {})", parts.join(" ")), state)
}

/// A task whose bounds are as sharp as they get.
fn sharp(goal: &Goal, state: &State, rules: Rules) -> Task {
    let task = Task::new(goal, state, rules).unwrap();
    while task.sharpen() != Sharpened::Whole {}
    task
}

#[test]
fn whenever_it_is_stopped_its_plan_is_one_and_no_plan_is_shorter_than_it_says() {
    let mut proved = 0;
    for seed in 0..24 {
        let state = world(seed * 3 + 1, 2);
        let goal = bring(&state, 2);
        let rules = Rules { pull: seed % 2 == 0, ..Rules::default() };
        let wanted = planned(&goal, &state, rules.pull);
        let task = Task::new(&goal, &state, rules).unwrap();
        for steps in [0, 10, 500, 600, 1_000, 1_000_000] {
            let mut solver = AnyTime::new(&task, Settings::default().with_budget(steps, 100_000));
            let outcome = solver.run();
            let plan = solver.plan();
            let least = solver.progress().least as usize;
            let Some(shortest) = wanted else {
                assert!(plan.is_none() && outcome != Outcome::Solved);
                continue;
            };
            assert!(least <= shortest, "{least} is more than {shortest}");
            let Some(plan) = plan else { continue };
            let end = plan.actions.iter().fold(state.clone(), |state, &a| step(&state, a));
            assert!(goal.holds(&end), "the plan does not reach the goal");
            assert!(plan.actions.len() >= shortest);
            if outcome == Outcome::Solved {
                proved += 1;
                assert_eq!(plan.actions.len(), shortest);
            }
        }
    }
    assert!(proved > 20, "{proved} proved");
}

#[test]
fn many_objects_have_a_plan_at_once() {
    for seed in [3, 5, 8] {
        let state = generate(&Plan { side: (10, 12), objects: (5, 5) }, seed);
        let goal = bring(&state, 5);
        let task = Task::new(&goal, &state, Rules { pull: true, ..Rules::default() }).unwrap();
        let mut solver = AnyTime::new(&task, Settings::default().with_budget(30_000, 100_000));
        let outcome = solver.run();
        let plan = solver.plan().expect("a plan");
        let end = plan.actions.iter().fold(state.clone(), |state, &a| step(&state, a));
        assert!(goal.holds(&end));
        let least = solver.progress().least as usize;
        assert!(least <= plan.actions.len() && (outcome == Outcome::Solved || least > 10));
    }
}

#[test]
fn pairs_keep_the_promises_of_a_bound_and_are_sharper() {
    let mut sharper = 0;
    for seed in 0..16 {
        let state = world(seed, 2);
        let goal = bring(&state, 2);
        let rules = Rules { pull: seed % 3 > 0, ..Rules::default() };
        let plain = Task::new(&goal, &state, rules).unwrap();
        let sharp = sharp(&goal, &state, rules);
        let seen = mdp::check(&sharp, 4_000, |_| true);
        assert!(seen.is_ok(), "{seen:?}");
        let start = sharp.initial();
        assert!(sharp.heuristic(start).is_none_or(|n| Some(n) >= plain.heuristic(start)));
        sharper += u32::from(sharp.heuristic(start) > plain.heuristic(start));
    }
    assert!(sharper > 3, "{sharper}");
}

#[test]
fn a_leap_is_what_its_actions_do() {
    for seed in 0..20 {
        let state = world(seed, 3);
        let goal = bring(&state, 3);
        let rules = Rules { pull: seed % 2 == 0, ..Rules::default() };
        let task = Task::new(&goal, &state, rules).unwrap();
        let mut at = task.initial();
        for n in 0..12 {
            let mut leaps = Leaps::default();
            task.leaps(at, &mut leaps);
            let mut found = Vec::new();
            for (leap, ends) in leaps.iter() {
                assert!(leap.is_sure() && ends.len() == 1);
                let mut actions = Vec::new();
                task.way(at, leap.number, &mut actions);
                assert_eq!(actions.len(), leap.cost as usize);
                assert_eq!(led(&task, at, &actions), ends[0].0);
                found.push(ends[0].0);
            }
            let Some(leap) = found.get((seed as usize * 7 + n * 5) % found.len().max(1)) else {
                break;
            };
            at = *leap;
        }
    }
}

/// Where sure actions lead.
fn led(task: &Task, from: Packed, actions: &[Action]) -> Packed {
    let mut out = Vec::new();
    actions.iter().fold(from, |from, &action| {
        out.clear();
        task.successors(from, action, &mut out);
        out[0].0
    })
}
