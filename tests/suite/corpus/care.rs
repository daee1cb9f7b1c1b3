//! What is written for a person to go on with: bad rows as a file of the same form, and what was decided of rows.

use super::{HEADER, PRE, commands, csv, file, post};
use groundling::corpus::{Corpus, Decision, Options, jsonl, read, table};

/// The bad rows of a file, which must be so many.
#[track_caller]
fn bad(text: &str, rows: usize) -> String {
    let (corpus, _) = csv(text);
    assert_eq!((corpus.bad.kept, corpus.bad.more, corpus.left_out), (rows, 0, rows));
    String::from_utf8(corpus.bad.text).unwrap()
}

#[test]
fn bad_rows_are_a_file_to_mend_and_read_again() {
    let post = post();
    let good = ["A1", PRE, &post, "go east", "x", ""];
    let broken = PRE.replacen("agent", "agnt", 1);
    let bad_state = ["A2", &broken, &post, "go, \"quickly\"\nnorth", "x", ""];
    let silent = ["A3", PRE, &post, " ", "x", ""];
    for end in ["\n", "\r\n"] {
        let text = file(&[&HEADER, &good, &bad_state, &good, &silent], end);
        let rows = bad(&text, 2);
        assert_eq!(rows, file(&[&HEADER, &bad_state, &silent], end), "as they stood");
        let mended = rows.replace("agnt", "agent").replace("\" \"", "\"go south\"");
        assert_eq!(commands(&csv(&mended).0), ["go, \"quickly\"\nnorth", "go south"]);
    }
    // Quotes that never close, and too many cells, cost their line.
    let all = file(&[&HEADER, &good], "\n")
        + "\"A4,never closed\n"
        + &file(&[&good], "\n")
        + "a,b,c,d,e,f,g\n";
    assert_eq!(bad(&all, 2), file(&[&HEADER], "\n") + "\"A4,never closed\na,b,c,d,e,f,g\n");
    // What a file says of its separator stays said.
    let semicolons = "sep=;\nInput.pre_1;Input.post_1;Answer.command\n{};{};go\n";
    assert_eq!(bad(semicolons, 1), semicolons);
    assert!(csv(file(&[&HEADER, &good], "\n")).0.bad.text.is_empty(), "no bad rows, no file");
}

#[test]
fn bad_objects_are_a_file_too() {
    let good =
        format!("{{\"command\": \"go\", \"pairs\": [{{\"pre\": {PRE}, \"post\": {}}}]}}", post());
    let no_states = "{\"command\": \"go\"}";
    let text = format!("{good}\n{no_states}\n{{\"command\": \n{good}\n");
    assert_eq!(bad(&text, 2), format!("{no_states}\n{{\"command\":\n"));
    let list = format!("[\n{good},\n{no_states},\n{good}\n]\n");
    assert_eq!(bad(&list, 1), format!("{no_states}\n"));
}

#[test]
fn what_was_decided_is_written_and_read_back() {
    let post = post();
    let columns = [
        "AssignmentId",
        "AssignmentStatus",
        "Input.pre_1",
        "Input.post_1",
        "Answer.command",
        "Approve",
        "Reject",
    ];
    let row =
        |status, approve, reject| ["A1", status, PRE, post.as_str(), "go east", approve, reject];
    let rows = [
        row("Submitted", "", ""),
        row("Approved", "", ""),
        row("Submitted", "x", ""),
        row("Rejected", "", ""),
        row("Submitted", "", "bad"),
    ];
    let all: Vec<&[&str]> =
        std::iter::once(columns.as_slice()).chain(rows.iter().map(|row| row.as_slice())).collect();
    let text = file(&all, "\r\n");
    let read_all =
        |bytes: &[u8]| read(bytes, Options { with_rejected: true, ..Options::default() }).0;
    let corpus = read_all(text.as_bytes());
    let decided: Vec<Decision> = corpus.examples.iter().map(|one| one.decision.clone()).collect();
    let rejected = |why: &str| Decision::Rejected(why.into());
    let wanted =
        [Decision::Open, Decision::Approved, Decision::Approved, rejected(""), rejected("bad")];
    assert_eq!(decided, wanted);
    let written = |corpus: &Corpus| {
        let (mut table, mut lines) = (Vec::new(), Vec::new());
        table::write(corpus, &mut table).unwrap();
        jsonl::write(corpus, &mut lines).unwrap();
        (table, lines)
    };
    let decisions =
        |corpus: Corpus| corpus.examples.into_iter().map(|one| one.decision).collect::<Vec<_>>();
    let (table, lines) = written(&corpus);
    assert_eq!(read_all(&table), corpus, "what nobody touched is as it was");
    assert!(decisions(read_all(&lines)).into_iter().eq(wanted.clone()));
    // Every decision turned round.
    let mut turned = corpus.clone();
    for example in &mut turned.examples {
        example.decision = match example.decision {
            Decision::Rejected(_) => Decision::Approved,
            _ => rejected("says, \"nothing\""),
        };
    }
    let (table, lines) = written(&turned);
    for bytes in [table.as_slice(), lines.as_slice()] {
        assert_eq!(decisions(read_all(bytes)), decisions(turned.clone()));
    }
    let (good, _) = read(table.as_slice(), Options::default());
    assert_eq!((good.examples.len(), good.rejected), (2, 3));
    // Undecided again.
    for example in &mut turned.examples {
        example.decision = Decision::Open;
    }
    assert!(decisions(read_all(&written(&turned).0)).into_iter().all(|one| one == Decision::Open));
}
