//! A hundred sentences about goals in time (`tests/data/time/hundred.txt`): what the model that comes with the page makes of
//! each, and that the plan for it is as short as a breadth-first search over states and residuals finds.

use super::plans::is_shortest;
use crate::commands::{asked, shipped};
use crate::logic::cases;
use groundling::domain::State;
use groundling::ground::Course;
use groundling::logic::print_human;

const HUNDRED: &str = include_str!("../../data/time/hundred.txt");

/// Four rooms in a ring, the robot in a fifth; of the things there those that a command names, lest the search go on for
/// ever.
fn world(command: &str) -> State {
    let mut state = State::read(include_str!("../../data/time/world.json")).unwrap();
    state.objects.retain(|object| command.contains(object.shape.name()));
    state
}

#[test]
fn a_hundred_sentences_are_understood_and_their_plans_are_shortest() {
    let mut model = shipped();
    let (mut wrong, mut planned) = (Vec::new(), 0);
    cases(HUNDRED, 100, |line, command, expected| {
        let parse = asked(&mut model, command);
        let Some(reading) = parse.answer().filter(|_| parse.skipped.is_empty()) else {
            return wrong.push(format!("line {line}: {command}\n=> no answer: {:?}", parse.reason));
        };
        let found = print_human(&model.grammar.terms, reading.form);
        if found != expected {
            wrong.push(format!("line {line}: {command}\n=> {found}"));
        }
        let initial = world(command);
        let course = Course::new(&model.grammar.terms, reading.form, &initial).unwrap();
        planned += usize::from(is_shortest(&course, &initial, command).unwrap().is_some());
    });
    assert!(wrong.is_empty(), "{} are otherwise:\n{}", wrong.len(), wrong.join("\n"));
    assert!(planned >= 95, "{planned} can be done");
}
