//! A corpus that is worked on in the engine: files, windows, decisions, splits, training that rests and goes on, what a
//! model makes of the rows and what it learned.

use super::{SIX, file, learn, next, only, pump, refused, settings, six};
use groundling::learn::experiment::By;
use groundling::learn::sheet::Deed;
use groundling::worker::protocol::{
    Care, Decision, EntryView, Envelope, Event, Form, Half, Lexicon, MappedFile, Mapping, Outcome,
    Request, Rule, Rules, Settings, SheetReport, Split, Status, VERSION, Verdict, View, Window,
    decode, encode,
};
use groundling::worker::{Engine, Learner};

/// Everything that a request brings about; each event comes back from the wire.
#[track_caller]
fn ask(engine: &mut Engine<Learner>, request: Request) -> Vec<Event> {
    let sent = Envelope { groundling: VERSION, id: 7, body: request };
    let request = decode::<Request>(&encode(&sent).unwrap()).unwrap().body;
    assert_eq!(request, sent.body);
    let events = pump(engine, 7, request);
    for body in events.iter().cloned() {
        let sent = Envelope { groundling: VERSION, id: 7, body };
        let bytes = encode(&sent).unwrap();
        assert_eq!(decode::<Event>(&bytes).as_ref(), Ok(&sent));
        assert!(decode::<Event>(&bytes[..bytes.len() - 1]).is_err());
    }
    events
}

fn open(engine: &mut Engine<Learner>, files: Vec<MappedFile>) -> SheetReport {
    match ask(engine, Request::OpenSheet { files, with_rejected: false }).pop() {
        Some(Event::Sheet(report)) => *report,
        other => panic!("{other:?}"),
    }
}

pub(super) fn care(engine: &mut Engine<Learner>, request: Request) -> Care {
    match ask(engine, request).pop() {
        Some(Event::Care(care)) => care,
        other => panic!("{other:?}"),
    }
}

fn window(engine: &mut Engine<Learner>, view: View) -> Window {
    match only(ask(engine, Request::Window { view, offset: 0, count: 100 })) {
        Event::Window(window) => *window,
        other => panic!("{other:?}"),
    }
}

fn rows(window: &Window) -> Vec<u32> {
    window.lines.iter().map(|line| line.row).collect()
}

/// The six sentences, and the same as JSON lines with a worker each, of which the second is rejected.
pub(super) fn sheet() -> Engine<Learner> {
    let mut engine = Engine::new();
    let lines = six().into_iter().enumerate().map(|(at, example)| {
        let pair = &example.pairs[0];
        let status = if at == 1 { ", \"AssignmentStatus\": \"Rejected\", \"Reject\": \"wrong\"" } else { "" };
        format!(
            "{{\"command\": \"please {}\", \"worker\": \"w{}\", \"task\": \"t{}\"{status}, \"pairs\": [{{\"pre\": {}, \"post\": {}}}]}}\n",
            example.command, at % 2, at / 3, pair.pre.write(), pair.post.write()
        )
    });
    let report = open(
        &mut engine,
        vec![file("six.csv", SIX), file("more.jsonl", &lines.collect::<String>())],
    );
    assert_eq!((report.care.rows, report.care.train, report.care.rejected), (12, 11, 1));
    assert_eq!(report.files.iter().map(|file| file.rows).collect::<Vec<_>>(), [6, 6]);
    engine
}

