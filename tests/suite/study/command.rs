//! The command line of studies: a study out of tasks or of a corpus, and answers reviewed.

use crate::command::call;
use groundling::study::rehearse::script;
use groundling::study::{Answer, Care, Study, answer};
use std::path::{Path, PathBuf};

fn place(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

fn path(name: &Path) -> &str {
    name.to_str().unwrap()
}

/// What the participants of some seeds answer to a study.
fn answers(study: &Study, seeds: std::ops::Range<u32>) -> Vec<Answer> {
    let of = |seed: u32| {
        let script = script(study, seed);
        let of = script.turns.len();
        let turns = script.turns.into_iter().zip(script.acts).enumerate();
        let worker = script.worker.clone();
        turns
            .map(|(at, (turn, act))| {
                let item = &study.items[turn.item];
                Answer {
                    format: answer::FORMAT.into(),
                    id: format!("{worker}-{}", at + 1),
                    command: act.words,
                    task: item.task.clone(),
                    worker: worker.clone(),
                    pairs: turn.shows.iter().map(|&at| item.shows[at].clone()).collect(),
                    runs: Vec::new(),
                    study: study.fingerprint(),
                    item: item.id.clone(),
                    turn: [at + 1, of],
                    assignment: None,
                    hit: None,
                    at: 0.0,
                    care: Care {
                        active_ms: act.looks_ms,
                        seen_ms: vec![act.looks_ms; 3],
                        ..Care::default()
                    },
                    simulated: Some(script.careless),
                }
            })
            .collect::<Vec<_>>()
    };
    seeds.flat_map(of).collect()
}

#[test]
fn a_study_is_made_taken_and_reviewed() {
    let settings = place("settings.json");
    std::fs::write(
        &settings,
        r#"{"asked": 2, "pay": {"cents": 50, "currency": "EUR"}, "language": "en"}"#,
    )
    .unwrap();
    let made = call(
        &[
            "generate",
            "--study",
            "Six",
            "--from",
            "assets/corpus/six.csv",
            "--rehearsed",
            "--settings",
            path(&settings),
        ],
        "",
    );
    assert!(made.status.success(), "{made:?}");
    let text = String::from_utf8(made.stdout).unwrap();
    let study = Study::read(&text).unwrap();
    assert_eq!((study.items.len(), study.asked), (6, Some(2)));
    assert!(study.words.example.is_some(), "rows bring no worked example: one is drawn");
    let (file, given) = (place("six-study.json"), place("six-answers.jsonl"));
    std::fs::write(&file, &text).unwrap();
    std::fs::write(&given, answer::lines(&answers(&study, 0..5))).unwrap();
    let (out, pay, more) = (place("six-out.csv"), place("six-pay.csv"), place("six-more.json"));
    let reviewed = call(
        &[
            "review",
            "--study",
            path(&file),
            "--answers",
            path(&given),
            path(&given),
            "--model",
            "assets/model/cleanup.model",
            "--reject",
            "some_pairs,no_pair,unread",
            "--out",
            path(&out),
            "--pay",
            path(&pay),
            "--top-up",
            "9",
            path(&more),
            "--json",
        ],
        "",
    );
    assert!(reviewed.status.success(), "{reviewed:?}");
    let report: serde_json::Value = serde_json::from_slice(&reviewed.stdout).unwrap();
    assert_eq!((&report["answers"], &report["doubles"]), (&10.into(), &10.into()));
    assert_eq!(report["told_apart"]["good"], 10);
    assert_eq!(report["flags"]["simulated"], 10);
    assert!(
        report["approved"].as_u64().unwrap() >= 8,
        "the shipped model reads the six sentences: {report}"
    );
    assert_eq!(Study::read(&std::fs::read_to_string(&more).unwrap()).unwrap().items.len(), 6);
    let again = call(&["review", "--answers", path(&out), "--json"], "");
    let again: serde_json::Value = serde_json::from_slice(&again.stdout).unwrap();
    assert_eq!((&again["answers"], &again["approved"]), (&report["answers"], &report["approved"]));
    assert!(std::fs::read_to_string(&pay).unwrap().starts_with("worker,answers,approved"));
}

#[test]
fn bad_arguments_are_refused_in_a_line() {
    let bad = place("bad-study.json");
    std::fs::write(&bad, "{\"format\":\"groundling study\"}").unwrap();
    for (arguments, expected) in [
        (&["generate", "--study", "a"][..], "--tasks FILE|all is missing, or --from CORPUS"),
        (&["generate", "--from", "assets/corpus/six.csv"], "--study NAME is missing"),
        (&["generate", "--study", "a", "--tasks", "all", "--rehearsed"], "leave one out"),
        (&["generate", "--study", "a", "--worlds", "1"], "leave one out"),
        (&["generate", "--study", "a", "--tasks", "all", "--pairs", "0"], "use 1 to 100"),
        (&["review"], "--answers FILE is missing"),
        (&["review", "--study", path(&bad), "--answers", "assets/corpus/six.csv"], "missing field"),
        (
            &["review", "--answers", "assets/corpus/six.csv", "--reject", "rude"],
            "no flag is called so",
        ),
        (&["review", "--answers", "nowhere.jsonl"], "cannot read nowhere.jsonl"),
    ] {
        let output = call(arguments, "");
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{error}");
        assert!(error.contains(expected) && error.lines().count() == 1, "{error}");
    }
}
