//! The command `experiment`, and what `evaluate` says beside its contract, run as a script runs them.

use crate::command::call;
use serde_json::Value;

const LEARN: &str = "tests/data/corpus/crowd-learn.csv";
const JUDGE: &str = "tests/data/corpus/crowd-judge.csv";
const SIX: &str = "assets/corpus/six.csv";

/// What a call that goes well prints.
#[track_caller]
fn text(arguments: &[&str]) -> String {
    let output = call(arguments, "");
    assert!(output.status.success(), "{arguments:?}: {output:?}");
    String::from_utf8(output.stdout).unwrap()
}

#[track_caller]
fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&text(&[arguments, &["--json"]].concat())).unwrap()
}

/// The runs' names and the paper's F1.
fn rows(report: &Value) -> Vec<(&str, Option<f64>)> {
    let runs = report["runs"].as_array().unwrap();
    runs.iter().map(|run| (run["name"].as_str().unwrap(), run["paper_f1"].as_f64())).collect()
}

/// A report without what a clock says.
fn timeless(mut report: Value) -> Value {
    for run in report["runs"].as_array_mut().unwrap() {
        let run = run.as_object_mut().unwrap();
        assert!(run.remove("seconds").is_some() && run.remove("cpu_seconds").is_some());
    }
    report
}

#[test]
fn table_2_has_a_row_for_each_set_and_number_of_demonstrations() {
    let pruned = format!("pruned={LEARN},{JUDGE}");
    let own = format!("six={SIX},{SIX}");
    let table = |jobs| {
        let sets = ["experiment", "table2", "--set", &pruned, &own];
        json(&[&sets[..], &["--epochs", "2", "--jobs", jobs]].concat())
    };
    let report = timeless(table("1"));
    assert_eq!(
        rows(&report),
        [
            ("pruned, 3", Some(0.82)),
            ("pruned, 2", Some(0.75)),
            ("pruned, 1", Some(0.71)),
            ("six, 3", None),
            ("six, 2", None),
            ("six, 1", None),
        ]
    );
    assert_eq!(report, timeless(table("4")), "side by side, the same");
    let first = &report["runs"][0];
    assert_eq!((&first["examples"], &first["total"]), (&24.into(), &12.into()));
    assert!(first["skipping_f1"].as_f64().unwrap() > 0.5, "{first}");
    let sets = ["experiment", "table2", "--set", &pruned, "--epochs", "1"];
    let text = text(&sets);
    assert!(text.contains("pruned, 2") && text.contains("0.75"), "{text}");
}

#[test]
fn table_3_tells_what_planning_costs() {
    let files = ["experiment", "table3", "--train", LEARN, "--test", JUDGE, "--epochs", "1"];
    let report = json(&[&files[..], &["--without-memo"]].concat());
    let names: Vec<&str> = rows(&report).into_iter().map(|(name, _)| name).collect();
    assert_eq!(
        names,
        [
            "no planning",
            "horizon 1",
            "horizon 10",
            "horizon 20",
            "horizon 1, no memo",
            "horizon 10, no memo",
            "horizon 20, no memo",
        ]
    );
    let runs = report["runs"].as_array().unwrap();
    assert_eq!(runs[0]["paper_seconds"], 87.18);
    assert!(runs[0].get("planner").is_none(), "learning itself calls no planner");
    for (with, without) in runs[1..4].iter().zip(&runs[4..]) {
        let calls = |run: &Value, kind: &str| run["planner"][kind].as_u64().unwrap();
        assert_eq!(
            calls(with, "calls") + calls(with, "saved"),
            calls(without, "calls"),
            "what the memo saves is asked anew without it"
        );
        for same in ["f1", "entries", "valid", "horizon", "paper_f1"] {
            assert_eq!(with[same], without[same], "{same}");
        }
        assert!(with["seconds"]["learning"].as_f64().unwrap() > 0.0);
        assert!(with["cpu_seconds"]["learning"].as_f64().unwrap() > 0.0);
    }
    let spent = json(&[&files[..], &["--budget", "0"]].concat());
    for run in &spent["runs"].as_array().unwrap()[1..] {
        assert_eq!(run["valid"], 0, "without a planner's leave nothing is valid");
        assert_eq!(run["planner"]["calls"], run["planner"]["given_up"]);
    }
    let text = text(&files);
    assert!(text.contains("47598") && text.contains("horizon 20"), "{text}");
}

#[test]
fn the_demonstration_does_what_it_never_heard() {
    let report = json(&["experiment", "demonstration"]);
    assert_eq!(report["reached"], true);
    assert_eq!(report["human"], "in(the agent, the λx. blue(x) ∧ room(x))");
    assert_eq!(report["heard"]["correct"], 6);
    let text = text(&["experiment", "demonstration", "--corpus", SIX]);
    assert!(text.contains("the goal holds") && text.contains("paper:"), "{text}");
    let other = ["experiment", "demonstration", "--command", "juggle"];
    let report = json(&other);
    assert_eq!((&report["reached"], &report["form"]), (&false.into(), &Value::Null));
    assert_eq!(report["reason"], "unknown_words");
}

