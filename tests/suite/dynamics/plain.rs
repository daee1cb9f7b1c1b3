//! How the world moves, once more and plainly: on whole states, slowly, sentence by sentence as the method says
//! it. What the packed world does is held against this.

use groundling::domain::{Action, Cell, Direction, Form, Lock, Rules, State, cell_at};

/// What an action may lead to, each state once.
pub(crate) fn outcomes(state: &State, rules: &Rules, action: Action) -> Vec<(State, f64)> {
    let chances = rules.chances;
    let mut all = Vec::new();
    add(&mut all, state.clone(), chances.slip());
    for (next, p) in unslipped(state, rules, action) {
        add(&mut all, next, p * (1.0 - chances.slip()));
    }
    all
}

fn add(all: &mut Vec<(State, f64)>, state: State, p: f64) {
    match all.iter_mut().find(|o| o.0 == state) {
        _ if p == 0.0 => {}
        Some(known) => known.1 += p,
        None => all.push((state, p)),
    }
}

fn unslipped(state: &State, rules: &Rules, action: Action) -> Vec<(State, f64)> {
    let mut turned = state.clone();
    let heading = state.agent.direction;
    match (rules.form, action) {
        (Form::Compass, Action::North) => turned.agent.direction = Direction::North,
        (Form::Compass, Action::South) => turned.agent.direction = Direction::South,
        (Form::Compass, Action::East) => turned.agent.direction = Direction::East,
        (Form::Compass, Action::West) => turned.agent.direction = Direction::West,
        (Form::Robot, Action::Forward) | (_, Action::Pull) => {}
        (Form::Robot, Action::TurnLeft | Action::TurnRight) => {
            let clockwise = [Direction::North, Direction::East, Direction::South, Direction::West];
            let at = clockwise.iter().position(|&d| d == heading).unwrap();
            let by = if action == Action::TurnRight { 1 } else { 3 };
            turned.agent.direction = clockwise[(at + by) % 4];
            return vec![(turned, 1.0)];
        }
        _ => panic!("{action} is of the other form"),
    }
    let (dx, dy) = turned.agent.direction.step();
    let here = (state.agent.x, state.agent.y);
    let ahead = (here.0 + dx, here.1 + dy);
    let object = state.objects.iter().position(|o| (o.x, o.y) == ahead);
    let goes = match (object, action) {
        (None, Action::Pull) => return vec![(turned, 1.0)],
        (Some(_), Action::Pull) => vec![ahead, here],
        (Some(_), _) => vec![ahead, (ahead.0 + dx, ahead.1 + dy)],
        (None, _) => vec![ahead],
    };
    let is_stuck = object.is_some_and(|o| !rules.movable.allows(o));
    let is_taken = action != Action::Pull
        && object.is_some()
        && state.objects.iter().any(|o| (o.x, o.y) == goes[1]);
    if is_stuck || is_taken || !goes.iter().all(|&cell| is_free(state, cell)) {
        return vec![(turned, 1.0)];
    }
    let mut all = Vec::new();
    let (mut still, mut left) = (turned, 1.0);
    for &(x, y) in &goes {
        if let Some(d) = still.doors.iter().position(|d| d.bounds.contains(x, y))
            && still.doors[d].lock == Lock::Unknown
        {
            let mut locked = still.clone();
            locked.doors[d].lock = Lock::Locked;
            add(&mut all, locked, left * rules.chances.lock());
            still.doors[d].lock = Lock::Unlocked;
            left *= 1.0 - rules.chances.lock();
        }
    }
    let mut moved = still.clone();
    (moved.agent.x, moved.agent.y) = ahead;
    if let Some(o) = object {
        add(&mut all, still, left * rules.chances.loss());
        left *= 1.0 - rules.chances.loss();
        (moved.objects[o].x, moved.objects[o].y) = goes[1];
    }
    if action == Action::Pull {
        moved.agent.direction = heading.opposite();
    }
    add(&mut all, moved, left);
    all
}

fn is_free(state: &State, (x, y): (i32, i32)) -> bool {
    match cell_at(&state.rooms, &state.doors, x, y) {
        Cell::Wall => false,
        Cell::Floor => true,
        Cell::Door(d) => state.doors[d].lock != Lock::Locked,
    }
}
