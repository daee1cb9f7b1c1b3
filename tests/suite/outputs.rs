//! Where the command line's results go: devices, pipes, links, modes, standard output, several runs at once; and that none
//! replaces what is read.

use super::command::call;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

pub(crate) const SIX: &str = "assets/corpus/six.csv";

/// An empty folder for a test.
pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Trains for a pass, with more arguments.
pub(crate) fn train(arguments: &[&str], input: &str) -> Output {
    let lexicon = ["train", "--lexicon", "assets/lexicon/demonstration.txt", "--epochs", "1"];
    call(&[&lexicon[..], arguments].concat(), input)
}

pub(crate) fn text(bytes: &[u8]) -> &str {
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

    let made = Command::new("mkfifo").arg(at("pipe")).status().unwrap();
    assert!(made.success());
    let pipe = at("pipe");
    let reader = std::thread::spawn(move || fs::read_to_string(pipe).unwrap());
    assert!(train(&["--corpus", SIX, "--out", &at("pipe")], "").status.success());
    assert!(is_model(&reader.join().unwrap()));
    assert!(fs::symlink_metadata(at("pipe")).unwrap().file_type().is_fifo());

    // Only root can make a device; the machine's own serves as well when nothing is beside it to be replaced.
    let made = Command::new("mknod").args([&at("null"), "c", "1", "3"]).output().unwrap();
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
    assert!(is_model(&fs::read_to_string(out).unwrap()));
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
    refused(&["--corpus", SIX, "--out", &at("missing/x.model")], "make its folder first");
    refused(
        &["--corpus", SIX, "--out", &at("x"), "--checkpoint", &at("missing/x")],
        "cannot write",
    );
    let one = ["--corpus", SIX, "--out", &at("x"), "--checkpoint", &at("./x")];
    refused(&one, "name one file");
    refused(&["--corpus", SIX, "--out", folder.to_str().unwrap()], "it is a folder");
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

/// A call whose input or output is a file.
fn redirected(arguments: &[&str], input: Option<&str>, output: Option<fs::File>) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_groundling"));
    command.args(arguments).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    if let Some(input) = input {
        command.stdin(fs::File::open(input).unwrap());
    }
    if let Some(output) = output {
        command.stdout(output);
    }
    command.spawn().unwrap().wait_with_output().unwrap()
}

/// That a call is refused, and why.
#[track_caller]
fn refuses(output: &Output, why: &str) {
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains(why) && !said.contains("epoch 1"), "{said}");
}

#[cfg(unix)]
#[test]
fn a_file_is_known_whatever_it_is_called_and_however_it_is_written() {
    let folder = folder("known");
    // Beside a name as long as this no other can be made, as in a folder that lets none be made.
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let mut places = vec![at("six.csv"), at(&"n".repeat(250))];
    let memory = format!("/dev/shm/groundling-{}", std::process::id());
    if fs::write(&memory, "").is_ok() {
        places.push(memory.clone());
    }
    fs::create_dir(at("sub")).unwrap();
    std::os::unix::fs::symlink("six.csv", at("link")).unwrap();
    for place in &places {
        fs::copy(SIX, place).unwrap();
        let read = "is read as well";
        refuses(&train(&["--corpus", place, "--out", place], ""), read);
        refuses(&train(&["--corpus", SIX, "--held-out", place, "--out", place], ""), read);
        let into = ["train", "--corpus", "-", "--out", place];
        refuses(&redirected(&into, Some(place), None), read);
        let from = ["train", "--corpus", place, "--out", "-"];
        let open = fs::OpenOptions::new().append(true).open(place).unwrap();
        refuses(&redirected(&from, None, Some(open)), read);
        let twice = ["--corpus", SIX, "--out", place, "--checkpoint", place];
        refuses(&train(&twice, ""), "--out and --checkpoint name one file");
        assert_eq!(fs::read(place).unwrap(), fs::read(SIX).unwrap());
    }
    let link = ["--corpus", &at("six.csv"), "--out", &at("link")];
    refuses(&train(&link, ""), "is read as well");
    let around = at("sub/../new");
    let new = ["--corpus", SIX, "--out", &at("new"), "--checkpoint", &around];
    refuses(&train(&new, ""), "name one file");
    for place in &places {
        assert!(train(&["--corpus", SIX, "--out", place], "").status.success());
        assert!(is_model(&fs::read_to_string(place).unwrap()), "{place}");
    }
    let _ = fs::remove_file(memory);
}