#[test]
fn what_was_decided_holds_for_the_same_rows_once_more() {
    let mut engine = sheet();
    let why = Verdict::Reject("too, \"vague\"".to_owned());
    care(&mut engine, Request::Decide { rows: vec![2, 3, 5], verdict: why });
    care(&mut engine, Request::Decide { rows: vec![0], verdict: Verdict::Approve });
    care(&mut engine, Request::Decide { rows: vec![7], verdict: Verdict::Reopen });
    care(&mut engine, Request::Decide { rows: vec![8, 9], verdict: Verdict::Put(Half::HeldOut) });
    let text = |engine: &mut Engine<Learner>| match only(ask(engine, Request::Decisions)) {
        Event::Decisions { text } => text,
        other => panic!("{other:?}"),
    };
    let (decided, lines) = (text(&mut engine), window(&mut engine, View::default()).lines);
    let mut other = sheet();
    assert_ne!(text(&mut other), decided);
    let after = care(&mut other, Request::TakeDecisions { text: decided.clone() });
    assert_eq!((after.rejected, after.held_out), (3, 2));
    assert_eq!(
        (text(&mut other), window(&mut other, View::default()).lines),
        (decided.clone(), lines)
    );
    for wrong in
        [&decided.replace("\"8-9\"", "\"8-99\""), "{}", &decided.replacen("corpus", "korpus", 1)]
    {
        let said = refused(&mut other, Request::TakeDecisions { text: wrong.to_owned() });
        assert!(said.starts_with("The decisions cannot be read: "), "{said}");
    }
    let mut six = Engine::<Learner>::new();
    open(&mut six, vec![file("six.csv", SIX)]);
    let said = refused(&mut six, Request::TakeDecisions { text: decided });
    assert_eq!(said, "The decisions cannot be read: they are of other rows.");
}

#[test]
fn a_window_has_what_its_view_says() {
    let mut engine = sheet();
    let all = window(&mut engine, View::default());
    assert_eq!((all.total, all.lines.len()), (12, 12));
    assert_eq!(all.lines[6].worker.as_deref(), Some("w0"));
    assert_eq!((all.lines[7].file, all.lines[7].line), (1, 2));
    assert_eq!(all.lines[7].decision, Decision::Rejected("wrong".into()));
    let text = |text: &str| Some(text.to_owned());
    for (view, wanted) in [
        (View { text: "PLEASE".to_owned(), ..View::default() }, vec![6, 7, 8, 9, 10, 11]),
        (View { text: "plea zzz".to_owned(), ..View::default() }, vec![]),
        (View { worker: text("w1"), ..View::default() }, vec![7, 9, 11]),
        (
            View { worker: text(""), file: Some(0), ..View::default() },
            window(&mut engine, View { file: Some(0), ..View::default() })
                .lines
                .iter()
                .filter(|line| line.worker.is_none())
                .map(|line| line.row)
                .collect(),
        ),
        (View { task: text("t1"), descending: true, ..View::default() }, vec![11, 10, 9]),
        (View { status: Some(Status::Rejected), ..View::default() }, vec![7]),
        (View { half: Some(Half::HeldOut), ..View::default() }, vec![]),
        (View { file: Some(1), worker: text("w0"), ..View::default() }, vec![6, 8, 10]),
    ] {
        assert_eq!(rows(&window(&mut engine, view.clone())), wanted, "{view:?}");
    }
    let sorted = window(
        &mut engine,
        View { sort: groundling::learn::sheet::Sort::Command, ..View::default() },
    );
    assert!(sorted.lines.is_sorted_by(|a, b| a.command <= b.command));
    let Event::Window(part) =
        only(ask(&mut engine, Request::Window { view: View::default(), offset: 10, count: 5 }))
    else {
        panic!()
    };
    assert_eq!((part.total, part.offset, rows(&part)), (12, 10, vec![10, 11]));
    let Event::Facets(facets) = only(ask(&mut engine, Request::Facets)) else { panic!() };
    assert_eq!(facets.files, [6, 6]);
    assert_eq!(facets.halves, [(Half::Train, 12)]);
    assert!(facets.workers.values.contains(&("w1".to_owned(), 3)), "{facets:?}");
    assert!(facets.statuses.contains(&(Status::Rejected, 1)));
}

