//! Teaching a finished model a new word: what it then knows, what stays as it was, and what is refused; in the
//! library, on the command line and through the engine.

use crate::command::call;
use groundling::ccg::{ChartConfig, EntryText, Model, parse};
use groundling::corpus::{Example, Options, read};
use groundling::learn::{CLEANUP_LEXICON, Config, Taught, Trainer, seed_model, teach};
use groundling::worker::job::Role;
use groundling::worker::protocol::{
    Event, Fate, Lesson, PairText, Request, TeachReport, WorldRules,
};
use groundling::worker::{Engine, Learner, Talker};
use std::path::PathBuf;
use std::sync::LazyLock;

const SIX: &str = include_str!("../../assets/corpus/six.csv");
const CROWD: &str = include_str!("../data/corpus/crowd-learn.csv");

fn examples(text: &str) -> Vec<Example> {
    read(text.as_bytes(), Options::default()).0.examples
}

/// A model of the crowd's rows, trained once for all tests here.
fn model() -> Model {
    static MODEL: LazyLock<Model> = LazyLock::new(|| run().averaged());
    MODEL.clone()
}

fn run() -> Trainer {
    let config = Config { epochs: 2, ..Config::default() };
    let mut trainer = Trainer::new(seed_model(CLEANUP_LEXICON).unwrap(), &examples(CROWD), config);
    while !trainer.is_done() {
        trainer.step();
    }
    trainer
}

/// The demonstrations of one of the six sentences under another command.
fn lesson(like: &str, command: &str) -> Example {
    let example = examples(SIX).into_iter().find(|example| example.command == like).unwrap();
    Example { command: command.to_owned(), ..example }
}

/// "go to the emerald room", shown as one would show "go to the green room".
fn emerald() -> Example {
    lesson("go to the green room", "go to the emerald room")
}

fn taught(model: Model, lessons: &[Example]) -> Taught {
    let config = Config { demonstrations: None, ..Config::of(&model) };
    teach(model, lessons, config).unwrap()
}

/// Form and score of the best readings, to the last bit.
fn heard(model: &mut Model, command: &str) -> Vec<(String, u64)> {
    let parse = parse(model, command, ChartConfig::of(model));
    let terms = &model.grammar.terms;
    let show =
        |r: &groundling::ccg::Reading| (groundling::logic::print(terms, r.form), r.score.to_bits());
    parse.readings.iter().map(show).collect()
}

#[test]
fn a_new_word_is_learned_and_no_other_sentence_notices() {
    let mut before = model();
    let Taught { model: mut after, entries, understood } = taught(before.clone(), &[emerald()]);
    assert_eq!(understood, [true]);
    let added: Vec<EntryText> = entries.iter().map(|&id| EntryText::of(&after, id)).collect();
    assert!(added.iter().any(|entry| entry.words == "emerald"), "{added:?}");
    assert!(added.iter().all(|entry| entry.learned && entry.words.contains("emerald")));
    for example in examples(CROWD) {
        let command = &example.command;
        assert_eq!(heard(&mut before, command), heard(&mut after, command), "{command}");
    }
    let form = |model: &mut Model, command: &str| heard(model, command)[0].0.clone();
    let (green, emerald) = ("walk into the green room", "walk into the emerald room");
    assert_eq!(form(&mut after, emerald), form(&mut after, green), "in a sentence never heard");
}

#[test]
fn the_same_lesson_gives_the_same_bytes_from_memory_and_from_a_file() {
    let fresh = taught(model(), &[emerald()]).model.print();
    let read = Model::read(&model().print()).unwrap();
    assert!(taught(read, &[emerald()]).model.print() == fresh);
    // What the model says of its training stays; how much it was taught comes on top.
    let facts = Model::read(&fresh).unwrap().facts;
    let mut wanted = model().facts;
    wanted.insert("taught".to_owned(), "1".to_owned());
    assert_eq!(facts, wanted);
    let again = taught(Model::read(&fresh).unwrap(), &[emerald()]);
    assert_eq!((again.entries.len(), again.model.facts["taught"].as_str()), (0, "2"));
}

#[test]
fn what_contradicts_the_language_is_not_believed_and_moves_nothing() {
    let before = model();
    let contradiction = lesson("go to the green room", "go to the red room");
    let Taught { model: after, understood, .. } = taught(before.clone(), &[contradiction]);
    assert_eq!(understood, [false]);
    let weights = |model: &Model| {
        let known = before.features.iter().map(|(feature, ..)| feature);
        known.map(|feature| model.features.weight(feature).to_bits()).collect::<Vec<u64>>()
    };
    assert_eq!(weights(&after), weights(&before));
}

#[test]
fn hopeless_lessons_end() {
    let nothing = Example { pairs: Vec::new(), ..emerald() };
    let long = lesson("go to the green room", &"blah ".repeat(60));
    let babble = lesson("go to the green room", "xa xb xc xd xe xf xg");
    let Taught { understood, .. } = taught(model(), &[nothing, long, babble]);
    assert_eq!(understood.len(), 3);
    assert_eq!(understood[..2], [false, false]);
    assert!(taught(model(), &[]).entries.is_empty());
}

