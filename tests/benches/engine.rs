//! What the engine's parts cost, in CPU time on one thread, and how that compares with the reference system
//! (Java, a two-core machine of the same kind). Numbers are reported, never asserted: `make bench`.

#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "a bench prints, and stops when it cannot go on"
)]

#[path = "cpu.rs"]
mod cpu;
#[path = "learning.rs"]
mod learning;
#[path = "sentences.rs"]
mod sentences;

use cpu::{Row, print_table, seconds};
use groundling::ccg::Model;
use groundling::domain::{Color, Direction, Lock, Plan, Rules, State, generate};
use groundling::ground::{Goal, Task};
use groundling::logic::{Terms, print, read};
use groundling::mdp::{Settings, Solver};
use groundling::plan::AStar;
use groundling::render::{Arrow, Options, Scene};
use groundling::worker::job::Role;
use groundling::worker::protocol::{
    CorpusFile, Event, Lexicon, MappedFile, Mapping, Request, SeedLexicon, Settings as Learning,
    WorldRules,
};
use groundling::worker::{Engine, Learner, Talker};
use std::hint::black_box;
use std::sync::Arc;

/// Three rooms on 9 × 9 cells with three objects.
const NINE: &str = include_str!("worlds/nine.json");
/// What the page opens with.
const SHIPPED: &str = include_str!("../../assets/model/cleanup.model");
/// The six sentences of the demonstration, and the paper's settings.
const SIX: &str = include_str!("../../assets/corpus/six.csv");
/// Training as in the paper's Section VII.
fn train() -> Request {
    let lexicon = Lexicon::Here(SeedLexicon::Demonstration);
    let settings = Box::new(Learning { lexicon, ..Learning::default() });
    Request::Learn { settings, resume: None }
}

/// The reference system on the six sentences, in CPU seconds.
const REFERENCE_SIX: f64 = 41.0;
/// The reference library's breadth-first search: three objects, with pull.
const REFERENCE_PLAN: f64 = 4.0;

/// Three objects in three rooms, all to be put elsewhere.
const MOVE_ALL: &str = "(and:<t*,t> \
    (in:<e,<e,t>> (the:<<e,t>,e> (lambda $0:e (chair:<e,t> $0))) (the:<<e,t>,e> (lambda $0:e (and:<t*,t> (red:<e,t> $0) (room:<e,t> $0))))) \
    (in:<e,<e,t>> (the:<<e,t>,e> (lambda $0:e (bag:<e,t> $0))) (the:<<e,t>,e> (lambda $0:e (and:<t*,t> (blue:<e,t> $0) (room:<e,t> $0))))) \
    (in:<e,<e,t>> (the:<<e,t>,e> (lambda $0:e (box:<e,t> $0))) (the:<<e,t>,e> (lambda $0:e (and:<t*,t> (green:<e,t> $0) (room:<e,t> $0))))))";
const THREE_OBJECTS: &str = r#"{"agent":{"x":6,"y":6,"direction":"south"},
"rooms":[{"name":"room0","color":"green","left":0,"bottom":0,"right":8,"top":4},
{"name":"room1","color":"blue","left":0,"bottom":4,"right":4,"top":8},
{"name":"room2","color":"red","left":4,"bottom":4,"right":8,"top":8}],
"doors":[{"name":"door0","left":6,"bottom":4,"right":6,"top":4,"lock":"unlocked"},
{"name":"door1","left":2,"bottom":4,"right":2,"top":4,"lock":"unlocked"}],
"objects":[{"name":"object0","shape":"chair","color":"tan","x":2,"y":2},
{"name":"object1","shape":"bag","color":"teal","x":5,"y":2},
{"name":"object2","shape":"box","color":"brown","x":6,"y":7}]}"#;