#[test]
fn decisions_are_undone_done_again_and_saved() {
    let mut engine = sheet();
    let reject = |why: &str| Verdict::Reject(why.to_owned());
    let short =
        View { text: "please".to_owned(), worker: Some("w0".to_owned()), ..View::default() };
    let after =
        care(&mut engine, Request::DecideAll { view: short, verdict: reject("too polite") });
    assert_eq!((after.train, after.rejected), (8, 4));
    assert_eq!(after.done.map(|done| (done.deed, done.rows)), Some((Deed::Reject, 3)));
    let after =
        care(&mut engine, Request::Decide { rows: vec![7, 7, 99], verdict: Verdict::Approve });
    assert_eq!((after.train, after.rejected), (9, 3));
    let same = care(&mut engine, Request::Decide { rows: vec![7], verdict: Verdict::Approve });
    assert_eq!((same.done, same.undo.map(|done| done.deed)), (None, Some(Deed::Approve)));
    let put = care(
        &mut engine,
        Request::Decide { rows: vec![0, 1], verdict: Verdict::Put(Half::HeldOut) },
    );
    assert_eq!((put.train, put.held_out), (7, 2));
    for (request, train) in [
        (Request::Undo, 9),
        (Request::Undo, 8),
        (Request::Redo, 9),
        (Request::Redo, 7),
        (Request::Redo, 7),
    ] {
        assert_eq!(care(&mut engine, request).train, train);
    }
    let Event::Saved { name, bytes } =
        only(ask(&mut engine, Request::SaveSheet { file: 1, form: None }))
    else {
        panic!()
    };
    assert_eq!(name, "more-decided.jsonl");
    let saved = String::from_utf8(bytes).unwrap();
    assert_eq!(saved.matches("too polite").count(), 3);
    let mut again = Engine::new();
    let report = open(&mut again, vec![file("more.jsonl", &saved)]);
    assert_eq!((report.care.rows, report.care.rejected), (6, 3));
    let Event::Saved { name, bytes } =
        only(ask(&mut engine, Request::SaveSheet { file: 1, form: Some(Form::Csv) }))
    else {
        panic!()
    };
    assert_eq!(name, "more-decided.csv");
    assert_eq!(
        open(&mut again, vec![file("b", &String::from_utf8(bytes).unwrap())]).care.rejected,
        3
    );
    // What nobody decided is as it was.
    care(&mut engine, Request::Undo);
    let Event::Saved { bytes, .. } =
        only(ask(&mut engine, Request::SaveSheet { file: 0, form: None }))
    else {
        panic!()
    };
    assert_eq!(open(&mut again, vec![file("b", &String::from_utf8(bytes).unwrap())]).care.rows, 6);
    assert_eq!(
        refused(&mut engine, Request::SaveSheet { file: 2, form: None }),
        "There is no file 2."
    );
}

#[test]
fn bad_rows_are_saved_to_be_mended_even_when_all_are_bad() {
    let broken = SIX.replacen("\"\"red\"\"", "\"\"rde\"\"", 1);
    let mut engine = Engine::new();
    let report = open(&mut engine, vec![file("six.csv.gz", &broken)]);
    assert_eq!(
        (report.files[0].rows, report.files[0].left_out, report.files[0].bad_rows),
        (5, 1, 1)
    );
    let fault = &report.faults[0];
    assert_eq!((fault.file, fault.line, fault.kept), (0, 2, false));
    assert!(
        fault.what.contains("rde")
            && fault.mend.as_deref().is_some_and(|mend| mend.contains("red")),
        "{fault:?}"
    );
    let save =
        |engine: &mut Engine<Learner>| match only(ask(engine, Request::SaveBadRows { file: 0 })) {
            Event::Saved { name, bytes } => (name, String::from_utf8(bytes).unwrap()),
            other => panic!("{other:?}"),
        };
    let (name, text) = save(&mut engine);
    assert_eq!(name, "six-bad.csv");
    let report = open(&mut engine, vec![file(&name, &text)]);
    assert!(report.files[0].useless.is_some());
    assert_eq!(report.care.rows, 5, "what was open stays");
    assert_eq!(save(&mut engine).1, text, "bad rows of what was refused are there, too");
    assert_eq!(open(&mut engine, vec![file("b", &text.replace("rde", "red"))]).care.rows, 1);
    assert_eq!(refused(&mut engine, Request::SaveBadRows { file: 0 }), "b has no bad rows.");
}

