//! When the engine asks before it plans, about which readings, and what it says of words that it takes for others.

use super::{only, pump, refused, taught};
use crate::ccg::{AMBIGUOUS, model};
use groundling::ccg::{Doubt, Model};
use groundling::domain::text;
use groundling::learn::{CLEANUP_LEXICON, seed_model};
use groundling::worker::protocol::{
    Answer, Closed, Event, Fate, Reading, Refers, Request, WorldRules,
};
use groundling::worker::{Engine, Talker};

const WORLD: &str = include_str!("../../../assets/worlds/three-rooms.txt");
const WORDS: &str = include_str!("../../../assets/lexicon/words.txt");

fn open(text: String) -> Engine<Talker> {
    let mut engine = Engine::new();
    let event = only(pump(&mut engine, 1, Request::OpenModel { text }));
    assert!(matches!(event, Event::Opened(_)), "{event:?}");
    engine
}

/// An engine that knows the seed lexicon and the general resource.
fn speaker() -> Engine<Talker> {
    let mut engine = open(seed_model(CLEANUP_LEXICON).unwrap().print());
    let words = Request::Words { text: WORDS.to_owned() };
    assert_eq!(only(pump(&mut engine, 2, words)), Event::Words);
    engine
}

fn answer(engine: &mut Engine<Talker>, command: &str) -> Answer {
    let state = text::read_legal(WORLD).unwrap();
    let ask = Request::Ask { command: command.to_owned(), state, rules: WorldRules::default() };
    match pump(engine, 3, ask).pop() {
        Some(Event::Answer(answer)) => *answer,
        other => panic!("{command}: {other:?}"),
    }
}

fn refers(reading: &Reading) -> bool {
    reading.phrases.iter().all(|phrase| phrase.refers == Refers::One)
}

#[test]
fn what_is_equally_likely_is_asked_about_and_not_planned() {
    let mut engine = open(model(AMBIGUOUS).print());
    let tie = answer(&mut engine, "go to the red room");
    assert_eq!((tie.reason.as_deref(), tie.plan), (Some("tie"), None));
    assert!((2..=3).contains(&tie.asks.len()) && tie.asks.contains(&0), "{:?}", tie.asks);
    let scores: Vec<f64> = tie.asks.iter().map(|&at| tie.readings[at].score).collect();
    assert!(scores.windows(2).all(|two| two[0] == two[1]));
}

#[test]
fn what_can_be_meant_in_one_way_is_done_unless_it_is_hardly_likely() {
    let mut model = Model::read(&taught(15).1).unwrap();
    let command = "go to the blue room";
    assert_eq!(answer(&mut open(model.print()), command).probability, None);
    for (bias, asks) in [("-1", true), ("0", false), ("1", false)] {
        let mut doubt = Doubt { threshold: 0.9, ..Doubt::default() };
        doubt.read_line("bias", bias).unwrap();
        model.doubt = Some(doubt);
        let answer = answer(&mut open(model.print()), command);
        assert!(answer.probability.unwrap() < 0.9);
        assert_eq!((answer.asks.is_empty(), answer.plan.is_none()), (!asks, asks));
        assert!(!asks || answer.asks.contains(&0));
    }
}

#[test]
fn a_reading_of_what_is_not_there_is_asked_about_beside_one_of_what_is() {
    let mut engine = speaker();
    let sure = answer(&mut engine, "go to the blue room");
    assert!(sure.asks.is_empty() && sure.plan.is_some() && refers(&sure.readings[0]));
    for command in ["go to the yellow room", "do not go to the yellow room"] {
        let lost = answer(&mut engine, command);
        match &lost.asks[..] {
            [] => {
                assert_eq!(lost.plan.unwrap().reason.as_deref(), Some("no_referent"), "{command}")
            }
            [other, 0] => assert!(refers(&lost.readings[*other]), "{command}"),
            asks => panic!("{command}: {asks:?}"),
        }
    }
}

#[test]
fn half_of_a_command_is_told_and_not_planned() {
    let mut engine = speaker();
    let half = answer(&mut engine, "move the block to the blue room if you were in the red room");
    assert_eq!((half.reason.as_deref(), half.plan), (Some("left_out"), None));
    assert!(half.asks.is_empty() && !half.readings.is_empty());
    let fates: Vec<Fate> = half.words.iter().map(|word| word.fate).collect();
    let condition = half.words.iter().position(|word| word.text == "if").unwrap();
    assert_eq!(half.words[condition].closed, Some(Closed::Orders));
    assert_eq!(fates[condition], Fate::Skipped);
    assert!(!fates.contains(&Fate::Empty), "what stands beside it was left out with it: {fates:?}");
}

#[test]
fn what_words_were_taken_for_is_said() {
    let mut engine = speaker();
    let stool = answer(&mut engine, "go to the armchair");
    let [taken] = &stool.taken[..] else { panic!("{:?}", stool.taken) };
    assert_eq!((taken.words, &*taken.name), ((3, 4), "chair"));
    assert_eq!(stool.words[3].heard, None, "it is no misspelling");
    let violet = answer(&mut engine, "go to the violet room");
    assert!(violet.taken.is_empty(), "{:?}", violet.taken);
    let shades = violet.readings[0].phrases.iter().filter_map(|phrase| phrase.taken);
    let shades: Vec<_> = shades.map(|(shade, color)| (shade.name(), color.name())).collect();
    assert_eq!(shades, [("violet", "blue")]);
    let misspelt = answer(&mut engine, "go to the bleu room");
    assert!(misspelt.taken.is_empty() && misspelt.words[3].heard.as_deref() == Some("blue"));
}

#[test]
fn the_resource_holds_for_a_model_that_is_opened_later_and_a_bad_one_changes_nothing() {
    let mut engine = Engine::new();
    pump(&mut engine, 1, Request::Words { text: WORDS.to_owned() });
    let said = refused(&mut engine, Request::Words { text: "two words".to_owned() });
    assert!(said.contains("line 1"), "{said}");
    let text = seed_model(CLEANUP_LEXICON).unwrap().print();
    pump(&mut engine, 2, Request::OpenModel { text });
    assert_eq!(answer(&mut engine, "go to the armchair").reason, None);
}