fn main() {
    let large = generate(&Plan { side: (32, 32), objects: (20, 20) }, 1);
    let options = watched();
    let mut rows = vec![
        Row::of("generate a world", 2_000, None, |round| {
            black_box(generate(&Plan::default(), round));
        }),
        Row::of("a picture: 32 × 32 cells with values and arrows", 500, None, |_| {
            black_box(Scene::of(&large, &options).floats());
        }),
        Row::of("read and print a goal, new arena", 2_000, None, |_| {
            let mut terms = Terms::new();
            let goal = read(&mut terms, MOVE_ALL).unwrap();
            black_box(print(&terms, goal));
        }),
        Row::of("train: six sentences, 15 epochs", 10, Some(REFERENCE_SIX), |_| {
            black_box(trained());
        }),
    ];
    rows.push(Row::from_seconds("train: one step (never over 16 ms)", steps()));
    let mut engine = Engine::<Talker>::new();
    pump(&mut engine, Request::OpenModel { text: trained() });
    rows.push(Row::of("answer: parse, ground and plan", 200, None, |round| {
        let state = generate(&Plan::default(), round);
        let command = "go to the blue room".to_owned();
        black_box(pump(&mut engine, Request::Ask { command, state, rules: WorldRules::default() }));
    }));
    rows.push(Row::of("open the model that the page opens with", 20, None, |_| {
        black_box(pump(&mut engine, Request::OpenModel { text: SHIPPED.to_owned() }));
    }));
    rows.push(Row::of("answer with it: every reading taken apart", 200, None, |round| {
        let state = generate(&Plan::default(), round);
        let command = "move the chair to the room with the block".to_owned();
        black_box(pump(&mut engine, Request::Ask { command, state, rules: WorldRules::default() }));
    }));
    rows.push(Row::of("plan: three objects with pull", 20, Some(REFERENCE_PLAN), |_| plan()));
    rows.push(Row::of("the engine's job: plan behind doors that lock", 5, None, |_| {
        black_box(pump(&mut engine, behind_doors()));
    }));
    rows.push(Row::from_seconds("one step of it (never over 16 ms)", job_steps(behind_doors())));
    rows.extend(learning::rows());
    rows.extend(sentences::rows(&Model::read(SHIPPED).unwrap()));
    print_table(&rows);
    if let Some(megabytes) = learning::peak_memory() {
        println!("\nmost memory held: {megabytes:.0} MB");
    }
}

/// Everything that a picture can show of 32 × 32 cells.
fn watched() -> Options {
    let cells = || (0..32).flat_map(|x| (0..32).map(move |y| (x, y)));
    Options {
        letters: true,
        values: cells().map(|(x, y)| (x, y, (x + y) as f32 / 64.0)).collect(),
        arrows: cells().map(|(x, y)| (x, y, Arrow::Step(Direction::East))).collect(),
        goal: cells().take(100).collect(),
        highlight: cells().skip(500).take(200).collect(),
        cursor: Some((3, 3)),
        ..Options::default()
    }
}

/// A learner with the six sentences.
fn learner() -> Engine<Learner> {
    let mut engine = Engine::new();
    let name = "six.csv".to_owned();
    let file = CorpusFile { name, bytes: Arc::new(SIX.into()) };
    let files = vec![MappedFile { file, mapping: Mapping::default() }];
    pump(&mut engine, Request::OpenSheet { files, with_rejected: false });
    engine
}

/// The model that a new engine learns from the six sentences.
fn trained() -> String {
    match pump(&mut learner(), train()) {
        Some(Event::Trained(report)) => report.model,
        other => panic!("no model: {other:?}"),
    }
}

/// What each step of training costs, in seconds.
fn steps() -> Vec<f64> {
    let mut engine = learner();
    engine.start(1, train());
    let mut steps = Vec::new();
    while engine.busy() {
        steps.push(seconds(|| {
            black_box(engine.step());
        }));
    }
    steps
}

/// Three objects to three rooms, behind doors that lock as often as not.
fn behind_doors() -> Request {
    let mut state = State::read(NINE).unwrap();
    state.doors.iter_mut().for_each(|door| door.lock = Lock::Unknown);
    let the = |a: &str, b: &str| {
        format!("(the:<<e,t>,e> (lambda $0:e (and:<t*,t> ({a}:<e,t> $0) ({b}:<e,t> $0))))")
    };
    let rooms = [Color::Red, Color::Blue, Color::Green];
    let parts = state.objects.iter().zip(rooms).map(|(object, room)| {
        let object = the(object.shape.name(), object.color.name());
        format!("(in:<e,<e,t>> {object} {})", the("room", room.name()))
    });
    let form = format!("(and:<t*,t> {})", parts.collect::<Vec<_>>().join(" "));
    let rules =
        WorldRules { pull: true, landmarks_stay: false, lock: 0.5, ..WorldRules::default() };
    Request::Plan { form, run: vec![state], rules }
}

/// What each step of a request costs, in seconds.
fn job_steps(request: Request) -> Vec<f64> {
    let mut engine = Engine::<Talker>::new();
    engine.start(1, request);
    let mut steps = Vec::new();
    while engine.busy() {
        steps.push(seconds(|| drop(black_box(engine.step()))));
    }
    steps
}

/// Pumps a request to its end; the last thing that the engine says.
fn pump<R: Role>(engine: &mut Engine<R>, request: Request) -> Option<Event> {
    engine.start(1, request);
    let mut last = None;
    while engine.busy() {
        last = engine.step().map(|(_, event)| event).or(last);
    }
    last
}

fn plan() {
    let initial = State::read(THREE_OBJECTS).unwrap();
    let mut terms = Terms::new();
    let goal = read(&mut terms, MOVE_ALL).unwrap();
    let goal = Goal::new(&terms, goal, &initial).unwrap();
    let task = Task::new(&goal, &initial, Rules { pull: true, ..Rules::default() }).unwrap();
    black_box(AStar::new(&task, Settings::default()).run());
}
