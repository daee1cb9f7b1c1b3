//! Why nothing came of a command: every kind is told with what to do about it, and its buttons do what they say.

use super::{Page, failed, no_plan, plan, understood, word, world};
use groundling::domain::{Color, Shape};
use groundling::ui::app::Action;
use groundling::ui::page::language::Language;
use groundling::ui::talk;
use groundling::ui::talk::room::edit::Look;
use groundling::ui::talk::room::state::Mode;
use groundling::ui::talk::why::help::Help;
use groundling::ui::talk::why::message::Message;
use groundling::worker::protocol::{
    Answer, Article, Description, Event, Fate, Noun, Phrase, Referent, Refers, Request, Word,
};

/// A page that was told something and answered so.
fn answered(answer: Answer) -> Page {
    let mut page = Page::ready();
    page.act(talk::Action::AskExample(answer.command.clone()));
    page.answer(Event::Answer(Box::new(answer)));
    page
}

fn messages(answer: Answer) -> Vec<Message> {
    answered(answer).messages()
}

fn phrase(refers: Refers, referents: Vec<Referent>) -> Phrase {
    let description = Description {
        article: Article::The,
        properties: vec!["red".to_owned(), "chair".to_owned()],
        claims: Vec::new(),
    };
    let noun = Noun::Described(Box::new(description));
    Phrase { noun, words: vec![2, 3, 4], refers, referents, taken: None }
}

fn chair(color: Color) -> Referent {
    Referent {
        class: "object".to_owned(),
        color: Some(color),
        shape: Some(Shape::Chair),
        size: None,
        cells: vec![(1, 1)],
    }
}

/// An answer to "go to the red chair" whose phrase fails.
fn failing(refers: Refers, referents: Vec<Referent>) -> Answer {
    let mut answer = understood("go to the red chair", Some(no_plan("no_referent")));
    answer.readings[0].phrases = vec![phrase(refers, referents)];
    answer
}

#[test]
fn every_failure_says_what_is_wrong_and_what_to_do() {
    let unknown = Word { near: vec!["room".to_owned()], ..word("roon", Fate::Unknown) };
    let cases = [
        ("empty", failed("", "empty")),
        ("too_long", failed("go", "too_long")),
        ("unknown_words", Answer { words: vec![unknown], ..failed("roon", "unknown_words") }),
        ("no_parse", failed("the", "no_parse")),
        ("budget", failed("go", "budget")),
        ("no_referent", failing(Refers::None, Vec::new())),
        ("no_referent", failing(Refers::Several, vec![chair(Color::Red), chair(Color::Blue)])),
        ("no_referent", failing(Refers::Tie, vec![chair(Color::Red), chair(Color::Blue)])),
        ("no_referent", failing(Refers::Single, vec![chair(Color::Red)])),
        ("no_referent", failing(Refers::Mixed, Vec::new())),
        ("no_referent", understood("go", Some(no_plan("no_referent")))),
        ("already_true", understood("go", Some(plan(&world(), 0)))),
        ("unreachable", understood("go", Some(no_plan("unreachable")))),
        ("plan_budget", understood("go", Some(no_plan("budget")))),
        ("bad_goal", understood("go", Some(no_plan("bad_goal")))),
        (
            "not_reached",
            understood(
                "go",
                Some(groundling::worker::protocol::PlanText {
                    reached: false,
                    ..plan(&world(), 2)
                }),
            ),
        ),
    ];
    for language in Language::ALL {
        for (kind, answer) in cases.clone() {
            let mut page = answered(answer);
            page.state.shared.language = language;
            let found = page.messages();
            assert_eq!(found.iter().map(|m| m.kind).collect::<Vec<_>>(), [kind]);
            assert!(found[0].what.len() > 10 && found[0].fix.len() > 10, "{:?}", found[0]);
        }
    }
}

#[test]
fn a_command_that_works_is_told_without_a_word() {
    assert!(messages(understood("go", Some(plan(&world(), 2)))).is_empty());
}

