//! What a command is answered, and why it may not be: readings, plan, each reason; cancelled and damaged models.

use super::{SIX, learn, learner, next, only, pump, refused, taught};
use crate::ccg::{AMBIGUOUS, model};
use groundling::domain::{Lock, State};
use groundling::ground::Goal;
use groundling::logic::{Terms, read};
use groundling::worker::protocol::{Answer, Event, Fate, Phrase, Refers, Request, WorldRules};
use groundling::worker::{Engine, Talker};

/// A red room with the robot in it, a blue one, and a door between.
fn world() -> State {
    State::read(
        r#"{"agent":{"x":1,"y":1,"direction":"south"},
        "rooms":[{"name":"r","color":"red","left":0,"bottom":0,"right":4,"top":4},
                 {"name":"b","color":"blue","left":4,"bottom":0,"right":10,"top":4}],
        "doors":[{"name":"d","left":4,"bottom":2,"right":4,"top":2,"lock":"unlocked"}],
        "objects":[{"name":"c","shape":"chair","color":"red","x":7,"y":2}]}"#,
    )
    .unwrap()
}

fn ask(command: &str, state: &State) -> Request {
    Request::Ask { command: command.to_owned(), state: state.clone(), rules: WorldRules::default() }
}

#[track_caller]
fn answer(engine: &mut Engine<Talker>, command: &str, state: &State) -> Answer {
    match only(pump(engine, 5, ask(command, state))) {
        Event::Answer(answer) => *answer,
        other => panic!("{command}: {other:?}"),
    }
}

fn fates(answer: &Answer) -> Vec<Fate> {
    answer.words.iter().map(|word| word.fate).collect()
}

#[test]
fn without_a_model_nothing_is_answered() {
    let said = refused(&mut Engine::<Talker>::new(), ask("go to the blue room", &world()));
    assert_eq!(said, "There is no model yet: train one, or open a model file.");
}

#[test]
fn a_command_is_answered_with_readings_and_a_plan_that_reaches_the_goal() {
    let (mut engine, _) = taught(15);
    let state = world();
    let answer = answer(&mut engine, "Go to the blue room!", &state);
    assert_eq!(answer.command, "Go to the blue room!");
    let words: Vec<(&str, Fate)> = answer.words.iter().map(|w| (&*w.text, w.fate)).collect();
    assert_eq!(words, ["go", "to", "the", "blue", "room"].map(|word| (word, Fate::Meant)));
    assert_eq!(answer.reason, None);
    let best = &answer.readings[0];
    let formula: String = best.formula.iter().map(|piece| &*piece.text).collect();
    assert_eq!(formula, "in(the agent, the λx. blue(x) ∧ room(x))");
    assert!(best.phrases.iter().all(|phrase| phrase.refers == Refers::One));
    for part in ["go", "blue", "NP/N", "---", "the :="] {
        assert!(best.derivation.contains(part), "no {part} in\n{}", best.derivation);
    }
    assert!(answer.readings.is_sorted_by(|a, b| a.score >= b.score));
    let plan = answer.plan.unwrap();
    assert_eq!(plan.reason, None);
    assert_eq!((plan.actions.len(), plan.states.len()), (5, 6), "{:?}", plan.actions);
    assert_eq!(plan.states[0], state);
    let mut terms = Terms::new();
    let form = read(&mut terms, &best.form).unwrap();
    let goal = Goal::new(&terms, form, &state).unwrap();
    let held: Vec<bool> = plan.states.iter().map(|state| goal.holds(state)).collect();
    assert_eq!(held, [false, false, false, false, false, true], "at its end and not before");
}

#[test]
fn each_reason_for_no_answer_is_given() {
    let (mut engine, _) = taught(15);
    let state = world();
    let long = "go ".repeat(200);
    for (command, reason) in [
        ("", "empty"),
        ("🤖", "empty"),
        (&*long, "too_long"),
        ("xyzzy", "unknown_words"),
        ("the room", "no_parse"),
    ] {
        let answer = answer(&mut engine, command, &state);
        assert_eq!(answer.reason.as_deref(), Some(reason), "{command:.20}");
        assert!(answer.readings.is_empty() && answer.plan.is_none(), "{command:.20}");
    }
    let odd = answer(&mut engine, "xyzzy", &state);
    assert_eq!(fates(&odd), [Fate::Unknown]);
    let idle = answer(&mut engine, "the room", &state);
    assert_eq!(fates(&idle), [Fate::Idle, Fate::Idle]);
    let skipping = answer(&mut engine, "please go to the blue room", &state);
    assert_eq!((&skipping.reason, skipping.plan.is_some()), (&None, true));
    assert_eq!(fates(&skipping)[..2], [Fate::Unknown, Fate::Meant]);
}

