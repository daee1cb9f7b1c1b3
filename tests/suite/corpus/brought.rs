//! What people bring: files as other programs write them (a data suite), and files that are far too much. Each is read,
//! or refused in words, in linear time and bounded steps.

use super::{PRE, csv, post};
use crate::plain_words::spoken;
use groundling::corpus::{Corpus, Flaw, Options, Reading, Rows, limits::MAX_COLUMNS, read};
use std::io::Cursor;

/// The bytes of a case's file.
fn file(text: &str) -> Vec<u8> {
    let post = post();
    let cell = |state: &str| format!("\"{}\"", state.replace('"', "\"\""));
    let string = |state: &str| serde_json::to_string(state).unwrap();
    let text = text
        .replace("@PRE", &cell(PRE))
        .replace("@POST", &cell(&post))
        .replace("@\"pairs\"", &string(&format!("[{{\"pre\":{PRE},\"post\":{post}}}]")))
        .replace("@\"pre\"", &string(PRE))
        .replace("@\"post\"", &string(&post))
        .replace("@pre", PRE)
        .replace("@post", &post)
        .replace('»', "\t")
        .replace("‹mark›", "\u{feff}");
    let parts: Vec<&[u8]> = text.split('¿').map(str::as_bytes).collect();
    parts.join(&0xE9)
}

fn counts(corpus: &Corpus) -> String {
    format!("{} {} {}", corpus.examples.len(), corpus.rejected, corpus.left_out)
}

fn said(flaws: &[Flaw]) -> String {
    flaws.iter().map(|flaw| format!("{flaw}\n")).collect()
}

#[test]
fn files_of_other_programs_are_read() {
    let all = include_str!("../../data/corpus/brought.txt");
    let cases: Vec<&str> = all.split("=== ").skip(1).collect();
    assert!(cases.len() > 30);
    for case in cases {
        let (head, text) = case.split_once('\n').unwrap();
        let (name, wanted) = head.split_once(" => ").unwrap();
        let (wanted, message) = wanted.split_once(" |").unwrap();
        for bytes in [file(text), file(text.trim_end()), file(&text.replace('\n', "\r\n"))] {
            let (corpus, flaws) = read(bytes.as_slice(), Options::default());
            let told = said(&flaws);
            assert_eq!(counts(&corpus), wanted, "{name}: {told}");
            assert!(told.contains(message.trim()), "{name}: {told}");
            assert_eq!(flaws.is_empty(), message.trim().is_empty(), "{name}: {told}");
            assert!(spoken(&told).is_none() && told.len() < 2_000, "{name}: {told}");
            assert!(corpus.examples.iter().all(|e| e.command.starts_with("go east")), "{name}");
            let nothing = ["NA", "", "null"].map(Some);
            let names = |e: &groundling::corpus::Example| {
                [e.task.clone(), e.worker.clone(), Some(e.id.clone())]
            };
            let is_nothing = |name: Option<String>| nothing.contains(&name.as_deref());
            assert!(!corpus.examples.iter().flat_map(names).any(is_nothing), "{name}");
        }
    }
}

#[test]
fn utf_16_is_read_in_both_orders() {
    let text =
        String::from_utf8(file("Input.pre_1»Input.post_1»Answer.command\n@PRE»@POST»go east 🤖\n"))
            .unwrap();
    let units: Vec<u16> = "\u{feff}".encode_utf16().chain(text.encode_utf16()).collect();
    let little: Vec<u8> = units.iter().flat_map(|unit| unit.to_le_bytes()).collect();
    let big: Vec<u8> = units.iter().flat_map(|unit| unit.to_be_bytes()).collect();
    for bytes in [little, big] {
        // A stream that gives an odd number of bytes at a time.
        let stream = Trickle(Cursor::new(bytes));
        let (corpus, flaws) = read(stream, Options::default());
        assert_eq!(flaws, []);
        assert_eq!(corpus.examples[0].command, "go east 🤖");
    }
}

struct Trickle(Cursor<Vec<u8>>);

impl std::io::Read for Trickle {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        let most = into.len().min(7);
        self.0.read(&mut into[..most])
    }
}

#[test]
fn what_keeps_rejected_rows_is_said_when_there_are_no_others() {
    let rows = "Input.pre_1,Input.post_1,Answer.command,Reject\n@PRE,@POST,go east,no\n@PRE,@POST,go east,no\n";
    let (corpus, flaws) = read(file(rows).as_slice(), Options::default());
    assert_eq!(corpus.why_empty(&flaws).unwrap(), "all its 2 rows are rejected");
    let (corpus, flaws) =
        read(file(rows).as_slice(), Options { with_rejected: true, ..Options::default() });
    assert_eq!((corpus.why_empty(&flaws), corpus.examples.len()), (None, 2));
}

/// What reading a file in steps comes to.
struct Steps {
    /// How many there were.
    n: usize,
    /// The most bytes that one took of the file: what its work is in proportion to.
    longest: u64,
    corpus: Corpus,
    flaws: Vec<Flaw>,
}

fn steps(bytes: Vec<u8>) -> Steps {
    let mut reading = Reading::new(Cursor::new(bytes), Options::default()).unwrap();
    let (mut n, mut longest) = (0, 0);
    loop {
        let before = reading.bytes();
        let goes_on = reading.step();
        longest = longest.max(reading.bytes() - before);
        n += 1;
        if !goes_on {
            let (corpus, flaws) = reading.end();
            return Steps { n, longest, corpus, flaws };
        }
    }
}

