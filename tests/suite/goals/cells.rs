//! Where the thing that a goal moves could stand for the goal to hold.

use super::world;
use groundling::domain::{Lock, State};
use groundling::ground::Goal;
use groundling::logic::{Terms, read};

const AGENT: &str = "(the:<<e,t>,e> agent:<e,t>)";
const RED_CHAIR: &str =
    "(the:<<e,t>,e> (lambda $0:e (and:<t*,t> (red:<e,t> $0) (chair:<e,t> $0))))";

fn room(color: &str) -> String {
    format!("(the:<<e,t>,e> (lambda $0:e (and:<t*,t> (room:<e,t> $0) ({color}:<e,t> $0))))")
}

#[track_caller]
fn cells(goal: &str, state: &State) -> Vec<(i32, i32)> {
    let mut terms = Terms::new();
    let term = read(&mut terms, goal).unwrap();
    Goal::new(&terms, term, state).unwrap().cells(state)
}

#[test]
fn the_cells_of_a_goal_are_those_where_it_would_hold() {
    let state = world(|_| {});
    let in_red: Vec<(i32, i32)> = (1..=3).flat_map(|y| (1..=3).map(move |x| (x, y))).collect();
    let robot = cells(&format!("(in:<e,<e,t>> {AGENT} {})", room("red")), &state);
    assert_eq!(robot, in_red, "where it stands now is one of them");
    let without =
        |cell: (i32, i32)| in_red.iter().copied().filter(|&one| one != cell).collect::<Vec<_>>();
    let chair = cells(&format!("(in:<e,<e,t>> {RED_CHAIR} {})", room("red")), &state);
    assert_eq!(chair, without((1, 1)), "the robot stands in the way");
    let left = cells(&format!("(left:<e,<e,t>> {AGENT} {RED_CHAIR})"), &state);
    assert_eq!(left, [(6, 2)]);
    // One of two; both; what shall not be; some object, of which there is one that could.
    let either = format!(
        "(or:<t*,t> (left:<e,<e,t>> {AGENT} {RED_CHAIR}) (right:<e,<e,t>> {AGENT} {RED_CHAIR}))"
    );
    assert_eq!(cells(&either, &state), [(6, 2), (8, 2)]);
    let both = either.replace("(or:", "(and:");
    assert_eq!(cells(&both, &state), []);
    let out = cells(&format!("(not:<t,t> (in:<e,<e,t>> {AGENT} {}))", room("blue")), &state);
    assert_eq!(out.len(), 9 + 1, "the red room and the doorway");
    let some = format!(
        "(exists:<<e,t>,t> (lambda $0:e (and:<t*,t> (red:<e,t> $0) (chair:<e,t> $0) (in:<e,<e,t>> $0 {}))))",
        room("red")
    );
    assert_eq!(cells(&some, &state), chair);
}

#[test]
fn there_are_no_cells_where_no_single_thing_is_to_move_or_too_much_to_look_through() {
    let state = world(|_| {});
    let two = format!(
        "(and:<t*,t> (near:<e,<e,t>> {AGENT} {RED_CHAIR}) (in:<e,<e,t>> {RED_CHAIR} {}))",
        room("red")
    );
    assert_eq!(cells(&two, &state), []);
    let any = format!("(exists:<<e,t>,t> (lambda $0:e (in:<e,<e,t>> $0 {})))", room("red"));
    assert_eq!(cells(&any, &state), []);
    assert_eq!(cells("true:t", &state), []);
    let lost = format!("(in:<e,<e,t>> {AGENT} {})", room("green"));
    assert_eq!(cells(&lost, &state), []);
    // A locked door is no place to stand; an illegal world has no places at all.
    let out = format!("(not:<t,t> (in:<e,<e,t>> {AGENT} {}))", room("blue"));
    assert_eq!(cells(&out, &world(|s| s.doors[0].lock = Lock::Locked)).len(), 9);
    assert_eq!(cells(&out, &world(|s| s.rooms[0].bounds.right = i32::MAX)), []);
    let wide = world(|s| s.rooms[1].bounds.top = 250);
    assert_eq!(cells(&out, &wide), []);
}
