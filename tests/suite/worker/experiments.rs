//! Experiments in the engine: they find what the same runs find outside it, leave what was loaded as it was, can
//! be cancelled, and say what is wrong with what they were given.

use super::{SIX, learner, next, only, pump, refused, settings, six};
use groundling::domain::State;
use groundling::learn::experiment::{By, Event as Step, Running, cross};
use groundling::learn::{CLEANUP_LEXICON, Config, Ties, seed_model};
use groundling::worker::protocol::{
    CorpusFile, Event, Experiment, ExperimentReport, Request, RunPart,
};
use groundling::worker::{Engine, Learner};
use std::sync::Arc;

const WORLD: &str = include_str!("../../../assets/worlds/three-rooms.json");

fn experiment(experiment: Experiment, epochs: u32) -> Request {
    Request::Experiment { experiment, settings: settings(epochs) }
}

fn three_folds() -> Experiment {
    Experiment::Cross { folds: 3, by: By::Command }
}

fn six_again() -> CorpusFile {
    CorpusFile { name: "six.csv".to_owned(), bytes: SIX.into() }
}

/// What an experiment finds, after it has told its way.
#[track_caller]
fn found(engine: &mut Engine<Learner>, request: Request) -> ExperimentReport {
    let mut events = pump(engine, 2, request);
    let Some(Event::Experimented { report }) = events.pop() else { panic!("{events:?}") };
    let way = |event: &Event| matches!(event, Event::Experimenting(_));
    assert!(events.iter().all(way), "only progress before the end");
    serde_json::from_str(&report).unwrap()
}

#[test]
fn cross_validation_finds_what_the_same_runs_find_outside() {
    let report = found(&mut learner(), experiment(three_folds(), 3));
    let config = Config { epochs: 3, ..Config::default() };
    let runs = cross(&Arc::from(six()), 3, By::Command, &config);
    assert_eq!(report.runs.len(), 3);
    let mut total = 0;
    for (run, row) in runs.into_iter().zip(&report.runs) {
        let name = run.name.clone();
        let mut running = Running::new(run, seed_model(CLEANUP_LEXICON).unwrap());
        let outcome = loop {
            if let Some(Step::Ended { outcome, .. }) = running.step() {
                break outcome;
            }
        };
        let scores = outcome.report.scores(Ties::Abstain);
        assert_eq!((&row.name, row.examples), (&name, outcome.examples));
        assert_eq!(row.judgement.total, scores.total);
        assert_eq!(row.judgement.plain.correct, scores.plain.correct);
        assert_eq!(row.judgement.skipping.f1[0], scores.skipping.f1(scores.total));
        total += scores.skipping.correct;
    }
    let all = report.all.unwrap();
    assert_eq!((all.total, all.skipping.correct), (6, total));
    let by_task: usize = all.tasks.iter().map(|task| task.correct).sum();
    assert_eq!(by_task, total);
    let wrong: usize = all.confusion.iter().map(|cell| cell.count).sum();
    assert_eq!(wrong, all.skipping.answered - all.skipping.correct);
}

#[test]
fn the_tables_have_their_rows_and_the_paper_beside_them() {
    let mut engine = learner();
    let table = Experiment::Table2 { set: "pruned".to_owned(), test: six_again() };
    let report = found(&mut engine, experiment(table, 1));
    let rows: Vec<_> = report.runs.iter().map(|row| (row.name.as_str(), row.paper_f1)).collect();
    assert_eq!(
        rows,
        [("pruned, 3", Some(0.82)), ("pruned, 2", Some(0.75)), ("pruned, 1", Some(0.71))]
    );
    assert!(report.all.is_none() && report.answer.is_none() && report.problems.is_empty());
    let table = Experiment::Table3 { test: six_again(), budget: 1_000_000 };
    let report = found(&mut engine, experiment(table, 1));
    let rows: Vec<_> = report.runs.iter().map(|row| (row.name.as_str(), row.paper_f1)).collect();
    assert_eq!(
        rows,
        [
            ("no planning", Some(0.72)),
            ("horizon 1", Some(0.0)),
            ("horizon 10", Some(0.667)),
            ("horizon 20", Some(0.667))
        ]
    );
    assert!(report.runs[0].planner.is_none());
    assert!(report.runs[1..].iter().all(|row| row.planner.as_ref().unwrap().calls > 0));
    assert_eq!(report.runs[1].valid, 0, "nothing is done in one step");
    assert_eq!((report.runs[0].valid, report.runs[3].valid), (6, 6));
}

#[test]
fn the_demonstration_ends_in_the_blue_room() {
    let command = "go to the blue room".to_owned();
    let state = State::read(WORLD).unwrap();
    let request = experiment(Experiment::Demonstration { command, state }, 15);
    let mut engine = learner();
    let report = found(&mut engine, request);
    assert_eq!(report.runs[0].judgement.plain.correct, 6);
    let answer = report.answer.unwrap();
    assert_eq!(answer.reason, None);
    let formula: String = answer.readings[0].formula.iter().map(|piece| &*piece.text).collect();
    assert_eq!(formula, "in(the agent, the λx. blue(x) ∧ room(x))");
    let plan = answer.plan.unwrap();
    let agent = &plan.states.last().unwrap().agent;
    let blue = plan.states[0].rooms.iter().find(|room| room.color.name() == "blue").unwrap();
    assert!(blue.bounds.left < agent.x && agent.x < blue.bounds.right, "{agent:?} in {blue:?}");
    assert!(blue.bounds.bottom < agent.y && agent.y < blue.bounds.top, "{agent:?} in {blue:?}");
}

#[test]
fn a_cancelled_experiment_leaves_everything_as_it_was() {
    let mut engine = learner();
    for words_before in [0, 1, 5, 11, 30] {
        engine.start(7, experiment(three_folds(), 5));
        for _ in 0..words_before {
            let (_, event) = next(&mut engine);
            let Event::Experimenting(progress) = event else { panic!("{event:?}") };
            assert_eq!(progress.runs, 3);
            assert!(matches!(progress.part, RunPart::Learning(_) | RunPart::Judging { .. }));
        }
        engine.start(8, Request::Cancel);
        assert_eq!(next(&mut engine), (7, Event::Cancelled));
        assert!(!engine.busy());
        // The corpus is there.
        assert!(matches!(
            only(pump(&mut engine, 9, Request::ShowRow { row: 5 })),
            Event::Row { .. }
        ));
    }
}

#[test]
fn what_cannot_be_run_is_refused_in_words() {
    let said = refused(&mut Engine::<Learner>::new(), experiment(three_folds(), 1));
    assert_eq!(said, "There is nothing to learn from: load a corpus first.");
    let mut engine = learner();
    let said = refused(&mut engine, experiment(three_folds(), 0));
    assert_eq!(said, "The epochs must be between 1 and 1000.");
    for folds in [0, 1, 7, u32::MAX] {
        let cross = Experiment::Cross { folds, by: By::Row };
        let said = refused(&mut engine, experiment(cross, 1));
        assert_eq!(said, "The folds must be between 2 and 6.");
    }
    let headers = SIX.lines().next().unwrap();
    for (text, wanted) in [
        ("", "No row of the test file can be used: the file is empty"),
        (headers, "No row of the test file can be used"),
        (&SIX.replace("{\"\"agent\"\"", "{\"\"agnt\"\""), "No row of the test file can be used"),
    ] {
        let test = CorpusFile { name: "test.csv".to_owned(), bytes: text.into() };
        let table = Experiment::Table3 { test, budget: 1 };
        let said = refused(&mut engine, experiment(table, 1));
        assert!(said.starts_with(wanted), "{said}");
    }
}
