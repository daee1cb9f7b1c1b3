//! Messages between page and engines: each kind comes back as it went in, and what is cut short or goes to the wrong
//! program is refused.

use super::{corpus, refused, settings, six};
use groundling::domain::{Blueprint, Color, Direction, Shape, Size};
use groundling::learn::PlannerCost;
use groundling::worker::protocol::{
    Answer, Article, CellValue, Check, Claim, Closed, Confused, Demonstrated, Description,
    EntryText, Envelope, Event, ExperimentProgress, Explanation, Fate, Figures, Instead, Judgement,
    Lesson, Meaning, Node, Noun, PairText, Part, Phrase, Piece, PlanProgress, PlanText, Program,
    Progress, Reading, Referent, Refers, Refusal, Request, RunPart, RunReport, RunText, Runs,
    Settings, Shade, Shown, Study, Taken, TaskFigures, TeachReport, Told, TrainReport, VERSION,
    ValueMap, Wanted, What, Why, WireError, Word, WorldRules, decode, decode_asked, decode_said,
    encode,
};
use groundling::worker::{Engine, Learner, Talker};
use serde::{Serialize, de::DeserializeOwned};
use std::collections::HashSet;
use std::fmt::Debug;
use std::mem::{Discriminant, discriminant};

/// Sends each message over the wire; there must be so many kinds of them.
#[track_caller]
fn come_back<T: Serialize + DeserializeOwned + PartialEq + Debug + Clone>(
    messages: &[T],
    kinds: usize,
) {
    let seen: HashSet<Discriminant<T>> = messages.iter().map(discriminant).collect();
    assert_eq!(seen.len(), kinds, "a message of every kind");
    for (id, body) in (1..).zip(messages.iter().cloned()) {
        let envelope = Envelope { groundling: VERSION, id, body };
        let bytes = encode(&envelope).unwrap();
        assert_eq!(decode::<T>(&bytes).as_ref(), Ok(&envelope));
        // Whatever is cut off is missed, and never a panic.
        for length in 0..bytes.len() {
            assert_eq!(decode::<T>(&bytes[..length]), Err(WireError::Malformed), "{envelope:?}");
        }
    }
}

#[test]
fn page_and_talker_read_their_part_of_the_protocol_and_no_more() {
    for (id, body) in (1..).zip(requests()) {
        let is_asked = !matches!(
            body.program(),
            Some(Program::Learner) | None if !matches!(body, Request::Cancel | Request::Ping)
        );
        let envelope = Envelope { groundling: VERSION, id, body };
        let read = decode_asked(&encode(&envelope).unwrap());
        let wanted = if is_asked { Ok(envelope) } else { Err(WireError::Malformed) };
        assert_eq!(read, wanted);
    }
    let said = events().into_iter().zip(1..).filter(|(body, id)| {
        let envelope = Envelope { groundling: VERSION, id: *id, body: body.clone() };
        let read = decode_said(&encode(&envelope).unwrap());
        assert!(read == Err(WireError::Malformed) || read.as_ref() == Ok(&envelope));
        read.is_ok()
    });
    assert_eq!(said.map(|(body, _)| discriminant(&body)).collect::<HashSet<_>>().len(), 18);
}

#[test]
fn another_version_is_refused_whatever_follows() {
    for version in [0, VERSION - 1, VERSION + 1, u32::MAX] {
        let envelope = Envelope { groundling: version, id: 1, body: Request::Ping };
        let bytes = encode(&envelope).unwrap();
        assert_eq!(decode::<Request>(&bytes), Err(WireError::Version));
        assert_eq!(decode::<Event>(&bytes[..bytes.len() - 1]), Err(WireError::Version));
    }
    assert_eq!(decode::<Request>(&[]), Err(WireError::Malformed));
    assert_eq!(decode::<Request>(&[0xff; 64]), Err(WireError::Malformed));
}

#[test]
fn each_program_refuses_what_is_the_other_s() {
    let mut seen = [0, 0];
    for request in requests() {
        let Some(program) = request.program() else { continue };
        let said = match program {
            Program::Talker => refused(&mut Engine::<Learner>::new(), request),
            Program::Learner => refused(&mut Engine::<Talker>::new(), request),
        };
        let others = ["learner", "talker"];
        let (own, other) = match program {
            Program::Talker => (others[1], others[0]),
            Program::Learner => (others[0], others[1]),
        };
        assert_eq!(said, format!("This is for the {own}, and was sent to the {other}."));
        seen[program as usize] += 1;
    }
    assert!(seen.iter().all(|&n| n >= 5), "{seen:?}");
}

