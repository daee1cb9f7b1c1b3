//! Questions by their words, what lies beyond the language, and the guide: its examples are filled in from the room.

use super::{Page, understood, world};
use groundling::ui::app::Action;
use groundling::ui::help::guide::filled;
use groundling::ui::talk;
use groundling::ui::talk::command::query::{Query, query};
use groundling::ui::talk::teach::other::in_other_words;
use groundling::worker::protocol::{Beyond, Event, Meaning, Request, beyond};

const GUIDES: [&str; 2] =
    [include_str!("../../../www/help.en.html"), include_str!("../../../www/help.de.html")];

#[test]
fn questions_are_told_from_commands() {
    let about = query;
    let is = |kind, words: &str| Some((kind, words.to_owned()));
    assert_eq!(about("Where is the block?"), is(Query::Where, "go to the block"));
    assert_eq!(about("Which room is the block in?"), is(Query::Where, "go to the block"));
    assert_eq!(about("where's the red chair"), is(Query::Where, "go to the red chair"));
    assert_eq!(about("where are you?"), is(Query::Where, "go to the robot"));
    assert_eq!(about("what is in the blue room?"), is(Query::Inside, "go to the blue room"));
    let put = "put the block in the blue room";
    assert_eq!(about("is the block in the blue room?"), is(Query::Is, put));
    assert_eq!(about("are you in the red room?"), is(Query::Is, "go in the red room"));
    assert_eq!(about("how many chairs are there?"), is(Query::Count, "go to the chair"));
    assert_eq!(about("is there a chair?"), is(Query::Count, "go to the chair"));
    assert_eq!(about("are there any red chairs?"), is(Query::Count, "go to the red chair"));
    assert_eq!(
        about("is there a block in the red room"),
        is(Query::Is, "put a block in the red room")
    );
    assert_eq!(about("what rooms are there?"), is(Query::Count, "go to the room"));
    assert_eq!(about("which objects do you see"), is(Query::Count, "go to the object"));
    assert_eq!(about("how many rooms"), is(Query::Count, "go to the room"));
    assert_eq!(about("what can you see?"), is(Query::World, ""));
    assert_eq!(about("what can you do?"), is(Query::Can, ""));
    assert_eq!(about("how do I teach you a word"), is(Query::Can, ""));
    assert_eq!(about("what is the biggest room?"), is(Query::Name, "go to the biggest room"));
    assert_eq!(about("which room is the smallest"), is(Query::Name, "go to the smallest room"));
    assert_eq!(about("what color is the block"), is(Query::Name, "go to the block"));
    assert_eq!(about("wheres the block?"), is(Query::Where, "go to the block"));
    assert_eq!(about("tell me where the block is"), is(Query::Where, "go to the block"));
    assert_eq!(about("can you see the block?"), is(Query::Where, "go to the block"));
    for greeting in ["hello", "Hi robot!", "hi robot, how are you?", "thanks"] {
        assert_eq!(about(greeting), is(Query::Can, ""), "{greeting}");
    }
    for question in [
        "should i go to the red room?",
        "did you go to the red room?",
        "do you like the red room?",
        "who made you?",
        "why not",
        "is the door locked?",
        "which block do you see",
        "how far is it",
    ] {
        assert_eq!(about(question), is(Query::Else, ""), "{question}");
    }
    for command in [
        "go to the blue room",
        "can you go to the blue room?",
        "hello robot, go to the blue room",
        "hide the block",
        "have the robot go to the blue room",
        "take it where you want",
        "when you are ready go to the blue room",
        "how about going to the red room",
        "where the chair is, go there",
    ] {
        assert_eq!(about(command), None, "{command}");
    }
}

#[test]
fn a_question_is_looked_up_and_changes_nothing() {
    let mut page = Page::ready();
    page.act(talk::Action::AskExample("where is the block?".to_owned()));
    let Request::Read { command, .. } = page.asked() else { panic!("{:?}", page.posted) };
    assert_eq!(command, "go to the block");
    page.answer(Event::Answer(Box::new(understood("go to the block", None))));
    assert!(page.state.talk.command.reply.is_some());
    assert_eq!(page.shown(), &world());
    assert_eq!(page.state.talk.past.lines.len(), 1);
    page.act(talk::Action::AskExample("where are you?".to_owned()));
    let reply = page.state.talk.command.reply.as_ref().unwrap();
    assert!(reply.words.starts_with("The robot is in"), "{}", reply.words);
    page.act(talk::Action::Typed("go".to_owned()));
    assert_eq!(page.state.talk.command.reply, None, "it is of another sentence now");
}

#[test]
fn a_question_is_answered_though_other_words_come_meanwhile() {
    let words = || Action::FetchedWords(Ok("stool\tchair\n".to_owned()));
    let question = || talk::Action::AskExample("where is the block?".to_owned());
    let answer = || Event::Answer(Box::new(understood("go to the block", None)));
    for are_words_first in [true, false] {
        let mut page = Page::opened();
        if are_words_first {
            page.act(words());
            page.act(question());
            page.answer(Event::Words);
            assert!(matches!(page.asked(), Request::Read { .. }), "{:?}", page.posted);
            page.answer(answer());
        } else {
            page.act(question());
            page.act(words());
            page.answer(answer());
            page.answer(Event::Words);
        }
        assert!(page.state.talk.command.reply.is_some(), "words first: {are_words_first}");
    }
}

#[test]
fn a_lesson_in_other_words_is_told_from_a_command() {
    let lesson = in_other_words("“tidy up” means: put the block in the blue room").unwrap();
    let words = "put the block in the blue room".to_owned();
    assert_eq!((&*lesson.command, lesson.means), ("tidy up", Some(Meaning::Words(words))));
    assert_eq!(in_other_words("go by all means to the blue room").map(|l| l.command), None);
}

#[test]
fn what_lies_beyond_is_known_by_its_words() {
    for (word, kind) in [
        ("3", Beyond::Number),
        ("seven", Beyond::Number),
        ("between", Beyond::Between),
        ("door", Beyond::Door),
        ("if", Beyond::Condition),
        ("north", Beyond::Direction),
        ("slowly", Beyond::Manner),
        ("open", Beyond::Deed),
    ] {
        assert_eq!(beyond(word), Some(kind), "{word}");
    }
    assert_eq!(beyond("room"), None);
}

#[test]
fn the_guides_say_the_same_and_their_examples_are_of_the_room() {
    let said = |text: &str| {
        let filled = filled(text, &world());
        let parts: Vec<String> = filled
            .split("#say=")
            .skip(1)
            .filter_map(|part| part.split('"').next().map(str::to_owned))
            .collect();
        parts
    };
    let [english, german] = GUIDES.map(said);
    assert_eq!(english, german);
    assert!(english.contains(&"go to the room with the yellow block".to_owned()), "{english:?}");
    assert!(english.iter().all(|words| !words.contains('{')), "{english:?}");
    let bare = filled(GUIDES[0], &groundling::ui::page::world::empty());
    assert!(!bare.contains("yellow") && bare.contains("enter the biggest room"));
}
