//! Corpora: the quirks of real batch-results files, what is said of bad ones, and that what is written is
//! read back. Bad rows, odd rows and bad files are data suites under `tests/data/corpus`.

use groundling::corpus::{
    Corpus, Flaw, Options, jsonl, limits::MAX_CELL_BYTES, limits::MAX_FILE_BYTES, read, table,
};
use proptest::prelude::{any, prop, proptest};

#[path = "corpus/brought.rs"]
mod brought;
#[path = "corpus/care.rs"]
mod care;
#[path = "corpus/mapped.rs"]
mod mapped;
#[path = "corpus/packed.rs"]
mod packed;

pub(crate) const PRE: &str = r#"{"agent":{"x":2,"y":3,"direction":"south"},"rooms":[{"name":"room0","color":"red","left":0,"bottom":0,"right":4,"top":4},{"name":"room1","color":"blue","left":4,"bottom":0,"right":8,"top":4}],"doors":[{"name":"door0","left":4,"bottom":2,"right":4,"top":2,"lock":"unlocked"}],"objects":[{"name":"object0","shape":"chair","color":"green","x":6,"y":2}]}"#;

fn post() -> String {
    PRE.replacen("\"x\":2,\"y\":3", "\"x\":3,\"y\":3", 1)
}

/// A file: a header, then rows; every cell quoted.
fn file(rows: &[&[&str]], end: &str) -> String {
    let line = |cells: &&[&str]| {
        let quoted = cells.iter().map(|cell| format!("\"{}\"", cell.replace('"', "\"\"")));
        quoted.collect::<Vec<_>>().join(",")
    };
    rows.iter().map(line).map(|line| line + end).collect()
}

fn csv(text: impl AsRef<[u8]>) -> (Corpus, Vec<Flaw>) {
    read(text.as_ref(), Options::default())
}

fn commands(corpus: &Corpus) -> Vec<&str> {
    corpus.examples.iter().map(|example| example.command.as_str()).collect()
}

/// The cases of a data suite, parted at bars.
fn cases(text: &'static str) -> impl Iterator<Item = Vec<String>> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| {
        let parts = line.split(" | ").map(|part| part.replace('«', "\n").replace('»', "\t"));
        parts.map(|part| if part == " " { String::new() } else { part }).collect()
    })
}

const HEADER: [&str; 6] =
    ["AssignmentId", "Input.pre_1", "Input.post_1", "Answer.command", "Approve", "Reject"];

/// Mends nothing: the middle one of three rows is changed as the case says.
fn with_changed_row(case: &[String]) -> (Corpus, Vec<Flaw>) {
    let post = post();
    let good = ["A1", PRE, &post, "go east", "x", ""];
    let [column, from, to, _] = case else { panic!("four parts: {case:?}") };
    let at = HEADER.iter().position(|name| name == column).unwrap();
    let cell = if from.trim().is_empty() {
        to.trim_matches(' ').to_owned()
    } else {
        assert!(good[at].contains(from.as_str()), "{from} is not in {}", good[at]);
        good[at].replacen(from.as_str(), to, 1)
    };
    let mut bad = good;
    bad[at] = &cell;
    csv(file(&[&HEADER, &good, &bad, &good], "\n"))
}

#[test]
fn a_bad_row_is_explained_and_stops_no_other() {
    for case in cases(include_str!("../data/corpus/bad_rows.txt")) {
        let (corpus, flaws) = with_changed_row(&case);
        assert_eq!(corpus.examples.len(), 2, "{case:?}");
        let said = flaws.iter().any(|flaw| {
            let placed = flaw.line == 3 && flaw.column.as_deref() == Some(&case[0]);
            placed && flaw.to_string().contains(&case[3])
        });
        assert!(said, "{case:?}: {flaws:?}");
        assert!(flaws.iter().all(|flaw| !flaw.kept), "{flaws:?}");
    }
}