/// The most bytes that a step may take.
const MOST_BYTES: u64 = 64 << 10;

#[test]
fn a_line_that_does_not_end_is_refused_in_words_and_in_steps() {
    let wide: String = (0..80_000).map(|n| format!("0.{n:09},")).collect();
    let Steps { longest, flaws, .. } = steps(wide.into_bytes());
    assert!(said(&flaws).contains("the first line has more than 16384 cells"), "{flaws:?}");
    assert!(longest <= MOST_BYTES, "{longest}");
    let Steps { n, longest, flaws, .. } = steps(vec![b'x'; 40 << 20]);
    assert!(n > 500 && said(&flaws).contains("a cell of it is too large"), "{n}: {flaws:?}");
    assert!(longest <= MOST_BYTES, "{longest}");
    let list = [b"[".repeat(1_000), b"{\"a\":".repeat(1 << 20)].concat();
    let Steps { longest, flaws, .. } = steps(list);
    assert!(!flaws.is_empty() && longest <= MOST_BYTES, "{longest}");
    let quoted =
        [&b"Input.pre_1,Input.post_1,Answer.command\n\""[..], &b"x\n".repeat(4 << 20)].concat();
    let Steps { longest, flaws, .. } = steps(quoted);
    assert!(said(&flaws).contains("more than 100000 rows"), "{}", flaws.len());
    assert!(longest <= MOST_BYTES, "{longest}");
}

#[test]
fn quotes_that_swallow_rows_are_given_up_in_linear_time() {
    let row = "\"a\"\"\n".repeat(200_000);
    let Steps { n, flaws, .. } =
        steps(format!("Input.pre_1,Input.post_1,Answer.command\n{row}").into_bytes());
    assert!(n < 1_000_000 && flaws.len() < 1_100, "{n}, {}", flaws.len());
}

#[test]
fn columns_are_found_once_and_cost_little_more_than_their_bytes() {
    let header: String = (0..3_000).map(|n| format!(",c{n}")).collect();
    let row = format!("@PRE,@POST,go east{}\n", ",".repeat(3_000));
    let text = format!("Input.pre_1,Input.post_1,Answer.command{header}\n{}", row.repeat(200));
    let (corpus, flaws) = csv(file(&text));
    assert_eq!((corpus.examples.len(), flaws.len()), (200, 0));
    assert_eq!(corpus.examples[0].rest.len(), 3_000);
    let Steps { n, longest, corpus, flaws } = steps(file(&text));
    assert!((n as u64) > 200 && longest <= MOST_BYTES && flaws.is_empty(), "{n}, {longest}");
    assert_eq!(corpus.examples.len(), 200);
    let most = "x,".repeat(MAX_COLUMNS - 4) + "Input.pre_1,Input.post_1,Answer.command\n";
    let mut rows = Rows::new(Cursor::new(most), Options::default()).unwrap();
    while rows.header().is_none() {
        rows.step().unwrap();
    }
    let header = rows.header().unwrap();
    assert_eq!((header.pairs.as_slice(), header.command), (&[(16_380, 16_381)][..], Some(16_382)));
}

#[test]
fn many_rows_of_many_columns_are_read_a_row_a_step() {
    let columns = ",".repeat(3_000);
    let header = format!("Input.pre_1,Input.post_1,Answer.command{columns}\n");
    let row = format!("@PRE,@POST,go east{columns}\n");
    let Steps { n, longest, corpus, flaws } = steps(file(&(header + &row.repeat(8_000))));
    assert_eq!((corpus.examples.len(), flaws.len()), (8_000, 0));
    // A step for the record, the pair and the end of each row, and one for each chunk of the file.
    assert!((24_000..25_000).contains(&n) && longest <= MOST_BYTES, "{n}, {longest}");
    assert!(corpus.examples.iter().all(|example| example.rest.len() == 3_000));
}

#[test]
fn a_message_on_many_long_names_is_short() {
    let name = "a long name ".repeat(80);
    let header = vec![name.as_str(); MAX_COLUMNS].join(",");
    let keys: String = (0..3_000).map(|n| format!("\"{n} {name}\":7,")).collect();
    for (text, wanted) in [
        (header + "\n7\n", "the column Input.pre_1 is missing (found: a long name a long name"),
        (format!("{{{keys}\"a\":7}}\n"), "the row has no command (found: 0 a long name"),
    ] {
        let (_, flaws) = csv(text);
        let told = said(&flaws);
        assert!(told.contains(wanted) && told.len() < 1_600, "{}: {told}", told.len());
    }
}

#[test]
fn more_than_the_most_is_refused_and_not_cut() {
    let rows = "Input.pre_1,Input.post_1,Answer.command\n@PRE,@POST,go east\n";
    let (corpus, flaws) = csv([file(rows), b",,\n".repeat(100_000)].concat());
    assert_eq!(counts(&corpus), "0 0 0");
    assert!(said(&flaws).contains("more than 100000 rows; split it"), "{flaws:?}");
    let (corpus, flaws) = csv([file(rows), b",,\n".repeat(99_999)].concat());
    assert_eq!((corpus.rows(), corpus.left_out), (100_000, 99_999));
    assert!(
        flaws.len() <= 1_001 && said(&flaws).contains("more are not listed"),
        "{}",
        flaws.len()
    );
}
