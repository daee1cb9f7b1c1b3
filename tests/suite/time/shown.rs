//! Runs in corpora: read, written back whole, drawn for a form, and what they show by the definition.

use super::commands::{in_room, reach};
use crate::command::call;
use groundling::corpus::{Corpus, Options, jsonl, read as read_corpus, table};
use groundling::ground::{Course, Validator};
use groundling::logic::{Terms, read};
use serde_json::Value;

fn corpus(text: &str) -> Corpus {
    let (corpus, flaws) = read_corpus(text.as_bytes(), Options::default());
    assert!(flaws.is_empty(), "{flaws:?}");
    corpus
}

fn forms() -> [String; 3] {
    let never = format!("(always:<t,p> (not:<t,t> {}))", in_room("yellow"));
    let (red, blue) = (in_room("red"), in_room("blue"));
    let both = reach(&red, &reach(&blue, "done:p"));
    [
        format!("(all:<p*,p> {never} {both})"),
        both,
        format!("(all:<p*,p> {never} {})", reach(&red, "done:p")),
    ]
}

fn drawn(form: &str, seed: &str) -> String {
    let output = call(&["generate", "--goal", form, "--runs", "3", "--seed", seed, "--json"], "");
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn what_is_drawn_for_a_form_shows_it_and_nothing_that_asks_for_less() {
    let [both, without, only_red] = forms();
    let rows = drawn(&both, "4");
    assert_eq!(rows, drawn(&both, "4"));
    let corpus = corpus(&rows);
    let pairs = &corpus.examples[0].pairs;
    assert_eq!((corpus.examples.len(), pairs.len()), (1, 3));
    let (mut terms, mut validator) = (Terms::new(), Validator::new());
    let mut shown = |form: &str| {
        let term = read(&mut terms, form).unwrap();
        let ids: Vec<_> = pairs
            .iter()
            .map(|pair| validator.shown(&pair.pre, &pair.post, pair.way.as_deref()))
            .collect();
        validator.valid(&terms, term, &ids)
    };
    assert!(shown(&both));
    assert!(!shown(&without) && !shown(&only_red) && !shown(&in_room("blue")));
    for pair in pairs {
        let way = pair.way.as_ref().unwrap();
        let states = way.states(&pair.pre).unwrap();
        let term = read(&mut terms, &both).unwrap();
        let course = Course::new(&terms, term, &pair.pre).unwrap();
        assert_eq!(states[0].last(), Some(&pair.post));
        assert_eq!(course.beginnings(&states[0]).first(), Some(states[0].len() - 1));
        assert!(states[1..].iter().all(|contrast| course.beginnings(contrast).first().is_none()));
    }
}

#[test]
fn runs_are_written_back_as_they_were_read() {
    let rows = drawn(&forms()[0], "9");
    let mut row: Value = serde_json::from_str(&rows).unwrap();
    row["strict"] = 3.into();
    row["note"] = serde_json::json!({ "of": ["mine"] });
    let read = corpus(&format!("{row}\n"));
    let mut lines = Vec::new();
    jsonl::write(&read, &mut lines).unwrap();
    assert_eq!(serde_json::from_slice::<Value>(&lines).unwrap(), row);
    assert_eq!(read.value(&read.examples[0], "strict"), Some("3"));
    let mut cells = Vec::new();
    table::write(&read, &mut cells).unwrap();
    let head = String::from_utf8(cells.clone()).unwrap();
    assert!(head.lines().next().unwrap().contains("\"Input.run_3\""), "{head}");
    assert!(!head.contains("Input.pre_"));
    let again = corpus(&head);
    assert_eq!(again.examples[0].pairs, read.examples[0].pairs);
    let mut twice = Vec::new();
    table::write(&again, &mut twice).unwrap();
    assert_eq!(twice, cells);
}

#[test]
fn what_is_wrong_with_a_run_is_said_where_it_stands() {
    let row: Value = serde_json::from_str(&drawn(&forms()[1], "2")).unwrap();
    let bad = |change: fn(&mut Value)| {
        let mut row = row.clone();
        change(&mut row["runs"]);
        let (corpus, flaws) = read_corpus(format!("{row}\n").as_bytes(), Options::default());
        assert_eq!(corpus.left_out, 1);
        flaws[0].to_string()
    };
    let cases: [(fn(&mut Value), &str); 5] = [
        (|runs| runs[1]["actions"] = "nnx".into(), "runs[1]: no action is called 'x'"),
        (|runs| runs[0]["contrast"] = "nn".into(), "runs[0]: this is no run"),
        (|runs| runs[0]["start"]["agent"]["x"] = 0.into(), "runs[0]"),
        (|runs| *runs = Value::from(7), "this is no list of runs"),
        (|runs| *runs = Value::Array(Vec::new()), "a row needs 1 to"),
    ];
    for (change, says) in cases {
        let found = bad(change);
        assert!(found.contains(says), "{found}");
    }
}

#[test]
fn any_key_of_the_rows_parts_a_corpus() {
    let mut text = String::new();
    for seed in 1..=4 {
        let mut row: Value =
            serde_json::from_str(&drawn(&in_room("red"), &seed.to_string())).unwrap();
        row["part"] = (seed % 2).into();
        row["command"] = "go to the red room".into();
        text += &format!("{row}\n");
    }
    let cross = |by: &str| {
        let options = ["--corpus", "-", "--by", by, "--folds", "2", "--epochs", "1", "--json"];
        call(&[&["experiment", "cross"], &options[..]].concat(), &text)
    };
    let report: Value = serde_json::from_slice(&cross("part").stdout).unwrap();
    assert_eq!(report["runs"].as_array().unwrap().len(), 2, "{report}");
    assert_eq!(report["all"]["total"], 4);
    assert!(!cross("colour").status.success());
}
