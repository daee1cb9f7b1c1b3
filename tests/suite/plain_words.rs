//! No message speaks of the program: whatever JSON stands where something else should, it is refused in the words of whoever
//! wrote it. Every text from outside is tried with a value of every kind at each of its paths, and without each.

use crate::command::{answers, run};
use crate::corpus::PRE;
use crate::study::files::{item, run as shown};
use groundling::corpus::{Corpus, Mapping, Options, States, read};
use groundling::domain::State;
use groundling::learn::runs::{Matrix, Plan, Shard, join};
use groundling::learn::sheet::{Sheet, decided};
use groundling::robot::frame::Frame;
use groundling::study::gather::Gathering;
use groundling::study::survey::mapping::SurveyMapping;
use groundling::study::{End, Study};
use groundling::ui::talk::share::session::Session;
use groundling::ui::train::data::pack;
use groundling::ui::train::{experiments, run as training};
use serde_json::Value;
use std::sync::Arc;

/// One of every kind.
const VALUES: [&str; 14] = [
    "true",
    "7",
    "-1",
    "1.5",
    "99999999999999999999",
    "1e400",
    "\"\"",
    "\"x\"",
    "[]",
    "[7]",
    "[\"x\",\"y\"]",
    "{}",
    "{\"x\":1}",
    "null",
];

/// What only the program says.
const FORBIDDEN: [&str; 17] = [
    "struct",
    "enum",
    "variant",
    "i32",
    "i64",
    "u32",
    "u64",
    "usize",
    "f32",
    "f64",
    "sequence",
    "tuple",
    "newtype",
    "unit",
    "Some",
    "None",
    "identifier",
];

/// The word of the program that a message speaks, if it speaks one.
pub(crate) fn spoken(message: &str) -> Option<&str> {
    // The names of our own commands and fields are words of the files.
    let mut words = message.split(|c: char| !c.is_alphanumeric() && c != '_');
    let phrase = ["invalid length", "::"].into_iter().find(|phrase| message.contains(phrase));
    // To map columns, and a file, is ours to say.
    let maps = message.contains("map the");
    // The words that may stand somewhere are written in small letters.
    let listed = message.split_once("expected one of ").map_or("", |(_, listed)| listed);
    let listed = listed.split('`').skip(1).step_by(2);
    let strange = listed.into_iter().find(|word| word.starts_with(char::is_uppercase));
    words.find(|word| FORBIDDEN.contains(word) || *word == "map" && !maps).or(phrase).or(strange)
}

/// The paths of all that is in a value.
fn paths(value: &Value, path: String, all: &mut Vec<String>) {
    match value {
        Value::Object(fields) => {
            fields.iter().for_each(|(key, value)| paths(value, format!("{path}/{key}"), all));
        }
        Value::Array(items) => {
            // What the first and the last show, those between show as well.
            for at in [0, items.len().saturating_sub(1)] {
                items.get(at).iter().for_each(|item| paths(item, format!("{path}/{at}"), all));
            }
        }
        _ => {}
    }
    all.push(path);
}

/// A text with each value at each of its paths, without each key, and with one more.
fn spoilt(good: &str) -> Vec<String> {
    let good: Value = serde_json::from_str(good).unwrap();
    let mut all = Vec::new();
    paths(&good, String::new(), &mut all);
    let mut texts = Vec::new();
    for path in all {
        let mut other = good.clone();
        *other.pointer_mut(&path).unwrap() = "@@".into();
        let text = other.to_string();
        texts.extend(VALUES.map(|value| text.replace("\"@@\"", value)));
        let mut other = good.clone();
        if let Some(Value::Object(fields)) = other.pointer_mut(&path) {
            fields.insert("@".to_owned(), 7.into());
            texts.push(other.to_string());
        }
        let (parent, key) = path.rsplit_once('/').unwrap_or_default();
        let mut other = good.clone();
        if let Some(Value::Object(fields)) = other.pointer_mut(parent) {
            fields.remove(key);
            texts.push(other.to_string());
        }
    }
    texts
}

