//! Every report says what became of the rows of the files that it is about; and what a file is goes by its content.

use super::command::call;
use super::outputs::{SIX, folder, text, train};
use serde_json::Value;
use std::fs;
use std::process::Output;

/// What a report says of rows: read, rejected, left out.
fn figures(report: &Value) -> [u64; 3] {
    ["rows", "rejected", "left_out"].map(|name| report[name].as_u64().unwrap())
}

#[track_caller]
fn json(output: &Output) -> Value {
    assert!(output.status.success(), "{}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The six rows with the last column of the first `n` filled: they are rejected.
fn rejected(n: usize) -> String {
    let six = fs::read_to_string(SIX).unwrap();
    let row = |(at, line): (usize, &str)| match line.rsplit_once(',') {
        Some((row, _)) if (1..=n).contains(&at) => format!("{row},\"too vague\"\n"),
        _ => format!("{line}\n"),
    };
    six.lines().enumerate().map(row).collect()
}

/// Nine rows, one of them rejected and one bad.
fn mixed() -> String {
    let six = fs::read_to_string(SIX).unwrap();
    let bad = six.replacen("\"\"agent\"\"", "\"\"agnt\"\"", 1);
    let rows = [six.lines().nth(1), six.lines().nth(2), bad.lines().nth(1)];
    rejected(1) + &rows.map(|row| row.unwrap().to_owned() + "\n").concat()
}

#[test]
fn every_report_says_what_became_of_the_rows() {
    let folder = folder("rows");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let six = fs::read_to_string(SIX).unwrap();
    fs::write(at("two.csv"), rejected(2)).unwrap();
    fs::write(at("all.csv"), rejected(6)).unwrap();
    fs::write(
        at("no-name"),
        format!("\u{feff}{}", six.replacen("\"\"agent\"\"", "\"\"agnt\"\"", 1)),
    )
    .unwrap();
    let output =
        train(&["--corpus", &at("two.csv"), &at("no-name"), "--json", "--out", &at("a.model")], "");
    let report = json(&output);
    assert_eq!((figures(&report), report["examples"].as_u64()), ([12, 2, 1], Some(9)));
    let said = text(&output.stderr);
    let two = "6 rows: 4 used, 2 rejected, 0 left out (--with-rejected uses rejected rows)";
    assert!(said.contains(two), "{said}");

    let evaluate = ["evaluate", "--model", &at("a.model"), "--json"];
    let corpora = ["--corpus", &at("two.csv"), "--corpus", "-"];
    let report = json(&call(&[&evaluate[..], &corpora].concat(), &six));
    assert_eq!((figures(&report), report["total"].as_u64()), ([12, 2, 0], Some(10)));

    let output = train(&["--corpus", &at("all.csv"), "--out", &at("b.model")], "");
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(said.contains("all its 6 rows are rejected (--with-rejected uses them)"), "{said}");
    let output =
        train(&["--corpus", &at("all.csv"), "--with-rejected", "--out", &at("b.model")], "");
    assert!(output.status.success());
}

#[test]
fn what_is_held_out_and_what_calibrates_is_counted() {
    let folder = folder("rows-held-out");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let (mix, model) = (at("mix.csv"), at("a.model"));
    fs::write(&mix, mixed()).unwrap();
    let output = train(&["--corpus", SIX, "--held-out", &mix, "--json", "--out", &model], "");
    let report = json(&output);
    assert_eq!((figures(&report), figures(&report["held_out"])), ([6, 0, 0], [9, 1, 1]));
    let said = text(&output.stderr);
    assert!(said.contains("held out: 9 rows: 7 used, 1 rejected, 1 left out"), "{said}");
    let report = json(&train(&["--corpus", SIX, "--json", "--out", &model], ""));
    assert!(report.get("held_out").is_none());

    let output = call(&["calibrate", "--model", &model, "--corpus", &mix, "--out", "-"], "");
    assert!(output.status.success());
    let said = text(&output.stderr);
    assert!(said.ends_with("9 rows: 7 used, 1 rejected, 1 left out\n"), "{said}");
}

#[test]
fn experiments_count_as_the_plan_does() {
    let folder = folder("rows-plans");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let (mix, plan, shard) = (at("mix.csv"), at("plan.json"), at("shard.json"));
    fs::write(&mix, mixed()).unwrap();
    let counts = "15 rows: 13 used, 1 rejected, 1 left out";
    let made = |more: &[&str]| {
        let arguments =
            ["experiment", "plan", "--corpus", &mix, "--held-out", SIX, "--epochs", "1"];
        let output = call(&[&arguments[..], more].concat(), "");
        assert!(output.status.success(), "{}", text(&output.stderr));
        output
    };
    let output = made(&[]);
    let said = text(&output.stderr);
    assert!(said.contains(&format!("{counts} (--with-rejected uses rejected rows)")), "{said}");
    assert!(!said.contains("0 rejected"), "{said}");
    fs::write(&plan, &output.stdout).unwrap();
    let given = ["--plan", &plan, "--corpus", &mix, SIX];
    let run = |kind: &str, more: &[&str]| {
        let output = call(&[&["experiment", kind], &given[..], more].concat(), "");
        assert!(output.status.success(), "{}", text(&output.stderr));
        assert!(text(&output.stderr).contains(counts), "{}", text(&output.stderr));
        output.stdout
    };
    let found = run("run", &["--json"]);
    let report: Value = serde_json::from_slice(&found).unwrap();
    assert_eq!(
        (figures(&report), report["results"][0]["examples"].as_u64()),
        ([15, 1, 1], Some(7))
    );
    assert!(text(&run("run", &[])).ends_with(&format!("\n{counts}\n")));
    fs::write(&shard, run("shard", &[])).unwrap();
    let join = ["experiment", "join", "--plan", &plan, "--shard", &shard, "--json"];
    assert_eq!(call(&join, "").stdout, found, "in shards");
    let said = made(&["--with-rejected"]).stderr;
    assert!(text(&said).contains("15 rows: 14 used, 0 rejected, 1 left out"), "{}", text(&said));

    let cross = ["experiment", "cross", "--corpus", &mix, "--epochs", "1", "--folds", "2"];
    let output = call(&cross, "");
    assert!(text(&output.stdout).starts_with("9 rows: 7 used, 1 rejected"));
    assert_eq!(figures(&json(&call(&[&cross[..], &["--json"]].concat(), ""))), [9, 1, 1]);
    let demonstration = json(&call(&["experiment", "demonstration", "--json"], ""));
    assert_eq!(figures(&demonstration), [6, 0, 0]);
}

#[test]
fn a_review_counts_what_was_read() {
    let folder = folder("rows-review");
    let mix = folder.join("mix.csv").to_str().unwrap().to_owned();
    fs::write(&mix, mixed()).unwrap();
    let review = |more: &[&str]| call(&[&["review", "--answers"], more].concat(), "");
    let report = json(&review(&[&mix, "--json"]));
    assert_eq!(figures(&report), [9, 1, 1]);
    let read = ["answers", "doubles", "left_out"].map(|name| report[name].as_u64().unwrap());
    assert_eq!(read.iter().sum::<u64>(), 9, "{report}");
    let told = review(&[&mix]).stdout;
    assert!(text(&told).starts_with("9 rows, 1 left out: "), "{}", text(&told));
    let lines = folder.join("lines.jsonl").to_str().unwrap().to_owned();
    fs::write(&lines, "{\"format\": \"another\"}\n{\"half\n").unwrap();
    let report = json(&review(&[&mix, &lines, "--json"]));
    assert_eq!(figures(&report), [11, 1, 3]);
}

#[test]
fn what_is_too_large_is_told_with_figures() {
    let folder = folder("rows-many");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let large = fs::File::create(at("large.csv")).unwrap();
    large.set_len((64 << 20) + 1).unwrap();
    let head = fs::read_to_string(SIX).unwrap().lines().next().unwrap().to_owned() + "\n";
    fs::write(at("many.csv"), head + &"x\n".repeat(100_001)).unwrap();
    for (file, why) in [
        ("large.csv", "the file has 65 MB, more than 64; split it"),
        ("many.csv", "the file has more than 100000 rows; split it"),
    ] {
        let model = "assets/model/cleanup.model";
        for arguments in [["train", "--out", "-"], ["evaluate", "--model", model]] {
            let output = call(&[&arguments[..], &["--corpus", &at(file)]].concat(), "");
            let said = text(&output.stderr);
            assert_eq!(output.status.code(), Some(2), "{said}");
            assert!(said.contains(why) && output.stdout.is_empty(), "{said}");
        }
    }
}

#[test]
fn a_file_is_what_is_in_it() {
    let folder = folder("rows-content");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let drawn = call(&["generate", "--tasks", "all", "--pairs", "1", "--json"], "");
    let lines = text(&drawn.stdout).to_owned();
    fs::write(at("lines.csv"), &lines).unwrap();
    for (corpus, input) in [("-", lines.as_str()), (&at("lines.csv"), "")] {
        let arguments =
            ["evaluate", "--model", "assets/model/cleanup.model", "--corpus", corpus, "--json"];
        let report = json(&call(&arguments, input));
        assert_eq!((figures(&report), report["total"].as_u64()), ([23, 0, 0], Some(23)));
    }
    let task = "task here\nsays one: Go to the red room.\ngoal (in:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) \
                (the:<<e,t>,e> (lambda $0:e (and:<t*,t> (room:<e,t> $0) (red:<e,t> $0)))))\n";
    fs::write(at("plain.txt"), task).unwrap();
    fs::write(at("marked.txt"), format!("\u{feff}{task}")).unwrap();
    let [plain, marked] = ["plain.txt", "marked.txt"].map(|name| {
        let output = call(&["generate", "--tasks", &at(name), "--pairs", "1"], "");
        assert!(output.status.success(), "{}", text(&output.stderr));
        output.stdout
    });
    assert_eq!(marked, plain);
}
