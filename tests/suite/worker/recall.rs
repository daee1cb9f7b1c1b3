//! A run that is over is taken up again by an engine that has the same rows; and a model that several engines are asked
//! about is judged as by one.

use super::sheets::{care, sheet};
use super::{learn, next, only, pump, refused, settings};
use groundling::worker::protocol::{
    Answered, Checkpoint, EntryView, EntryWindow, Errors, Event, Half, Request, RowReading, Rules,
    TrainReport, Verdict, View, Window,
};
use groundling::worker::{Engine, Learner};

fn trained(engine: &mut Engine<Learner>, request: Request) -> TrainReport {
    match pump(engine, 5, request).pop() {
        Some(Event::Trained(report)) => report,
        other => panic!("{other:?}"),
    }
}

fn entries(engine: &mut Engine<Learner>) -> EntryWindow {
    let view = EntryView { learned: true, ..EntryView::default() };
    match only(pump(engine, 6, Request::Entries { view, offset: 0, count: 50 })) {
        Event::Entries(window) => *window,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_run_that_is_over_is_taken_up_again_with_what_it_learned_and_from_where() {
    let mut engine = sheet();
    care(&mut engine, Request::Decide { rows: vec![8, 9], verdict: Verdict::Put(Half::HeldOut) });
    let Event::Decisions { text: decisions } = only(pump(&mut engine, 2, Request::Decisions))
    else {
        panic!()
    };
    let report = trained(&mut engine, learn(3));
    let learned = entries(&mut engine);
    assert!(learned.total > 0 && learned.lines.iter().all(|line| line.from.is_some()));
    let Event::Checkpoint(Checkpoint { text: checkpoint, .. }) =
        only(pump(&mut engine, 3, Request::Checkpoint))
    else {
        panic!()
    };

    // In another engine, whose rows stand otherwise by now.
    let mut other = sheet();
    care(&mut other, Request::Decide { rows: vec![0], verdict: Verdict::Put(Half::Aside) });
    let recall = |passes: u32, checkpoint: &str| Request::Recall {
        settings: settings(passes),
        decisions: decisions.clone(),
        checkpoint: checkpoint.to_owned(),
    };
    let said = pump(&mut other, 4, recall(3, &checkpoint));
    assert_eq!(only(said), Event::Trained(report), "and nothing is judged or learned");
    assert_eq!(entries(&mut other), learned);
    assert_eq!(care(&mut other, Request::Care).train, 10, "the rows stand as they did");
    let said = refused(&mut other, recall(3, "none"));
    assert!(said.starts_with("The checkpoint cannot be read: "), "{said}");
    let said = refused(&mut other, recall(4, &checkpoint));
    assert!(said.starts_with("The run cannot go on: "), "{said}");
}

#[test]
fn a_model_that_was_given_is_looked_at_as_long_as_none_was_trained() {
    let mut engine = sheet();
    let all = Request::Entries { view: EntryView::default(), offset: 0, count: 50 };
    let said = refused(&mut engine, all.clone());
    assert_eq!(said, "There is no model yet: train one, or open one.");
    let report = trained(&mut sheet(), learn(2));
    let give = Request::KeepModel { text: report.model.clone() };
    assert_eq!(only(pump(&mut engine, 2, give)), Event::Heard);
    let Event::Entries(given) = only(pump(&mut engine, 3, all)) else { panic!() };
    assert_eq!(given.total as usize, report.entries);
    let said = refused(&mut engine, Request::KeepModel { text: "none".to_owned() });
    assert!(said.starts_with("The model cannot be read: "), "{said}");
}

/// All that is to be seen of a model that was asked about every row.
fn seen(
    engine: &mut Engine<Learner>,
    model: &str,
    known: Vec<Answered>,
) -> (Window, Errors, EntryWindow, RowReading) {
    let rules = Rules::default();
    care(engine, Request::Audit { model: Some(model.to_owned()), rules, known });
    let view = View::default();
    let Event::Window(rows) =
        only(pump(engine, 2, Request::Window { view, offset: 0, count: 100 }))
    else {
        panic!()
    };
    let Event::Errors(errors) = only(pump(engine, 3, Request::Errors)) else { panic!() };
    let Event::RowReading(row) = only(pump(engine, 4, Request::ReadRow { row: 3 })) else {
        panic!()
    };
    (*rows, *errors, entries(engine), *row)
}

#[test]
fn several_engines_make_of_the_rows_what_one_makes_of_them() {
    // Of a run that is far from its end, so that there are errors.
    let mut engine = sheet();
    care(&mut engine, Request::Decide { rows: vec![1, 4, 7], verdict: Verdict::Put(Half::Aside) });
    let model = trained(&mut engine, learn(1)).model;
    let alone = seen(&mut sheet(), &model, Vec::new());
    assert!(!alone.1.commands.is_empty(), "{:?}", alone.1);
    let part = |part: u32| {
        let ask = Request::AskPart { model: model.clone(), part, of: 5 };
        match pump(&mut sheet(), 9, ask).pop() {
            Some(Event::Answered { commands }) => commands,
            other => panic!("{other:?}"),
        }
    };
    let parts = [4, 1, 0, 3, 2].map(part).concat();
    assert_eq!(parts.iter().map(|answered| answered.rows.len()).sum::<usize>(), 12);
    assert_eq!(seen(&mut sheet(), &model, parts.clone()), alone);
    // What lacks is asked here, and what is there twice counts once.
    let some: Vec<Answered> = parts.iter().take(3).chain(parts.iter().take(2)).cloned().collect();
    assert_eq!(seen(&mut sheet(), &model, some), alone);
    let mut engine = sheet();
    engine.start(1, Request::AskPart { model: "none".to_owned(), part: 0, of: 1 });
    assert!(matches!(next(&mut engine), (1, Event::Refused { .. })));
}
