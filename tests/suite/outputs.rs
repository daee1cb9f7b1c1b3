//! Where the command line's results go: devices, pipes, links, modes, standard output, several runs at once; and what it
//! says of the rows of the files it was given.

use super::command::call;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

const SIX: &str = "assets/corpus/six.csv";

/// An empty folder for a test.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Trains for a pass, with more arguments.
fn train(arguments: &[&str], input: &str) -> Output {
    let lexicon = ["train", "--lexicon", "assets/lexicon/demonstration.txt", "--epochs", "1"];
    call(&[&lexicon[..], arguments].concat(), input)
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

/// The names in a folder.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

fn is_model(text: &str) -> bool {
    text.starts_with("groundling model") && text.ends_with("end\n")
}

#[test]
fn a_minus_is_standard_output_and_the_report_goes_beside() {
    let output = train(&["--corpus", SIX, "--json", "--out", "-"], "");
    assert!(output.status.success() && is_model(text(&output.stdout)));
    assert!(text(&output.stderr).contains("\"examples\":6"), "{}", text(&output.stderr));
    assert!(!Path::new("-").exists());
}

#[cfg(unix)]
#[test]
fn what_the_name_stands_for_is_written() {
    use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
    let folder = folder("outputs");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();

    fs::write(at("target.model"), "old").unwrap();
    fs::set_permissions(at("target.model"), fs::Permissions::from_mode(0o600)).unwrap();
    symlink("target.model", at("link.model")).unwrap();
    symlink("new.model", at("dangling.model")).unwrap();
    for link in ["link.model", "dangling.model"] {
        let output = train(&["--corpus", SIX, "--out", &at(link)], "");
        assert!(output.status.success(), "{}", text(&output.stderr));
        assert!(fs::symlink_metadata(at(link)).unwrap().is_symlink(), "{link}");
    }
    assert!(is_model(&fs::read_to_string(at("target.model")).unwrap()));
    assert!(is_model(&fs::read_to_string(at("new.model")).unwrap()));
    let mode = fs::metadata(at("target.model")).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o600, "the mode is kept");

    let made = std::process::Command::new("mkfifo").arg(at("pipe")).status().unwrap();
    assert!(made.success());
    let pipe = at("pipe");
    let reader = std::thread::spawn(move || fs::read_to_string(pipe).unwrap());
    assert!(train(&["--corpus", SIX, "--out", &at("pipe")], "").status.success());
    assert!(is_model(&reader.join().unwrap()));
    assert!(fs::symlink_metadata(at("pipe")).unwrap().file_type().is_fifo());

    // Only root can make a device; the machine's own serves as well when nothing is beside it to be replaced.
    let made =
        std::process::Command::new("mknod").args([&at("null"), "c", "1", "3"]).output().unwrap();
    let null = if made.status.success() { at("null") } else { "/dev/null".to_owned() };
    assert!(train(&["--corpus", SIX, "--out", &null], "").status.success());
    assert!(fs::symlink_metadata(&null).unwrap().file_type().is_char_device());
    assert!(!names(&folder).iter().any(|name| name.ends_with(".part")), "{:?}", names(&folder));
}

#[test]
fn runs_at_once_do_not_disturb_each_other() {
    let folder = folder("at-once");
    let (out, checkpoint) = (folder.join("a.model"), folder.join("a.checkpoint"));
    let (out, checkpoint) = (out.to_str().unwrap(), checkpoint.to_str().unwrap());
    std::thread::scope(|scope| {
        for _ in 0..6 {
            scope.spawn(|| {
                let output =
                    train(&["--corpus", SIX, "--out", out, "--checkpoint", checkpoint], "");
                assert!(output.status.success(), "{}", text(&output.stderr));
            });
        }
    });
    assert_eq!(names(&folder), ["a.checkpoint", "a.model"]);
    let again = train(
        &["--corpus", SIX, "--resume", checkpoint, "--checkpoint", checkpoint, "--out", out],
        "",
    );
    assert!(again.status.success(), "{}", text(&again.stderr));
}

#[test]
fn places_are_tried_before_the_work_and_no_corpus_is_replaced() {
    let folder = folder("places");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    fs::copy(SIX, at("six.csv")).unwrap();
    let refused = |arguments: &[&str], why: &str| {
        let output = train(arguments, "");
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(why) && !said.contains("epoch"), "{said}");
    };
    refused(&["--corpus", SIX, "--out", &at("missing/x.model")], "cannot write");
    refused(
        &["--corpus", SIX, "--out", &at("x"), "--checkpoint", &at("missing/x")],
        "cannot write",
    );
    let one = ["--corpus", SIX, "--out", &at("x"), "--checkpoint", &at("./x")];
    refused(&one, "name one file");
    refused(&["--corpus", SIX, "--out", folder.to_str().unwrap()], "cannot write");
    refused(&["--corpus", &at("six.csv"), "--out", &at("./six.csv")], "is read as well");
    refused(
        &[
            "--corpus",
            SIX,
            "--held-out",
            &at("six.csv"),
            "--out",
            &at("x"),
            "--checkpoint",
            &at("six.csv"),
        ],
        "is read as well",
    );
    refused(&["--corpus", SIX, "--out", &at("x"), "--out", &at("y")], "--out is given twice");
    assert_eq!(names(&folder), ["six.csv"]);
    assert_eq!(fs::read(at("six.csv")).unwrap(), fs::read(SIX).unwrap());
}

