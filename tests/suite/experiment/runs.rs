//! `experiment plan`, `run`, `shard` and `join`, and `compare`, run as a script runs them.

use crate::command::call;
use std::path::PathBuf;

const SIX: &str = "assets/corpus/six.csv";
const LEARN: &str = "tests/data/corpus/crowd-learn.csv";

/// What a call that goes well prints.
#[track_caller]
fn text(arguments: &[&str]) -> String {
    let output = call(arguments, "");
    assert!(output.status.success(), "{arguments:?}: {output:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// A file with a text, for arguments.
fn kept(name: &str, text: &str) -> String {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("runs");
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn a_plan_is_repeated_by_one_by_several_and_in_shards() {
    let matrix = r#"{"ablation": {"kinds": ["pair", "head"], "demonstrations": []}}"#;
    let plan = ["experiment", "plan", "--corpus", SIX, "--held-out", SIX, "--epochs", "2"];
    let made = text(&[&plan[..], &["--matrix", matrix]].concat());
    assert_eq!(text(&[&plan[..], &["--matrix", matrix]].concat()), made);
    let plan = kept("plan.json", &made);
    let given = ["--plan", plan.as_str(), "--corpus", SIX, SIX];
    let run = |more: &[&str]| text(&[&["experiment", "run"], &given[..], more].concat());
    let all = run(&["--json", "--jobs", "1"]);
    assert_eq!(run(&["--json", "--jobs", "3"]), all, "one job or three");
    let shard =
        |runs: &[&str]| text(&[&["experiment", "shard"], &given[..], &["--run"], runs].concat());
    let shards = [kept("a.json", &shard(&["2", "0"])), kept("b.json", &shard(&["1"]))];
    let join = |more: &[&str]| {
        let [a, b] = &shards;
        text(&[&["experiment", "join", "--plan", &plan, "--shard", a, b], more].concat())
    };
    assert_eq!(join(&["--json"]), all, "in shards");
    let table = run(&["--csv"]);
    assert_eq!(join(&["--csv"]), table);
    assert!(table.ends_with("\r\n"), "every line ends alike, as in the file that the page saves");
    let report = run(&[]);
    assert_eq!(report.matches("\n| without ").count(), 2, "{report}");
    assert!(report.starts_with("# ablation\n"), "{report}");
    for (arguments, said) in [
        (
            &["experiment", "run", "--plan", &plan, "--corpus", LEARN][..],
            "the plan is for another corpus",
        ),
        (&["experiment", "run", "--plan", SIX, "--corpus", SIX], "no plan: "),
        (&["experiment", "join", "--plan", &plan, "--shard", &shards[0]], "run 1 is missing"),
        (&["experiment", "plan", "--corpus", SIX, "--matrix", "{}"], "--matrix {}"),
        (&["experiment", "plan", "--corpus", SIX], "Nothing is held out"),
    ] {
        let output = call(arguments, "");
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let error = String::from_utf8(output.stderr).unwrap();
        assert!(error.contains(said), "{error}");
    }
}

#[test]
fn two_models_are_held_against_each_other() {
    let model = |epochs: &str| {
        let lexicon = "assets/lexicon/demonstration.txt";
        let train =
            ["train", "--corpus", SIX, "--lexicon", lexicon, "--epochs", epochs, "--out", "-"];
        kept(&format!("{epochs}.model"), &text(&train))
    };
    let (one, two) = (model("1"), model("3"));
    let same: serde_json::Value =
        serde_json::from_str(&text(&["compare", &one, &one, "--json"])).unwrap();
    assert!(same["common"].as_u64() > Some(10));
    for part in ["facts", "entries", "features"] {
        assert_eq!(same[part].as_array().unwrap().len(), 0, "{part}");
    }
    let told = text(&["compare", &one, &two]);
    assert!(told.contains("epochs: 1 → 3") && told.contains("entries of both"), "{told}");
    let output = call(&["compare", &one], "");
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn training_takes_a_mapping_packed_files_and_does_without_features() {
    let lexicon = "assets/lexicon/demonstration.txt";
    let train = |corpus: &str, more: &[&str]| {
        let begin =
            ["train", "--corpus", corpus, "--lexicon", lexicon, "--epochs", "2", "--out", "-"];
        text(&[&begin[..], more].concat())
    };
    let plain = train(SIX, &[]);
    let own = std::fs::read_to_string(SIX).unwrap().replacen("Answer.command", "said", 1);
    let mut mapping = groundling::corpus::preview(own.as_bytes()).unwrap().proposal;
    mapping.task = None;
    let mapping = kept("mapping.json", &mapping.write());
    assert_eq!(train(&kept("own.csv", &own), &["--mapping", &mapping]), plain);
    let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    std::io::Write::write_all(&mut packer, &std::fs::read(SIX).unwrap()).unwrap();
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("runs");
    let packed = folder.join("six.gz");
    std::fs::write(&packed, packer.finish().unwrap()).unwrap();
    assert_eq!(train(packed.to_str().unwrap(), &[]), plain);
    let less = train(SIX, &["--without", "pair", "head"]);
    assert!(less.contains("fact\twithout\tpair head\n") && less != plain);
    assert!(train(SIX, &["--margin", "1"]).contains("fact\tmargin\t1\n"));
    for (bad, said) in [
        (&["--without", "words"][..], "--without `words`: use one of lexeme"),
        (&["--margin", "-1"], "--margin"),
        (&["--mapping", SIX], "no mapping"),
    ] {
        let begin = ["train", "--corpus", SIX, "--out", "-"];
        let output = call(&[&begin[..], bad].concat(), "");
        assert_eq!(output.status.code(), Some(2), "{bad:?}");
        let error = String::from_utf8(output.stderr).unwrap();
        assert!(error.contains(said), "{error}");
    }
}
