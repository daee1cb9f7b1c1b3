//! What a person does in the room, with a pointer and with keys.

use super::{Page, world};
use groundling::domain::Direction;
use groundling::render::{Options, Thing};
use groundling::ui::app::Action;
use groundling::ui::page::effect::Effect;
use groundling::ui::talk;
use groundling::ui::talk::room::overlay;
use groundling::ui::talk::room::point::{Key, Point, PointKind};
use groundling::ui::talk::room::state::{Held, Mode, Tool};
use groundling::worker::protocol::{Event, Request};

fn point(kind: PointKind, cell: (i32, i32)) -> talk::Action {
    talk::Action::Point(Point { kind, x: cell.0 as f32, y: cell.1 as f32, cell })
}

/// Drags from one cell to another.
fn drag(page: &mut Page, from: (i32, i32), to: (i32, i32)) {
    page.act(point(PointKind::Down, from));
    page.act(point(PointKind::Move, to));
    page.act(point(PointKind::Up, to));
}

fn options(page: &Page) -> Options {
    overlay::options(&page.state.talk, &page.state.shared)
}

fn editing() -> Page {
    let mut page = Page::ready();
    page.act(talk::Action::SetMode(Mode::Edit));
    page
}

#[test]
fn a_thing_is_dragged_and_the_change_undone() {
    let mut page = editing();
    let start = world();
    let block = (start.objects[0].x, start.objects[0].y);
    page.act(point(PointKind::Down, block));
    page.act(point(PointKind::Move, (1, 1)));
    let ghost = options(&page).ghost.expect("it is in the hand");
    assert_eq!((ghost.what, ghost.target, ghost.allowed), (Thing::Object(0), (1, 1), true));
    page.act(point(PointKind::Move, (0, 0)));
    assert!(options(&page).ghost.is_some_and(|ghost| !ghost.allowed), "a wall");
    page.act(point(PointKind::Up, (1, 1)));
    assert_eq!((page.shown().objects[0].x, page.shown().objects[0].y), (1, 1));
    assert!(page.state.shared.announcement.contains("The yellow block is now in the blue room"));
    page.act(Action::Undo);
    assert_eq!(page.shown(), &start);
}

#[test]
fn what_cannot_be_is_told_and_changes_nothing() {
    let mut page = editing();
    let start = world();
    drag(&mut page, (start.agent.x, start.agent.y), (0, 0));
    assert!(page.state.talk.room.obstacle.is_some() && !page.state.shared.history.can_undo());
    assert_eq!(page.state.shared.announcement, "There is no floor.");
    page.act(point(PointKind::Down, (start.agent.x, start.agent.y)));
    page.act(point(PointKind::Leave, (1, 1)));
    assert_eq!((page.state.talk.room.held, page.shown()), (None, &start), "let go outside");
}

#[test]
fn a_click_turns_the_robot() {
    let mut page = editing();
    let robot = (world().agent.x, world().agent.y);
    drag(&mut page, robot, robot);
    assert_eq!(page.shown().agent.direction, world().agent.direction.left());
}

#[test]
fn all_of_it_is_done_with_keys() {
    let mut page = editing();
    let start = world();
    let robot = (start.agent.x, start.agent.y);
    page.act(talk::Action::Press(Key::Arrow(Direction::North, false)));
    assert_eq!(page.state.talk.room.cursor, Some((robot.0, robot.1 + 1)), "it begins at the robot");
    assert!(page.state.shared.announcement.starts_with(&format!(
        "column {}, row {}",
        robot.0,
        robot.1 + 1
    )));
    page.act(talk::Action::Press(Key::Arrow(Direction::South, false)));
    page.act(talk::Action::Press(Key::Act));
    assert!(matches!(page.state.talk.room.held, Some(Held::Item(Thing::Robot, _))));
    page.act(talk::Action::Press(Key::Arrow(Direction::South, false)));
    page.act(talk::Action::Press(Key::Act));
    assert_eq!((page.shown().agent.x, page.shown().agent.y), (robot.0, robot.1 - 1));
    page.act(talk::Action::Press(Key::Turn));
    assert_eq!(page.shown().agent.direction, start.agent.direction.left());
    page.act(talk::Action::Take(Tool::Object));
    page.act(talk::Action::Press(Key::Arrow(Direction::North, false)));
    page.act(talk::Action::Press(Key::Act));
    assert_eq!(page.shown().objects.len(), start.objects.len() + 1);
    page.act(talk::Action::Press(Key::Cancel));
    assert_eq!(page.state.talk.room.cursor, None);
    for _ in 0..3 {
        page.act(Action::Undo);
    }
    assert_eq!(page.shown(), &start);
}

