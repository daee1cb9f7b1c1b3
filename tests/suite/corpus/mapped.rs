//! Columns with names of their own: what they seem to be, what a mapping makes of them, and mappings as files.

use super::{HEADER, PRE, commands, csv, file, post};
use groundling::corpus::{Corpus, Decision, Flaw, Mapping, Options, preview, read, table};

const OWN: [&str; 6] =
    ["annotator", "initialState", "finalState", "Instruction", "remark", "rejected_because"];

fn own(rows: &[[&str; 6]]) -> String {
    let rows = std::iter::once(OWN.as_slice()).chain(rows.iter().map(|row| row.as_slice()));
    file(&rows.collect::<Vec<_>>(), "\n")
}

fn mapped(text: &str, mapping: &Mapping) -> (Corpus, Vec<Flaw>) {
    let options = Options { with_rejected: true, mapping: mapping.clone() };
    read(text.as_bytes(), options)
}

#[test]
fn what_columns_seem_to_be_is_proposed_from_their_names() {
    for (columns, said) in [
        (&OWN[..], "Instruction annotator initialState→finalState"),
        (&HEADER[..], "Answer.command Input.pre_1→Input.post_1"),
        (&["text", "pre", "post"], "text pre→post"),
        (
            &["before 2", "after 2", "before 1", "after 1", "user_id", "said"],
            "said user_id before 1→after 1 before 2→after 2",
        ),
        (&["a", "b"], ""),
        (&["state_start", "sentence"], "sentence"),
    ] {
        let columns: Vec<String> = columns.iter().map(|name| (*name).to_owned()).collect();
        let found = Mapping::propose(&columns);
        let pairs = found.pairs.iter().map(|states| format!("{}→{}", states.pre, states.post));
        let parts = found.command.iter().chain(&found.worker).cloned().chain(pairs);
        assert_eq!(parts.collect::<Vec<_>>().join(" "), said, "{columns:?}");
        assert_eq!(found.is_complete(), said.contains('→'));
    }
}

#[test]
fn a_file_is_looked_at_before_its_columns_are_mapped() {
    let text = own(&[["w1", PRE, &post(), "go east", "", ""]; 9]);
    let found = preview(text.as_bytes()).unwrap();
    assert!(!found.is_json);
    assert_eq!(found.columns, OWN);
    assert_eq!(found.rows.len(), 5);
    assert_eq!((found.rows[0][0].as_str(), found.rows[4][3].as_str()), ("w1", "go east"));
    assert_eq!(found.rows[0][1].chars().count(), 81, "cells are cut");
    assert_eq!(found.proposal.reject.as_deref(), Some("rejected_because"));
    let lines = format!("{{\"said\": \"go\", \"pre\": {PRE}, \"post\": {}}}\n", post()).repeat(3);
    let found = preview(lines.as_bytes()).unwrap();
    assert!(found.is_json);
    assert_eq!(found.columns, ["post", "pre", "said"]);
    assert_eq!(found.rows[2][2], "go");
    assert!(found.proposal.is_complete());
    assert!(preview(&b"PK\x03\x04"[..]).is_err());
    assert!(preview(&b""[..]).is_err());
}

#[test]
fn mapped_columns_are_read_and_written_back_under_their_own_names() {
    let post = post();
    let text = own(&[
        ["w1", PRE, &post, "go east", "Approve", ""],
        ["w2", PRE, &post, "go west", "", "nonsense"],
    ]);
    let (nothing, flaws) = csv(&text);
    assert!(nothing.examples.is_empty() && flaws[0].to_string().contains("is missing"));
    let mapping = preview(text.as_bytes()).unwrap().proposal;
    let (mut corpus, flaws) = mapped(&text, &mapping);
    assert_eq!(flaws, []);
    assert_eq!(commands(&corpus), ["go east", "go west"]);
    assert_eq!(corpus.examples[0].worker.as_deref(), Some("w1"));
    assert_eq!(corpus.examples[1].decision, Decision::Rejected("nonsense".into()));
    let written = |corpus: &Corpus| {
        let mut out = Vec::new();
        table::write(corpus, &mut out).unwrap();
        String::from_utf8(out).unwrap()
    };
    assert_eq!(mapped(&written(&corpus), &mapping).0, corpus);
    assert_eq!(written(&corpus).replace("\r\n", "\n").replace(PRE, ""), text.replace(PRE, ""));
    // Without a mapping for it the decision goes into columns of its own.
    corpus.examples[0].decision = Decision::Rejected("too short".into());
    let again = written(&corpus);
    assert!(
        again
            .lines()
            .next()
            .unwrap()
            .ends_with(r#","rejected_because","AssignmentStatus","Approve""#)
    );
    assert_eq!(mapped(&again, &mapping).0.examples[0].decision, corpus.examples[0].decision);
}

#[test]
fn keys_of_objects_are_mapped_like_columns() {
    let line = format!("{{\"said\": \"go\", \"who\": \"w\", \"b\": {PRE}, \"a\": {}}}\n", post());
    let pairs = "[{\"pre\": \"b\", \"post\": \"a\"}]";
    let text = format!(
        "{{\"format\": \"groundling mapping\", \"version\": 1, \"columns\":
        {{\"command\": \"said\", \"worker\": \"who\", \"pairs\": {pairs}}}}}"
    );
    let mapping = Mapping::read(&text).unwrap();
    assert_eq!(Mapping::read(&mapping.write()).unwrap(), mapping);
    let (corpus, flaws) = mapped(&line, &mapping);
    assert_eq!(flaws, []);
    assert_eq!(commands(&corpus), ["go"]);
    assert_eq!(corpus.examples[0].worker.as_deref(), Some("w"));
    assert!(csv(&line).1[0].to_string().contains("no command"));
}

#[test]
fn a_mapping_that_does_not_fit_is_told_in_words() {
    let text = own(&[["w1", PRE, &post(), "go east", "", ""]]);
    let good = preview(text.as_bytes()).unwrap().proposal;
    for (change, said) in [
        (
            Mapping { task: Some("label".to_owned()), ..good.clone() },
            "the mapped column label is missing",
        ),
        (
            Mapping { task: good.command.clone(), ..good.clone() },
            "the mapping names Instruction twice",
        ),
        (Mapping { command: None, ..good.clone() }, "a mapping names the command"),
    ] {
        let (_, flaws) = mapped(&text, &change);
        assert!(flaws[0].to_string().contains(said), "{flaws:?}");
    }
    for (text, said) in [
        ("", "the cell is empty"),
        ("{}", "missing field"),
        (&good.write().replace("mapping\"", "model\""), "no mapping of columns"),
        (&good.write().replace("1,", "2,"), "version 2"),
        (&good.write().replace("\"task\"", "\"tusk\""), "unknown field"),
    ] {
        let wrong = Mapping::read(text).err().unwrap_or_else(|| panic!("{text}"));
        assert!(wrong.to_string().contains(said), "{wrong}");
    }
}
