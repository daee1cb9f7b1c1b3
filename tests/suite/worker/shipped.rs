//! The model that the page opens with: it is small, reads back, says where it comes from, and understands what a
//! visitor is likely to say (`tests/data/ccg/shipped.txt`).

use super::{only, pump};
use groundling::ccg::Model;
use groundling::domain::State;
use groundling::ui::talk::command::state::EXAMPLES;
use groundling::worker::protocol::{Event, Request, WorldRules};
use groundling::worker::{Engine, Talker};

const MODEL: &str = include_str!("../../../assets/model/cleanup.model");
const WORLD: &str = include_str!("../../../assets/worlds/three-rooms.json");
const CASES: &str = include_str!("../../data/ccg/shipped.txt");

fn engine() -> Engine<Talker> {
    let mut engine = Engine::new();
    let open = Request::OpenModel { text: MODEL.to_owned() };
    let Event::Opened(report) = only(pump(&mut engine, 1, open)) else { panic!("not opened") };
    assert_eq!(report.examples, 2_909);
    assert!(report.valid > 2_500, "{} commands were understood", report.valid);
    engine
}

#[test]
fn it_is_small_and_reads_back_the_same() {
    assert!(MODEL.len() < 500_000, "{} bytes", MODEL.len());
    assert!(Model::read(MODEL).unwrap().print() == MODEL);
}

#[test]
fn it_understands_what_a_visitor_is_likely_to_say() {
    let mut engine = engine();
    let state = State::read(WORLD).unwrap();
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

#[test]
fn the_commands_that_the_page_offers_are_done_without_asking() {
    let mut engine = engine();
    let state = State::read(WORLD).unwrap();
    for command in EXAMPLES {
        let command = command.to_owned();
        let ask = Request::Ask { command, state: state.clone(), rules: WorldRules::default() };
        let Some(Event::Answer(answer)) = pump(&mut engine, 2, ask).pop() else { panic!() };
        assert!(answer.asks.is_empty(), "{}: {:?}", answer.command, answer.probability);
        let plan = answer.plan.unwrap();
        assert!(plan.reached && !plan.actions.is_empty(), "{}", answer.command);
    }
}