#[test]
fn a_sheet_is_parted_by_share_by_name_and_by_hand() {
    let mut engine = sheet();
    let share = |by, percent, seed| Request::Divide { split: Split::Share { by, percent, seed } };
    let held = |engine: &mut Engine<Learner>| {
        rows(&window(engine, View { half: Some(Half::HeldOut), ..View::default() }))
    };
    let after = care(&mut engine, share(By::Row, 25, 1));
    assert_eq!((after.held_out + after.train, held(&mut engine).len()), (11, 3));
    let first = held(&mut engine);
    care(&mut engine, share(By::Row, 25, 2));
    assert_ne!(held(&mut engine), first, "another seed");
    care(&mut engine, share(By::Row, 25, 1));
    assert_eq!(held(&mut engine), first, "the same seed");
    care(&mut engine, share(By::Worker, 30, 0));
    assert_eq!(held(&mut engine).len(), 3, "all that one of them said");
    care(&mut engine, share(By::Task, 60, 0));
    assert!(held(&mut engine).len() >= 3);
    let names = vec!["t1".to_owned()];
    care(&mut engine, Request::Divide { split: Split::Named { workers: false, names } });
    assert_eq!(held(&mut engine), [9, 10, 11]);
    care(&mut engine, Request::Divide { split: Split::None });
    assert!(held(&mut engine).is_empty());
    care(&mut engine, Request::Undo);
    assert_eq!(held(&mut engine), [9, 10, 11]);
    let said = refused(&mut engine, share(By::Row, 100, 0));
    assert_eq!(said, "The share that is held out must be between 1 and 99 percent.");
}

#[test]
fn a_run_rests_is_looked_at_and_goes_on_from_a_checkpoint_in_another_engine() {
    let mut engine = sheet();
    care(&mut engine, Request::Decide { rows: vec![10, 11], verdict: Verdict::Put(Half::HeldOut) });
    let whole = ask(&mut engine, learn(3));
    let held: Vec<u32> = whole
        .iter()
        .filter_map(|event| match event {
            Event::HeldOut { epoch, judgement } => {
                assert_eq!(judgement.total, 2);
                Some(*epoch)
            }
            _ => None,
        })
        .collect();
    assert_eq!(held, [1, 2, 3, 4], "after every epoch, and in the end");
    let Some(Event::Trained(uninterrupted)) = whole.last().cloned() else { panic!() };
    engine.start(5, learn(3));
    engine.start(6, Request::Pause);
    assert_eq!(next(&mut engine), (6, Event::Heard));
    assert_eq!(next(&mut engine), (5, Event::Paused));
    assert!(!engine.busy() && engine.step().is_none(), "it rests");
    assert_eq!(only(ask(&mut engine, Request::Look)), Event::Look(None));
    let mut checkpoints = Vec::new();
    for (request, stops) in [
        (Request::StepExample, (1, 1)),
        (Request::StepExample, (1, 2)),
        (Request::StepEpoch, (1, 9)),
        (Request::StepExample, (2, 1)),
        (Request::StepEpoch, (2, 9)),
    ] {
        engine.start(8, request);
        let mut last = None;
        while engine.busy() {
            match next(&mut engine) {
                (8, Event::Heard) | (5, Event::HeldOut { .. } | Event::Paused) => {}
                (5, Event::Progress(progress)) => last = Some((progress.epoch, progress.example)),
                other => panic!("{other:?}"),
            }
        }
        assert_eq!(last, Some(stops));
        let Event::Look(Some(look)) = only(ask(&mut engine, Request::Look)) else { panic!() };
        assert!(!look.forms.is_empty() && !look.command.is_empty(), "{look:?}");
        let Event::Checkpoint(checkpoint) = only(ask(&mut engine, Request::Checkpoint)) else {
            panic!()
        };
        assert_eq!((checkpoint.epoch, checkpoint.example), stops);
        checkpoints.push(checkpoint.text);
    }
    // One in the middle of a run, which goes on to the end of the command for it.
    engine.start(9, Request::Resume);
    engine.start(10, Request::Checkpoint);
    let mut last = None;
    while engine.busy() {
        match next(&mut engine) {
            (10, Event::Checkpoint(checkpoint)) => checkpoints.push(checkpoint.text),
            (_, event) => last = Some(event),
        }
    }
    assert_eq!(last, Some(Event::Trained(uninterrupted.clone())));
    let mut other = sheet();
    care(&mut other, Request::Decide { rows: vec![10, 11], verdict: Verdict::Put(Half::HeldOut) });
    for text in checkpoints {
        let events = ask(&mut other, Request::Learn { settings: settings(3), resume: Some(text) });
        assert_eq!(events.last(), Some(&Event::Trained(uninterrupted.clone())), "the same bytes");
    }
    let said =
        refused(&mut other, Request::Learn { settings: settings(4), resume: Some("x".to_owned()) });
    assert!(said.starts_with("The checkpoint cannot be read"), "{said}");
}

