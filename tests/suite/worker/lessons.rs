//! Lessons of the shipped model: they end where things were put, or the readings that would are offered; a phrase is
//! taught by other words; no closed word gets a new meaning; and what was learned is told in plain words.

use super::{only, pump};
use groundling::ccg::any_closed;
use groundling::domain::text;
use groundling::worker::protocol::{
    Answer, Event, Lesson, Meaning, PairText, Refusal, Request, TeachReport, What, WorldRules,
};
use groundling::worker::{Engine, Learner, Talker};

const MODEL: &str = include_str!("../../../assets/model/cleanup.model");
const WORLD: &str = include_str!("../../../assets/worlds/three-rooms.txt");
const BOTH: &str = "take the block to the green room and go to the blue room";

/// A lesson that takes the robot and the block to these cells.
fn shown(command: &str, robot: (i32, i32), block: (i32, i32)) -> Lesson {
    let pre = text::read_legal(WORLD).unwrap();
    let mut post = pre.clone();
    (post.agent.x, post.agent.y) = robot;
    (post.objects[0].x, post.objects[0].y) = block;
    Lesson {
        command: command.to_owned(),
        pairs: vec![PairText { pre, post }],
        runs: Vec::new(),
        means: None,
    }
}

fn said(command: &str, words: &str) -> Lesson {
    let means = Some(Meaning::Words(words.to_owned()));
    Lesson { command: command.to_owned(), pairs: Vec::new(), runs: Vec::new(), means }
}

fn teach(examples: &[Lesson]) -> TeachReport {
    let request = Request::Teach { model: MODEL.to_owned(), examples: examples.to_vec() };
    match only(pump(&mut Engine::<Learner>::new(), 1, request)) {
        Event::Taught(report) => *report,
        other => panic!("{other:?}"),
    }
}

fn ask(model: &str, command: &str) -> Answer {
    let mut engine = Engine::<Talker>::new();
    pump(&mut engine, 1, Request::OpenModel { text: model.to_owned() });
    let state = text::read_legal(WORLD).unwrap();
    let ask = Request::Ask { command: command.to_owned(), state, rules: WorldRules::default() };
    match pump(&mut engine, 2, ask).pop() {
        Some(Event::Answer(answer)) => *answer,
        other => panic!("{command}: {other:?}"),
    }
}

/// What a command means at first, as a form.
fn best(model: &str, command: &str) -> String {
    ask(model, command).readings[0].form.clone()
}

/// Teaches a lesson, and if it does not hold the first of the readings that are offered for it.
fn held(lesson: Lesson) -> TeachReport {
    let report = teach(std::slice::from_ref(&lesson));
    let check = report.check.clone().unwrap();
    if check.ends {
        return report;
    }
    let form = check.fits[0].form.clone();
    teach(&[Lesson { means: Some(Meaning::Form(form)), ..lesson }])
}

#[test]
fn a_lesson_of_two_things_does_both() {
    let lesson = shown(BOTH, (2, 6), (8, 2));
    let report = held(lesson);
    assert_eq!(report.understood, [true]);
    let form = best(&report.model.model, BOTH);
    assert!(form.contains("green") && form.contains("blue"), "{form}");
}

#[test]
fn a_reading_that_fits_is_offered_where_another_comes_first() {
    let report = held(shown("leave the green room", (6, 6), (8, 6)));
    assert_eq!(report.understood, [true], "{:?}", report.check);
    let form = best(&report.model.model, "leave the green room");
    assert!(form.contains("not:<t,t>") && form.contains("green"), "{form}");
}

#[test]
fn a_phrase_is_taught_by_other_words() {
    let words = "put the block in the blue room";
    let report = teach(&[said("tidy up", words)]);
    assert_eq!((report.understood, report.refusal), (vec![true], None));
    let model = &report.model.model;
    assert_eq!(best(model, "tidy up"), best(MODEL, words));
    assert!(ask(model, "tidy up").words.iter().all(|word| word.heard.is_none()), "as it is spelt");
    assert_eq!(best(model, "go to the blue room"), best(MODEL, "go to the blue room"));
}

