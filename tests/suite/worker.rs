//! The engines behind the page, pumped as the page's workers pump them.

#[path = "worker/answers.rs"]
mod answers;
#[path = "worker/doubts.rs"]
mod doubts;
#[path = "worker/experiments.rs"]
mod experiments;
#[path = "worker/large.rs"]
mod large;
#[path = "worker/drives.rs"]
mod drives;
#[path = "worker/lessons.rs"]
mod lessons;
#[path = "worker/messages.rs"]
mod messages;
#[path = "worker/plans.rs"]
mod plans;
#[path = "worker/readings.rs"]
mod readings;
#[path = "worker/recall.rs"]
mod recall;
#[path = "worker/resting.rs"]
mod resting;
#[path = "worker/shards.rs"]
mod shards;
#[path = "worker/sheets.rs"]
mod sheets;
#[path = "worker/shipped.rs"]
mod shipped;
#[path = "worker/worlds.rs"]
mod worlds;

use crate::learn::{SIX, six};
use groundling::learn::{Config, DEMONSTRATION_LEXICON, Trainer, seed_model};
use groundling::worker::job::Role;
use groundling::worker::protocol::{
    CorpusFile, Event, Lexicon, MappedFile, Mapping, Request, SeedLexicon, Settings, SheetReport,
};
use groundling::worker::{Engine, Learner, Talker};

/// The steps that may pass without a word: a search of two million states at 2,000 a step takes a thousand.
const MOST_SILENT_STEPS: usize = 1_010;

fn settings(epochs: u32) -> Box<Settings> {
    let lexicon = Lexicon::Here(SeedLexicon::Demonstration);
    Box::new(Settings { lexicon, epochs, ..Settings::default() })
}

fn learn(epochs: u32) -> Request {
    Request::Learn { settings: settings(epochs), resume: None }
}

fn file(name: &str, text: &str) -> MappedFile {
    let file = CorpusFile { name: name.to_owned(), bytes: text.as_bytes().to_vec().into() };
    MappedFile { file, mapping: Mapping::default() }
}

fn corpus(name: &str, text: &str) -> Request {
    Request::OpenSheet { files: vec![file(name, text)], with_rejected: false }
}

/// What came of reading one file.
#[track_caller]
fn opened(engine: &mut Engine<Learner>, name: &str, text: &str) -> SheetReport {
    match only(pump(engine, 1, corpus(name, text))) {
        Event::Sheet(report) => *report,
        other => panic!("{name}: {other:?}"),
    }
}

/// Steps until there is something to say.
#[track_caller]
fn next<R: Role>(engine: &mut Engine<R>) -> (u32, Event) {
    for _ in 0..MOST_SILENT_STEPS {
        assert!(engine.busy(), "nothing is at work, and nothing was said");
        if let Some(event) = engine.step() {
            return event;
        }
    }
    panic!("no word in {MOST_SILENT_STEPS} steps");
}

/// Everything that a request brings about.
#[track_caller]
fn pump<R: Role>(engine: &mut Engine<R>, id: u32, request: Request) -> Vec<Event> {
    engine.start(id, request);
    let mut events = Vec::new();
    while engine.busy() {
        let (of, event) = next(engine);
        assert_eq!(of, id, "{event:?} answers another request");
        events.push(event);
    }
    assert!(engine.step().is_none(), "it has said all");
    events
}

#[track_caller]
fn only(mut events: Vec<Event>) -> Event {
    assert_eq!(events.len(), 1, "{events:?}");
    events.remove(0)
}

#[track_caller]
fn refused<R: Role>(engine: &mut Engine<R>, request: Request) -> String {
    match only(pump(engine, 99, request)) {
        Event::Refused { message } => message,
        other => panic!("not refused: {other:?}"),
    }
}

/// A learner with the six sentences.
fn learner() -> Engine<Learner> {
    let mut engine = Engine::new();
    pump(&mut engine, 1, corpus("six.csv", SIX));
    engine
}