/// Reads all that can become of a good text; no message speaks of the program, and some of them say something.
#[track_caller]
fn check<E: ToString>(good: &str, read: impl Fn(&str) -> Result<(), E>) {
    if let Err(error) = read(good) {
        panic!("{}: {good}", error.to_string());
    }
    let refused = spoilt(good).into_iter().filter_map(|text| Some((read(&text).err()?, text)));
    let mut n = 0;
    for (error, text) in refused {
        let message = error.to_string();
        assert_eq!(spoken(&message), None, "{message}\n{text}");
        assert!(message.len() < 1_000, "{message}");
        n += 1;
    }
    assert!(n > 10, "{n} of {good}");
}

fn six() -> Corpus {
    let six = std::fs::read("assets/corpus/six.csv").unwrap();
    read(six.as_slice(), Options::default()).0
}

fn plan() -> Plan {
    let rows = six().examples;
    let matrix = Matrix::Once;
    matrix.plan(&Default::default(), &rows, (&[0, 1, 2], &[3, 4, 5])).unwrap()
}

/// The rows of a file of JSON, or what is wrong with them.
fn rows(text: &str, mapping: &Mapping) -> Result<(), String> {
    let options = Options { with_rejected: true, mapping: mapping.clone() };
    let (_, flaws) = read(text.as_bytes(), options);
    let said: Vec<String> = flaws.iter().map(ToString::to_string).collect();
    if said.is_empty() { Ok(()) } else { Err(said.join("\n")) }
}

#[test]
fn rows_and_worlds() {
    let none = Mapping::default();
    let pair = format!("{{\"pre\":{PRE},\"post\":{PRE}}}");
    let run = format!("{{\"start\":{PRE},\"actions\":\"n\",\"contrast\":[\"e\"]}}");
    check(
        &format!(
            "{{\"id\":\"a\",\"command\":\"go\",\"Reject\":\"\",\"pairs\":[{pair}],\"runs\":[{run}]}}"
        ),
        |text| rows(text, &none),
    );
    check(
        &format!("{{\"Answer.taskAnswers\":[{{\"command\":\"go\"}}],\"Input.pre_1\":{PRE},\"Input.post_1\":{PRE},\"Input.run_1\":{run}}}")
            .replace("[{\"command\":\"go\"}]", "\"[{\\\"command\\\":\\\"go\\\"}]\""),
        |text| rows(text, &none),
    );
    let states = States { pre: "b".to_owned(), post: "a".to_owned() };
    let mapping =
        Mapping { command: Some("said".to_owned()), pairs: vec![states], ..Mapping::default() };
    check(&format!("{{\"said\":\"go\",\"b\":{PRE},\"a\":{PRE}}}"), |text| rows(text, &mapping));
    check(PRE, |text| State::read(text).map(drop));
    check(&mapping.write(), |text| Mapping::read(text).map(drop));
    for cell in ["[{\"command\":\"go\"}]", "{\"command\":\"go\",\"more\":[1]}"] {
        check(&format!("{{\"Answer.taskAnswers\":{cell}}}"), |text| {
            let cell =
                text.strip_prefix("{\"Answer.taskAnswers\":").and_then(|t| t.strip_suffix('}'));
            let quoted = cell.unwrap_or(text).replace('"', "\"\"");
            let state = PRE.replace('"', "\"\"");
            let table = format!(
                "Input.pre_1,Input.post_1,Answer.taskAnswers\n\"{state}\",\"{state}\",\"{quoted}\"\n"
            );
            rows(&table, &none)
        });
    }
}

