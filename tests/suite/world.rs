//! States: what is legal, what is refused and in which words; and what the generator promises.

#[path = "world/blueprint.rs"]
mod blueprint;

use groundling::domain::{Color, Direction, Layout, Plan, Shape, State, generate, text};
use std::collections::BTreeSet;

/// A world of two rooms: `object0` at (2, 2), the agent at (1, 1), a door at (4, 2).
const GOOD: &str = r#"{"agent":{"x":1,"y":1,"direction":"south"},
"rooms":[{"name":"room0","color":"red","left":0,"bottom":0,"right":4,"top":4},
{"name":"room1","color":"blue","left":4,"bottom":0,"right":8,"top":4}],
"doors":[{"name":"door0","left":4,"bottom":2,"right":4,"top":2,"lock":"unlocked"}],
"objects":[{"name":"object0","shape":"chair","color":"red","x":2,"y":2},
{"name":"object1","shape":"bag","color":"tan","x":6,"y":2,"size":"large"}]}"#;

#[test]
fn a_bad_state_is_refused_with_place_and_remedy() {
    for (from, to, expected) in [
        (
            "chair",
            "sofa",
            "objects[0].shape: unknown shape `sofa`: use one of chair, basket, block",
        ),
        (
            "\"red\",\"x\"",
            "\"pink\",\"x\"",
            "objects[0].color: unknown colour `pink`: use one of red",
        ),
        ("\"x\":2,", "", "objects[0]: missing field `x`: add it"),
        ("\"x\":2", "\"x\":\"2\"", "objects[0].x: invalid type"),
        ("\"left\":4,\"bottom\":2", "\"left\":4.5,\"bottom\":2", "doors[0].left: invalid type"),
        ("south", "up", "agent.direction: unknown direction `up`: use one of north"),
        ("\"large\"", "\"huge\"", "objects[1].size: unknown size `huge`"),
        ("\"x\":1,\"y\":1", "\"x\":0,\"y\":1", "`agent` stands in a wall, at column 0, row 1"),
        ("\"x\":1,\"y\":1", "\"x\":40,\"y\":1", "`agent` is outside all rooms, at column 40"),
        ("\"x\":1,\"y\":1", "\"x\":2,\"y\":2", "`agent` and `object0` share the cell"),
        ("\"x\":6,\"y\":2", "\"x\":2,\"y\":2", "`object0` and `object1` share the cell"),
        ("\"x\":6,\"y\":2", "\"x\":4,\"y\":1", "`object1` stands in a wall"),
        ("object1", "object0", "two objects are called `object0`: rename one"),
        ("door0", "room0", "two rooms or doors are called `room0`: rename one"),
        ("object1", "", "objects number 2 has an empty name"),
        ("\"right\":8", "\"right\":3", "`room1` has left > right"),
        ("\"right\":8", "\"right\":1001", "`room1` lies beyond 1000 cells"),
        ("\"right\":8", "\"right\":900", "the world is 901 × 5 cells"),
        ("\"x\":6,", "\"x\":2000000000,", "`object1` lies beyond"),
    ] {
        assert!(GOOD.contains(from), "{from}");
        let error = State::read(&GOOD.replacen(from, to, 1)).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{to}: {error}");
    }
    let error = State::read(&GOOD[..100]).unwrap_err().to_string();
    assert!(error.contains("ends too early") && error.contains("line 2"), "{error}");
    let error = State::read("move it").unwrap_err().to_string();
    assert!(error.contains("not JSON") && error.contains("line 1, column 1"), "{error}");
    assert!(State::read(&format!("{GOOD} and more")).is_err());
}

#[test]
fn after_a_demonstration_a_shared_cell_is_a_warning() {
    let shared = GOOD.replacen("\"x\":6,\"y\":2", "\"x\":2,\"y\":2", 1);
    let (state, warnings) = State::read_after(&shared).unwrap();
    assert_eq!((state.objects.len(), warnings.len()), (2, 1));
    assert!(state.check().is_err());
    let in_wall = GOOD.replacen("\"x\":6,\"y\":2", "\"x\":4,\"y\":1", 1);
    assert!(State::read_after(&in_wall).is_err());
}

#[test]
fn too_many_things_are_refused() {
    let mut state = State::read(GOOD).unwrap();
    let first = state.objects[0].clone();
    state.objects = (0..65)
        .map(|i| groundling::domain::Object { name: i.to_string(), ..first.clone() })
        .collect();
    assert_eq!(
        state.check().unwrap_err().to_string(),
        "there are 65 objects, more than 64: leave some out"
    );
}