#[test]
fn an_odd_row_is_kept_with_a_warning() {
    for case in cases(include_str!("../data/corpus/odd_rows.txt")) {
        let (corpus, flaws) = with_changed_row(&case);
        assert_eq!(corpus.examples.len(), 3, "{case:?}: {flaws:?}");
        let [flaw] = flaws.as_slice() else { panic!("one warning: {flaws:?}") };
        assert!(
            flaw.kept && flaw.line == 3 && flaw.to_string().contains(&case[3]),
            "{case:?}: {flaw:?}"
        );
    }
}

#[test]
fn a_bad_file_is_explained() {
    for case in cases(include_str!("../data/corpus/bad_files.txt")) {
        let (corpus, flaws) = csv(case[0].trim_start_matches(' '));
        let [flaw] = flaws.as_slice() else { panic!("one flaw: {flaws:?}") };
        assert!(
            corpus.examples.is_empty() && flaw.to_string().contains(&case[1]),
            "{case:?}: {flaw:?}"
        );
    }
    for (bytes, said) in [
        (&b"PK\x03\x04rest"[..], "save it as CSV"),
        (b"\x89PNG\0\0", "not a text file"),
        (b"Input.pre_1,\xE9\n", "the column Input.post_1 is missing"),
        (b"\x1F\x8B\x08\0", "cut short or damaged"),
    ] {
        let (_, flaws) = csv(bytes);
        assert!(flaws[0].to_string().contains(said), "{flaws:?}");
    }
}

#[test]
fn the_quirks_of_real_files_are_read() {
    let post = post();
    let row = ["A1", PRE, &post, "go east", "x", ""];
    let two_short = ["A2", PRE, &post, "go north, \"now\""];
    let plain = file(&[&HEADER, &row, &two_short], "\n");
    let (expected, flaws) = csv(&plain);
    assert_eq!(flaws, []);
    assert_eq!(commands(&expected), ["go east", "go north, \"now\""]);
    assert!(expected.examples[1].rest.iter().eq(["A2", "", ""]));
    assert_eq!(expected.columns, HEADER);
    for (quirk, text) in [
        ("CR LF", plain.replace('\n', "\r\n")),
        ("a byte-order mark", format!("\u{feff}{plain}")),
        ("no last newline", plain.trim_end().to_owned()),
        ("empty lines at the end", format!("{plain}\n\r\n")),
    ] {
        assert_eq!(csv(text), (expected.clone(), vec![]), "{quirk}");
    }
    let reordered = file(
        &[&["Answer.command", "Input.post_1", "X", "Input.pre_1"], &["go east", &post, "", PRE]],
        "\n",
    );
    assert_eq!(csv(reordered).0.examples[0].pairs, expected.examples[0].pairs);
}

#[test]
fn lines_are_those_of_an_editor() {
    let post = post().replace("\"rooms\"", "\n\n\"rooms\"");
    let tall = ["A1", PRE, &post, "go\neast", "x", ""];
    let bad = ["A2", PRE, &post, "", "x", ""];
    for end in ["\n", "\r\n"] {
        let (corpus, flaws) = csv(file(&[&HEADER, &tall, &bad, &tall], end));
        let lines: Vec<u64> = corpus.examples.iter().map(|example| example.line).collect();
        assert_eq!((lines, flaws[0].line), (vec![2, 9], 6), "{end:?}");
        assert_eq!(commands(&corpus), ["go\neast", "go\neast"]);
    }
}

#[test]
fn after_a_quote_that_is_never_closed_reading_goes_on() {
    let post = post();
    let row = |command| ["A1", PRE, post.as_str(), command, "x", ""];
    let good = file(&[&HEADER, &row("go east"), &row("go north"), &row("go south")], "\n");
    let (corpus, flaws) = csv(good.replacen("\"go north\"", "\"go north", 1));
    assert_eq!(commands(&corpus), ["go east", "go south"], "{flaws:?}");
    assert_eq!((flaws.len(), flaws[0].line), (1, 3), "{flaws:?}");
    let (corpus, flaws) = csv(good.replacen("\"x\",\"\"\n\"A1\"", "\"x\",\"\n\"A1\"", 1));
    assert_eq!(commands(&corpus), ["go north", "go south"], "{flaws:?}");
    let last = good.trim_end().strip_suffix('"').unwrap();
    let (corpus, flaws) = csv(last);
    assert_eq!(commands(&corpus), ["go east", "go north"]);
    assert!(flaws[0].line == 4 && flaws[0].to_string().contains("never closed"), "{flaws:?}");
}

