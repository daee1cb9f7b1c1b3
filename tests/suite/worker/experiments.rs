//! Experiments in the engine: they find what the same runs find outside it, leave what was loaded as it was, can
//! be cancelled, and say what is wrong with what they were given.

use super::{learner, next, only, pump, refused, settings, six};
use groundling::domain::text;
use groundling::learn::experiment::{By, Event as Step, Running, cross};
use groundling::learn::{Config, DEMONSTRATION_LEXICON, Ties, seed_model};
use groundling::worker::protocol::{
    Demonstrated, Event, Half, Joined, Matrix, Request, RunPart, Verdict,
};
use groundling::worker::{Engine, Learner};
use std::sync::Arc;

const WORLD: &str = include_str!("../../../assets/worlds/three-rooms.txt");

fn demonstrate(epochs: u32) -> Request {
    let command = "go to the blue room".to_owned();
    let state = text::read_legal(WORLD).unwrap();
    Request::Demonstrate { command, state, settings: settings(epochs) }
}

/// The last word of a request, after it has told its way.
#[track_caller]
fn found(engine: &mut Engine<Learner>, request: Request) -> Event {
    let mut events = pump(engine, 2, request);
    let last = events.pop().unwrap();
    let way = |event: &Event| matches!(event, Event::Experimenting(_));
    assert!(events.iter().all(way), "only progress before the end");
    last
}

/// What all runs of a matrix find.
#[track_caller]
fn run(engine: &mut Engine<Learner>, matrix: Matrix, epochs: u32) -> Joined {
    let request = Request::PlanRuns { matrix, settings: settings(epochs) };
    let Event::Plan { text: plan } = only(pump(engine, 3, request)) else { panic!("no plan") };
    let runs: Vec<u32> = (0..).take(plan.matches("\"train\"").count()).collect();
    let Event::Shard { text } =
        found(engine, Request::RunShard { plan: plan.clone(), runs: runs.clone() })
    else {
        panic!("no shard")
    };
    match only(pump(engine, 4, Request::JoinRuns { plan, shards: vec![text] })) {
        Event::Joined(joined) => {
            assert_eq!(joined.runs.len(), runs.len());
            *joined
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn cross_validation_finds_what_the_same_runs_find_outside() {
    let report = run(&mut learner(), Matrix::Cross { folds: 3, by: By::Command }, 3);
    let config = Config { epochs: 3, ..Config::default() };
    let runs = cross(&Arc::from(six()), 3, By::Command, &config);
    assert_eq!(report.runs.len(), 3);
    let mut total = 0;
    for (run, row) in runs.into_iter().zip(&report.runs) {
        let name = run.name.clone();
        let mut running = Running::new(run, seed_model(DEMONSTRATION_LEXICON).unwrap());
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
    let held_out = Verdict::Put(Half::HeldOut);
    pump(&mut engine, 5, Request::Decide { rows: vec![5], verdict: held_out });
    let report = run(&mut engine, Matrix::Table2 { set: "pruned".to_owned() }, 1);
    let rows: Vec<_> = report.runs.iter().map(|row| (row.name.as_str(), row.paper_f1)).collect();
    assert_eq!(
        rows,
        [("pruned, 3", Some(0.82)), ("pruned, 2", Some(0.75)), ("pruned, 1", Some(0.71))]
    );
    assert!(report.all.is_none());
    let report = run(&mut engine, Matrix::Table3 { budget: 1_000_000 }, 1);
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
    assert_eq!((report.runs[0].valid, report.runs[3].valid), (5, 5));
}

#[test]
fn the_demonstration_ends_in_the_blue_room() {
    let Event::Demonstrated(report) = found(&mut learner(), demonstrate(15)) else {
        panic!("no end")
    };
    let Demonstrated { run, answer } = *report;
    assert_eq!((run.examples, run.judgement.plain.correct), (6, 6));
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
        engine.start(7, demonstrate(5));
        for _ in 0..words_before {
            let (_, event) = next(&mut engine);
            let Event::Experimenting(progress) = event else { panic!("{event:?}") };
            assert_eq!((progress.run, progress.runs), (0, 1));
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
    let said = refused(&mut Engine::<Learner>::new(), demonstrate(1));
    assert_eq!(said, "There is nothing to learn from: load a corpus first.");
    let mut engine = learner();
    let said = refused(&mut engine, demonstrate(0));
    assert_eq!(said, "The epochs must be between 1 and 1000.");
    for folds in [0, 1, 7, u32::MAX] {
        let matrix = Matrix::Cross { folds, by: By::Row };
        let said = refused(&mut engine, Request::PlanRuns { matrix, settings: settings(1) });
        assert_eq!(said, "The folds must be between 2 and 6.");
    }
}
