//! The command `holds`, run as a person or a script runs it: every conformance case, and bad lines answered
//! in their place.

use crate::command::{answers, run};

const CASES: &str = include_str!("../data/conformance/goals.jsonl");

#[test]
fn every_conformance_case_is_answered_as_it_says() {
    let output = run("holds", CASES);
    assert!(output.status.success(), "{output:?}");
    let answers = answers(&output);
    assert_eq!(answers.len(), CASES.lines().count());
    for (line, (case, answer)) in (1..).zip(CASES.lines().zip(answers)) {
        let case: serde_json::Value = serde_json::from_str(case).unwrap();
        assert_eq!(answer, serde_json::json!({ "holds": case["holds"] }), "line {line}");
    }
}

#[test]
fn a_bad_line_is_answered_in_its_place() {
    let good = CASES.lines().next().unwrap();
    for (bad, said) in [
        ("not JSON".to_owned(), "expected"),
        (good.replacen("\"initial\"", "\"start\"", 1), "give either initial and current, or run"),
        (good.replacen("(in:", "((in:", 1), "goal: "),
        (good.replacen("(red:", "(purple:", 1), "goal: unknown constant purple"),
        (good.replacen("\"west\"", "\"up\"", 1), "initial: unknown direction `up`"),
    ] {
        let output = run("holds", &format!("{good}\n{bad}\n{good}\n"));
        assert_eq!(output.status.code(), Some(2), "{bad}");
        let answers = answers(&output);
        assert_eq!(answers.len(), 3, "{bad}");
        assert!(answers[0]["holds"].is_boolean() && answers[2]["holds"].is_boolean());
        assert_eq!(answers[1]["line"], 2);
        assert!(answers[1]["error"].as_str().unwrap().contains(said), "{:?}", answers[1]);
    }
}
