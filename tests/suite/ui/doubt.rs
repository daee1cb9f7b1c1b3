//! What is doubtful is asked about, and what would be half of a command is offered: neither is done by itself.

use super::{Page, failed, model, outside, plan, reading, taught, understood, word, world};
use groundling::domain::Color;
use groundling::ui::app::Action;
use groundling::ui::page::coming::Resource;
use groundling::ui::page::effect::Effect;
use groundling::ui::page::language::Language;
use groundling::ui::talk;
use groundling::ui::talk::command::ask::question;
use groundling::ui::talk::room::state::Mode;
use groundling::ui::talk::share::session::Session;
use groundling::ui::talk::why::help::Help;
use groundling::worker::protocol::{
    Answer, Closed, Event, Fate, Noun, Phrase, Program, Refers, Request, Shade, Taken, Word,
};

fn asked(page: &Page) -> Option<&[usize]> {
    question(&page.state.talk, &page.state.shared)
}

fn said(page: &Page) -> &str {
    &page.state.shared.announcement
}

/// A page that asks which of two readings of "go" is meant.
fn asking() -> Page {
    let mut page = Page::ready();
    page.act(talk::Action::AskExample("go".to_owned()));
    let readings = vec![reading("(f:t)"), outside("(g:t)")];
    let answer = Answer { readings, asks: vec![1, 0], ..understood("go", None) };
    page.answer(Event::Answer(Box::new(answer)));
    page
}

#[test]
fn a_question_is_asked_aloud_and_nothing_is_done() {
    let page = asking();
    assert_eq!(asked(&page), Some(&[1, 0][..]));
    assert_eq!(
        said(&page),
        "Which do you mean? 1: The robot is outside the red room. 2: The robot is the same as the robot."
    );
    // The room is brought to sight when it was said, and again when the answer has taken its place.
    let scene = Effect::Reveal("scene");
    let asked = Effect::FocusOnDesk("command");
    assert_eq!(page.others, [asked, scene.clone(), scene, Effect::Focus("choice-1")]);
    assert!(page.posted.is_empty() && page.state.talk.watch.playback.is_none());
    assert_eq!(page.shown(), &world());
    assert!(page.messages().is_empty());
}

#[test]
fn the_answer_is_done_and_can_be_remembered() {
    let mut page = asking();
    page.act(talk::Action::Choose(1));
    assert_eq!(asked(&page), None, "it is being planned");
    let Request::Plan { form, .. } = page.asked() else { panic!() };
    assert_eq!(form, "(g:t)");
    page.act(talk::Action::Remember);
    assert_eq!(page.posted.len(), 1, "there is nothing to remember yet");
    page.answer(Event::Planned(Box::new(plan(&world(), 2))));
    assert!(
        said(&page).contains("stay out of the red room. The plan has 2 steps."),
        "{}",
        said(&page)
    );
    while page.play_on() {}
    page.act(talk::Action::Remember);
    page.hear(Program::Learner, 0, Event::Ready);
    let Request::Teach { examples, .. } = page.asked() else { panic!("{:?}", page.posted) };
    let [lesson] = &examples[..] else { panic!() };
    assert_eq!((lesson.command.as_str(), &lesson.pairs[0].pre), ("go", &world()));
    assert_eq!(lesson.pairs[0].post.agent.x, world().agent.x + 2);
    page.answer(taught("taught", &[true]));
    page.answer(Event::Opened(model("taught")));
    assert_eq!(page.state.shared.document.lessons.len(), 1);
    page.act(talk::Action::Remember);
    assert!(page.posted.is_empty(), "once is enough");
    // What was taught is not asked about again.
    page.act(talk::Action::Ask);
    let readings = vec![outside("(g:t)"), reading("(f:t)")];
    let answer = Answer { readings, asks: vec![0, 1], ..understood("go", None) };
    page.answer(Event::Answer(Box::new(answer)));
    assert!(matches!(page.asked(), Request::Plan { form, .. } if form == "(g:t)"));
    assert_eq!(asked(&page), None);
}