/// A request of every kind, some more than once.
fn requests() -> Vec<Request> {
    let state = six()[0].pairs[0].pre.clone();
    let pair = PairText { pre: state.clone(), post: state.clone() };
    let some = Box::new(Settings { demonstrations: Some(2), ..*settings(3) });
    let command = "go".to_owned();
    let rules =
        WorldRules { pull: true, robot: true, slip: 0.1, lock: 0.2, ..WorldRules::default() };
    vec![
        corpus("a \"b\".csv", "x,\"y\"\r\n\u{fffd}🤖"),
        Request::ShowRow { row: 3 },
        Request::Learn { settings: settings(15), resume: None },
        Request::Learn { settings: some, resume: Some("so far".to_owned()) },
        Request::Teach {
            model: "groundling model 1\nend\n".to_owned(),
            examples: vec![Lesson {
                command: "go".to_owned(),
                pairs: vec![pair],
                runs: vec![RunText {
                    start: state.clone(),
                    actions: "nn".to_owned(),
                    contrast: vec!["ee".to_owned()],
                }],
                means: Some(Meaning::Words("walk".to_owned())),
            }],
        },
        Request::Explain { command: "go".to_owned() },
        Request::Read { command: "go".to_owned(), state: state.clone() },
        Request::Example { wanted: Wanted::Said("go".to_owned()), state: state.clone(), rules },
        Request::Draw { blueprint: Blueprint::default(), seed: 7 },
        Request::ReadWorld { text: "###\n".to_owned() },
        Request::WriteWorld { state: state.clone() },
        Request::OpenModel { text: "groundling model 1\nend\n".to_owned() },
        Request::Words { text: "stool\tchair\n".to_owned() },
        Request::Ask { command: "go".to_owned(), state: state.clone(), rules },
        Request::Plan { form: "p:t".to_owned(), run: vec![state.clone()], rules },
        Request::Values { state: state.clone(), done: 0 },
        Request::GoOn { form: "p:t".to_owned(), run: vec![state.clone()], rules },
        Request::RollOut { runs: 100, seed: 7 },
        Request::Demonstrate { command, state, settings: settings(2) },
        Request::Cancel,
        Request::Ping,
    ]
}

#[test]
fn requests_come_back_from_the_wire() {
    come_back(&requests(), 20);
}

#[test]
fn events_come_back_from_the_wire() {
    come_back(&events(), 24);
}

