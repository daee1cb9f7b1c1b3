//! What actions do, on drawings; packing and its limits; what the planner may take for the same state.

#[path = "dynamics/chances.rs"]
pub(crate) mod chances;
#[path = "dynamics/plain.rs"]
pub(crate) mod plain;

use groundling::domain::{Action, Direction, Dynamics, Plan, Rules, State, generate, text};

#[test]
fn every_drawing_moves_as_drawn() {
    let cases = include_str!("../data/world/moves.txt");
    let mut n = 0;
    for case in cases.split("\n== ").skip(1) {
        let mut lines = case.lines().take_while(|l| !l.is_empty());
        let (name, actions) = lines.next().unwrap().split_once(": ").unwrap();
        let (drawings, remarks): (Vec<&str>, Vec<&str>) = lines.partition(|l| l.contains("   "));
        let side = |i| drawings.iter().map(|l| l.split("   ").nth(i).unwrap()).collect::<Vec<_>>();
        let (before, after) = (world(&side(0), &remarks), world(&side(1), &remarks));
        let rules = Rules { pull: !remarks.contains(&"no pull"), ..Rules::default() };
        let dynamics = Dynamics::new(&before, rules).unwrap();
        let mut packed = dynamics.pack(&before).unwrap();
        for action in actions.split(' ') {
            packed = dynamics.step(packed, action.parse().unwrap());
        }
        let found = dynamics.unpack(packed);
        assert_eq!(found, after, "{name}\n{}\nfor\n{}", text::print(&found), text::print(&after));
        n += 1;
    }
    assert!(n >= 25, "only {n} cases were read");
}

/// A world from rows of cells: walls around, the rooms and the door said in the legend.
fn world(rows: &[&str], remarks: &[&str]) -> State {
    let width = rows[0].len();
    let wall = rows[rows.len() - 1].find('#');
    let (height, right) = (rows.len() + 1, wall.unwrap_or(width) + 1);
    let all = rows.concat();
    let mut drawing = format!("{}\n", "#".repeat(width + 2));
    for row in rows {
        drawing += &format!("#{row}#\n");
    }
    drawing += &format!("{0}\n\nr room red at 0 0 {right} {height}\n", "#".repeat(width + 2));
    if wall.is_some() {
        drawing += &format!("b room blue at {right} 0 {} {height}\n", width + 1);
        let shown = [('+', "unlocked"), ('x', "locked"), ('?', "unknown")];
        let hidden = if remarks.contains(&"door locked") { "locked" } else { "unlocked" };
        let (mark, lock) = shown.into_iter().find(|s| all.contains(s.0)).unwrap_or(('-', hidden));
        let row = height - 1;
        drawing += &format!("{mark} door {lock} at {right} {row} {right} {row}\n");
    }
    for (mark, line) in [('C', "C chair red\n"), ('K', "K basket green\n")] {
        if all.contains(mark) {
            drawing += line;
        }
    }
    text::read_legal(&drawing).unwrap_or_else(|e| panic!("{e}\n{drawing}"))
}

/// Worlds with some doors locked or never tried.
fn worlds(n: u64) -> impl Iterator<Item = State> {
    (0..n).map(|seed| {
        let mut state = generate(&Plan { side: (7, 10), objects: (1, 4) }, seed);
        for (i, door) in (0..).zip(&mut state.doors) {
            door.lock = groundling::domain::Lock::ALL[((seed + i) % 3) as usize];
        }
        state
    })
}

#[test]
fn packing_is_undone_by_unpacking() {
    for state in worlds(100) {
        let dynamics = Dynamics::new(&state, Rules::default()).unwrap();
        assert_eq!(dynamics.unpack(dynamics.pack(&state).unwrap()), state);
    }
}

#[test]
fn the_robot_can_be_put_on_every_cell_that_is_free() {
    for state in worlds(20) {
        let dynamics = Dynamics::new(&state, Rules::default()).unwrap();
        let packed = dynamics.pack(&state).unwrap();
        for place in dynamics.layout().places() {
            let (x, y) = dynamics.layout().cell(place);
            let found = dynamics.with_agent(packed, place, Direction::West);
            let mut expected = state.clone();
            (expected.agent.x, expected.agent.y) = (x, y);
            expected.agent.direction = Direction::West;
            let is_free = state.objects.iter().all(|o| (o.x, o.y) != (x, y));
            assert_eq!(found.map(|p| dynamics.unpack(p)), is_free.then_some(expected));
        }
    }
}

#[test]
fn a_step_from_a_legal_state_ends_in_one() {
    for (seed, state) in (0u64..).zip(worlds(100)) {
        let dynamics = Dynamics::new(&state, Rules { pull: true, ..Rules::default() }).unwrap();
        let mut packed = dynamics.pack(&state).unwrap();
        for i in 0..300 {
            let draw = (seed * 7919 + i * i * 31 + i) % 1009 % 5;
            packed = dynamics.step(packed, Action::ALL[draw as usize]);
            dynamics.unpack(packed).check().unwrap();
        }
    }
}

#[test]
fn states_taken_for_the_same_stay_the_same() {
    for pull in [false, true] {
        for (seed, state) in (0u64..).zip(worlds(60)) {
            let dynamics = Dynamics::new(&state, Rules { pull, ..Rules::default() }).unwrap();
            let mut real = dynamics.pack(&state).unwrap();
            let mut merged = dynamics.quotient(real);
            for i in 0..200 {
                let draw = (seed * 104_729 + i * i * 17 + i) % 997;
                let action = dynamics.actions()[draw as usize % dynamics.actions().len()];
                real = dynamics.step(real, action);
                merged = dynamics.quotient(dynamics.step(merged, action));
                assert_eq!(dynamics.quotient(real), merged, "seed {seed}, step {i}");
            }
        }
    }
}

#[test]
fn what_does_not_fit_two_words_is_refused() {
    let mut state = generate(&Plan { side: (31, 31), objects: (8, 8) }, 1);
    assert!(Dynamics::new(&state, Rules::default()).is_ok());
    let floor: Vec<(i32, i32)> = state.rooms[0].bounds.cells().collect();
    let (rooms, like) = (state.rooms.clone(), state.objects[0].clone());
    let free = floor.into_iter().filter(|&(x, y)| rooms[0].bounds.strictly_inside(x, y));
    state.objects = (0..20)
        .zip(free)
        .map(|(i, (x, y))| groundling::domain::Object {
            name: format!("o{i}"),
            x,
            y,
            ..like.clone()
        })
        .collect();
    let error = Dynamics::new(&state, Rules::default()).unwrap_err().to_string();
    assert!(error.starts_with("20 objects in ") && error.contains("more than 128"), "{error}");
}