#[test]
fn settings_and_what_is_done_without_reach_training() {
    let mut engine = sheet();
    let without = [groundling::ccg::Kind::Pair, groundling::ccg::Kind::Template];
    let some = Settings { without: without.into(), margin: 1.0, idioms: false, ..*settings(2) };
    let Some(Event::Trained(report)) =
        ask(&mut engine, Request::Learn { settings: Box::new(some), resume: None }).pop()
    else {
        panic!()
    };
    let weights = |kind: &str| {
        report
            .model
            .lines()
            .filter(|line| line.starts_with(&format!("weight\t{kind}\t")))
            .map(|line| line.rsplit('\t').next().unwrap().to_owned())
            .collect::<Vec<_>>()
    };
    assert!(!weights("pair").is_empty() && weights("pair").iter().all(|weight| weight == "0"));
    assert!(weights("template").iter().all(|weight| weight == "0"));
    assert!(report.model.contains("fact\tmargin\t1\n"));
    assert!(report.model.contains("fact\twithout\ttemplate pair\n"));
    for (bad, said) in [
        (Settings { margin: f64::NAN, ..*settings(1) }, "The margin must be between 0 and 1000."),
        (Settings { epochs: 0, ..*settings(1) }, "The epochs must be between 1 and 1000."),
        (
            Settings { lexicon: Lexicon::Own("x".to_owned()), ..*settings(1) },
            "The seed lexicon cannot be read: line 1: a line is words :- CATEGORY : meaning.",
        ),
    ] {
        engine.start(3, Request::Learn { settings: Box::new(bad), resume: None });
        assert_eq!(next(&mut engine), (3, Event::Refused { message: said.to_owned() }));
    }
}

