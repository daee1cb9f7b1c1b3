//! Sharing: what goes out comes back the same, and what comes in is checked.

use super::{Page, model, pair, taught, understood, world};
use groundling::ui::app::Action;
use groundling::ui::page::coming::Resource;
use groundling::ui::page::effect::Effect;
use groundling::ui::page::preferences::Depth;
use groundling::ui::talk;
use groundling::ui::talk::share::session::{Session, SessionError, VERSION};
use groundling::worker::protocol::{Event, Lesson, MOST_TAUGHT, Request, RunText, WorldRules};
use proptest::prelude::any;
use proptest::proptest;

pub(crate) fn session() -> Session {
    Session {
        version: VERSION,
        world: world(),
        rules: WorldRules { pull: true, slip: 0.25, ..WorldRules::default() },
        command: Some("go to the blue room".to_owned()),
        form: Some("(g:t)".to_owned()),
        depth: Depth::See,
        lessons: vec![Lesson {
            command: "scoot".to_owned(),
            pairs: vec![pair()],
            runs: vec![driven("nn", "ee")],
            means: None,
        }],
        model: None,
        also: None,
    }
}

fn driven(actions: &str, contrast: &str) -> RunText {
    let contrast = vec![contrast.to_owned()];
    RunText { start: world(), actions: actions.to_owned(), contrast }
}

#[test]
fn a_session_reads_back_as_it_was_written() {
    assert_eq!(Session::read(&session().write()), Ok(session()));
    assert_eq!(Session::unpack(&session().pack()), Some(session()));
}

#[test]
fn what_is_shared_is_what_was_said_and_where() {
    let mut page = Page::told(3);
    while page.play_on() {}
    page.act(talk::Action::Share);
    let Some(Effect::Share(packed)) = page.others.last() else { panic!() };
    let shared = Session::unpack(packed).unwrap();
    assert_eq!((shared.world, shared.command.as_deref()), (world(), Some("go")));
    assert_eq!((shared.form, shared.model), (None, None));
}

#[test]
fn a_shared_session_opens_lessons_first_then_the_command_then_the_reading() {
    let mut page = Page::ready();
    page.act(talk::Action::Open(Ok(session().pack())));
    assert_eq!(
        (page.state.shared.depth, page.state.shared.document.rules.pull),
        (Depth::See, true)
    );
    page.hear(groundling::worker::protocol::Program::Learner, 0, Event::Ready);
    assert!(matches!(page.asked(), Request::Teach { examples, .. } if examples.len() == 1));
    page.answer(taught("taught", &[true]));
    page.answer(Event::Opened(model("taught")));
    assert!(
        page.state.shared.talker.is_at(
            |r| matches!(r, Request::Ask { command, .. } if command == "go to the blue room")
        )
    );
    let mut answer = understood("go to the blue room", None);
    answer.readings.push(super::reading("(g:t)"));
    while !matches!(page.asked(), Request::Ask { .. }) {
        page.answer(Event::Answer(Box::new(understood("x", None))));
    }
    page.answer(Event::Answer(Box::new(answer)));
    assert!(
        page.state
            .shared
            .talker
            .is_at(|r| matches!(r, Request::Plan { form, .. } if form == "(g:t)"))
    );
    page.act(Action::Undo);
}

#[test]
fn what_a_person_says_goes_before_what_a_link_has_still_to_say() {
    let mut page = Page::ready();
    page.state.shared.words = Resource::Coming;
    let session = Session { lessons: Vec::new(), ..session() };
    page.act(talk::Action::Open(Ok(session.pack())));
    assert!(page.state.talk.resume.command.is_some(), "its words are still to come");
    page.act(talk::Action::AskExample("enter the red room".to_owned()));
    page.act(Action::FetchedWords(Ok("stool\tchair\n".to_owned())));
    page.answer(Event::Words);
    let of_the_link =
        |r: &Request| matches!(r, Request::Ask { command, .. } if command == "go to the blue room");
    assert!(!page.state.shared.talker.is_at(of_the_link));
    assert_eq!(page.state.talk.resume.command, None);
}

#[test]
fn what_a_person_types_stays_in_the_box_when_a_session_speaks_at_last() {
    let mut page = Page::ready();
    page.state.shared.words = Resource::Coming;
    let session = Session { lessons: Vec::new(), ..session() };
    page.act(talk::Action::Open(Ok(session.pack())));
    page.act(talk::Action::Typed("enter the red room".to_owned()));
    page.act(Action::FetchedWords(Ok("stool\tchair\n".to_owned())));
    page.answer(Event::Words);
    assert_eq!(page.state.talk.command.input, "enter the red room");
    page.act(talk::Action::Ask);
    let typed =
        |r: &Request| matches!(r, Request::Ask { command, .. } if command == "enter the red room");
    assert!(page.state.shared.talker.is_at(typed));
}

#[test]
fn what_a_link_may_not_hold_is_refused_and_changes_nothing() {
    let good = session();
    let with = |change: fn(&mut Session)| {
        let mut session = good.clone();
        change(&mut session);
        session
    };
    type Wanted = fn(&SessionError) -> bool;
    let cases: [(Session, Wanted); 8] = [
        (with(|s| s.version = 99), |e| matches!(e, SessionError::Version(99))),
        (with(|s| s.world.agent.x = 500), |e| matches!(e, SessionError::World(_))),
        (with(|s| s.rules.slip = 1.5), |e| *e == SessionError::Rules),
        (with(|s| s.rules.loss = -0.1), |e| *e == SessionError::Rules),
        (with(|s| s.lessons = vec![s.lessons[0].clone(); MOST_TAUGHT + 1]), |e| {
            matches!(e, SessionError::Lessons(_))
        }),
        (with(|s| (s.lessons[0].pairs, s.lessons[0].runs) = Default::default()), |e| {
            *e == SessionError::Lesson(1)
        }),
        (with(|s| s.lessons[0].runs[0].actions = "nx".to_owned()), |e| {
            *e == SessionError::Lesson(1)
        }),
        (with(|s| s.command = Some("x".repeat(5_000))), |e| *e == SessionError::Command),
    ];
    for (session, wanted) in cases {
        let error = Session::read(&session.write()).unwrap_err();
        assert!(wanted(&error), "{error:?}");
        let mut page = Page::ready();
        let before = page.state.shared.document.clone();
        page.act(talk::Action::Open(Err(error.to_string())));
        assert_eq!(page.state.shared.document, before);
        assert!(
            page.state.talk.sharing.notice.as_ref().is_some_and(|n| n.contains(&error.to_string()))
        );
    }
    assert!(matches!(Session::read("{"), Err(SessionError::NotASession(_))));
    assert_eq!(Session::read(&" ".repeat(5_000_000)), Err(SessionError::TooLong));
}

proptest! {
    #[test]
    fn no_text_makes_a_panic(text in any::<String>(), cut in 0..400usize) {
        let _ = Session::read(&text);
        let whole = session().write();
        let cut: String = whole.chars().take(whole.len().saturating_sub(cut)).collect();
        let _ = Session::read(&cut);
    }
}
