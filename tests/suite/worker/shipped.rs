//! The model that the page opens with: it is small, reads back, says where it comes from, and understands what a
//! visitor is likely to say (`tests/data/ccg/shipped.txt`).

use super::{only, pump};
use groundling::ccg::Model;
use groundling::domain::{State, text};
use groundling::ui::page::world::WORLDS;
use groundling::worker::protocol::{Answer, Event, Request, Wanted, WorldRules, lost};
use groundling::worker::{Engine, Talker};

const MODEL: &str = include_str!("../../../assets/model/cleanup.model");
const WORLD: &str = include_str!("../../../assets/worlds/three-rooms.txt");
const CASES: &str = include_str!("../../data/ccg/shipped.txt");

fn engine() -> Engine<Talker> {
    let mut engine = Engine::new();
    let open = Request::OpenModel { text: MODEL.to_owned() };
    let Event::Opened(report) = only(pump(&mut engine, 1, open)) else { panic!("not opened") };
    assert_eq!(report.examples, 3_573);
    assert!(report.valid > 3_100, "{} commands were understood", report.valid);
    engine
}

#[test]
fn it_is_small_and_reads_back_the_same() {
    assert!(MODEL.len() < 1_300_000, "{} bytes", MODEL.len());
    assert!(Model::read(MODEL).unwrap().print() == MODEL);
}

#[test]
fn it_understands_what_a_visitor_is_likely_to_say() {
    let mut engine = engine();
    let state = text::read_legal(WORLD).unwrap();
    let (mut command, mut found) = ("", String::new());
    for line in CASES.lines() {
        if line.starts_with("=> ") {
            let ask = Request::Ask {
                command: command.to_owned(),
                state: state.clone(),
                rules: WorldRules::default(),
            };
            let Some(Event::Answer(answer)) = pump(&mut engine, 2, ask).pop() else {
                panic!("{command}: no answer");
            };
            assert_eq!(answer.reason, None, "{command}");
            let pieces = answer.readings[0].formula.iter();
            let formula: String = pieces.map(|piece| &*piece.text).collect();
            found.push_str(&format!("=> {formula}\n"));
        } else {
            command = line;
            found.push_str(&format!("{line}\n"));
        }
    }
    assert!(found == CASES, "tests/data/ccg/shipped.txt should read\n{found}");
}

/// What a command comes to in a world.
fn answer(engine: &mut Engine<Talker>, command: &str, state: &State) -> Answer {
    let (command, state) = (command.to_owned(), state.clone());
    let ask = Request::Ask { command, state, rules: WorldRules::default() };
    match pump(engine, 2, ask).pop() {
        Some(Event::Answer(answer)) => *answer,
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_commands_that_the_page_offers_in_its_worlds_are_done_without_asking() {
    let mut engine = engine();
    for choice in WORLDS {
        let (state, rules) = (choice.open().unwrap(), WorldRules::default());
        let said = Wanted::Said(choice.example.to_owned());
        let kinds = [said.clone(), Wanted::Go, Wanted::Bring, Wanted::Describe, Wanted::Beside];
        for wanted in kinds {
            let look = Request::Example { wanted: wanted.clone(), state: state.clone(), rules };
            let found = only(pump(&mut engine, 3, look));
            let Event::Example { command, .. } = found else { panic!("{found:?}") };
            if wanted == said {
                assert_eq!(command.as_deref(), Some(choice.example), "{:?}", choice.name);
            }
            let Some(command) = command else { continue };
            let answer = answer(&mut engine, &command, &state);
            assert!(answer.asks.is_empty(), "{command}: {:?}", answer.probability);
            let plan = answer.plan.unwrap();
            let is_barred = wanted == said && plan.reason.as_deref() == Some("unreachable");
            assert!(plan.reached && !plan.actions.is_empty() || is_barred, "{command}");
        }
    }
}

#[test]
fn one_example_holds_a_word_that_is_not_known() {
    let (mut engine, state) = (engine(), WORLDS[0].open().unwrap());
    let (wanted, rules) = (Wanted::Unknown, WorldRules::default());
    let found =
        only(pump(&mut engine, 3, Request::Example { wanted, state: state.clone(), rules }));
    let Event::Example { command: Some(command), .. } = found else { panic!("{found:?}") };
    let answer = answer(&mut engine, &command, &state);
    assert_eq!((answer.reason.as_deref(), answer.plan), (Some("unknown_words"), None), "{command}");
}

#[test]
fn what_can_be_meant_in_one_way_is_done_without_asking() {
    let (mut engine, state) = (engine(), WORLDS[1].open().unwrap());
    for command in ["go to the chair", "move the chair to the red room"] {
        let answer = answer(&mut engine, command, &state);
        assert!(answer.asks.is_empty(), "{command}: {:?}", answer.asks);
        assert!(answer.plan.unwrap().reached, "{command}");
    }
    // One that nobody can be sure of is asked about.
    let answer = answer(&mut engine, "robot go blue", &state);
    assert!(answer.plan.is_none(), "{answer:?}");
}

#[test]
fn what_lies_beyond_the_language_is_not_done_in_part_without_asking() {
    let (mut engine, state) = (engine(), WORLDS[0].open().unwrap());
    let commands = [
        "put the block between the red room and the blue room",
        "if the block is in the red room go to the blue room",
        "move three steps to the blue room",
    ];
    for command in commands {
        let answer = answer(&mut engine, command, &state);
        assert!(answer.words.iter().any(|word| lost(word).is_some()), "{command}");
        assert_eq!(answer.plan, None, "{command}");
    }
}