#[test]
fn ties_and_spent_budgets_are_told_too() {
    let mut engine = Engine::new();
    let open = |engine: &mut Engine<Talker>, budget: &str| {
        let mut model = model(AMBIGUOUS);
        model.facts.insert("budget".to_owned(), budget.to_owned());
        let event = only(pump(engine, 1, Request::OpenModel { text: model.print() }));
        assert!(matches!(event, Event::Opened(_)), "{event:?}");
    };
    open(&mut engine, "1000");
    let tie = answer(&mut engine, "go to the room", &world());
    assert_eq!(tie.reason.as_deref(), Some("tie"));
    assert!(tie.readings.len() >= 2 && tie.plan.is_none());
    assert_eq!(tie.readings[0].score, tie.readings[1].score);
    let lost = |phrase: &Phrase| phrase.refers == Refers::Several && phrase.referents.len() == 2;
    assert!(tie.readings[0].phrases.iter().any(lost), "two rooms: `the room` does not refer");
    open(&mut engine, "1");
    let spent = answer(&mut engine, "go to the room", &world());
    assert_eq!(spent.reason.as_deref(), Some("budget"));
}

#[test]
fn a_goal_may_be_true_lost_or_out_of_reach() {
    let (mut engine, _) = taught(15);
    let at_home = answer(&mut engine, "go to the red room", &world()).plan.unwrap();
    assert_eq!((at_home.reason, at_home.actions.len(), at_home.states.len()), (None, 0, 1));
    let lost = answer(&mut engine, "go to the green room", &world());
    let refers: Vec<Refers> = lost.readings[0].phrases.iter().map(|p| p.refers).collect();
    assert_eq!(refers, [Refers::One, Refers::None]);
    let plan = lost.plan.unwrap();
    assert_eq!(plan.reason.as_deref(), Some("no_referent"));
    assert_eq!((plan.actions.len(), &plan.states[..]), (0, &[world()][..]));
    let mut shut = world();
    shut.doors[0].lock = Lock::Locked;
    let plan = answer(&mut engine, "go to the blue room", &shut).plan.unwrap();
    assert_eq!(plan.reason.as_deref(), Some("unreachable"));
    let mut walled = world();
    (walled.agent.x, walled.agent.y) = (0, 0);
    let said = refused(&mut engine, ask("go to the blue room", &walled));
    assert!(said.contains("wall"), "{said}");
}

#[test]
fn training_that_is_cancelled_leaves_the_corpus_and_one_that_is_replaced_too() {
    let mut engine = learner();
    engine.start(20, learn(15));
    for _ in 0..7 {
        assert!(matches!(next(&mut engine), (20, Event::Progress(_))));
    }
    engine.start(21, Request::Cancel);
    assert_eq!(next(&mut engine), (20, Event::Cancelled));
    assert!(!engine.busy());
    engine.start(22, learn(15));
    next(&mut engine);
    engine.start(23, Request::ShowRow { row: 5 });
    assert!(
        matches!(next(&mut engine), (23, Event::Row { row: 5, .. })),
        "a look replaces nothing"
    );
    assert!(matches!(next(&mut engine), (22, Event::Progress(_))));
    engine.start(24, learn(15));
    assert_eq!(next(&mut engine), (22, Event::Cancelled));
}

#[test]
fn a_damaged_model_is_refused_by_line_and_leaves_the_old_one_in_place() {
    let (mut engine, text) = taught(15);
    let before = answer(&mut engine, "go to the blue room", &world());
    for (damaged, said) in [
        ("", "This is no model file: line 1: the file breaks off before its end."),
        ("nonsense", "This is no model file: line 1: "),
        (&text[..text.len() / 2], "This is no model file: line "),
        (&text.replace("weight\tskip\t", "weight\tskip\tNaN\t"), "This is no model file: line "),
        (SIX, "This is no model file: line 1: "),
    ] {
        let message = refused(&mut engine, Request::OpenModel { text: damaged.to_owned() });
        assert!(message.starts_with(said), "{message:.200}");
        assert_eq!(answer(&mut engine, "go to the blue room", &world()), before);
    }
    // A model that is opened, but cancelled before it was, is not there.
    engine.start(24, Request::OpenModel { text: model(AMBIGUOUS).print() });
    engine.start(25, Request::Cancel);
    assert_eq!(next(&mut engine), (24, Event::Cancelled));
    assert_eq!(answer(&mut engine, "go to the blue room", &world()), before);
    // The file that was kept brings the same engine back.
    let mut other = Engine::new();
    let event = only(pump(&mut other, 1, Request::OpenModel { text: text.clone() }));
    let Event::Opened(report) = event else { panic!("{event:?}") };
    assert!(report.model == text && report.examples == 6);
    assert_eq!(answer(&mut other, "go to the blue room", &world()), before);
}

#[test]
fn what_is_typed_is_read_without_a_plan_and_leaves_the_policy_alone() {
    let (mut engine, _) = taught(15);
    let state = world();
    let said = answer(&mut engine, "go to the blue room", &state);
    let read = |engine: &mut Engine<Talker>, command: &str| {
        let request = Request::Read { command: command.to_owned(), state: state.clone() };
        match only(pump(engine, 6, request)) {
            Event::Answer(answer) => *answer,
            other => panic!("{other:?}"),
        }
    };
    let typed = read(&mut engine, "go to the blue room");
    assert_eq!(typed, Answer { plan: None, ..said });
    assert_eq!(read(&mut engine, "go to the").plan, None);
    let values = pump(&mut engine, 7, Request::Values { state: state.clone(), done: 0 });
    assert!(matches!(only(values), Event::Values(map) if !map.cells.is_empty()));
}
