//! A sheet of a hundred thousand rows: it is read, looked at, sorted, marked and decided on, and what crosses stays small.

use super::{next, only, pump};
use groundling::learn::experiment::By;
use groundling::learn::sheet::Sort;
use groundling::worker::protocol::{
    CorpusFile, Envelope, Event, MappedFile, Mapping, Request, Rules, Split, VERSION, Verdict,
    View, encode,
};
use groundling::worker::{Engine, Learner};

const ROWS: usize = 100_000;

const PRE: &str = r#"{"agent":{"x":1,"y":1,"direction":"east"},"rooms":[{"name":"r","color":"red","left":0,"bottom":0,"right":3,"top":3}],"doors":[],"objects":[]}"#;

fn file() -> Vec<u8> {
    let post = PRE.replacen("\"x\":1", "\"x\":2", 1);
    let row = |n: usize| {
        format!(
            "{{\"id\":\"a\",\"command\":\"go to cell {n}\",\"task\":\"t{}\",\"worker\":\"w{}\",\"pairs\":[{{\"pre\":{PRE},\"post\":{post}}}]}}\n",
            n % 23,
            n % 997
        )
    };
    (0..ROWS).map(row).collect::<String>().into_bytes()
}

/// What a request brings about, and how many bytes of it cross.
fn ask(engine: &mut Engine<Learner>, what: &str, request: Request) -> Event {
    let event = only(pump(engine, 2, request));
    let sent = Envelope { groundling: VERSION, id: 2, body: event.clone() };
    let bytes = encode(&sent).unwrap().len();
    assert!(bytes < 200_000, "{what}: {bytes} bytes");
    event
}

#[test]
fn a_hundred_thousand_rows_are_worked_on() {
    let bytes = file();
    let mut engine = Engine::new();
    let mapped = MappedFile {
        file: CorpusFile { name: "large.jsonl".to_owned(), bytes: bytes.into() },
        mapping: Mapping::default(),
    };
    engine.start(1, Request::OpenSheet { files: vec![mapped], with_rejected: false });
    let mut reports = 0;
    let report = loop {
        match next(&mut engine) {
            (_, Event::Reading { .. }) => reports += 1,
            (_, Event::Sheet(report)) => break report,
            other => panic!("{other:?}"),
        }
    };
    assert!(reports > 100, "{reports}");
    assert_eq!((report.care.rows, report.faults.len()), (ROWS as u32, 0));
    let window = |engine: &mut Engine<Learner>, what: &str, view: View, offset: u32| {
        let request = Request::Window { view, offset, count: 60 };
        match ask(engine, what, request) {
            Event::Window(window) => *window,
            other => panic!("{other:?}"),
        }
    };
    let all = window(&mut engine, "all", View::default(), 99_990);
    assert_eq!(
        (all.total, all.lines.len(), all.lines[9].command.as_str()),
        (100_000, 10, "go to cell 99999")
    );
    let sorted = View { sort: Sort::Command, descending: true, ..View::default() };
    assert_eq!(
        window(&mut engine, "sorted", sorted.clone(), 0).lines[0].command,
        "go to cell 99999"
    );
    window(&mut engine, "scrolled", sorted, 50_000);
    let found =
        View { text: "cell 777".to_owned(), task: Some("t18".to_owned()), ..View::default() };
    let total = window(&mut engine, "found", found.clone(), 0).total;
    assert_eq!(
        total as usize,
        (0..ROWS).filter(|n| n.to_string().contains("777") && n % 23 == 18).count()
    );
    assert!(matches!(ask(&mut engine, "facets", Request::Facets), Event::Facets(_)));
    let Event::Care(_) = ask(&mut engine, "marked", Request::Mark { rules: Rules::default() })
    else {
        panic!()
    };
    let verdict = Verdict::Reject("no such cell".to_owned());
    let Event::Care(care) =
        ask(&mut engine, "decided", Request::DecideAll { view: found, verdict })
    else {
        panic!()
    };
    assert_eq!(care.rejected, total);
    let split = Split::Share { by: By::Worker, percent: 20, seed: 3 };
    let Event::Care(care) = ask(&mut engine, "parted", Request::Divide { split }) else { panic!() };
    assert!(care.held_out > 18_000 && care.held_out <= 20_000, "{care:?}");
    let Event::Care(care) = ask(&mut engine, "undone", Request::Undo) else { panic!() };
    assert_eq!(care.held_out, 0);
}
