//! The text form of a state: what a person draws is read, what is printed reads back, mistakes have a place.

use groundling::domain::{
    Bounds, Color, Direction, Lock, Plan, Shape, Size, State, generate, text,
};
use proptest::prelude::{Strategy, any};
use proptest::{prop_assert_eq, proptest};

const DRAWING: &str = "\
#########
#rrr+bCb#
#r>r#bbb#
#########

r room red
b room blue as the far room
+ door unlocked
C chair green large
";

#[test]
fn a_drawing_is_read() {
    let state = text::read_legal(DRAWING).unwrap();
    assert_eq!((state.agent.x, state.agent.y, state.agent.direction), (2, 1, Direction::East));
    assert_eq!(state.rooms[0].bounds, Bounds { left: 0, bottom: 0, right: 4, top: 3 });
    assert_eq!((state.rooms[1].name.as_str(), state.rooms[1].color), ("the far room", Color::Blue));
    assert_eq!(state.doors[0].bounds, Bounds { left: 4, bottom: 2, right: 4, top: 2 });
    let chair = &state.objects[0];
    assert_eq!(
        (chair.x, chair.y, chair.shape, chair.size),
        (6, 2, Shape::Chair, Some(Size::Large))
    );
    assert_eq!(text::print(&state), DRAWING);
}

#[test]
fn mistakes_have_a_place() {
    for (from, to, expected) in [
        ("chair", "sofa", "line 9, column 3: room, door or a shape is wanted here, not `sofa`"),
        ("green", "pink", "line 9, column 9: a colour is wanted here, not `pink` (unknown colour"),
        ("large", "huge", "line 9, column 15: `huge` is too much here"),
        (" red", "", "line 6, column 7: a colour is missing here"),
        ("C chair", "D chair", "line 9, column 20: its mark is not in the map"),
        ("b room", "r room", "line 7, column 1: `r` has its meaning already"),
        ("bCb", "bCC", "line 2, column 8: `C` is one object"),
        ("bCb", "bZC", "line 2, column 7: `Z` stands in no line of the legend"),
        ("r>r", "r#r", "line 1, column 1: the map has no robot"),
        ("r>r", "r>^", "line 3, column 4: the map has a second robot"),
        ("r>r#bbb", "r>r#b#b", "line 3, column 7: room `b` is no rectangle"),
        ("r>r", "r>b", "line 3, column 4: room `r` is no rectangle"),
        ("large", "at 5", "line 9, column 19: a whole number is missing here"),
        ("large", "at 4 1", "line 1, column 1: `object0` stands in a wall"),
        ("r room", "origin 5000 1\nr room", "line 6, column 14: the origin is too far away"),
    ] {
        assert!(DRAWING.contains(from), "{from}");
        let error = text::read_legal(&DRAWING.replacen(from, to, 1)).unwrap_err().to_string();
        assert!(error.starts_with(expected), "{from} → {to}: {error}");
    }
    assert!(text::read("").unwrap_err().message.contains("no robot"));
    assert!(text::read(&"#".repeat(300)).unwrap_err().message.contains("larger than"));
}

/// Legal states with what makes them hard to draw: hidden floors, odd names, far origins, all locks.
fn states() -> impl Strategy<Value = State> {
    let plan = (7u32..12, 0u32..8).prop_map(|(side, n)| Plan { side: (7, side), objects: (n, 8) });
    let shift = (-500i32..500, -500i32..500);
    (plan, any::<u64>(), shift, ".{1,8}", any::<[u8; 4]>()).prop_map(
        |(plan, seed, (dx, dy), name, dice)| {
            let mut state = generate(&plan, seed);
            state.agent.x += dx;
            state.agent.y += dy;
            let doors = state.doors.iter_mut().map(|d| &mut d.bounds);
            for b in state.rooms.iter_mut().map(|r| &mut r.bounds).chain(doors) {
                (b.left, b.right) = (b.left + dx, b.right + dx);
                (b.bottom, b.top) = (b.bottom + dy, b.top + dy);
            }
            for o in &mut state.objects {
                (o.x, o.y) = (o.x + dx, o.y + dy);
                o.size = Size::ALL.get(usize::from(dice[0] % 5)).copied();
            }
            state.doors[0].lock = Lock::ALL[usize::from(dice[1] % 3)];
            state.rooms[usize::from(dice[2] % 3)].color = Color::ALL[usize::from(dice[3] % 9)];
            // The robot in a doorway hides a door; an object there hides another.
            if dice[2] % 2 == 0 {
                (state.agent.x, state.agent.y) =
                    (state.doors[0].bounds.left, state.doors[0].bounds.bottom);
            }
            if let (Some(object), 0) = (state.objects.first_mut(), dice[3] % 2) {
                (object.x, object.y) = (state.doors[1].bounds.left, state.doors[1].bounds.bottom);
                object.name.clone_from(&name);
            }
            state.rooms[0].name = name;
            state
        },
    )
}

proptest! {
    #[test]
    fn what_is_printed_reads_back(state in states()) {
        let printed = text::print(&state);
        prop_assert_eq!(text::read(&printed).map_err(|e| format!("{e}\n{printed}")), Ok(state));
    }

    #[test]
    fn no_text_is_too_strange(a in ".{0,60}\n{1,2}.{0,60}", at in 0usize..100, what in ".{0,4}") {
        let _ = text::read(&a);
        let mut edited = DRAWING.to_owned();
        edited.insert_str(at.min(edited.len()), &what);
        let _ = text::read_legal(&edited);
    }
}

#[test]
fn rooms_that_cannot_be_drawn_are_said() {
    let mut state = generate(&Plan::default(), 3);
    let whole = state.extent().unwrap();
    state.rooms.push(groundling::domain::Room {
        name: "over all".into(),
        color: Color::Tan,
        bounds: whole,
    });
    for i in 0..28 {
        state.rooms.push(groundling::domain::Room {
            name: format!("\"{i}\" as\n{i}"),
            color: Color::Red,
            bounds: Bounds { left: 40 + i, bottom: 0, right: 40 + i, top: i },
        });
    }
    let printed = text::print(&state);
    assert_eq!(text::read(&printed).unwrap(), state, "{printed}");
}
