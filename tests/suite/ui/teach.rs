//! Teaching: showing, saying, learning, forgetting, and all of it undone.

use super::{Page, model, taught, world};
use groundling::domain::Direction;
use groundling::ui::app::Action;
use groundling::ui::page::effect::Effect;
use groundling::ui::page::files::Given;
use groundling::ui::talk;
use groundling::ui::talk::room::point::Key;
use groundling::ui::talk::room::state::Mode;
use groundling::ui::talk::teach::learn;
use groundling::ui::talk::teach::state::Missing;
use groundling::worker::protocol::{Event, Lesson, Program, Request};

/// A page on which the robot was driven a step west for a lesson, the learner being up.
fn shown() -> Page {
    let mut page = Page::ready();
    page.act(talk::Action::SetMode(Mode::Teach));
    assert_eq!(page.others, [Effect::SpawnEngine(Program::Learner)], "made ready meanwhile");
    page.hear(Program::Learner, 0, Event::Ready);
    page.act(talk::Action::Press(Key::Arrow(Direction::West, false)));
    page
}

/// The page has learned one command.
fn learned() -> Page {
    let mut page = shown();
    page.act(talk::Action::TypedLesson("scoot over".to_owned()));
    page.act(talk::Action::Teach);
    page.answer(taught("taught once", &[true]));
    page.answer(Event::Opened(model("taught once")));
    page
}

#[test]
fn showing_moves_nothing_but_the_demonstration() {
    let page = shown();
    assert_eq!(page.state.shared.document.world, world());
    assert_eq!(page.shown().agent.x, world().agent.x - 1);
}

#[test]
fn a_lesson_lacks_what_is_not_shown_or_said() {
    let mut page = Page::ready();
    page.act(talk::Action::SetMode(Mode::Teach));
    page.act(talk::Action::Teach);
    assert_eq!(page.state.talk.teach.missing, Some(Missing::Demonstration));
    page.act(talk::Action::Press(Key::Arrow(Direction::West, false)));
    page.act(talk::Action::Teach);
    assert_eq!(page.state.talk.teach.missing, Some(Missing::Words));
    assert!(page.posted.is_empty());
    page.act(talk::Action::ClearDraft);
    assert_eq!(page.shown(), &world());
    page.act(Action::Undo);
    assert_eq!(page.shown().agent.x, world().agent.x - 1, "even that is undone");
}

#[test]
fn what_was_taught_is_used_at_once() {
    let mut page = shown();
    page.act(talk::Action::TypedLesson(" scoot over ".to_owned()));
    page.act(talk::Action::Teach);
    let Request::Teach { model: base, examples } = page.asked() else { panic!() };
    assert_eq!(base, "the model");
    let [Lesson { command, pairs, runs, .. }] = examples.as_slice() else { panic!() };
    assert_eq!((command.as_str(), pairs.len()), ("scoot over", 0));
    assert_eq!((&runs[0].start, &*runs[0].actions), (&world(), "w"), "the way is known");
    page.answer(taught("taught once", &[true]));
    assert_eq!(page.asked(), &Request::OpenModel { text: "taught once".to_owned() });
    page.answer(Event::Opened(model("taught once")));
    assert_eq!(
        (page.state.talk.room.mode, page.state.talk.command.input.as_str()),
        (Mode::Watch, "scoot over")
    );
    assert_eq!(page.shown(), &world(), "the command can be tried where it was shown");
    assert!(matches!(page.asked(), Request::Read { command, .. } if command == "scoot over"));
}

#[test]
fn lessons_are_always_taught_to_the_model_before_them() {
    let mut page = learned();
    page.posted.clear();
    page.act(talk::Action::SetMode(Mode::Teach));
    page.act(talk::Action::Press(Key::Arrow(Direction::West, false)));
    page.act(talk::Action::TypedLesson("again".to_owned()));
    page.act(talk::Action::Teach);
    let Request::Teach { model: base, examples } = page.asked() else { panic!() };
    let commands: Vec<&str> = examples.iter().map(|lesson| &*lesson.command).collect();
    assert_eq!((base.as_str(), commands), ("the model", vec!["scoot over", "again"]));
}

#[test]
fn what_could_not_be_learned_changes_nothing() {
    let mut page = shown();
    page.act(talk::Action::TypedLesson("xyzzy".to_owned()));
    page.act(talk::Action::Teach);
    page.answer(taught("worse", &[false]));
    assert!(page.state.talk.teach.notice.as_ref().is_some_and(|words| words.contains("xyzzy")));
    assert!(page.state.shared.document.lessons.is_empty() && page.posted.is_empty());
    assert_eq!(
        (page.state.talk.room.mode, page.state.talk.teach.words.as_str()),
        (Mode::Teach, "xyzzy")
    );
}

#[test]
fn lessons_are_undone_redone_and_forgotten() {
    let mut page = learned();
    page.posted.clear();
    let text =
        |page: &Page| page.state.shared.document.model.as_ref().map(|m| m.report.model.clone());
    page.act(Action::Undo);
    assert_eq!(
        (text(&page).as_deref(), page.state.shared.document.lessons.len()),
        (Some("the model"), 0)
    );
    page.act(Action::Redo);
    assert_eq!(
        (text(&page).as_deref(), page.state.shared.document.lessons.len()),
        (Some("taught once"), 1)
    );
    page.act(talk::Action::Unteach(0));
    assert_eq!(
        (text(&page).as_deref(), page.state.shared.document.lessons.len()),
        (Some("the model"), 0)
    );
    page.act(Action::Undo);
    assert_eq!(page.state.shared.document.lessons.len(), 1);
}

#[test]
fn lessons_are_saved_as_a_corpus_that_the_project_reads() {
    let mut page = learned();
    page.others.clear();
    page.act(talk::Action::SaveLessons);
    let [Effect::SaveLessons(packed)] = page.others.as_slice() else { panic!() };
    let text = learn::corpus(packed);
    let (corpus, flaws) = groundling::corpus::read(text.as_bytes(), Default::default());
    assert_eq!(flaws, []);
    assert_eq!(corpus.examples[0].command, "scoot over");
    assert_eq!(corpus.examples[0].pairs[0].pre, world());
}

#[test]
fn a_new_model_is_taught_the_same_lessons() {
    let mut page = learned();
    page.answer(Event::Answer(Box::new(super::failed("scoot over", "no_parse"))));
    page.act(Action::Given(Given::Model("another".to_owned())));
    assert_eq!(page.asked(), &Request::OpenModel { text: "another".to_owned() });
    page.answer(Event::Opened(model("another")));
    let Request::Teach { model: base, examples } = page.asked() else { panic!() };
    assert_eq!((base.as_str(), examples.len()), ("another", 1));
}
