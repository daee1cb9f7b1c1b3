//! What must come out the same everywhere (invariant 3): a report of the engine's work as text, held against
//! `tests/data/same.txt` natively, in the page and in a dedicated worker. That page and command line learn the
//! same model to the last byte is held end to end.

use groundling::domain::{
    Action, Blueprint, Chances, Form, Lock, Plan, Rules, State, Style, generate,
};
use groundling::ground::{Goal, Task};
use groundling::logic::{Terms, print, read};
use groundling::mdp::{Mdp, RolloutSettings, Rollouts, Settings, Solver, StartingAt, simulate};
use groundling::plan::{AnySolver, Auto, SOLVERS};
use groundling::worker::job::Role;
use groundling::worker::protocol::{
    CorpusFile, Event, Lexicon, MappedFile, Mapping, Request, SeedLexicon, Settings as Learning,
    WorldRules,
};
use groundling::worker::{Engine, Learner, Talker};
use std::fmt::Write;

/// What the report was when it was last looked at.
const WANTED: &str = include_str!("../data/same.txt");

/// Terms whose normal forms are part of the report.
const TERMS: [&str; 3] = [
    "(in:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) (the:<<e,t>,e> (lambda $0:e (and:<t*,t> (room:<e,t> $0) (blue:<e,t> $0)))))",
    "((lambda $0:<e,t> (exists:<<e,t>,t> $0)) (lambda $0:e (not:<t,t> (not:<t,t> (red:<e,t> $0)))))",
    "(or:<t*,t> (and:<t*,t> true:t false:t) (eq:<e,<e,t>> (argmax:<<e,t>,<<e,n>,e>> room:<e,t> size:<e,n>) (the:<<e,t>,e> door:<e,t>)))",
];

/// Some object in the smallest room.
const BRING: &str = "(exists:<<e,t>,t> (lambda $0:e (and:<t*,t> (object:<e,t> $0) \
    (in:<e,<e,t>> $0 (argmin:<<e,t>,<<e,n>,e>> room:<e,t> size:<e,n>)))))";

/// What the parser is learned from, and the commands that are then tried.
const CORPUS: &str = include_str!("../../assets/corpus/six.csv");
const COMMANDS: [&str; 4] =
    ["go to the blue room", "walk near the block", "go to the purple room", "room the go to the"];

/// Fails when this machine does not come to the same results as all others.
pub(crate) fn holds() {
    let report = report();
    assert!(report == WANTED, "tests/data/same.txt should read\n{report}");
}

fn report() -> String {
    let mut out = String::new();
    let mut terms = Terms::new();
    for text in TERMS {
        match read(&mut terms, text) {
            Ok(term) => writeln!(out, "term {}", print(&terms, term)),
            Err(error) => writeln!(out, "term {error}"),
        }
        .expect("a string takes any text");
    }
    let worlds: String = (0..200).map(|seed| generate(&Plan::default(), seed).write()).collect();
    writeln!(out, "worlds {:016x}", fnv1a(&worlds)).expect("a string takes any text");
    drawn(&mut out);
    planned(&mut out);
    learned(&mut out);
    out
}

/// What is drawn by seed: worlds of many rooms, runs through a world where things go wrong.
fn drawn(out: &mut String) {
    let styles = || Style::ALL.iter().flat_map(|&style| (0..20).map(move |seed| (style, seed)));
    let plan = Blueprint { rooms: 7, columns: 24, rows: 16, objects: 4, ..Blueprint::default() };
    let plan = Blueprint { lock: Lock::Unknown, ..plan };
    let built: String = styles()
        .map(|(style, seed)| match (Blueprint { style, ..plan }).build(seed) {
            Ok(state) => state.write(),
            Err(error) => error.to_string(),
        })
        .collect();
    let mut terms = Terms::new();
    let never = read(&mut terms, "false:t").expect("a term");
    let chances = Chances::new(0.1, 0.3, 0.2).expect("probabilities");
    let rules = Rules { pull: true, form: Form::Robot, chances, ..Rules::default() };
    let mut runs = String::new();
    for (style, seed) in styles().step_by(5) {
        let state = (Blueprint { style, ..plan }).build(seed).expect("there is room");
        let goal = Goal::new(&terms, never, &state).expect("a goal");
        let task = Task::new(&goal, &state, rules).expect("a world that fits");
        let actions: Vec<Action> = rules.actions().iter().copied().cycle().take(300).collect();
        for packed in simulate(&task.world(), &actions, seed) {
            runs += &task.dynamics().unpack(packed).write();
        }
    }
    for (what, text) in [("built", built), ("runs", runs)] {
        writeln!(out, "{what} {:016x}", fnv1a(&text)).expect("a string takes any text");
    }
}