#[test]
fn a_run_that_has_not_ended_cannot_be_taught() {
    let checkpoint = Model::read(&run().checkpoint()).unwrap();
    let error = teach(checkpoint, &[emerald()], Config::default()).unwrap_err();
    assert!(error.to_string().contains("checkpoint"), "{error}");
}

/// A file of this test's own.
fn file(name: &str, text: &str) -> String {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("teach");
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name).display().to_string();
    std::fs::write(&path, text).unwrap();
    path
}

/// The row of the green room as a corpus of one, under a new command.
fn emerald_csv() -> String {
    let mut lines = SIX.lines();
    let head = lines.next().unwrap();
    let row = lines.find(|line| line.contains("\"go to the green room\"")).unwrap();
    format!("{head}\n{}\n", row.replace("\"go to the green room\"", "\"go to the emerald room\""))
}

#[test]
fn the_command_line_teaches_into_a_model() {
    let (corpus, into) = (file("emerald.csv", &emerald_csv()), file("a.model", &model().print()));
    let out = file("b.model", "");
    let arguments = ["train", "--into", &into, "--corpus", &corpus, "--out", &out, "--json"];
    let output = call(&arguments, "");
    assert!(output.status.success(), "{output:?}");
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["commands"][0]["understood"], true);
    let words = report["added"].as_array().unwrap().iter().map(|entry| &entry["words"]);
    assert!(words.into_iter().any(|words| words == "emerald"), "{report}");
    let written = std::fs::read_to_string(&out).unwrap();
    assert!(written == taught(model(), &[emerald()]).model.print(), "as the library teaches");

    let checkpoint = file("c.model", &run().checkpoint());
    let output = call(&["train", "--into", &checkpoint, "--corpus", &corpus, "--out", &out], "");
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("checkpoint"), "{output:?}");
}

/// The last thing that the engine says to a request.
fn last<R: Role>(engine: &mut Engine<R>, request: Request) -> Event {
    engine.start(7, request);
    let mut last = None;
    while engine.busy() {
        last = engine.step().or(last);
    }
    let (id, event) = last.unwrap();
    assert_eq!(id, 7);
    event
}

fn request(model: &str, lessons: &[Example]) -> Request {
    let pairs = |example: &Example| {
        let pairs = example.pairs.iter();
        pairs.map(|p| PairText { pre: p.pre.clone(), post: p.post.clone() }).collect()
    };
    let lesson = |e: &Example| Lesson {
        command: e.command.clone(),
        pairs: pairs(e),
        runs: Vec::new(),
        means: None,
    };
    let examples = lessons.iter().map(lesson).collect();
    Request::Teach { model: model.to_owned(), examples }
}

#[test]
fn the_learner_teaches_the_model_it_is_given() {
    let mut engine = Engine::<Learner>::new();
    let before = model().print();
    let refused = |engine: &mut Engine<Learner>, model: &str, lessons: &[Example]| match last(
        engine,
        request(model, lessons),
    ) {
        Event::Refused { message } => message,
        other => panic!("{other:?}"),
    };
    let said = refused(&mut engine, "nonsense", &[emerald()]);
    assert!(said.starts_with("The model cannot be read: line 1: "), "{said}");
    let bare = Example { pairs: Vec::new(), ..emerald() };
    assert_eq!(
        refused(&mut engine, &before, &[bare]),
        "Show what to do when one says \"go to the emerald room\"."
    );
    let many = vec![emerald(); 101];
    assert_eq!(refused(&mut engine, &before, &many), "Teach between 1 and 100 commands at once.");

    let mut talker = Engine::<Talker>::new();
    let mut answer = |model: &str| {
        last(&mut talker, Request::OpenModel { text: model.to_owned() });
        let command = "walk into the emerald room".to_owned();
        let state = emerald().pairs[0].pre.clone();
        match last(&mut talker, Request::Ask { command, state, rules: WorldRules::default() }) {
            Event::Answer(answer) => *answer,
            other => panic!("{other:?}"),
        }
    };
    let unknown = answer(&before).words.into_iter().filter(|w| w.fate == Fate::Unknown);
    assert!(unknown.map(|word| word.text).eq(["emerald"]));
    let Event::Taught(report) = last(&mut engine, request(&before, &[emerald()])) else {
        panic!("it was not taught");
    };
    let TeachReport { model: after, added, understood, .. } = *report;
    assert!(after.model == taught(model(), &[emerald()]).model.print(), "as the library teaches");
    assert!(added.iter().any(|entry| entry.words == "emerald") && understood == [true]);
    let answer = answer(&after.model);
    let meant = answer.words.iter().all(|word| word.fate == Fate::Meant);
    assert!(meant && answer.plan.is_some(), "{answer:?}");
}