#[test]
fn a_choice_is_undone_to_the_question_and_a_stopped_one_asks_again() {
    let mut page = asking();
    page.act(talk::Action::Choose(0));
    page.answer(Event::Cancelled);
    assert_eq!(asked(&page), Some(&[1, 0][..]));
    page.act(talk::Action::Choose(0));
    page.answer(Event::Planned(Box::new(plan(&world(), 1))));
    assert_eq!(asked(&page), None);
    page.act(Action::Undo);
    assert_eq!(asked(&page), Some(&[1, 0][..]));
}

#[test]
fn none_of_them_is_shown_instead() {
    let mut page = asking();
    page.act(talk::Action::Help(Help::Teach));
    assert_eq!((page.state.talk.room.mode, &*page.state.talk.teach.words), (Mode::Teach, "go"));
}

#[test]
fn a_link_holds_the_answer_and_not_an_open_question() {
    let mut page = asking();
    assert_eq!(Session::of(&page.state.shared, false).form, None);
    page.act(talk::Action::Choose(0));
    page.answer(Event::Planned(Box::new(plan(&world(), 1))));
    let session = Session::of(&page.state.shared, false);
    assert_eq!(session.form.as_deref(), Some("(f:t)"));
    let mut other = Page::ready();
    other.act(talk::Action::Open(Ok(session.pack())));
    let readings = vec![reading("(f:t)"), outside("(g:t)")];
    let answer = Answer { readings, asks: vec![1, 0], ..understood("go", None) };
    other.answer(Event::Answer(Box::new(answer)));
    assert!(matches!(other.asked(), Request::Plan { form, .. } if form == "(f:t)"));
}

/// A page that was told "go through now" and can go now.
fn half(kind: Closed) -> Page {
    let mut page = Page::ready();
    page.act(talk::Action::AskExample("go through it now".to_owned()));
    let words = vec![
        word("go", Fate::Meant),
        Word { closed: Some(kind), ..word("through", Fate::Skipped) },
        word("it", Fate::Skipped),
        word("now", Fate::Empty),
    ];
    let reason = Some("left_out".to_owned());
    let answer = Answer { words, reason, ..understood("go through it now", None) };
    page.answer(Event::Answer(Box::new(answer)));
    page
}

#[test]
fn what_was_left_out_is_said_by_its_kind_and_the_rest_is_offered() {
    for (kind, name) in
        [(Closed::Orders, "time"), (Closed::Turns, "prohibition"), (Closed::Joins, "half")]
    {
        for language in Language::ALL {
            let mut page = half(kind);
            page.state.shared.language = language;
            let [message] = &page.messages()[..] else { panic!("{:?}", page.messages()) };
            assert_eq!(message.kind, name);
            assert!(message.what.contains("through it") && message.fix.len() > 10, "{message:?}");
            assert!(matches!(message.helps[..], [Help::Just(_), Help::Teach]), "{message:?}");
        }
    }
    let mut page = half(Closed::Orders);
    assert!(page.posted.is_empty(), "nothing is done by itself");
    let just = page.messages()[0].helps[0].clone();
    page.act(talk::Action::Help(just));
    assert!(matches!(page.asked(), Request::Plan { form, .. } if form == "(f:t)"));
    page.answer(Event::Planned(Box::new(plan(&world(), 1))));
    let [message] = &page.messages()[..] else { panic!("{:?}", page.messages()) };
    assert_eq!(message.helps, [Help::Teach], "it was done, and what was left out is still said");
    assert!(said(&page).contains("“through it”") && said(&page).contains("one step"));
}

#[test]
fn where_nothing_is_left_nothing_is_offered() {
    let mut page = Page::ready();
    page.act(talk::Action::AskExample("neither".to_owned()));
    let words = vec![Word { closed: Some(Closed::Turns), ..word("neither", Fate::Skipped) }];
    page.answer(Event::Answer(Box::new(Answer { words, ..failed("neither", "left_out") })));
    let [message] = &page.messages()[..] else { panic!("{:?}", page.messages()) };
    assert!(message.what.contains("“neither”"));
    assert_eq!(message.helps, [Help::Teach]);
}