#[cfg(unix)]
#[test]
fn standard_output_has_many_names() {
    let folder = folder("streams");
    let named = |out: &str, checkpoint: &str| {
        train(&["--corpus", SIX, "--out", out, "--checkpoint", checkpoint], "")
    };
    for (out, checkpoint) in [("-", "-"), ("-", "/dev/stdout"), ("/dev/stdout", "/dev/fd/1")] {
        refuses(&named(out, checkpoint), "--out and --checkpoint name standard output");
    }
    assert!(named("/dev/null", "/dev/null").status.success(), "what is lost may be lost twice");
    let train = ["train", "--corpus", SIX, "--epochs", "1", "--json", "--out", "/dev/stdout"];
    let output = redirected(&train, None, None);
    assert!(is_model(text(&output.stdout)) && text(&output.stderr).contains("\"examples\":6"));
    // Where it is a file the model stands in it, behind what was there, and no report over it.
    let place = folder.join("all");
    fs::write(&place, "before\n").unwrap();
    let open = fs::OpenOptions::new().append(true).open(&place).unwrap();
    assert!(redirected(&train, None, Some(open)).status.success());
    let all = fs::read_to_string(&place).unwrap();
    assert!(is_model(all.strip_prefix("before\n").unwrap()), "{all}");
}

#[cfg(unix)]
#[test]
fn a_checkpoint_goes_where_a_model_can() {
    let folder = folder("checkpoints");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    std::os::unix::fs::symlink("kept", at("link")).unwrap();
    assert!(Command::new("mkfifo").arg(at("pipe")).status().unwrap().success());
    let pipe = at("pipe");
    let reader = std::thread::spawn(move || fs::read_to_string(pipe).unwrap());
    for place in [at("link"), at("pipe"), "/dev/null".to_owned()] {
        let output = train(&["--corpus", SIX, "--out", &at("model"), "--checkpoint", &place], "");
        assert!(output.status.success(), "{place}: {}", text(&output.stderr));
    }
    assert_eq!(names(&folder), ["kept", "link", "model", "pipe"]);
    let kept = fs::read_to_string(at("kept")).unwrap();
    assert!(is_model(&kept) && fs::symlink_metadata(at("link")).unwrap().is_symlink());
    assert_eq!(reader.join().unwrap(), kept);
}

#[cfg(unix)]
#[test]
fn a_write_that_fails_leaves_nothing_and_a_new_file_has_the_ordinary_mode() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder("failed");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let shell = |before: &str, out: &str| {
        let train = "train --epochs 1 --corpus assets/corpus/six.csv";
        let binary = env!("CARGO_BIN_EXE_groundling");
        let script = format!("{before}; exec \"$1\" {train} --out \"$2\"");
        Command::new("sh").args(["-c", &script, "sh", binary, out]).output().unwrap()
    };
    fs::write(at("old"), "old").unwrap();
    for name in ["old", "new"] {
        // No file may grow beyond a block or two.
        let output = shell("trap '' XFSZ; ulimit -f 1", &at(name));
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains("cannot write"), "{}", text(&output.stderr));
    }
    assert_eq!((names(&folder), fs::read(at("old")).unwrap()), (vec!["old".into()], b"old".into()));
    fs::set_permissions(at("old"), fs::Permissions::from_mode(0o604)).unwrap();
    for (name, mode) in [("old", 0o604), ("new", 0o640)] {
        assert!(shell("umask 027", &at(name)).status.success());
        assert_eq!(fs::metadata(at(name)).unwrap().permissions().mode() & 0o777, mode, "{name}");
    }
    assert_eq!(names(&folder), ["new", "old"]);
}

#[test]
fn what_is_gone_on_from_may_be_replaced() {
    let folder = folder("into");
    let model = folder.join("a.model").to_str().unwrap().to_owned();
    assert!(train(&["--corpus", SIX, "--out", &model], "").status.success());
    let lesson = fs::read_to_string(SIX).unwrap().replace("the green room", "the emerald room");
    let corpus = folder.join("lesson.csv").to_str().unwrap().to_owned();
    fs::write(&corpus, lesson).unwrap();
    let output = call(&["train", "--into", &model, "--corpus", &corpus, "--out", &model], "");
    assert!(output.status.success(), "{}", text(&output.stderr));
    let taught = fs::read_to_string(&model).unwrap();
    assert!(is_model(&taught) && taught.contains("emerald"));
}