#[test]
fn by_other_words_nothing_known_gets_another_meaning() {
    let refusal = |command: &str, words: &str| {
        let report = teach(&[said(command, words)]);
        assert_eq!(report.understood, [false], "{command}");
        report.refusal
    };
    let blue = "go to the blue room";
    assert_eq!(refusal("and so on", blue), Some(Refusal::Closed("and".to_owned())));
    assert_eq!(refusal("unless zip", blue), Some(Refusal::Closed("unless".to_owned())));
    assert_eq!(refusal("go to the red room", blue), Some(Refusal::Known));
    assert_eq!(refusal("the", blue), Some(Refusal::Known));
    assert_eq!(refusal("not bruno", "the blue room"), Some(Refusal::Closed("not".to_owned())));
    assert_eq!(refusal("zip", "frobnicate the gadget"), Some(Refusal::Lost));
}

#[test]
fn a_phrase_of_two_things_is_taught_by_other_words() {
    let words = "put the block and the chair in the blue room";
    let report = teach(&[said("tidy up", words)]);
    assert_eq!((report.understood, report.refusal), (vec![true], None));
    let form = best(&report.model.model, "tidy up");
    assert!(form.contains("block") && form.contains("chair") && form.contains("blue"), "{form}");
}

#[test]
fn what_is_shown_gives_no_closed_word_a_meaning() {
    for command in ["unless flump to the blue room", "flump and the blue room", "not so blue"] {
        let report = teach(&[shown(command, (2, 6), (8, 6))]);
        for entry in &report.added {
            let words: Vec<&str> = entry.words.split(' ').collect();
            assert!(!any_closed(&words), "{command}: {}", entry.words);
        }
    }
}

#[test]
fn what_was_learned_is_told_in_plain_words() {
    let report = teach(&[shown("flump to the blue room", (2, 6), (8, 6))]);
    assert_eq!(report.added.len(), report.told.len());
    assert!(report.told.iter().any(|told| told.words.contains("flump")));
    let plain = report.told.iter().filter(|told| told.what != What::Other);
    assert!(plain.count() > 0, "{:?}", report.told);
}

#[test]
fn a_name_is_taught_by_a_description() {
    for (name, thing) in [
        ("dungeon", "the blue room"),
        ("the dungeon", "blue room"),
        ("cosy corner", "the room with the block"),
    ] {
        let report = teach(&[said(name, thing)]);
        assert_eq!((report.understood, report.refusal), (vec![true], None), "{name}");
        let (model, called) = (&report.model.model, name.trim_start_matches("the "));
        let meant = thing.trim_start_matches("the ");
        for frame in ["go to the", "leave the", "put the block in the"] {
            let [named, described] =
                [called, meant].map(|noun| best(model, &format!("{frame} {noun}")));
            assert_eq!(named, described, "{frame} {called}");
        }
        assert!(
            matches!(report.told[..], [ref told] if told.words == called && matches!(told.what, What::Thing(_)))
        );
    }
}

#[test]
fn a_thing_has_a_name_too() {
    let report = teach(&[
        said("bruno", "the yellow block"),
        said("bring bruno home", "take bruno to the red room"),
    ]);
    assert_eq!(report.understood, [true, true]);
    let model = &report.model.model;
    assert_eq!(
        best(model, "take bruno to the blue room"),
        best(MODEL, "take the yellow block to the blue room")
    );
    assert_eq!(
        best(model, "bring bruno home"),
        best(MODEL, "take the yellow block to the red room")
    );
}

#[test]
fn a_taught_phrase_holds_among_words_that_mean_nothing() {
    let words = "put the block in the blue room";
    let report = teach(&[said("tidy up", words)]);
    let model = &report.model.model;
    for command in ["please tidy up", "tidy up please", "Please, tidy up now!"] {
        let answer = ask(model, command);
        assert_eq!(
            (answer.readings[0].form.clone(), answer.reason),
            (best(MODEL, words), None),
            "{command}"
        );
    }
    assert_ne!(ask(model, "do not tidy up").reason, None, "a closed word is never silent");
}