#[test]
fn words_that_were_left_out_are_told_unknown_ones_first() {
    let words = vec![
        word("please", Fate::Skipped),
        Word { near: vec!["purple".to_owned()], ..word("purpel", Fate::Unknown) },
        word("go", Fate::Meant),
    ];
    let found =
        messages(Answer { words, ..understood("please purpel go", Some(plan(&world(), 1))) });
    assert_eq!(found.iter().map(|m| m.kind).collect::<Vec<_>>(), ["unknown_words", "skipped"]);
    assert_eq!(found[0].helps, [Help::Say((1, 2), "purple".to_owned()), Help::Teach]);
    assert!(found[1].what.contains("“please”"));
}

#[test]
fn a_near_spelling_is_said_instead() {
    let words = vec![word("go", Fate::Idle), word("roon", Fate::Unknown), word("now", Fate::Idle)];
    let mut page = answered(Answer { words, ..failed("go roon now", "unknown_words") });
    page.act(talk::Action::Help(Help::Say((1, 2), "to the room".to_owned())));
    assert!(
        matches!(page.asked(), Request::Ask { command, .. } if command == "go to the room now")
    );
}

#[test]
fn several_things_can_be_told_apart_at_a_press() {
    let found = messages(failing(Refers::Several, vec![chair(Color::Red), chair(Color::Blue)]));
    assert!(found[0].helps.contains(&Help::Say((2, 5), "the blue chair".to_owned())), "{found:?}");
    let mut spared = failing(Refers::Several, vec![chair(Color::Red), chair(Color::Blue)]);
    spared.words[2] = word("the", Fate::Empty);
    spared.readings[0].phrases[0].words = vec![3, 4];
    let found = messages(spared);
    let helps = &found[0].helps;
    assert!(helps.contains(&Help::Say((2, 5), "the blue chair".to_owned())), "one article");
    let twins = messages(failing(Refers::Several, vec![chair(Color::Red), chair(Color::Red)]));
    assert!(
        !twins[0].helps.iter().any(|help| matches!(help, Help::Say(..))),
        "twins have one name"
    );
    assert!(twins[0].helps.contains(&Help::Show((2, 5))));
}

#[test]
fn what_is_missing_is_put_there_at_a_press() {
    let look = Look { shape: Shape::Chair, color: Color::Red, size: None };
    let answer = failing(Refers::None, Vec::new());
    let mut page = answered(answer);
    assert_eq!(page.messages()[0].helps, [Help::Add(look), Help::Edit]);
    page.act(talk::Action::Help(Help::Add(look)));
    let chairs =
        page.state.shared.document.world.objects.iter().filter(|o| o.shape == Shape::Chair);
    assert_eq!(chairs.count(), 1);
    assert!(page.state.shared.talker.is_at(
        |request| matches!(request, Request::Ask { command, .. } if command == "go to the red chair")
    ));
}

#[test]
fn what_is_in_the_way_gives_way_at_a_press() {
    for (help, holds) in [
        (
            Help::FreeLandmarks,
            (|page| !page.state.shared.document.rules.landmarks_stay) as fn(&Page) -> bool,
        ),
        (Help::Pull, |page| page.state.shared.document.rules.pull),
        (Help::NoChance, |page| page.state.shared.document.rules.slip == 0.0),
    ] {
        let mut page = answered(understood("go", Some(no_plan("unreachable"))));
        page.act(talk::Action::Help(help.clone()));
        assert!(holds(&page), "{help:?}");
        assert!(matches!(page.asked(), Request::Plan { .. }), "{help:?}");
        page.act(Action::Undo);
        assert!(page.state.shared.document.rules == Page::ready().state.shared.document.rules);
    }
    let mut page = answered(understood("go", Some(no_plan("unreachable"))));
    page.act(talk::Action::Help(Help::Unlock));
    assert!(matches!(page.asked(), Request::Ask { .. } | Request::Read { .. }));
}

#[test]
fn a_command_that_was_not_understood_can_be_shown_instead() {
    let mut page = answered(failed("do the thing", "no_parse"));
    page.act(talk::Action::Help(Help::Teach));
    assert_eq!(
        (page.state.talk.room.mode, page.state.talk.teach.words.as_str()),
        (Mode::Teach, "do the thing")
    );
    page.act(talk::Action::Help(Help::Edit));
    assert_eq!(page.state.talk.room.mode, Mode::Edit);
    page.act(talk::Action::Help(Help::OtherWorld));
    assert!(matches!(page.asked(), Request::Draw { .. }));
}