#[test]
fn rejected_rows_are_left_out_unless_asked_for() {
    let post = post();
    let header = ["AssignmentStatus", "Input.pre_1", "Input.post_1", "Answer.command", "Reject"];
    let row = |status, command, reason| [status, PRE, post.as_str(), command, reason];
    let text = file(
        &[
            &header,
            &row("Approved", "a", ""),
            &row("Rejected", "b", ""),
            &row("Submitted", "c", "too vague"),
            &row("Submitted", "d", ""),
        ],
        "\n",
    );
    let (corpus, flaws) = csv(&text);
    assert_eq!((commands(&corpus), corpus.rejected, flaws), (vec!["a", "d"], 2, vec![]));
    let (corpus, _) = read(text.as_bytes(), Options { with_rejected: true, ..Options::default() });
    assert_eq!((commands(&corpus), corpus.rejected), (vec!["a", "b", "c", "d"], 0));
}

#[test]
fn answers_of_crowd_forms_are_read() {
    let post = post();
    let header = ["Input.pre_1", "Input.post_1", "Answer.taskAnswers"];
    for (form, expected) in [
        (r#"[{"command":" go east "}]"#, Ok("go east")),
        (r#"{"command":"go east","comment":"nice"}"#, Ok("go east")),
        (r#"[{"instruction":"go east"}]"#, Ok("go east")),
        (r#"[{"a":"go","b":"east"}]"#, Err("no answer is called command (found: a, b)")),
        (r#"[{"command":"#, Err("not JSON: EOF")),
        (r#"[{"command":""}]"#, Err("the command is empty")),
        (r#"[{"command":null}]"#, Err("the command is empty")),
        (r#"[{"command":"n/a"}]"#, Err("the command is empty")),
        ("NA", Err("the command is empty")),
        ("", Err("the command is empty")),
    ] {
        let (corpus, flaws) = csv(file(&[&header, &[PRE, &post, form]], "\n"));
        match expected {
            Ok(command) => assert_eq!(commands(&corpus), [command], "{flaws:?}"),
            Err(said) => assert!(flaws[0].to_string().contains(said), "{form}: {flaws:?}"),
        }
        let mut written = Vec::new();
        table::write(&corpus, &mut written).unwrap();
        assert_eq!(commands(&csv(written).0), commands(&corpus));
    }
}

#[test]
fn a_row_may_have_fewer_pairs_than_the_file_has_columns() {
    let post = post();
    let header = ["Input.pre_2", "Input.post_2", "Input.pre_1", "Input.post_1", "Answer.command"];
    let text = file(
        &[
            &header,
            &["", "", PRE, &post, "one"],
            &[PRE, &post, PRE, PRE, "two"],
            &["", PRE, PRE, &post, "x"],
        ],
        "\n",
    );
    let (corpus, flaws) = csv(text);
    assert_eq!(commands(&corpus), ["one", "two"]);
    assert_eq!(corpus.examples[0].pairs.len(), 1);
    assert_eq!(corpus.examples[1].pairs[0].post, corpus.examples[1].pairs[0].pre);
    assert_eq!((flaws.len(), flaws[0].column.as_deref()), (1, Some("Input.pre_2")));
}

#[test]
fn sizes_have_limits_and_say_so() {
    let post = post();
    let row = |command| ["A1", PRE, post.as_str(), command, "x", ""];
    let long = "go ".repeat(1_000);
    let huge = "x".repeat(MAX_CELL_BYTES + 1);
    let words = "go ".repeat(200);
    let (corpus, flaws) =
        csv(file(&[&HEADER, &row(&long), &row(&huge), &row(&words), &row("🦀 go")], "\n"));
    assert_eq!(commands(&corpus), [words.trim(), "🦀 go"]);
    assert!(flaws[0].to_string().contains("2999 characters, more than 2000"), "{flaws:?}");
    assert!(flaws[1].to_string().contains("larger than 1 MB"), "{flaws:?}");
    let more = std::io::Read::chain(
        std::io::Cursor::new(file(&[&HEADER, &row("go east")], "\n")),
        std::io::Read::take(std::io::repeat(b'\n'), MAX_FILE_BYTES),
    );
    let (corpus, flaws) = read(more, Options::default());
    assert_eq!(commands(&corpus), [""; 0], "what is past a limit is not dropped in silence");
    assert!(flaws[0].to_string().contains("larger than 64 MB"), "{flaws:?}");
    let rows = format!("{}{}", HEADER.join(","), "\n,".repeat(100_001));
    let (_, flaws) = csv(rows);
    assert!(flaws.last().unwrap().to_string().contains("more than 100000 rows"));
}

#[test]
fn both_forms_write_what_they_read() {
    let post = post();
    let header =
        ["WorkerId", "Note", "Input.task", "Input.pre_1", "Input.post_1", "Answer.command"];
    let rows: [&[&str]; 3] = [
        &header,
        &["W1", "kept, \"as is\"\n", "east", PRE, &post, "go, \"please\""],
        &["", "", "", PRE, &post, "🦀 7"],
    ];
    let text = file(&rows, "\r\n");
    let (corpus, flaws) = csv(&text);
    assert_eq!(flaws, []);
    let mut written = Vec::new();
    table::write(&corpus, &mut written).unwrap();
    assert_eq!(String::from_utf8(written).unwrap(), text);

    let mut lines = Vec::new();
    jsonl::write(&corpus, &mut lines).unwrap();
    let (again, flaws) = read(lines.as_slice(), Options::default());
    assert_eq!(flaws, []);
    assert_eq!(commands(&again), commands(&corpus));
    let mut as_csv = Vec::new();
    table::write(&again, &mut as_csv).unwrap();
    let (twice, flaws) = csv(as_csv);
    assert_eq!(flaws, []);
    let facts = |c: &Corpus| -> Vec<_> {
        let one =
            |e: &groundling::corpus::Example| (e.id.clone(), e.task.clone(), e.worker.clone());
        c.examples.iter().map(|e| (one(e), e.pairs.clone())).collect()
    };
    assert_eq!(facts(&twice), facts(&corpus));
}

#[test]
fn bad_json_lines_are_explained() {
    let good = format!(r#"{{"command":"go","pairs":[{{"pre":{PRE},"post":{PRE}}}]}}"#);
    for (bad, column, said) in [
        ("{", None, "EOF while parsing"),
        ("7", None, "this is no JSON object"),
        (r#"{"pairs":[]}"#, None, "the row has no command (found: pairs)"),
        (r#"{"command":"","pairs":[]}"#, Some("command"), "the command is empty"),
        (r#"{"command":"go","pairs":[]}"#, Some("pairs"), "1 to 100 pairs"),
        (&good.replace("chair", "sofa"), Some("pairs[0].pre"), "unknown shape `sofa`"),
    ] {
        let text = format!("{good}\n{bad}\n\n{good}");
        let (corpus, flaws) = read(text.as_bytes(), Options::default());
        assert_eq!(corpus.examples.iter().map(|e| e.line).collect::<Vec<_>>(), [1, 4]);
        assert!(flaws[0].line == 2 && flaws[0].to_string().contains(said), "{bad}: {flaws:?}");
        assert!(flaws.iter().any(|flaw| flaw.column.as_deref() == column), "{flaws:?}");
    }
    let (_, flaws) = read(&b"\xEF\xBB\xBF"[..], Options::default());
    assert!(flaws[0].to_string().contains("the file is empty"), "{flaws:?}");
}

proptest! {
    /// No bytes make a panic, and reading ends.
    #[test]
    fn any_bytes_are_answered(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        csv([b"Input.pre_1,Input.post_1,Answer.command\n", bytes.as_slice()].concat());
        csv(&bytes);
        read(bytes.as_slice(), Options::default());
    }

    #[test]
    fn any_text_of_quotes_and_breaks_is_answered(text in "[\",\r\na]{0,60}") {
        csv(format!("Input.pre_1,Input.post_1,Answer.command\n{text}"));
    }
}