#[test]
fn the_cursor_stays_in_the_picture() {
    let mut page = editing();
    for _ in 0..50 {
        page.act(talk::Action::Press(Key::Arrow(Direction::West, false)));
        page.act(talk::Action::Press(Key::Arrow(Direction::South, true)));
    }
    assert_eq!(page.state.talk.room.cursor, Some((0, 0)));
}

#[test]
fn a_room_is_painted_with_keys() {
    let mut page = editing();
    let right = world().extent().unwrap().right;
    page.act(talk::Action::Take(Tool::Room));
    page.act(point(PointKind::Down, (right, 0)));
    page.act(point(PointKind::Move, (right + 3, 3)));
    assert!(options(&page).highlight.contains(&(right + 3, 3)));
    page.act(point(PointKind::Up, (right + 3, 3)));
    assert_eq!(page.shown().rooms.len(), 4);
}

#[test]
fn other_worlds_come_from_the_engine_and_are_undone() {
    let mut page = Page::ready();
    page.act(talk::Action::DrawWorld);
    assert!(matches!(page.asked(), Request::Draw { seed: 1, .. }));
    let mut other = world();
    other.objects.clear();
    page.answer(Event::World(other.clone()));
    assert_eq!(
        (page.shown(), page.state.talk.room.seed, page.state.shared.document.preset),
        (&other, 2, None)
    );
    page.act(talk::Action::ToggleText);
    page.answer(Event::WorldText { text: "a map".to_owned() });
    page.act(talk::Action::TypedText("another map".to_owned()));
    page.act(talk::Action::ApplyText);
    assert_eq!(page.asked(), &Request::ReadWorld { text: "another map".to_owned() });
    page.answer(Event::Refused { message: "line 1, column 2: what is this".to_owned() });
    assert!(page.state.talk.room.notice.is_some() && page.shown() == &other, "nothing is lost");
    assert_eq!(page.state.talk.room.text.as_deref(), Some("another map"));
    page.act(talk::Action::ApplyText);
    page.answer(Event::World(world()));
    assert_eq!((page.shown(), page.state.talk.room.text.clone()), (&world(), None));
    page.act(Action::Undo);
    page.act(Action::Undo);
    assert_eq!((page.shown(), page.state.shared.document.preset), (&world(), Some(0)));
    page.act(talk::Action::ToggleText);
    page.answer(Event::WorldText { text: "a map".to_owned() });
    page.act(talk::Action::TypedText(" {}".to_owned()));
    page.act(talk::Action::ApplyText);
    assert_eq!(page.others.last(), Some(&Effect::ReadWorld(" {}".to_owned())));
    page.act(talk::Action::WorldRead(Err("it is no world".to_owned())));
    assert_eq!(page.state.talk.room.notice.as_deref(), Some("it is no world"));
    page.act(talk::Action::WorldRead(Ok(other.clone())));
    assert_eq!((page.shown(), page.state.talk.room.text.clone()), (&other, None));
}

#[test]
fn a_command_is_read_again_when_the_room_has_changed() {
    let mut page = editing();
    page.act(talk::Action::Typed("go".to_owned()));
    page.answer(Event::Answer(Box::new(super::understood("go", None))));
    drag(&mut page, (world().agent.x, world().agent.y), (1, 1));
    assert!(matches!(page.asked(), Request::Read { state, .. } if state.agent.x == 1));
}