#[test]
fn cross_validation_judges_every_row_once() {
    let cross = |more: &[&str]| {
        let all = ["experiment", "cross", "--corpus", LEARN, "--epochs", "1"];
        json(&[&all[..], more].concat())
    };
    for by in ["command", "row", "task"] {
        let report = cross(&["--by", by, "--folds", "4"]);
        assert_eq!((report["all"]["total"].as_u64(), &report["by"]), (Some(24), &by.into()));
        let runs = report["runs"].as_array().unwrap();
        assert_eq!(runs.len(), 4);
        for run in runs {
            let [learned, judged] = [&run["examples"], &run["total"]].map(|n| n.as_u64().unwrap());
            assert_eq!(learned + judged, 24);
        }
        // Just the second and third of the folds.
        let two = cross(&["--by", by, "--folds", "4", "--fold", "2", "3"]);
        let (two, all) = (timeless(two), timeless(report.clone()));
        let [two, all] = [&two, &all].map(|report| report["runs"].as_array().unwrap());
        assert_eq!(two[..], all[1..3]);
        // Nothing that a task's name can be learned from is on both sides.
        if by == "task" {
            assert!(runs.iter().all(|run| run["tasks"].as_array().unwrap().len() == 1));
        }
    }
    assert_eq!(cross(&["--with-rejected"])["all"]["total"], 26);
    let text = text(&["experiment", "cross", "--corpus", LEARN, "--epochs", "1"]);
    assert!(text.contains("fold 5") && text.contains("all folds: 24 commands"), "{text}");
}

#[test]
fn evaluate_says_more_than_its_contract() {
    let model = std::env::temp_dir().join(format!("groundling-evaluate-{}", std::process::id()));
    let model = model.to_str().unwrap();
    text(&["train", "--corpus", LEARN, "--out", model, "--epochs", "1"]);
    let report = json(&["evaluate", "--model", model, "--corpus", JUDGE]);
    let text = text(&["evaluate", "--model", model, "--corpus", JUDGE]);
    std::fs::remove_file(model).unwrap();
    let contract = ["total", "answered", "correct", "precision", "recall", "f1"];
    for prefix in ["", "skipping_", "resolved_", "resolved_skipping_"] {
        for key in contract {
            assert!(report[format!("{prefix}{key}")].is_number(), "{prefix}{key}");
        }
    }
    assert!(report["seconds"].is_number());
    for figure in ["precision", "recall", "f1"] {
        for key in [figure.to_owned(), format!("skipping_{figure}")] {
            let [low, high] = [0, 1].map(|end| report["intervals"][&key][end].as_f64().unwrap());
            let figure = report[&key].as_f64().unwrap();
            assert!(low <= figure && figure <= high, "{key}: {figure} in [{low}, {high}]");
        }
    }
    let tasks = report["tasks"].as_array().unwrap();
    assert_eq!(tasks.len(), 4);
    for key in ["total", "answered", "correct", "skipping_answered", "skipping_correct"] {
        let sum: u64 = tasks.iter().map(|task| task[key].as_u64().unwrap()).sum();
        assert_eq!(Some(sum), report[key].as_u64(), "{key}");
    }
    let wrong = report["skipping_answered"].as_u64().unwrap()
        - report["skipping_correct"].as_u64().unwrap();
    let cells = report["confusion"].as_array().unwrap();
    let confused: u64 = cells.iter().map(|cell| cell["count"].as_u64().unwrap()).sum();
    assert_eq!(confused, wrong);
    assert!(text.contains("12 commands") && text.contains("agent-in-blue"), "{text}");
}

#[test]
fn what_cannot_be_run_is_told_in_one_line() {
    for (arguments, said) in [
        ("", "no experiment given"),
        ("table9", "no experiment `table9`: use one of table2, table3, demonstration, cross"),
        ("table2", "--set NAME=TRAIN,TEST is missing"),
        ("table2 --set raw", "--set `raw`: write NAME=TRAIN,TEST"),
        ("table2 --set raw=a,", "--set `raw=a,`"),
        ("table2 --set raw=no/such.csv,no/such.csv", "cannot read no/such.csv"),
        ("table2 --demonstrations 2", "--demonstrations"),
        ("table3", "--train FILE is missing"),
        ("table3 --train assets/corpus/six.csv", "--test FILE is missing"),
        ("table3 --budget many", "many"),
        ("demonstration --world assets/corpus/six.csv", "assets/corpus/six.csv"),
        ("demonstration --lexicon README.md", "README.md"),
        ("cross", "--corpus FILE is missing"),
        ("cross --corpus assets/corpus/six.csv --folds 7", "--folds"),
        ("cross --corpus assets/corpus/six.csv --folds 1", "--folds"),
        ("cross --corpus assets/corpus/six.csv --fold 6", "--fold 6"),
        ("cross --corpus assets/corpus/six.csv --by colour", "--by `colour`"),
        ("cross --corpus assets/corpus/six.csv --epochs 0", "--epochs must be at least 1"),
        ("cross --corpus assets/corpus/six.csv --jobs 0", "--jobs must be at least 1"),
        ("cross --colour", "--colour"),
        ("cross six.csv", "six.csv"),
    ] {
        let all: Vec<&str> = ["experiment"].into_iter().chain(arguments.split(' ')).collect();
        let all = if arguments.is_empty() { &all[..1] } else { &all[..] };
        let output = call(all, "");
        let error = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments}: {error}");
        assert!(output.stdout.is_empty(), "{arguments}");
        assert_eq!(error.lines().count(), 1, "{arguments}: {error}");
        assert!(error.contains(said), "{arguments}: {error}");
    }
}