#[test]
fn every_command_tries_its_places_before_it_works() {
    let folder = folder("commands");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let study = call(&["generate", "--study", "Six", "--from", SIX], "").stdout;
    fs::write(at("study"), &study).unwrap();
    assert!(train(&["--corpus", SIX, "--out", &at("model")], "").status.success());
    let model = fs::read(at("model")).unwrap();
    let (study_file, model_file, pay) = (at("study"), at("model"), at("missing/pay"));
    let review = |more: &[&str]| {
        let begin = ["review", "--study", &study_file, "--answers", SIX];
        call(&[&begin[..], more].concat(), "")
    };
    refuses(&review(&["--out", &at("new"), "--pay", &pay]), "make its folder first");
    refuses(&review(&["--out", &at("new"), "--pay", &at("new")]), "--out and --pay name one file");
    let more = review(&["--pay", &at("new"), "--top-up", "2", &at("./new")]);
    refuses(&more, "--pay and --top-up name one file");
    refuses(&review(&["--out", &study_file]), "is read as well");
    refuses(&review(&["--model", &model_file, "--pay", &model_file]), "is read as well");
    let calibrate = ["calibrate", "--model", &model_file, "--corpus", SIX, "--out"];
    refuses(&call(&[&calibrate[..], &[&model_file]].concat(), ""), "is read as well");
    assert_eq!(names(&folder), ["model", "study"]);
    assert_eq!((fs::read(at("study")).unwrap(), fs::read(at("model")).unwrap()), (study, model));
    let output = review(&["--out", "-"]);
    assert!(text(&output.stdout).starts_with('"') || text(&output.stdout).starts_with("HITId"));
    assert!(text(&output.stderr).contains(" answers ("), "{}", text(&output.stderr));
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

/// The lines of a model that say how far it can be trusted.
fn doubt_of(model: &str) -> Vec<&str> {
    model.lines().filter(|line| line.starts_with("doubt\t")).collect()
}

#[test]
fn how_far_a_model_can_be_trusted_is_said_and_goes_with_it() {
    let folder = folder("doubt");
    let at = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    fs::write(at("map"), "doubt\tbias\t2\ndoubt\tthreshold\t0.7\n").unwrap();
    assert!(
        train(&["--corpus", SIX, "--doubt", &at("map"), "--out", &at("m")], "").status.success()
    );
    let model = fs::read_to_string(at("m")).unwrap();
    assert_eq!(doubt_of(&model), ["doubt\tbias\t2", "doubt\tthreshold\t0.7"]);
    let into = call(&["train", "--into", &at("m"), "--corpus", SIX, "--out", &at("more")], "");
    assert!(into.status.success(), "{}", text(&into.stderr));
    assert_eq!(doubt_of(&fs::read_to_string(at("more")).unwrap()), doubt_of(&model));
    let parse = call(&["parse", "--model", &at("m")], "go to the green room\n");
    let answer: serde_json::Value = serde_json::from_str(text(&parse.stdout)).unwrap();
    let probability = answer["probability"].as_f64().unwrap();
    assert!((probability - 1.0 / (1.0 + (-2.0f64).exp())).abs() < 1e-9, "{answer}");
    assert!(answer["asks"].is_null(), "above the threshold: {answer}");
    let judged = call(&["evaluate", "--model", &at("m"), "--corpus", SIX, "--json"], "");
    assert!(judged.stderr.is_empty() || !text(&judged.stderr).contains("how likely"));
    let judged: serde_json::Value = serde_json::from_str(text(&judged.stdout)).unwrap();
    assert_eq!(judged["asked"], 0);
    assert_eq!(judged["unasked_precision"], 1.0);
    assert!(judged["ece"].as_f64().is_some_and(|ece| (ece - (1.0 - probability)).abs() < 1e-9));
    let cuts = judged["risk_coverage"].as_array().unwrap();
    assert!(
        cuts.iter().any(|cut| cut["coverage"] == 1.0)
            && cuts.iter().any(|cut| cut["coverage"] == 0.0)
    );

    // A model from before there was a map still opens, and says that it has none.
    let old: String = model
        .lines()
        .filter(|line| !line.starts_with("doubt\t"))
        .map(|line| format!("{line}\n"))
        .collect();
    fs::write(at("old"), old).unwrap();
    let parse = call(&["parse", "--model", &at("old")], "go to the green room\n");
    let answer: serde_json::Value = serde_json::from_str(text(&parse.stdout)).unwrap();
    assert!(answer["probability"].is_null() && answer["forms"][0]["form"].is_string(), "{answer}");
    let judged = call(&["evaluate", "--model", &at("old"), "--corpus", SIX], "");
    assert!(text(&judged.stderr).contains("does not say how likely"), "{}", text(&judged.stderr));
    // Of another version, it is told what to do.
    let other = model.replacen("groundling model 1", "groundling model 0", 1);
    fs::write(at("other"), other).unwrap();
    let refused = call(&["parse", "--model", &at("other")], "");
    assert!(
        !refused.status.success() && text(&refused.stderr).contains("train"),
        "{}",
        text(&refused.stderr)
    );
}