#[test]
fn json_comes_back_as_it_went() {
    for seed in 0..50 {
        let state = generate(&Plan::default(), seed);
        assert_eq!(State::read(&state.write()).unwrap(), state);
    }
    let state = State::read(GOOD).unwrap();
    assert_eq!(
        state.write(),
        GOOD.replace('\n', "")
            .replace(",\"x\":6,\"y\":2,\"size\":\"large\"", ",\"size\":\"large\",\"x\":6,\"y\":2")
    );
}

#[test]
fn names_and_letters_go_both_ways() {
    assert!(Color::ALL.iter().all(|c| c.name().parse() == Ok(*c)));
    assert!(Shape::ALL.iter().all(|s| s.to_string().parse() == Ok(*s)));
    assert_eq!(
        Color::ALL.iter().map(|c| c.letter()).collect::<BTreeSet<_>>().len(),
        Color::ALL.len()
    );
    assert_eq!(
        Shape::ALL.iter().map(|s| s.letter()).collect::<BTreeSet<_>>().len(),
        Shape::ALL.len()
    );
    assert!(Direction::ALL.iter().all(|d| d.opposite() != *d && d.opposite().opposite() == *d));
}

#[test]
fn names_in_quotes_are_drawn_and_read_as_json_writes_them() {
    let mut state = generate(&Plan::default(), 1);
    for name in [
        "a \"b\" \\ c",
        " padded ",
        "zwei\nZeilen\t",
        "Ünïcode ☃ 🤖",
        "\u{1}\u{7f}",
        "\"",
        "\\u0041",
    ] {
        state.rooms[0].name = name.to_owned();
        let drawn = text::print(&state);
        assert_eq!(text::read(&drawn).map_err(|e| e.to_string()), Ok(state.clone()), "{drawn}");
        let as_json = drawn.lines().find_map(|line| line.split_once(" as ")).unwrap().1;
        assert_eq!(serde_json::from_str::<String>(as_json).unwrap(), name);
    }
    let (own, drawn) = (r#"as "\\u0041""#, text::print(&state));
    let with = |name: &str| text::read(&drawn.replace(own, &format!("as {name}")));
    assert_eq!(with(r#""\u0041\/\b""#).unwrap().rooms[0].name, "A/\u{8}");
    for (name, wrong) in [
        (r#""open"#, "does not end"),
        (r#""a" b"#, "behind its quote"),
        (r#""\x""#, "no such escape"),
        (r#""\ud800""#, "no such escape"),
        (r#""\u00""#, "no such escape"),
    ] {
        let error = with(name).unwrap_err().to_string();
        assert!(error.contains(wrong), "{error}");
    }
}

#[test]
fn generated_worlds_are_legal_connected_and_what_the_plan_says() {
    let plan = Plan { side: (7, 12), objects: (2, 4) };
    for seed in 0..300 {
        let state = generate(&plan, seed);
        state.check().unwrap();
        assert_eq!(generate(&plan, seed), state, "a pure function of the seed");
        assert_eq!(state.rooms.len(), 3);
        assert!((2..=4).contains(&state.objects.len()), "seed {seed}");
        let layout = Layout::new(&state);
        assert_eq!(reached(&layout), layout.len(), "seed {seed}: every place can be walked to");
        let e = layout.extent();
        assert!((7..=12).contains(&e.right) && (7..=12).contains(&e.top), "seed {seed}: {e:?}");
    }
    assert_ne!(generate(&plan, 1), generate(&plan, 2));
}

#[test]
fn an_odd_plan_is_brought_within_limits() {
    for plan in [
        Plan { side: (0, 0), objects: (8, 8) },
        Plan { side: (u32::MAX, 3), objects: (9000, 0) },
        Plan { side: (31, 31), objects: (8, 8) },
    ] {
        for seed in 0..50 {
            generate(&plan, seed).check().unwrap();
        }
    }
}

/// How many places can be walked to from the first.
fn reached(layout: &Layout) -> usize {
    let mut seen = BTreeSet::from([0]);
    let mut open = vec![0];
    while let Some(place) = open.pop() {
        for &d in Direction::ALL {
            let next = layout.neighbour(place, d);
            if next != groundling::domain::layout::NOWHERE && seen.insert(next) {
                open.push(next);
            }
        }
    }
    seen.len()
}
