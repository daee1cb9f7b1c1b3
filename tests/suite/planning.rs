//! Plans are shortest: against the conformance file, and on random worlds against a breadth-first search
//! that has its own, plain idea of how the world moves.

#[path = "planning/anytime.rs"]
mod anytime;
#[path = "planning/bounds.rs"]
mod bounds;
#[path = "planning/chance.rs"]
mod chance;
#[path = "planning/forms.rs"]
mod forms;
#[path = "planning/horizon.rs"]
mod horizon;
#[path = "planning/pump.rs"]
mod pump;

use groundling::domain::{
    Action, Cell, Direction, Lock, Plan, Rules, State, cell_at, generate, text,
};
use groundling::ground::{Goal, Task};
use groundling::logic::{Terms, read};
use groundling::mdp::{self, Mdp, Outcome, Settings, Solver};
use groundling::plan::AStar;
use std::cell::Cell as Counter;
use std::collections::{BTreeSet, VecDeque};

fn goal(text: &str, initial: &State) -> Goal {
    let mut terms = Terms::new();
    let term = read(&mut terms, text).unwrap_or_else(|e| panic!("{text}: {e}"));
    Goal::new(&terms, term, initial).unwrap()
}

/// The length of a shortest plan, after its actions were seen to reach the goal.
fn planned(goal: &Goal, initial: &State, pull: bool) -> Option<usize> {
    let task = Task::new(goal, initial, Rules { pull, ..Rules::default() }).unwrap();
    let mut search = AStar::new(&task, Settings::default());
    match (search.run(), search.plan()) {
        (Outcome::Solved, Some(plan)) => {
            assert_eq!(plan.states.len(), plan.actions.len() + 1);
            let mut state = initial.clone();
            for (i, &action) in plan.actions.iter().enumerate() {
                assert!(!goal.holds(&state), "the goal is reached before the end");
                state = step(&state, action);
                assert_eq!(task.replay(&plan.actions)[i + 1], state, "the replay differs");
            }
            assert!(goal.holds(&state), "the plan does not reach the goal");
            Some(plan.actions.len())
        }
        (Outcome::Unreachable, None) => None,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_conformance_file_is_met() {
    for line in include_str!("../data/conformance/plans.jsonl").lines() {
        let case: serde_json::Value = serde_json::from_str(line).unwrap();
        let initial = State::read(&case["initial"].to_string()).unwrap();
        let goal = goal(case["goal"].as_str().unwrap(), &initial);
        let pull = case["pull"].as_bool().unwrap();
        let length = case["length"].as_u64().map(|n| usize::try_from(n).unwrap());
        assert_eq!(planned(&goal, &initial, pull), length, "{line}");
    }
}

/// What an action does, as METHOD's third section says it, on plain states.
pub(crate) fn step(state: &State, action: Action) -> State {
    let is_free = |x, y| match cell_at(&state.rooms, &state.doors, x, y) {
        Cell::Wall => false,
        Cell::Floor => true,
        Cell::Door(d) => state.doors[d].lock != Lock::Locked,
    };
    let thing_at = |x, y| state.objects.iter().position(|o| (o.x, o.y) == (x, y));
    let mut next = state.clone();
    let (x, y) = (state.agent.x, state.agent.y);
    let direction = match action {
        Action::North => Direction::North,
        Action::South => Direction::South,
        Action::East => Direction::East,
        Action::West => Direction::West,
        Action::Pull | Action::Forward => state.agent.direction,
        Action::TurnLeft | Action::TurnRight => panic!("an action of the robot form"),
    };
    let (dx, dy) = direction.step();
    let (ahead, beyond) = ((x + dx, y + dy), (x + 2 * dx, y + 2 * dy));
    let mut entered = Vec::new();
    if action == Action::Pull {
        if let Some(o) = thing_at(ahead.0, ahead.1)
            && is_free(x, y)
            && is_free(ahead.0, ahead.1)
        {
            (next.objects[o].x, next.objects[o].y) = (x, y);
            (next.agent.x, next.agent.y) = ahead;
            next.agent.direction = direction.opposite();
            entered = vec![ahead, (x, y)];
        }
    } else {
        next.agent.direction = direction;
        if is_free(ahead.0, ahead.1) {
            match thing_at(ahead.0, ahead.1) {
                None => {
                    (next.agent.x, next.agent.y) = ahead;
                    entered = vec![ahead];
                }
                Some(o)
                    if is_free(beyond.0, beyond.1) && thing_at(beyond.0, beyond.1).is_none() =>
                {
                    (next.objects[o].x, next.objects[o].y) = beyond;
                    (next.agent.x, next.agent.y) = ahead;
                    entered = vec![ahead, beyond];
                }
                Some(_) => {}
            }
        }
    }
    for (x, y) in entered {
        if let Some(door) = next.doors.iter_mut().find(|d| d.bounds.contains(x, y)) {
            door.lock = Lock::Unlocked;
        }
    }
    next
}

/// The length of a shortest plan by breadth-first search.
fn oracle(goal: &Goal, initial: &State, pull: bool) -> Option<usize> {
    type Key = (i32, i32, Option<Direction>, Vec<(i32, i32)>);
    let key = |s: &State| -> Key {
        let objects = s.objects.iter().map(|o| (o.x, o.y)).collect();
        (s.agent.x, s.agent.y, pull.then_some(s.agent.direction), objects)
    };
    let actions = &Action::ALL[..if pull { 5 } else { 4 }];
    let mut seen = BTreeSet::from([key(initial)]);
    let mut queue = VecDeque::from([(initial.clone(), 0)]);
    while let Some((state, depth)) = queue.pop_front() {
        if goal.holds(&state) {
            return Some(depth);
        }
        for &action in actions {
            let next = step(&state, action);
            if seen.insert(key(&next)) {
                queue.push_back((next, depth + 1));
            }
        }
    }
    None
}

/// A small world with its first doors locked, or never tried, now and then.
pub(crate) fn world(seed: u64, objects: u32) -> State {
    let mut state = generate(&Plan { side: (7, 7), objects: (objects, objects) }, seed);
    state.doors[0].lock = Lock::ALL[(seed % 3) as usize];
    if seed.is_multiple_of(7) {
        state.doors[1].lock = Lock::Locked;
    }
    state
}

/// Goals of every form over a world, in the reader's text.
fn goals(state: &State) -> Vec<String> {
    let the = |p: &str| format!("(the:<<e,t>,e> {p})");
    let both =
        |a: &str, b: &str| format!("(lambda $0:e (and:<t*,t> ({a}:<e,t> $0) ({b}:<e,t> $0)))");
    let agent = the("agent:<e,t>");
    let thing: Vec<String> =
        state.objects.iter().map(|o| the(&both(o.shape.name(), o.color.name()))).collect();
    let first = &thing[0];
    let last = &thing[thing.len() - 1];
    let room: Vec<String> =
        state.rooms.iter().map(|r| the(&both("room", r.color.name()))).collect();
    let says = |r: &str, a: &str, b: &str| format!("({r}:<e,<e,t>> {a} {b})");
    let not = |a: String| format!("(not:<t,t> {a})");
    let and = |a: String, b: String| format!("(and:<t*,t> {a} {b})");
    let or = |a: String, b: String| format!("(or:<t*,t> {a} {b})");
    let mut all = vec![
        says("near", &agent, first),
        says("left", &agent, first),
        says("right", &agent, last),
        says("left", first, &agent),
        and(says("in", &agent, &room[0]), says("in", first, &room[1])),
        or(says("in", first, &room[2]), says("in", last, &room[1])),
        not(says("in", first, &room[0])),
        and(not(says("near", &agent, first)), says("in", &agent, &room[1])),
        format!(
            "(exists:<<e,t>,t> (lambda $0:e (and:<t*,t> (object:<e,t> $0) (in:<e,<e,t>> $0 {}))))",
            room[1]
        ),
        not(format!(
            "(exists:<<e,t>,t> (lambda $0:e (and:<t*,t> (object:<e,t> $0) (in:<e,<e,t>> $0 {}))))",
            room[0]
        )),
    ];
    all.extend(room.iter().map(|r| says("in", &agent, r)));
    all.extend(room.iter().map(|r| says("in", first, r)));
    if thing.len() > 1 {
        all.push(says("near", first, last));
        all.push(says("left", first, last));
        all.push(and(says("right", first, last), says("in", first, &room[0])));
        all.push(and(says("in", first, &room[1]), says("in", last, &room[2])));
        all.push(and(not(says("in", first, &room[1])), says("in", last, &room[0])));
    }
    all
}

#[test]
fn plans_are_as_short_as_a_breadth_first_search_finds() {
    let (mut reached, mut unreachable) = (0, 0);
    for seed in 0..130 {
        let n = if seed % 6 == 0 { 2 } else { 1 };
        let state = world(seed, n);
        let all = goals(&state);
        for i in 0..if n == 2 { 1 } else { 2 } {
            let text = &all[(seed as usize * 5 + i * 3) % all.len()];
            for pull in [false, true] {
                if pull && n == 2 && seed % 4 != 0 {
                    continue;
                }
                let goal = goal(text, &state);
                let expected = oracle(&goal, &state, pull);
                let found = planned(&goal, &state, pull);
                assert_eq!(found, expected, "{text}, pull {pull}\n{}", text::print(&state));
                match found {
                    Some(_) => reached += 1,
                    None => unreachable += 1,
                }
            }
        }
    }
    assert!(reached > 200 && unreachable > 20, "{reached} reached, {unreachable} not");
}

#[test]
fn tasks_keep_the_promises_of_a_problem() {
    for seed in 0..120 {
        let (state, rules) = crate::dynamics::chances::random(seed);
        for text in goals(&state).iter().skip(seed as usize % 3).step_by(3) {
            let goal = goal(text, &state);
            let task = Task::new(&goal, &state, rules).unwrap();
            let is_legal = |s| task.dynamics().unpack(s).check().is_ok();
            let seen = mdp::check(&task, 1_000, is_legal);
            assert!(seen.is_ok(), "{text} {rules:?}\n{}: {seen:?}", text::print(&state));
            let draws = mdp::check_draws(&task, 12, 200, seed);
            assert!(draws.is_ok(), "{text} {rules:?}\n{}: {draws:?}", text::print(&state));
            let seen = mdp::check(&task.world(), 300, is_legal);
            assert!(seen.is_ok(), "{text} {rules:?}\n{}: {seen:?}", text::print(&state));
        }
    }
}

#[test]
fn the_test_on_packed_states_agrees_with_the_goal() {
    for seed in 0..60 {
        let state = world(seed, 1 + (seed % 3) as u32);
        for text in goals(&state) {
            let goal = goal(&text, &state);
            let task = Task::new(&goal, &state, Rules { pull: true, ..Rules::default() }).unwrap();
            let mut packed = task.dynamics().pack(&state).unwrap();
            for i in 0..60 {
                let real = task.dynamics().unpack(packed);
                assert_eq!(task.is_terminal(packed), goal.holds(&real), "{text}");
                let draw = (seed * 31 + i * i * 7 + i) % 101 % 5;
                packed = task.dynamics().step(packed, Action::ALL[draw as usize]);
            }
        }
    }
}

/// A world and a goal that takes some actions.
fn far_goal() -> (State, Goal) {
    let state = world(1, 1);
    let all = goals(&state);
    let far = all.iter().map(|text| goal(text, &state));
    let goal = far.into_iter().find(|g| oracle(g, &state, false) > Some(2)).unwrap();
    (state, goal)
}

#[test]
fn a_search_can_be_pumped_and_stays_ended() {
    let (state, goal) = far_goal();
    let task = Task::new(&goal, &state, Rules::default()).unwrap();
    let mut whole = AStar::new(&task, Settings::default());
    let outcome = whole.run();
    let mut search = AStar::new(&task, Settings::default());
    let mut steps = 0;
    let pumped = loop {
        steps += 1;
        if let Some(outcome) = search.step(1) {
            break outcome;
        }
    };
    assert!(steps > 1 && search.expanded() < steps);
    assert_eq!((pumped, search.plan()), (outcome, whole.plan()));
    assert_eq!(search.step(1), Some(outcome));
}

#[test]
fn a_budget_that_runs_out_is_said() {
    let (state, goal) = far_goal();
    let task = Task::new(&goal, &state, Rules::default()).unwrap();
    for (steps, states) in [(0, 9), (9, 1)] {
        let settings = Settings::default().with_budget(steps, states);
        assert_eq!(AStar::new(&task, settings).run(), Outcome::Budget);
    }
}

/// A problem with two outcomes, and faults to choose from.
struct Odd {
    probabilities: [f64; 2],
    bound: u32,
}

impl Mdp for Odd {
    type State = u8;
    type Action = u8;

    fn initial(&self) -> u8 {
        0
    }
    fn actions(&self) -> &[u8] {
        &[0]
    }
    fn successors(&self, state: u8, _: u8, out: &mut Vec<(u8, f64)>) {
        out.extend([(state, self.probabilities[0]), (state + 1, self.probabilities[1])]);
    }
    fn is_terminal(&self, state: u8) -> bool {
        state == 3
    }
    fn heuristic(&self, state: u8) -> Option<u32> {
        Some(u32::from(3 - state) * self.bound)
    }
}

#[test]
fn the_kit_finds_what_is_wrong() {
    let fault = |probabilities, bound| mdp::check(&Odd { probabilities, bound }, 10, |s| s < 4);
    assert_eq!(fault([0.25, 0.75], 1), Ok(4));
    assert!(matches!(fault([0.25, 0.5], 1), Err(mdp::Fault::Sum { .. })));
    assert!(matches!(fault([0.0, 1.0], 1), Err(mdp::Fault::Probability { .. })));
    assert!(matches!(fault([0.25, 0.75], 2), Err(mdp::Fault::Bound { .. })));
    let odd = Odd { probabilities: [0.25, 0.75], bound: 1 };
    assert!(matches!(mdp::check(&odd, 10, |s| s < 2), Err(mdp::Fault::Illegal { .. })));
    assert_eq!(AStar::new(&odd, Settings::default()).run(), Outcome::Unfit);
    assert_eq!(mdp::check_draws(&odd, 10, 2_000, 1), Ok(3));
    assert!(mdp::check_draws(&Fickle(Counter::new(0)), 10, 2_000, 1).is_err());
}

/// A problem that says one thing the first time and another when it is asked for a draw.
struct Fickle(Counter<u32>);

impl Mdp for Fickle {
    type State = u8;
    type Action = u8;

    fn initial(&self) -> u8 {
        0
    }
    fn actions(&self) -> &[u8] {
        &[0]
    }
    fn successors(&self, _: u8, _: u8, out: &mut Vec<(u8, f64)>) {
        self.0.set(self.0.get() + 1);
        let first = if self.0.get() == 1 { 0.5 } else { 0.4 };
        out.extend([(0, first), (1, 1.0 - first)]);
    }
    fn is_terminal(&self, state: u8) -> bool {
        state == 1
    }
}

#[test]
fn draws_follow_the_distribution_and_the_seed() {
    let odd = Odd { probabilities: [0.25, 0.75], bound: 1 };
    let moves = |seed| mdp::simulate(&odd, &[0; 1000], seed);
    assert_eq!(moves(7), moves(7));
    let steps: usize = (0..400).map(|seed| moves(seed).len() - 1).sum();
    // Three moves at 3/4 each take 4 steps on average.
    assert!((1500..1700).contains(&steps), "{steps}");
    assert!((0..400).all(|seed| moves(seed).last() == Some(&3)), "a terminal state ends a run");
}