#[test]
fn every_row_is_judged_and_what_the_model_learned_is_shown() {
    let mut engine = sheet();
    assert_eq!(refused(&mut engine, Request::Errors), "No model was asked about the rows yet.");
    let none = Request::Audit { model: None, rules: Rules::default(), known: Vec::new() };
    assert_eq!(
        refused(&mut engine, none.clone()),
        "There is no model yet: train one, or open one."
    );
    care(
        &mut engine,
        Request::Divide {
            split: Split::Named { workers: false, names: vec!["t0".to_owned(), "t1".to_owned()] },
        },
    );
    let Some(Event::Trained(report)) = ask(&mut engine, learn(4)).pop() else { panic!() };
    let events = ask(&mut engine, none);
    assert!(matches!(events[0], Event::Auditing { done: 1, of: 12 }), "{:?}", events[0]);
    let judged = window(&mut engine, View::default());
    assert!(
        judged.lines[..6].iter().all(|line| line.outcome == Some(Outcome::Right)),
        "{judged:?}"
    );
    assert!(judged.lines[..6].iter().all(|line| line.form.is_some() && line.marks.is_empty()));
    let Event::RowReading(read) = only(ask(&mut engine, Request::ReadRow { row: 0 })) else {
        panic!()
    };
    assert!(read.readings[0].1.iter().all(|valid| *valid), "{:?}", read.readings[0].1);
    assert_eq!(read.readings[0].0.form, judged.lines[0].form.clone().unwrap());
    // A line's form is as it is printed, and the reading's as well.
    // What is used most comes first.
    let entries = |engine: &mut Engine<Learner>, learned| {
        let view = EntryView { learned, ..EntryView::default() };
        let asked = Request::Entries { view, offset: 0, count: 50 };
        let Event::Entries(found) = only(ask(engine, asked)) else { panic!() };
        found
    };
    let learned = entries(&mut engine, true);
    let top = &learned.lines[0];
    assert!(
        top.uses.count > 0
            && top.from.as_deref().is_some_and(|from| from.contains(&top.entry.words)),
        "{top:?}"
    );
    let places = vec![top.place];
    let Event::Trained(less) = only(ask(&mut engine, Request::Without { places })) else {
        panic!()
    };
    assert_eq!(less.entries + 1, report.entries);
    let compare = Request::Compare { first: report.model.clone(), second: less.model.clone() };
    let Event::Difference(found) = only(ask(&mut engine, compare)) else { panic!() };
    assert_eq!((found.first_alone.count, found.second_alone.count), (1, 0));
    assert_eq!(found.first_alone.first[0].0, top.entry);
    assert!(found.entries.is_empty() && found.features.is_empty(), "{found:?}");
    care(
        &mut engine,
        Request::Audit {
            model: Some(less.model),
            rules: Rules { least_words: 9, ..Rules::default() },
            known: Vec::new(),
        },
    );
    let Event::Errors(errors) = only(ask(&mut engine, Request::Errors)) else { panic!() };
    assert!(
        !errors.commands.is_empty()
            && errors.unknown.iter().any(|(word, _)| top.entry.words.contains(word)),
        "{errors:?}"
    );
    let invalid = window(&mut engine, View { rule: Some(Rule::Invalid), ..View::default() });
    assert!(
        invalid.total > 0 && invalid.lines.iter().all(|line| line.outcome != Some(Outcome::Right))
    );
    assert!(window(&mut engine, View { rule: Some(Rule::Short), ..View::default() }).total > 0);

    // What was learned is that of the model that came last.
    assert_eq!(entries(&mut engine, false).total as usize, less.entries);
    let Some(Event::Trained(again)) = ask(&mut engine, learn(4)).pop() else { panic!() };
    let whole = entries(&mut engine, false);
    assert_eq!((whole.total as usize, again.entries), (report.entries, report.entries));
    assert!(whole.lines.iter().all(|line| line.uses.count == 0), "it was not asked yet");
}

#[test]
fn columns_are_mapped_after_a_look_at_the_file() {
    let own = SIX.replacen("Answer.command", "Instruction", 1).replacen("Input.task", "kind", 1);
    let MappedFile { file, .. } = file("own.csv", &own);
    let mut engine = Engine::new();
    let report =
        open(&mut engine, vec![MappedFile { file: file.clone(), mapping: Mapping::default() }]);
    assert_eq!(report.care.rows, 0);
    assert!(report.files[0].useless.as_deref().unwrap().contains("Answer.command is missing"));
    let Event::Previewed(found) = only(ask(&mut engine, Request::Preview { file: file.clone() }))
    else {
        panic!()
    };
    assert_eq!(found.proposal.command.as_deref(), Some("Instruction"));
    assert_eq!(found.rows.len(), 5);
    let mapping = found.proposal;
    let report = open(&mut engine, vec![MappedFile { file, mapping: mapping.clone() }]);
    assert_eq!((report.care.rows, &report.files[0].mapping), (6, &mapping));
    let Event::Saved { bytes, .. } =
        only(ask(&mut engine, Request::SaveSheet { file: 0, form: None }))
    else {
        panic!()
    };
    let header = String::from_utf8(bytes).unwrap();
    assert!(header.lines().next().unwrap().contains("\"Instruction\""), "names stay");
    let picture = groundling::worker::protocol::CorpusFile {
        name: "a.xlsx".to_owned(),
        bytes: b"PK\x03\x04".to_vec().into(),
    };
    let said = refused(&mut engine, Request::Preview { file: picture });
    assert!(said.starts_with("a.xlsx: this is a spreadsheet"), "{said}");
}
