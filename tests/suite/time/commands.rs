//! `holds` and `equivalent` of goals in time, as a script asks them.

use crate::command::{answers, run};
use serde_json::{Value, json};

const RUNS: &str = include_str!("../../data/conformance/runs.jsonl");

#[test]
fn every_run_of_the_conformance_file_is_judged_as_it_says() {
    let output = run("holds", RUNS);
    assert!(output.status.success(), "{output:?}");
    let answers = answers(&output);
    assert_eq!(answers.len(), RUNS.lines().count());
    for (line, (case, answer)) in (1..).zip(RUNS.lines().zip(answers)) {
        let case: Value = serde_json::from_str(case).unwrap();
        assert_eq!(answer, json!({ "holds": case["holds"], "at": case["at"] }), "line {line}");
    }
}

pub(super) fn in_room(color: &str) -> String {
    format!(
        "(in:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) (the:<<e,t>,e> (lambda $0:e (and:<t*,t> ({color}:<e,t> $0) (room:<e,t> $0)))))"
    )
}

pub(super) fn reach(what: &str, then: &str) -> String {
    format!("(until:<t,<t,<p,p>>> true:t {what} {then})")
}

#[test]
fn tasks_are_compared_with_and_without_a_world() {
    let (red, yellow) = (in_room("red"), in_room("yellow"));
    let case: Value = serde_json::from_str(RUNS.lines().next().unwrap()).unwrap();
    let world = &case["run"][0];
    let never = format!("(always:<t,p> (not:<t,t> {yellow}))");
    let strict = format!(
        "(until:<t,<t,<p,p>>> (not:<t,t> {yellow}) (and:<t*,t> (not:<t,t> {yellow}) {red}) done:p)"
    );
    let both = format!("(and:<t*,t> {red} {yellow})");
    let input = [
        // A goal is the task to reach it; a prohibition beside a goal is one until.
        json!({ "a": red, "b": reach(&red, "done:p") }),
        json!({ "a": format!("(all:<p*,p> {never} {})", reach(&red, "done:p")), "b": strict }),
        // Order matters.
        json!({ "a": reach(&red, &reach(&yellow, "done:p")), "b": reach(&yellow, &reach(&red, "done:p")) }),
        // Only a world says that nobody is in two rooms.
        json!({ "a": both, "b": "false:t" }),
        json!({ "a": both, "b": "false:t", "initial": world }),
        json!({ "a": red, "b": "(red:<e,t> a:e" }),
    ];
    let output = run("equivalent", &input.map(|line| line.to_string() + "\n").concat());
    assert_eq!(output.status.code(), Some(2));
    let answers = answers(&output);
    assert_eq!(answers[0], json!({ "equivalent": true }));
    assert_eq!(answers[1], json!({ "equivalent": true }));
    assert_eq!(answers[2]["run"].as_array().unwrap().len(), 2, "{}", answers[2]);
    assert_eq!(answers[3]["run"].as_array().unwrap().len(), 1, "{}", answers[3]);
    assert_eq!(answers[3]["run"][0].as_array().unwrap().len(), 2, "{}", answers[3]);
    assert_eq!(answers[4], json!({ "equivalent": true }));
    assert!(answers[5]["error"].as_str().unwrap().starts_with("b: "), "{}", answers[5]);
}
