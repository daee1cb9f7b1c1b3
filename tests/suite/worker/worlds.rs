//! Worlds by chance and as text, as the page asks for them.

use super::{only, pump, refused};
use groundling::domain::{Blueprint, State, Style, text};
use groundling::worker::protocol::{Event, Request};
use groundling::worker::{Engine, Talker};

#[track_caller]
fn world(request: Request) -> State {
    match only(pump(&mut Engine::<Talker>::new(), 1, request)) {
        Event::World(state) => state,
        other => panic!("no world: {other:?}"),
    }
}

#[test]
fn a_world_is_drawn_by_its_seed_alone() {
    for &style in Style::ALL {
        let blueprint = Blueprint {
            style,
            rooms: 6,
            columns: 20,
            rows: 20,
            objects: 3,
            ..Blueprint::default()
        };
        let drawn = world(Request::Draw { blueprint, seed: 7 });
        assert_eq!(drawn, blueprint.build(7).unwrap());
        assert_ne!(drawn, world(Request::Draw { blueprint, seed: 8 }));
    }
    let blueprint = Blueprint { rooms: 99, ..Blueprint::default() };
    let said = refused(&mut Engine::<Talker>::new(), Request::Draw { blueprint, seed: 0 });
    assert_eq!(said, "99 rooms: use 3 to 12");
}

#[test]
fn a_world_goes_to_text_and_back() {
    let state = Blueprint { objects: 4, ..Blueprint::default() }.build(3).unwrap();
    let write = Request::WriteWorld { state: state.clone() };
    let Event::WorldText { text: drawn } = only(pump(&mut Engine::<Talker>::new(), 1, write))
    else {
        panic!("no text");
    };
    assert_eq!(drawn, text::print(&state));
    assert_eq!(world(Request::ReadWorld { text: drawn }), state);
}

#[test]
fn a_text_that_is_no_world_is_refused_with_its_place() {
    let mut engine = Engine::<Talker>::new();
    let mut walled = Blueprint::default().build(3).unwrap();
    let mut illegal = walled.clone();
    (walled.agent.x, walled.agent.y) = (0, 0);
    (illegal.agent.x, illegal.agent.y) = (illegal.objects[0].x, illegal.objects[0].y);
    for (source, said) in [
        (String::new(), "line 1, column 1: the map has no robot: put one of ^ v < > somewhere"),
        ("####\n#^?#\n####\n".to_owned(), "line 2, column 3: `?` stands in no line of the legend"),
        (text::print(&walled), "line 1, column 1: `agent` stands in a wall, at column 0, row 0"),
    ] {
        let message = refused(&mut engine, Request::ReadWorld { text: source });
        assert!(message.contains(said), "{message}");
    }
    let message = refused(&mut engine, Request::WriteWorld { state: illegal });
    assert!(message.contains("share the cell"), "{message}");
}
