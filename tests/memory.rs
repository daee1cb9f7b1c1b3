//! What reading a corpus takes of memory, counted byte by byte: at most ten times the file, whatever the file is. A binary of
//! its own, and one test in it: what others allocate at the same time would be counted, too.
#![cfg(not(target_arch = "wasm32"))]

use groundling::corpus::{Corpus, Flaw, Options, preview, read};
use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

const PRE: &str = r#"{"agent":{"x":2,"y":3,"direction":"south"},"rooms":[{"name":"room0","color":"red","left":0,"bottom":0,"right":4,"top":4}],"doors":[],"objects":[]}"#;

/// Times a file's size that reading it may take beside the file, and what it may take of a small one.
const MOST: usize = 10;
const LITTLE: usize = 1 << 20;

/// An object of JSON with this behind the command and the pairs, if that is all.
fn row(command: &str, more: &str) -> String {
    format!("{{\"command\":{command},\"pairs\":[{{\"pre\":{PRE},\"post\":{PRE}}}]{more}}}\n")
}

/// So many of these in a list.
fn list(item: &str, n: usize) -> String {
    format!("[{}]", vec![item; n].join(","))
}

/// A row with this for its pairs, or for another key.
fn with(key: &str, value: &str) -> String {
    format!("{{\"command\":\"go\",\"{key}\":{value}}}\n")
}

/// A table with many columns that nobody reads.
fn wide(columns: usize, rows: usize, cell: &str) -> String {
    let names: String = (0..columns).map(|n| format!(",c{n}")).collect();
    let state = format!("\"{}\"", PRE.replace('"', "\"\""));
    let row = format!("{state},{state},go east{}\n", format!(",{cell}").repeat(columns));
    format!("Input.pre_1,Input.post_1,Answer.command{names}\n{}", row.repeat(rows))
}

/// A table with one row, and this in a cell of it.
fn cell(column: &str, text: &str) -> String {
    let header = "Input.pre_1,Input.post_1,Answer.command,Input.run_1";
    let mut cells = [PRE, PRE, "go", ""];
    let at = header.split(',').position(|name| name == column).unwrap_or(0);
    cells[at] = text;
    let quoted = cells.map(|cell| format!("\"{}\"", cell.replace('"', "\"\"")));
    format!("{header}\n{}\n", quoted.join(","))
}

/// What reading takes at its height, and what came of it.
fn measured(name: &str, text: &[u8]) -> (Corpus, Vec<Flaw>) {
    MEMORY.reset_peak_usage();
    let before = MEMORY.current_usage();
    let found = read(text, Options::default());
    let peak = MEMORY.peak_usage() - before;
    let most = LITTLE + MOST * text.len();
    assert!(peak <= most, "{name}: {peak} bytes for {}, at most {most}", text.len());
    MEMORY.reset_peak_usage();
    // What is wrong with a file, a preview need not know.
    drop(preview(text));
    let peak = MEMORY.peak_usage() - before;
    assert!(peak <= 2 * most, "{name}, looked at: {peak} bytes for {}", text.len());
    found
}

#[test]
fn reading_takes_ten_times_the_file_at_most() {
    let million = 1 << 20;
    let long = format!("\"{}\"", "x".repeat(7_800_000));
    let keys: String = (0..700_000).map(|n| format!(",\"{n}\":7")).collect();
    let run =
        |contrast: &str| format!("{{\"start\":{PRE},\"actions\":\"\",\"contrast\":{contrast}}}");
    // What is one row, and what is said of it, if anything.
    let cases: [(&str, String, &str); 18] = [
        ("a long command", row(&long, ""), "command: the value is larger than 1 MB"),
        (
            "a long name",
            row("\"go\"", &format!(",\"worker\":{long}")),
            "worker: the value is larger",
        ),
        ("a long value that nobody reads", row("\"go\"", &format!(",\"note\":{long}")), ""),
        (
            "a long state",
            with("pairs", &format!("[{{\"pre\":{long},\"post\":7}}]")),
            "pairs[0].pre: ",
        ),
        (
            "a long list that nobody reads",
            row("\"go\"", &format!(",\"note\":{}", list("7", 3 * million))),
            "",
        ),
        ("many keys", row("\"go\"", &keys), "the row has more than 16384 keys"),
        (
            "many keys of a pair",
            with("pairs", &format!("[{{\"a\":7{keys}}}]")),
            "pairs[0].pre: the state is missing",
        ),
        (
            "many keys of a state",
            with("pairs", &format!("[{{\"pre\":{{\"a\":7{keys}}},\"post\":7}}]")),
            "pairs[0].pre: ",
        ),
        ("many pairs", with("pairs", &list("{}", 2_700_000)), "1 to 100 pairs"),
        ("many runs", with("runs", &list("{}", 2_700_000)), "1 to 100 runs"),
        (
            "many pairs in a text",
            with("pairs", &format!("\"{}\"", list("{}", 2_600_000))),
            "1 to 100 pairs",
        ),
        (
            "many contrasts",
            with("runs", &format!("[{}]", run(&list("\"\"", 300_000)))),
            "runs[0]: a run has 100 contrasts at most",
        ),
        (
            "many contrasts in a cell",
            cell("Input.run_1", &run(&list("\"\"", 200_000))),
            "100 contrasts",
        ),
        (
            "many answers",
            cell("Answer.command", &list("7", million / 3)),
            "no answer is called command",
        ),
        (
            "many answers with names",
            cell("Answer.command", &list("{\"a\":\"b\"}", 50_000)),
            "no answer",
        ),
        (
            "many answers in JSON",
            row(&format!("\"{}\"", list("7", million / 3)), ""),
            "no answer is called command",
        ),
        (
            "many rooms",
            cell(
                "Input.pre_1",
                &PRE.replace("\"doors\":[]", &format!("\"doors\":{}", list("{}", million / 4))),
            ),
            "missing field `name`",
        ),
        ("bytes that are no UTF-8", row("\"go\"", ",\"note\":\"@\""), ""),
    ];
    for (name, text, said) in &cases {
        let (before, behind) = text.split_once('@').unwrap_or((text, ""));
        let strange = if behind.is_empty() { Vec::new() } else { b"\\\"\xE9".repeat(million) };
        let text = [before.as_bytes(), &strange, behind.as_bytes()].concat();
        let (corpus, flaws) = measured(name, &text);
        let told: String = flaws.iter().map(|flaw| format!("{flaw}\n")).collect();
        assert_eq!(
            (corpus.examples.len(), flaws.is_empty()),
            (usize::from(said.is_empty()), said.is_empty()),
            "{name}: {told}"
        );
        assert!(told.contains(said) && told.len() < 2_000, "{name}: {told}");
    }
    for (name, cell, rows) in [("empty cells", "", 8_000), ("cells", "7", 4_000)] {
        let (corpus, flaws) = measured(name, wide(3_000, rows, cell).as_bytes());
        assert_eq!((corpus.examples.len(), flaws.len()), (rows, 0), "{name}");
    }
}
