//! The command `plan`, run as a script runs it: the conformance file as it is, reasons, and what is refused
//! in its place.

use crate::command::{answers, run};

const CASES: &str = include_str!("../data/conformance/plans.jsonl");

#[test]
fn every_conformance_case_has_its_length_and_value() {
    let output = run("plan", CASES);
    assert!(output.status.success(), "{output:?}");
    let answers = answers(&output);
    assert_eq!(answers.len(), CASES.lines().count());
    for (case, answer) in CASES.lines().zip(answers) {
        let case: serde_json::Value = serde_json::from_str(case).unwrap();
        assert_eq!(answer["length"], case["length"], "{case}");
        assert_eq!(answer["solver"], "astar");
        match case["length"].as_i64() {
            Some(n) => {
                assert_eq!(answer["actions"].as_array().unwrap().len() as i64, n);
                let value = answer["value"].as_f64().unwrap();
                let expected = if n == 0 { 1.0 } else { 0.99_f64.powi((n - 1) as i32) };
                assert!((value - expected).abs() < 1e-12, "{answer}");
                assert!(answer.get("reason").is_none(), "{answer}");
            }
            None => {
                assert_eq!(answer["reason"], "unreachable");
                assert_eq!((&answer["actions"], &answer["value"]), (&().into(), &0.0.into()));
            }
        }
    }
}

/// The first case with another goal and further fields.
fn question(goal: &str, more: &str) -> String {
    let case: serde_json::Value = serde_json::from_str(CASES.lines().next().unwrap()).unwrap();
    format!(
        "{{\"goal\":{},\"initial\":{}{more}}}\n",
        serde_json::Value::from(goal),
        case["initial"]
    )
}

#[test]
fn reasons_are_told_apart() {
    let near = |what: &str| {
        format!("(near:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) (the:<<e,t>,e> {what}:<e,t>))")
    };
    let input = [
        question("true:t", ""),
        question(&near("basket"), ""),
        question(&near("object"), ""),
        question("false:t", ""),
        question("(near:<e,<e,t>> x", ""),
        question("red:<e,t>", ""),
    ]
    .concat();
    let output = run("plan", &input);
    assert!(output.status.success(), "{output:?}");
    let answers = answers(&output);
    assert_eq!(answers[0]["length"], 0);
    assert_eq!(
        (&answers[0]["actions"], &answers[0]["value"]),
        (&serde_json::json!([]), &1.0.into())
    );
    let reasons: Vec<&str> =
        answers.iter().skip(1).map(|a| a["reason"].as_str().unwrap()).collect();
    assert_eq!(reasons, ["no_referent", "no_referent", "unreachable", "bad_goal", "bad_goal"]);
    assert!(answers[4]["message"].as_str().unwrap().starts_with("column "), "{}", answers[4]);
}

#[test]
fn what_is_not_there_is_refused_in_its_place() {
    let cases = [
        (r#","slip_probability":0.1"#, "slip_probability: only deterministic worlds"),
        (r#","lock_probability":-1"#, "lock_probability: -1 is no probability"),
        (r#","loss_probability":2"#, "loss_probability: 2 is no probability"),
        (r#","robot":true"#, "robot: the robot form"),
        (r#","landmarks":"fixed""#, "landmarks: they cannot be held fixed"),
        (r#","landmarks":"fred""#, "landmarks: `fred` is unknown"),
        (r#","solver":"vi""#, "solver: `vi` is not there"),
        (r#","solver":"magic""#, "solver: `magic` is unknown"),
        (r#","pull":3"#, "invalid type"),
    ];
    let good = question(
        "true:t",
        r#","slip_probability":0,"robot":false,"landmarks":"free","solver":"auto""#,
    );
    let bad: String = cases.iter().map(|c| question("true:t", c.0)).collect();
    let in_wall = question("true:t", "")
        .replace("\"agent\":{", "\"agent\":{\"z\":0,")
        .replace("\"x\":4,\"y\":4", "\"x\":0,\"y\":0");
    let output = run("plan", &format!("{good}{bad}{in_wall}not json\n{good}"));
    assert_eq!(output.status.code(), Some(2));
    let answers = answers(&output);
    assert_eq!(answers.len(), cases.len() + 4);
    assert_eq!(
        (&answers[0]["length"], &answers[answers.len() - 1]["length"]),
        (&0.into(), &0.into())
    );
    for (line, ((_, expected), answer)) in (2..).zip(cases.iter().zip(&answers[1..])) {
        assert!(answer["error"].as_str().unwrap().starts_with(expected), "{answer}");
        assert_eq!(answer["line"], line);
    }
    let wall = answers[cases.len() + 1]["error"].as_str().unwrap();
    assert!(wall.starts_with("initial: `agent` stands in a wall"), "{wall}");
}
