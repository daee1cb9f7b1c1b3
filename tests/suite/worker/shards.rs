//! Runs as data: plans repeat them, shards share them out, and what is joined is the same whoever worked on it.

use super::{learn, learner, next, only, pump, refused, settings, six};
use groundling::ccg::Kind;
use groundling::learn::experiment::By;
use groundling::learn::runs::{Matrix, Plan, spans};
use groundling::worker::protocol::{Event, Half, Joined, Request, Verdict};
use groundling::worker::{Engine, Learner};
use proptest::prelude::{any, prop, proptest};
use proptest::prop_assert_eq;

#[track_caller]
fn planned(engine: &mut Engine<Learner>, matrix: Matrix) -> Plan {
    let request = Request::PlanRuns { matrix, settings: settings(2) };
    match only(pump(engine, 2, request)) {
        Event::Plan { text } => {
            let plan = Plan::read(&text).unwrap();
            assert_eq!(plan.write(), text, "print and read");
            plan
        }
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn shard(engine: &mut Engine<Learner>, plan: &Plan, runs: Vec<u32>) -> String {
    match pump(engine, 3, Request::RunShard { plan: plan.write(), runs }).pop() {
        Some(Event::Shard { text }) => text,
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn joined(engine: &mut Engine<Learner>, plan: &Plan, shards: Vec<String>) -> Joined {
    match only(pump(engine, 4, Request::JoinRuns { plan: plan.write(), shards })) {
        Event::Joined(joined) => *joined,
        other => panic!("{other:?}"),
    }
}

#[test]
fn four_engines_find_what_one_finds() {
    let mut engines = [learner(), learner(), learner(), learner()];
    let [one, ..] = &mut engines;
    let plan = planned(one, Matrix::Cross { folds: 3, by: By::Row });
    assert_eq!((plan.runs.len(), plan.rows, plan.pooled), (3, 6, true));
    let alone = shard(one, &plan, vec![0, 1, 2]);
    let all = joined(one, &plan, vec![alone.clone()]);
    assert_eq!(all.results, alone, "joining one is nothing");
    let [_, b, c, d] = &mut engines;
    let parts = vec![shard(d, &plan, vec![1]), shard(b, &plan, vec![2]), shard(c, &plan, vec![0])];
    let [one, ..] = &mut engines;
    assert_eq!(joined(one, &plan, parts), all);
    let pooled = all.all.unwrap();
    assert_eq!((pooled.total, all.runs.len()), (6, 3));
    assert_eq!(all.csv.lines().count(), 5, "{}", all.csv);
    assert!(all.markdown.contains("| fold 2 |") && all.markdown.contains("| all |"));
    for (shards, said) in [
        (vec![], "Run 0 is missing."),
        (vec![alone.clone(), alone.clone()], "Run 0 is there twice."),
        (vec!["{}".to_owned()], "Shard 1: missing field `format`"),
    ] {
        let refusal = refused(one, Request::JoinRuns { plan: plan.write(), shards });
        assert!(refusal.starts_with(said), "{refusal}");
    }
}

#[test]
fn a_shard_says_how_far_it_is_and_may_be_stopped() {
    let mut engine = learner();
    let plan = planned(&mut engine, Matrix::Cross { folds: 2, by: By::Row });
    engine.start(9, Request::RunShard { plan: plan.write(), runs: vec![1, 0] });
    let (9, Event::Experimenting(progress)) = next(&mut engine) else { panic!() };
    assert_eq!((progress.run, progress.runs, progress.name.as_str()), (0, 2, "fold 2"));
    engine.start(10, Request::Cancel);
    assert_eq!(next(&mut engine), (9, Event::Cancelled));
    let other = plan.write().replace(&plan.corpus, "0123");
    let said = refused(&mut engine, Request::RunShard { plan: other, runs: vec![0] });
    assert!(said.starts_with("The plan is for another corpus"), "{said}");
    let said = refused(&mut engine, Request::RunShard { plan: plan.write(), runs: vec![2] });
    assert_eq!(said, "The plan has no run 2.");
    let said = refused(&mut engine, Request::RunShard { plan: "{".to_owned(), runs: vec![] });
    assert!(said.starts_with("The plan cannot be read: not JSON"), "{said}");
}

#[test]
fn every_matrix_has_its_runs() {
    let mut engine = learner();
    let none = Request::PlanRuns { matrix: Matrix::Once, settings: settings(2) };
    assert_eq!(refused(&mut engine, none), "Nothing is held out: part the corpus first.");
    let put = Request::Decide { rows: vec![4, 5], verdict: Verdict::Put(Half::HeldOut) };
    pump(&mut engine, 5, put);
    pump(
        &mut engine,
        5,
        Request::Decide { rows: vec![3], verdict: Verdict::Reject("no".to_owned()) },
    );
    let ablation =
        Matrix::Ablation { kinds: vec![Kind::Pair, Kind::Head], demonstrations: vec![1, 2] };
    for (matrix, names) in [
        (Matrix::Once, "once"),
        (Matrix::Table2 { set: "pruned".to_owned() }, "pruned, 3; pruned, 2; pruned, 1"),
        (Matrix::Table3 { budget: 100 }, "no planning; horizon 1; horizon 10; horizon 20"),
        (Matrix::Cross { folds: 3, by: By::Command }, "fold 1; fold 2; fold 3"),
        (Matrix::Curve { percents: vec![1, 50, 100], by: By::Row }, "50 %; 100 %"),
        (
            ablation,
            "all features, 1 demonstrations; all features, 2 demonstrations; without pair, 1 demonstrations; without pair, 2 demonstrations; without head, 1 demonstrations; without head, 2 demonstrations",
        ),
        (Matrix::Seeds { count: 2 }, "seed 0; seed 1"),
    ] {
        let plan = planned(&mut engine, matrix.clone());
        let found: Vec<&str> = plan.runs.iter().map(|run| run.name.as_str()).collect();
        assert_eq!(found.join("; "), names, "{matrix:?}");
        let rows = |text: &str| spans::read(text, 6).unwrap();
        assert!(plan.runs.iter().all(|run| !rows(&run.train).contains(&3)), "rejected");
        if matrix == Matrix::Once {
            assert_eq!((plan.runs[0].train.as_str(), plan.runs[0].test.as_str()), ("0-2", "4-5"));
        }
    }
    let table = planned(&mut engine, Matrix::Table2 { set: "pruned".to_owned() });
    assert_eq!(table.runs[0].paper_f1, Some(0.82));
    let text = shard(&mut engine, &table, vec![0, 1, 2]);
    let found = joined(&mut engine, &table, vec![text]);
    assert!(
        found.csv.contains("\"pruned, 3\",\"3\",\"2\",\"demonstration\",\"2\""),
        "{}",
        found.csv
    );
    assert_eq!((found.runs[0].examples, found.all), (3, None));
    for (matrix, said) in [
        (Matrix::Cross { folds: 1, by: By::Row }, "The folds must be between 2 and 3."),
        (Matrix::Seeds { count: 0 }, "These are 0 runs; a plan has 1 to 1000."),
    ] {
        let request = Request::PlanRuns { matrix, settings: settings(2) };
        assert_eq!(refused(&mut engine, request), said);
    }
}

#[test]
fn a_run_of_a_plan_is_the_run_that_training_does() {
    let mut engine = learner();
    pump(&mut engine, 5, Request::Decide { rows: vec![0], verdict: Verdict::Put(Half::HeldOut) });
    let plan = planned(&mut engine, Matrix::Once);
    let text = shard(&mut engine, &plan, vec![0]);
    let found = joined(&mut engine, &plan, vec![text]);
    let events = pump(&mut engine, 6, learn(2));
    let Some(Event::HeldOut { judgement, .. }) = events.iter().rev().nth(1) else { panic!() };
    assert_eq!(**judgement, found.runs[0].judgement);
    assert_eq!(six().len(), 6);
}

proptest! {
    #[test]
    fn spans_are_read_as_they_were_written(rows in prop::collection::btree_set(any::<u8>(), 0..60)) {
        let rows: Vec<u32> = rows.into_iter().map(u32::from).collect();
        prop_assert_eq!(spans::read(&spans::write(&rows), 256), Some(rows));
    }
}

#[test]
fn spans_that_cannot_be_are_none() {
    for text in ["5-4", "3,3", "4,1", "0-9", "a", "1-", "-", "0-4294967295"] {
        assert_eq!(spans::read(text, 9), None, "{text}");
    }
    assert_eq!(spans::read("", 9), Some(Vec::new()));
}