fn events() -> Vec<Event> {
    let pair = six()[0].pairs[0].clone();
    let states = vec![pair.pre.clone(), pair.post.clone()];
    let world = pair.pre.clone();
    let piece = Piece { text: "p".to_owned(), words: Some((0, 1)) };
    let described = |claims| Description {
        article: Article::Biggest,
        properties: vec!["red".to_owned()],
        claims,
    };
    let robot_near =
        |noun| Claim::Related { relation: "near".to_owned(), nouns: Box::new([Noun::Robot, noun]) };
    let claims = vec![
        Claim::Not(Box::new(robot_near(Noun::It))),
        Claim::Any(vec![Claim::Is("red".to_owned(), Box::new(Noun::Formula("x".to_owned())))]),
        Claim::Exists(Box::new(described(vec![]))),
        Claim::Formula("p".to_owned()),
    ];
    let noun = Noun::Described(Box::new(described(claims)));
    let referent = Referent {
        class: "object".to_owned(),
        color: Some(Color::Red),
        shape: Some(Shape::Chair),
        size: Some(Size::Large),
        cells: vec![(1, -2)],
    };
    let phrase = Phrase {
        noun: noun.clone(),
        words: vec![0, 2],
        refers: Refers::Tie,
        referents: vec![referent],
        taken: Shade::named("violet").map(|shade| (shade, Color::Blue)),
    };
    let node = Node {
        words: (0, 1),
        rule: ">".to_owned(),
        category: "N".to_owned(),
        meaning: vec![piece.clone()],
        parts: vec![0],
    };
    let reading = Reading {
        form: "p:t".to_owned(),
        formula: vec![Piece { text: "¬".to_owned(), words: None }, piece],
        claim: Claim::All(vec![robot_near(noun)]),
        score: -1.5,
        nodes: vec![node],
        derivation: "go\n--".to_owned(),
        phrases: vec![phrase],
        cells: vec![(0, 0)],
        forbidden: vec![(1, 1)],
    };
    let work = PlanProgress {
        solver: "lrtdp".to_owned(),
        why: Why::Large(10),
        states: 7,
        steps: 70,
        residual: 0.5,
        bounds: [0.25, 0.75],
        least: 3,
    };
    let plan = PlanText {
        actions: vec!["north".to_owned()],
        states,
        reason: Some("budget".to_owned()),
        reached: true,
        sure: false,
        replans: 2,
        work: Some(work.clone()),
        done: vec![0, 1],
        instead: Some(Box::new(Instead {
            demands: vec![Claim::Then(Vec::new())],
            reading: reading.clone(),
        })),
    };
    let cell = CellValue {
        x: 1,
        y: -2,
        facing: Direction::West,
        value: 0.5,
        action: Some("west".to_owned()),
        goal: false,
    };
    let runs = Runs {
        runs: 9,
        successes: 8,
        interval: [0.5, 0.9],
        mean_steps: Some(4.5),
        mean_return: [0.75, 0.125],
        replans: 1,
    };
    let answer = Answer {
        command: "Go".to_owned(),
        words: vec![Word {
            text: "gp".to_owned(),
            heard: Some("go".to_owned()),
            fate: Fate::Unknown,
            closed: Some(Closed::Turns),
            near: vec!["go".to_owned()],
        }],
        readings: vec![reading],
        taken: vec![Taken { words: (0, 1), name: "go".to_owned() }],
        reason: Some("tie".to_owned()),
        asks: vec![0],
        probability: Some(0.5),
        plan: Some(plan.clone()),
    };
    let without =
        Answer { readings: vec![], reason: None, probability: None, plan: None, ..answer.clone() };
    let progress = Progress {
        epoch: 1,
        epochs: 15,
        example: 2,
        examples: 6,
        valid: 1,
        updates: 0,
        entries: 7,
    };
    let name = "horizon 10".to_owned();
    let part = RunPart::Learning(progress.clone());
    let learning = ExperimentProgress { run: 1, runs: 4, name: name.clone(), part };
    let part = RunPart::Judging { judged: 3, commands: 20 };
    let judging = ExperimentProgress { part, ..learning.clone() };
    let third = [1.0 / 3.0, 0.0, 1.0];
    let figures = Figures { answered: 3, correct: 1, precision: third, recall: third, f1: third };
    let (task, none) = (Some("room".to_owned()), None);
    let judgement = Judgement {
        total: 3,
        plain: figures.clone(),
        skipping: figures,
        resolved_f1: 0.1,
        tasks: vec![TaskFigures { task: task.clone(), total: 3, answered: 3, correct: 1 }],
        confusion: vec![Confused { task, does: none, count: 2 }],
    };
    let planner = PlannerCost { calls: 9, saved: 8, expanded: 70, given_up: 1 };
    let row = RunReport {
        name,
        examples: 50,
        valid: 49,
        entries: 120,
        paper_f1: Some(0.667),
        planner: Some(planner),
        judgement,
    };
    let found = Demonstrated { run: row, answer: without.clone() };
    let model = "groundling model 1\nend\n".to_owned();
    let trained = TrainReport { model, examples: 6, valid: 6, entries: 9 };
    let entry = EntryText {
        words: "go".to_owned(),
        syntax: "N".to_owned(),
        meaning: "p:t".to_owned(),
        learned: true,
    };
    let part = Part { feature: "skip".to_owned(), count: 1, weight: 0.1, adds: 0.1 };
    vec![
        Event::Ready,
        Event::Pong,
        Event::Crashed { message: "at line 1".to_owned() },
        Event::Reading { done: 1 << 40, of: u64::MAX },
        Event::Row {
            row: 0,
            pairs: vec![Shown {
                run: Some(RunText {
                    start: pair.pre.clone(),
                    actions: "n".to_owned(),
                    contrast: Vec::new(),
                }),
                pair: PairText { pre: pair.pre, post: pair.post },
            }],
        },
        Event::Progress(progress.clone()),
        Event::Experimenting(learning),
        Event::Experimenting(judging),
        Event::Demonstrated(Box::new(found)),
        Event::Trained(trained.clone()),
        Event::Opened(trained.clone()),
        Event::Taught(Box::new(TeachReport {
            model: trained,
            added: vec![entry.clone()],
            told: vec![Told { words: "go".to_owned(), what: What::Like("walk".to_owned()) }],
            understood: vec![true],
            check: Some(Check { ends: false, fits: Vec::new() }),
            refusal: Some(Refusal::Closed("not".to_owned())),
            by_end: true,
        })),
        Event::Words,
        Event::Explained(vec![Study {
            explanation: Explanation { score: 0.1, parts: vec![part], entries: vec![entry] },
            reductions: vec![vec!["p".to_owned()]],
        }]),
        Event::Example { wanted: Wanted::Go, command: Some("go".to_owned()) },
        Event::World(world.clone()),
        Event::WorldText { text: "###".to_owned() },
        Event::Answer(Box::new(answer)),
        Event::Answer(Box::new(without)),
        Event::Planning(work),
        Event::Planned(Box::new(plan)),
        Event::Values(ValueMap { cells: vec![cell] }),
        Event::RollingOut(runs),
        Event::RolledOut(runs),
        Event::Refused { message: "no".to_owned() },
        Event::Cancelled,
    ]
}