#[test]
fn what_is_kept_from_is_told_so_when_there_is_nothing_to_do() {
    let mut page = Page::ready();
    page.act(talk::Action::AskExample("go".to_owned()));
    let plan = Some(plan(&world(), 0));
    let answer = Answer { readings: vec![outside("(g:t)")], ..understood("go", plan) };
    page.answer(Event::Answer(Box::new(answer)));
    let [message] = &page.messages()[..] else { panic!("{:?}", page.messages()) };
    assert_eq!((message.kind, &*message.what), ("keeps", "I stay out of the red room."));
    page.state.shared.language = Language::German;
    assert_eq!(page.messages()[0].what, "Ich bleibe dem roten Raum fern.");
}

#[test]
fn what_words_were_taken_for_is_said() {
    let mut page = Page::ready();
    page.act(talk::Action::AskExample("go armchair".to_owned()));
    let mut answer = understood("go armchair", Some(plan(&world(), 1)));
    answer.taken = vec![Taken { words: (1, 2), name: "chair".to_owned() }];
    let taken = Shade::named("violet").map(|shade| (shade, Color::Blue));
    answer.readings[0].phrases = vec![Phrase {
        noun: Noun::Robot,
        words: Vec::new(),
        refers: Refers::One,
        referents: Vec::new(),
        taken,
    }];
    page.answer(Event::Answer(Box::new(answer)));
    let words = "I take “armchair” for “chair”. I take “violet” for “blue”.";
    assert_eq!(page.messages().iter().map(|m| &*m.what).collect::<Vec<_>>(), [words]);
    assert!(said(&page).starts_with(words) && said(&page).contains("one step"), "{}", said(&page));
}

#[test]
fn the_resource_comes_after_the_model_and_is_given_to_a_new_engine() {
    let mut page = Page::new();
    page.hear(Program::Talker, 0, Event::Ready);
    page.act(Action::Fetched(Ok("the model".to_owned())));
    assert!(!page.others.contains(&Effect::FetchWords));
    page.answer(Event::Opened(model("the model")));
    assert_eq!(page.others.pop(), Some(Effect::FetchWords));
    // What a link holds waits for it: its words may need it.
    let session =
        Session { command: Some("go".to_owned()), ..Session::of(&page.state.shared, false) };
    page.act(talk::Action::Open(Ok(session.pack())));
    assert!(page.posted.is_empty());
    page.act(Action::FetchedWords(Ok("stool\tchair\n".to_owned())));
    assert!(matches!(page.asked(), Request::Words { .. }));
    page.answer(Event::Words);
    assert!(matches!(page.asked(), Request::Ask { command, .. } if command == "go"));
    page.answer(Event::Answer(Box::new(understood("go", None))));
    assert_eq!(page.state.shared.words, Resource::Here("stool\tchair\n".into()));
    page.act(Action::RestartEngine(Program::Talker));
    page.hear(Program::Talker, 0, Event::Ready);
    assert!(matches!(page.asked(), Request::Words { .. }));
    page.answer(Event::Words);
    assert!(matches!(page.asked(), Request::OpenModel { .. }));
}

#[test]
fn without_the_resource_all_else_works() {
    for lost in [true, false] {
        let mut page = Page::opened();
        if lost {
            page.act(Action::FetchedWords(Err("status 404".to_owned())));
        } else {
            page.act(Action::FetchedWords(Ok("nonsense".to_owned())));
            page.answer(Event::Refused { message: "line 1".to_owned() });
        }
        assert_eq!(page.state.shared.words, Resource::Lost);
        page.act(talk::Action::AskExample("go".to_owned()));
        assert!(matches!(page.asked(), Request::Ask { .. }));
    }
}
