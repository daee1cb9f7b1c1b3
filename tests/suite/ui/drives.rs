//! Teaching by ways: the robot is driven or taken along by a hand, what the page would have done is offered as what is not
//! meant, and so are plans.

use super::{Page, plan, taught, understood, world};
use groundling::domain::{Direction, State as World};
use groundling::ui::app::Action;
use groundling::ui::page::document::Draft;
use groundling::ui::page::place::Place;
use groundling::ui::talk::Action as Talk;
use groundling::ui::talk::room::point::{Key, Point, PointKind};
use groundling::ui::talk::room::state::Mode;
use groundling::ui::talk::teach::state::Missing;
use groundling::ui::talk::teach::trail::Trail;
use groundling::ui::talk::teach::unlike::Unlike;
use groundling::worker::protocol::{Event, Program, Request};

/// From the green room through the red one into the blue one; the straight way is "www".
const AROUND: &str = "ennnnwwww";

fn drive(page: &mut Page, letters: &str) {
    for letter in letters.chars() {
        let direction = match letter {
            'n' => Direction::North,
            's' => Direction::South,
            'e' => Direction::East,
            _ => Direction::West,
        };
        page.act(Talk::Press(Key::Arrow(direction, false)));
    }
}

fn teaching() -> Page {
    let mut page = Page::ready();
    page.act(Talk::SetMode(Mode::Teach));
    page.hear(Program::Learner, 0, Event::Ready);
    page
}

fn draft(page: &Page) -> &Draft {
    page.state.shared.document.draft.as_ref().unwrap()
}

fn offered(page: &Page) -> Option<&str> {
    page.state.talk.teach.straight.as_deref()
}

#[test]
fn a_way_that_is_driven_is_known_until_something_is_put_elsewhere() {
    let mut page = teaching();
    drive(&mut page, "wn");
    assert_eq!(draft(&page).way.as_deref(), Some("wn"));
    page.act(Talk::Press(Key::Turn));
    assert_eq!(draft(&page).way, None);
    drive(&mut page, "s");
    assert_eq!(draft(&page).way, None);
    page.act(Talk::ClearDraft);
    drive(&mut page, "s");
    assert_eq!(draft(&page).way.as_deref(), Some("s"));
}

#[test]
fn the_way_that_the_page_would_have_taken_is_offered_as_not_meant() {
    let mut page = teaching();
    drive(&mut page, "ennnn");
    assert_eq!(offered(&page), None, "straight into the red room");
    drive(&mut page, "wwww");
    assert_eq!(offered(&page), Some("www"));
    page.act(Talk::Unlike(Unlike::Straight));
    assert_eq!((offered(&page), &*draft(&page).contrasts), (None, &["www".to_owned()][..]));
    page.act(Action::Undo);
    assert_eq!((offered(&page), draft(&page).contrasts.len()), (Some("www"), 0));
    page.act(Action::Redo);
    page.act(Talk::TypedLesson("blue threading red".to_owned()));
    page.act(Talk::Teach);
    let Request::Teach { examples, .. } = page.asked() else { panic!() };
    let run = &examples[0].runs[0];
    assert_eq!((&*run.actions, &*run.contrast), (AROUND, &["www".to_owned()][..]));
    page.answer(taught("taught", &[true]));
    assert_eq!(page.shown(), &world());
}

#[test]
fn a_way_that_is_driven_can_be_what_is_not_meant() {
    let mut page = teaching();
    drive(&mut page, "www");
    page.act(Talk::Unlike(Unlike::Driven));
    assert_eq!(page.shown(), &world(), "what is meant is shown anew");
    assert_eq!(draft(&page).contrasts, ["www"]);
    page.act(Talk::TypedLesson("blue threading red".to_owned()));
    page.act(Talk::Teach);
    assert_eq!(page.state.talk.teach.missing, Some(Missing::Demonstration));
    drive(&mut page, AROUND);
    assert_eq!(offered(&page), None, "one such way is enough");
    page.act(Talk::Press(Key::Turn));
    page.act(Talk::Teach);
    assert_eq!(page.state.talk.teach.missing, Some(Missing::Way), "a contrast to what?");
    assert!(page.posted.is_empty());
}

#[test]
fn a_plan_that_is_not_meant_becomes_a_contrast_where_it_was_said() {
    let mut page = Page::ready();
    page.act(Talk::AskExample("go threading red".to_owned()));
    let start = page.shown().clone();
    page.answer(Event::Answer(Box::new(understood("go threading red", Some(plan(&start, 2))))));
    while page.play_on() {}
    assert_ne!(page.shown(), &start);
    page.act(Talk::Unlike(Unlike::Planned));
    assert_eq!((page.shown(), page.state.talk.room.mode), (&start, Mode::Teach));
    assert_eq!(draft(&page).contrasts, ["ee"]);
    assert_eq!(page.state.talk.teach.words, "go threading red");
    page.act(Action::Undo);
    assert_eq!(page.state.shared.document.draft, None);
    assert!(page.state.shared.document.said.is_some());
}

fn walk(world: &World, cells: &[Place]) -> Option<Trail> {
    cells.iter().try_fold(Trail::new(world), |trail, &cell| trail.to(cell))
}

#[test]
fn a_hand_drives_where_the_robot_can_go() {
    let world = world();
    let steps = |cells: &[Place]| walk(&world, cells).map(|trail| trail.steps);
    assert_eq!(steps(&[(5, 2), (4, 2), (3, 2)]).as_deref(), Some("www"));
    assert_eq!(steps(&[(7, 3)]).as_deref(), Some("en"), "a quick hand leaves cells out");
    assert_eq!(steps(&[(7, 3), (7, 4), (6, 4), (7, 5)]).as_deref(), Some("ennn"), "over a wall");
    assert_eq!(steps(&[(6, 6)]), None, "through a wall");
}

#[test]
fn the_robot_is_taken_along_with_a_pointer() {
    let mut page = teaching();
    let mut point = |kind, cell: Place| {
        let (x, y) = (cell.0 as f32, cell.1 as f32);
        page.act(Talk::Point(Point { kind, x, y, cell }));
    };
    point(PointKind::Down, (6, 2));
    point(PointKind::Move, (5, 2));
    point(PointKind::Move, (3, 2));
    point(PointKind::Up, (3, 2));
    assert_eq!(draft(&page).way.as_deref(), Some("www"));
    assert_eq!(page.shown().agent.x, 3);
}