#[test]
fn every_report_says_what_became_of_the_rows() {
    let folder = folder("rows");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let six = fs::read_to_string(SIX).unwrap();
    let rejected = |n: usize| -> String {
        let row = |(at, line): (usize, &str)| match line.rsplit_once(',') {
            Some((row, _)) if (1..=n).contains(&at) => format!("{row},\"too vague\"\n"),
            _ => format!("{line}\n"),
        };
        six.lines().enumerate().map(row).collect()
    };
    fs::write(at("two.csv"), rejected(2)).unwrap();
    fs::write(at("all.csv"), rejected(6)).unwrap();
    fs::write(
        at("no-name"),
        format!("\u{feff}{}", six.replacen("\"\"agent\"\"", "\"\"agnt\"\"", 1)),
    )
    .unwrap();
    let figures = |report: &Value| {
        ["rows", "rejected", "left_out"].map(|name| report[name].as_u64().unwrap())
    };

    let output =
        train(&["--corpus", &at("two.csv"), &at("no-name"), "--json", "--out", &at("a.model")], "");
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((figures(&report), report["examples"].as_u64()), ([12, 2, 1], Some(9)));
    let said = text(&output.stderr);
    assert!(
        said.contains(
            "6 rows: 4 used, 2 rejected, 0 left out (--with-rejected uses rejected rows)"
        ),
        "{said}"
    );

    let evaluate = [
        "evaluate",
        "--model",
        &at("a.model"),
        "--json",
        "--corpus",
        &at("two.csv"),
        "--corpus",
        "-",
    ];
    let output = call(&evaluate, &six);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((figures(&report), report["total"].as_u64()), ([12, 2, 0], Some(10)));

    let output = train(&["--corpus", &at("all.csv"), "--out", &at("b.model")], "");
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(said.contains("all its 6 rows are rejected (--with-rejected uses them)"), "{said}");
    let output =
        train(&["--corpus", &at("all.csv"), "--with-rejected", "--out", &at("b.model")], "");
    assert!(output.status.success());
    let large = fs::File::create(at("large.csv")).unwrap();
    large.set_len((64 << 20) + 1).unwrap();
    let output = train(&["--corpus", &at("large.csv"), "--out", &at("b.model")], "");
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(said.contains("the file has 65 MB, more than 64; split it"), "{said}");
}

#[test]
fn a_byte_order_mark_is_no_part_of_a_file_and_no_message_speaks_of_the_program() {
    let folder = folder("marks");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let lexicon = fs::read_to_string("assets/lexicon/demonstration.txt").unwrap();
    fs::write(at("lexicon.txt"), format!("\u{feff}{lexicon}")).unwrap();
    let arguments = [
        "train",
        "--epochs",
        "1",
        "--corpus",
        SIX,
        "--lexicon",
        &at("lexicon.txt"),
        "--out",
        &at("a.model"),
    ];
    let output = call(&arguments, "");
    assert!(output.status.success(), "{}", text(&output.stderr));
    let model = fs::read_to_string(at("a.model")).unwrap();
    fs::write(at("marked.model"), format!("\u{feff}{model}")).unwrap();
    let parse = |model: &str, input: &str| call(&["parse", "--model", model], input);
    assert!(parse(&at("marked.model"), "go to the red room\n").status.success());
    fs::write(at("spaces.model"), model.replace('\t', "    ")).unwrap();
    let said = parse(&at("spaces.model"), "").stderr;
    assert!(
        !text(&said).contains("Some(") && text(&said).contains("between tabs"),
        "{}",
        text(&said)
    );
    let long = parse(&at("a.model"), &format!("{}\n", "a".repeat(100_000))).stdout;
    assert!(text(&long).contains("\"reason\":\"too_long\""), "{}", text(&long).len());
    for input in
        ["7\n", "[]\n", "{\"goal\": 7}\n", "{\"goal\":\"x\",\"initial\":7,\"current\":7}\n"]
    {
        for command in ["holds", "plan"] {
            let output = call(&[command], input);
            let said = text(&output.stdout);
            let is_ours = |word: &str| said.contains(word);
            assert!(
                !["struct ", "enum ", "Some("].iter().any(|w| is_ours(w)),
                "{command} {input}: {said}"
            );
        }
    }
}