/// What every solver makes of a problem, to the last bit, and what runs of its policy come to.
fn planned(out: &mut String) {
    let mut state = generate(&Plan { side: (8, 8), objects: (1, 1) }, 5);
    state.doors.iter_mut().for_each(|door| door.lock = Lock::Unknown);
    let mut terms = Terms::new();
    let goal = read(&mut terms, BRING).expect("a term");
    let goal = Goal::new(&terms, goal, &state).expect("a goal");
    let chances = Chances::new(0.1, 0.3, 0.2).expect("probabilities");
    let settings = Settings { seed: 3, ..Settings::default() }.with_budget(100_000, 100_000);
    for name in SOLVERS.into_iter().chain(["auto"]) {
        let chances = if name == "astar" { Chances::default() } else { chances };
        let rules = Rules { pull: true, chances, ..Rules::default() };
        let task = Task::new(&goal, &state, rules).expect("a world that fits");
        let from = |start| -> Box<dyn Solver<_, _>> {
            let problem = StartingAt::new(&task, start);
            match AnySolver::named(name, problem, settings) {
                Some(solver) => Box::new(solver),
                None => Box::new(Auto::new(problem, settings)),
            }
        };
        let mut solver = from(task.initial());
        let outcome = solver.run();
        let (value, made) = (solver.value(task.initial()), solver.progress());
        let runs = RolloutSettings { runs: 20, seed: 4, ..RolloutSettings::default() };
        let report = Rollouts::new(&task, runs, solver, from).run();
        writeln!(
            out,
            "{name}: {outcome:?} {value:?} in {} states, {} steps, {:?}; {} of 20, {:?} earned",
            made.states, made.steps, made.upper, report.successes, report.mean_return
        )
        .expect("a string takes any text");
    }
}

/// Trains on the six sentences and asks, through the engines that the page pumps.
fn learned(out: &mut String) {
    let (mut learner, mut talker) = (Engine::<Learner>::new(), Engine::<Talker>::new());
    let name = "six.csv".to_owned();
    let file = CorpusFile { name, bytes: CORPUS.as_bytes().to_vec().into() };
    let files = vec![MappedFile { file, mapping: Mapping::default() }];
    last(&mut learner, Request::OpenSheet { files, with_rejected: false });
    let lexicon = Lexicon::Here(SeedLexicon::Demonstration);
    let settings = Box::new(Learning { lexicon, ..Learning::default() });
    match last(&mut learner, Request::Learn { settings, resume: None }) {
        Some(Event::Trained(report)) => {
            last(&mut talker, Request::OpenModel { text: report.model });
            writeln!(out, "learned {} of {}", report.valid, report.examples)
        }
        other => writeln!(out, "no model: {other:?}"),
    }
    .expect("a string takes any text");
    for (command, seed) in COMMANDS.into_iter().zip(0..) {
        let state: State = generate(&Plan::default(), seed);
        let request =
            Request::Ask { command: command.to_owned(), state, rules: WorldRules::default() };
        match last(&mut talker, request) {
            Some(Event::Answer(answer)) => {
                let reading = answer.readings.first();
                let form = reading.map_or("nothing", |reading| reading.form.as_str());
                let plan = answer.plan.map_or(0, |plan| plan.actions.len());
                writeln!(out, "{command}: {form} {plan} {:?}", answer.reason)
            }
            other => writeln!(out, "{command}: {other:?}"),
        }
        .expect("a string takes any text");
    }
}

/// Pumps a request to its end; the last thing that the engine says.
fn last<R: Role>(engine: &mut Engine<R>, request: Request) -> Option<Event> {
    engine.start(1, request);
    let mut last = None;
    while engine.busy() {
        last = engine.step().map(|(_, event)| event).or(last);
    }
    last
}

/// Fowler, Noll and Vo's hash, 64 bits.
fn fnv1a(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}
