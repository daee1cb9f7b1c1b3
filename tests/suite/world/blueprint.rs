//! Worlds built from blueprints: what they promise, and what is refused in which words.

use super::reached;
use groundling::domain::{
    Blueprint, Color, Dynamics, Layout, Lock, Rules, State, Style, cell_at, text,
};
use std::collections::BTreeSet;

/// Blueprints of every style and number of rooms, on worlds with room for them.
fn blueprints() -> Vec<Blueprint> {
    let mut all = Vec::new();
    for &style in Style::ALL {
        for rooms in 3..=12 {
            for (columns, rows) in [(24, 20), (32, 32), (7 + 2 * rooms, 16)] {
                let (columns, rows) = (columns.min(32), rows.max(7));
                let objects = rooms % 9;
                let connected = rooms % 3 != 0;
                let lock = Lock::ALL[rooms as usize % 3];
                all.push(Blueprint { style, rooms, columns, rows, objects, lock, connected });
            }
        }
    }
    all
}

#[test]
fn what_is_built_is_what_was_asked_for() {
    let mut built = 0;
    for plan in blueprints() {
        for seed in 0..12 {
            let state = match plan.build(seed) {
                Ok(state) => state,
                Err(error) => {
                    let crowded = plan.rooms > 6 && plan.columns * plan.rows < 500;
                    assert!(crowded, "{plan:?}: {error}");
                    continue;
                }
            };
            built += 1;
            state.check().unwrap();
            assert_eq!(plan.build(seed).unwrap(), state, "a pure function of the seed");
            assert_eq!(state.rooms.len(), plan.rooms as usize);
            assert_eq!(state.objects.len(), plan.objects as usize);
            assert!(state.doors.iter().all(|d| d.lock == plan.lock));
            let e = state.extent().unwrap();
            assert_eq!((e.right + 1, e.top + 1), (plan.columns as i32, plan.rows as i32));
            let layout = Layout::new(&state);
            let whole = reached(&layout) == layout.len();
            assert_eq!(whole, plan.connected, "{plan:?}\n{}", text::print(&state));
            let colors: BTreeSet<Color> = state.rooms.iter().map(|r| r.color).collect();
            assert_eq!(colors.len(), state.rooms.len().min(Color::ALL.len()));
            assert_fills(&state);
            let dynamics = Dynamics::new(&state, Rules::default()).unwrap();
            assert_eq!(dynamics.unpack(dynamics.pack(&state).unwrap()), state);
        }
    }
    assert!(built > 900, "{built}");
}

/// Every cell belongs to a room, and to the inside of one at most.
fn assert_fills(state: &State) {
    for (x, y) in state.extent().unwrap().cells() {
        let inside = state.rooms.iter().filter(|r| r.bounds.strictly_inside(x, y)).count();
        let within = state.rooms.iter().filter(|r| r.bounds.contains(x, y)).count();
        assert!(within >= 1 && (inside == 0 || within == 1), "({x}, {y})");
        assert_eq!(
            inside == 1,
            cell_at(&state.rooms, &state.doors, x, y) == groundling::domain::Cell::Floor
        );
    }
}

#[test]
fn in_a_hall_every_room_opens_on_the_corridor() {
    let plan =
        Blueprint { style: Style::Hall, rooms: 9, columns: 24, rows: 14, ..Blueprint::default() };
    for seed in 0..20 {
        let state = plan.build(seed).unwrap();
        let corridor = state.rooms[0].bounds;
        for room in &state.rooms[1..] {
            let opens = |d: &groundling::domain::Door| {
                d.bounds.overlaps(&corridor) && d.bounds.overlaps(&room.bounds)
            };
            assert!(state.doors.iter().any(opens), "{}", text::print(&state));
        }
    }
}

#[test]
fn what_cannot_be_built_is_refused_in_words() {
    let like = Blueprint::default();
    for (plan, expected) in [
        (Blueprint { rooms: 2, ..like }, "2 rooms: use 3 to 12"),
        (Blueprint { rooms: 13, ..like }, "13 rooms: use 3 to 12"),
        (Blueprint { columns: 33, ..like }, "33 cells a side: use 7 to 32"),
        (Blueprint { rows: 6, ..like }, "6 cells a side: use 7 to 32"),
        (Blueprint { objects: 9, ..like }, "9 objects: use 8 or fewer"),
        (
            Blueprint { rooms: 12, ..like },
            "12 rooms do not fit in 9 × 9 cells in the style `cuts`: use fewer rooms, a larger",
        ),
        (
            Blueprint { style: Style::Hall, columns: 32, ..like },
            "3 rooms do not fit in 32 × 9 cells in the style `hall`",
        ),
        (
            Blueprint { rooms: 4, columns: 7, rows: 7, objects: 8, ..like },
            "8 objects do not fit on the floor away from corners",
        ),
        (
            Blueprint {
                style: Style::Cuts,
                rooms: 12,
                columns: 32,
                rows: 32,
                objects: 8,
                lock: Lock::Unknown,
                ..like
            },
            "8 objects in ",
        ),
    ] {
        let errors: Vec<String> =
            (0..40).filter_map(|seed| plan.build(seed).err().map(|e| e.to_string())).collect();
        assert!(!errors.is_empty(), "{plan:?}");
        assert!(errors.iter().all(|e| e.starts_with(expected)), "{plan:?}: {}", errors[0]);
    }
}