/// A talker with a model that was learned from the six sentences, and the model's text.
fn taught(epochs: u32) -> (Engine<Talker>, String) {
    let Some(Event::Trained(report)) = pump(&mut learner(), 2, learn(epochs)).pop() else {
        panic!("it does not end with a model");
    };
    let mut engine = Engine::new();
    let open = Request::OpenModel { text: report.model.clone() };
    assert_eq!(only(pump(&mut engine, 3, open)), Event::Opened(report.clone()));
    (engine, report.model)
}

#[test]
fn a_corpus_is_read_and_kept_and_a_bad_one_replaces_nothing() {
    let mut engine = Engine::<Learner>::new();
    let report = opened(&mut engine, "six.csv", SIX);
    assert_eq!((report.files[0].rows, report.care.rejected), (6, 0));
    assert!(report.faults.is_empty(), "{:?}", report.faults);
    let show = |engine: &mut Engine<Learner>, row| only(pump(engine, 2, Request::ShowRow { row }));
    let first = show(&mut engine, 0);
    let Event::Row { row: 0, pairs } = &first else { panic!("{first:?}") };
    assert_eq!(pairs[0].pair.pre, six()[0].pairs[0].pre);
    let headers = SIX.lines().next().unwrap();
    let broken = SIX.replace("{\"\"agent\"\"", "{\"\"agnt\"\"");
    for (name, text) in [
        ("empty.csv", ""),
        ("blank.csv", "\n\n"),
        ("picture.csv", "\u{0}PNG\r\n\u{1a}\n\u{0}\u{1}\u{fffd}"),
        ("letter.csv", "Dear robot,\nplease go home.\n"),
        ("headers.csv", headers),
        ("broken.csv", &broken),
        ("other.csv", &SIX.replace("Answer.command", "Answer.remark")),
        ("empty.jsonl", ""),
    ] {
        let report = opened(&mut engine, name, text);
        assert!(report.files[0].useless.is_some(), "{name}");
        assert!(!report.faults.is_empty(), "{name}: nothing is said to be wrong");
        assert!(report.faults.iter().all(|fault| !fault.what.is_empty() && !fault.kept), "{name}");
        assert_eq!(show(&mut engine, 0), first, "{name}: the old corpus stays");
    }
    assert_eq!(refused(&mut engine, Request::ShowRow { row: 6 }), "The corpus has no row 6.");
    // A row that is bad leaves the good ones, and those are the corpus from then on.
    let one_bad = SIX.replacen("{\"\"agent\"\"", "{\"\"agnt\"\"", 1);
    let report = opened(&mut engine, "five.csv", &one_bad);
    assert_eq!((report.files[0].rows, report.faults[0].line), (5, 2));
    assert!(matches!(show(&mut engine, 4), Event::Row { row: 4, .. }));
    assert_eq!(refused(&mut engine, Request::ShowRow { row: 5 }), "The corpus has no row 5.");
}

#[test]
fn training_needs_a_corpus_and_settings_that_can_be() {
    let mut engine = Engine::<Learner>::new();
    let said = refused(&mut engine, learn(1));
    assert_eq!(said, "There is nothing to learn from: load a corpus first.");
    pump(&mut engine, 1, corpus("six.csv", SIX));
    for (change, said) in [
        (Settings { epochs: 0, ..*settings(1) }, "The epochs must be between 1 and 1000."),
        (Settings { beam: 0, ..*settings(1) }, "The beam must be between 1 and 10000."),
        (
            Settings { lexical_beam: 10_001, ..*settings(1) },
            "The lexical beam must be between 1 and 10000.",
        ),
        (
            Settings { demonstrations: Some(0), ..*settings(1) },
            "The demonstrations must be between 1 and 1000.",
        ),
    ] {
        let learn = Request::Learn { settings: Box::new(change), resume: None };
        assert_eq!(refused(&mut engine, learn), said);
    }
}

