//! Lessons of runs, taught to the shipped model: what is not meant tells a way from an end, one that drives too far is
//! understood, and where no way is said the end counts.

use super::{only, pump};
use groundling::domain::text;
use groundling::worker::protocol::{
    Event, Lesson, Meaning, Request, RunText, TeachReport, WorldRules,
};
use groundling::worker::{Engine, Learner, Talker};

const MODEL: &str = include_str!("../../../assets/model/cleanup.model");
/// Four rooms in a ring: red and blue in the north, green, where the robot is, and yellow in the south.
const RING: &str = "#############\n#rrrrr#bbbbb#\n#rrrrr+bbbbb#\n#rrrrr#bbbbb#\n###a#####c###\n#ggggg#yyyyy#\n#g<gggdyyyyy#\n#ggggg#yyyyy#\n#############\n\nr room red\nb room blue\ng room green\ny room yellow\n+ door unlocked\na door unlocked\nc door unlocked\nd door unlocked\n";
const BY_YELLOW: &str = "eeeeeeennn";
const BY_RED: &str = "ennnneeee";

fn driven(command: &str, actions: &str, contrast: &[&str]) -> Lesson {
    let start = text::read_legal(RING).unwrap();
    let contrast = contrast.iter().map(|&way| way.to_owned()).collect();
    let runs = vec![RunText { start, actions: actions.to_owned(), contrast }];
    Lesson { command: command.to_owned(), pairs: Vec::new(), runs, means: None }
}

fn teach(examples: &[Lesson]) -> TeachReport {
    let request = Request::Teach { model: MODEL.to_owned(), examples: examples.to_vec() };
    match only(pump(&mut Engine::<Learner>::new(), 1, request)) {
        Event::Taught(report) => *report,
        other => panic!("{other:?}"),
    }
}

/// The rooms that the robot goes through, by their colours, for the best reading of a command.
fn rooms(model: &str, command: &str) -> Vec<String> {
    let mut engine = Engine::<Talker>::new();
    pump(&mut engine, 1, Request::OpenModel { text: model.to_owned() });
    let state = text::read_legal(RING).unwrap();
    let ask = Request::Read { command: command.to_owned(), state: state.clone() };
    let Some(Event::Answer(answer)) = pump(&mut engine, 2, ask).pop() else { panic!("{command}") };
    let form = answer.readings[0].form.clone();
    let plan = Request::Plan { form, run: vec![state], rules: WorldRules::default() };
    let Some(Event::Planned(plan)) = pump(&mut engine, 3, plan).pop() else { panic!("{command}") };
    let states = plan.states;
    let rooms = groundling::domain::straight::passed(&states, None).into_iter();
    rooms.map(|room| states[0].rooms[room].color.name().to_owned()).collect()
}

#[test]
fn what_is_not_meant_teaches_a_word_that_forbids() {
    let lesson = driven("go to the blue room blarging the red room", BY_YELLOW, &[BY_RED]);
    let report = teach(&[lesson]);
    assert_eq!((report.understood, report.by_end), (vec![true], false));
    assert!(report.check.unwrap().ends);
    let model = &report.model.model;
    assert_eq!(
        rooms(model, "go to the blue room blarging the red room"),
        ["green", "yellow", "blue"]
    );
    let other = "move to the blue room blarging the yellow room";
    assert_eq!(rooms(model, other), ["green", "red", "blue"], "in a sentence never heard");
}

#[test]
fn what_is_not_meant_teaches_a_word_that_leads_through() {
    let command = "go to the blue room threading the yellow room";
    let report = teach(&[driven(command, BY_YELLOW, &[BY_RED])]);
    assert_eq!(report.understood, [true]);
    let other = "go to the red room threading the blue room";
    assert_eq!(rooms(&report.model.model, other), ["green", "red", "blue", "red"]);
}

#[test]
fn who_drives_too_far_is_understood() {
    let command = "go to the blue room blarging the red room";
    let far = format!("{BY_YELLOW}nnw");
    let report = teach(&[driven(command, &far, &[BY_RED])]);
    assert_eq!((report.understood, report.by_end), (vec![true], false));
    assert_eq!(rooms(&report.model.model, command), ["green", "yellow", "blue"]);
}

#[test]
fn where_no_way_is_said_the_end_counts() {
    let report = teach(&[driven("flump to the blue room", &format!("{BY_YELLOW}nn"), &[])]);
    assert_eq!(report.understood, [true]);
    assert_eq!(rooms(&report.model.model, "flump to the red room"), ["green", "red"]);
}

#[test]
fn what_is_said_of_both_ways_is_not_learned() {
    let report = teach(&[driven("flump to the blue room", BY_YELLOW, &[BY_RED])]);
    assert_eq!((report.understood, report.by_end), (vec![false], false));
}

#[test]
fn a_phrase_of_two_steps_is_taught_by_other_words() {
    let means = Meaning::Words("go to the red room and then to the blue room".to_owned());
    let command = "do the round".to_owned();
    let lesson = Lesson { command, pairs: Vec::new(), runs: Vec::new(), means: Some(means) };
    let report = teach(&[lesson]);
    assert_eq!((report.understood, report.refusal), (vec![true], None));
    assert_eq!(rooms(&report.model.model, "do the round"), ["green", "red", "blue"]);
}