#[test]
fn studies_and_their_answers() {
    let mut study = Study::new("A study", vec![item("i0", 1), item("i1", 1)]);
    study.items[1].shows = vec![shown("e")];
    study.hosts = vec!["https://panel.example".to_owned()];
    study.ends = vec![
        End::Endpoint { url: "https://panel.example/in".into(), key: "k".into() },
        End::Form { url: None },
        End::File,
    ];
    check(&study.write(), |text| Study::read(text).map(drop));
    check(
        "{\"shown\":3,\"asked\":2,\"order\":\"fixed\",\"again\":\"resume\",\"words\":{\"welcome\":\"x\"},\"ends\":[{\"form\":{\"url\":\"x\"}}],\"pay\":{\"cents\":5,\"currency\":\"EUR\"},\"care\":{}}",
        |text| study.with(text).map(drop),
    );
    let survey = SurveyMapping {
        command: "said".to_owned(),
        pairs: vec![States { pre: "b".to_owned(), post: "a".to_owned() }],
        ..SurveyMapping::default()
    };
    check(&survey.write(), |text| SurveyMapping::read(text).map(drop));
    let answer = crate::study::reviews::answer(&study, "w", 1, "go");
    check(&serde_json::to_string(&answer).unwrap(), |text| {
        let mut all = Gathering::new(text);
        while all.step() {}
        let said: Vec<String> = all.flaws.iter().map(ToString::to_string).collect();
        if said.is_empty() { Ok(()) } else { Err(said.join("\n")) }
    });
}

#[test]
fn plans_and_their_results() {
    let plan = plan();
    check(&plan.write(), |text| Plan::read(text).map(drop));
    for matrix in [
        "\"once\"",
        "{\"table2\":{\"set\":\"raw\"}}",
        "{\"cross\":{\"folds\":3,\"by\":\"row\"}}",
        "{\"curve\":{\"percents\":[10],\"by\":\"worker\"}}",
        "{\"ablation\":{\"kinds\":[\"pair\"],\"demonstrations\":[1]}}",
    ] {
        check(matrix, |text| Matrix::read(text).map(drop));
    }
    let rows: Arc<[_]> = six().examples.into();
    let shard = Shard::new(plan.clone(), rows, vec![]).unwrap().end(None);
    let result = "{\"run\":0}";
    let shard = shard.replace("\"results\":[]", &format!("\"results\":[{result}]"));
    for text in spoilt(&shard) {
        let said = join(&plan, &[text]).unwrap_err();
        assert_eq!(spoken(&said), None, "{said}");
    }
}

#[test]
fn what_the_page_keeps() {
    check(&experiments::file::write(&plan().write(), None), |text| {
        experiments::file::read("x", text).map(drop)
    });
    let run = training::state::Run::new(Default::default(), "a".to_owned(), "b".to_owned());
    check(&training::file::write(&run), |text| training::file::read("x", text).map(drop));
    let head = String::from_utf8(pack::write(&[], false, Some("x".to_owned()))).unwrap();
    check(head.trim_end(), |text| pack::read(format!("{text}\n").as_bytes()).map(drop));
    let sheet = || Sheet::new(Vec::new(), six().examples, true);
    check(&decided::write(&sheet()), |text| decided::take(&mut sheet(), text));
    check(&crate::ui::share::session().write(), |text| Session::read(text).map(drop));
    check(
        "{\"op\":\"subscribe\",\"topic\":\"/odom\",\"type\":\"x\",\"throttle_rate\":7}",
        |text| Frame::read(text).map(drop),
    );
}

#[test]
fn questions_a_line() {
    let case = include_str!("../data/conformance/goals.jsonl").lines().next().unwrap();
    let goal = "\"goal\":\"true:t\"";
    for (command, good) in [
        ("holds", case.to_owned()),
        ("holds", format!("{{{goal},\"run\":[{PRE}]}}")),
        ("equivalent", format!("{{\"a\":\"true:t\",\"b\":\"true:t\",\"initial\":{PRE}}}")),
        (
            "plan",
            format!(
                "{{{goal},\"initial\":{PRE},\"pull\":false,\"landmarks\":\"free\",\"steps\":7,\"rollouts\":1,\"slip_probability\":0.5}}"
            ),
        ),
    ] {
        let lines = spoilt(&good).join("\n");
        let output = run(command, &format!("{good}\n{lines}\n"));
        let answers = answers(&output);
        assert!(answers[0]["error"].is_null(), "{}", answers[0]);
        assert_eq!(answers.len(), 1 + lines.lines().count());
        let said = answers.iter().filter_map(|answer| answer["error"].as_str());
        assert!(said.clone().count() > 20);
        for message in said {
            assert_eq!(spoken(message), None, "{command}: {message}");
        }
    }
}