#[test]
fn training_reports_every_example_and_ends_with_the_command_line_s_bytes() {
    let mut engine = Engine::<Learner>::new();
    pump(&mut engine, 1, corpus("six.csv", SIX));
    let mut events = pump(&mut engine, 2, learn(4));
    let Some(Event::Trained(report)) = events.pop() else { panic!("no model") };
    let progress = events.iter().map(|event| match event {
        Event::Progress(p) => (p.epoch, p.example, p.epochs, p.examples),
        other => panic!("{other:?}"),
    });
    let wanted = (1..=4).flat_map(|epoch| (1..=6).map(move |example| (epoch, example, 5, 6)));
    // Then every command is looked at twice in search of idioms.
    let wanted = wanted.chain((1..=12).map(|seen| (5, seen / 2, 5, 6)));
    assert!(progress.eq(wanted), "{events:?}");
    let config = Config { epochs: 4, ..Config::default() };
    let seed = seed_model(DEMONSTRATION_LEXICON).unwrap();
    let mut trainer = Trainer::new(seed, &six(), config);
    while !trainer.is_done() {
        trainer.step();
    }
    let model = trainer.averaged();
    assert!(report.model == model.print(), "the page's model is not the command line's");
    let said = (report.examples, report.valid, report.entries);
    assert_eq!(said, (6, 6, model.lexicon.len()));
}

#[test]
fn training_says_something_every_few_steps() {
    let mut engine = Engine::<Learner>::new();
    pump(&mut engine, 1, corpus("six.csv", SIX));
    engine.start(2, learn(4));
    let (mut silent, mut reported) = (0, 0);
    while engine.busy() {
        let spoke = engine.step().is_some();
        (silent, reported) = (if spoke { 0 } else { silent + 1 }, reported + usize::from(spoke));
        // An example is at most an explanation and two generations; when all were seen, idioms are looked for among six
        // commands, twice.
        assert!(silent <= if reported < 24 { 2 } else { 12 }, "{silent} steps after {reported}");
    }
    // A file is read in steps of a demonstration, and says how far it is.
    engine.start(
        3,
        corpus("long.csv", &format!("{SIX}{}", SIX.split_once('\n').unwrap().1.repeat(9))),
    );
    let (mut steps, mut reports) = (0, 0);
    while engine.busy() {
        steps += 1;
        reports += usize::from(matches!(engine.step(), Some((3, Event::Reading { .. }))));
    }
    assert!((180..=600).contains(&steps), "{steps} steps for sixty rows");
    assert!((2..=8).contains(&reports), "{reports} reports of four pieces");
}

#[test]
fn a_ping_is_answered_and_replaces_nothing() {
    let mut engine = Engine::<Learner>::new();
    assert_eq!(only(pump(&mut engine, 7, Request::Ping)), Event::Pong);
    pump(&mut engine, 1, corpus("six.csv", SIX));
    engine.start(2, learn(1));
    next(&mut engine);
    engine.start(8, Request::Ping);
    assert_eq!(next(&mut engine), (8, Event::Pong));
    let mut last = next(&mut engine);
    while engine.busy() {
        last = next(&mut engine);
    }
    assert!(matches!(last, (2, Event::Trained(_))), "{last:?}");
}

#[test]
fn every_request_that_is_replaced_is_told_so() {
    let mut engine = learner();
    engine.start(10, learn(2));
    next(&mut engine);
    engine.start(11, learn(2));
    engine.start(12, corpus("six.csv", SIX));
    // A look at a row replaces nothing.
    engine.start(13, Request::ShowRow { row: 0 });
    assert_eq!(next(&mut engine), (10, Event::Cancelled));
    assert_eq!(next(&mut engine), (11, Event::Cancelled));
    assert!(matches!(next(&mut engine), (13, Event::Row { row: 0, .. })));
    engine.start(14, Request::Cancel);
    assert_eq!(next(&mut engine), (12, Event::Cancelled));
    assert!(!engine.busy());
    // Nothing is at work: there is nothing to cancel.
    engine.start(15, Request::Cancel);
    assert!(!engine.busy() && engine.step().is_none());
}
