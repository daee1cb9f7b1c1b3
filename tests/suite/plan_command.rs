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
        question(&format!("(not:<t,t> {})", near("basket")), ""),
        question(
            &format!("(and:<t*,t> true:t (not:<t,t> (not:<t,t> (not:<t,t> {}))))", near("basket")),
            "",
        ),
        question(&format!("(not:<t,t> {})", near("room")), ""),
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
    assert_eq!(
        reasons,
        [
            "no_referent",
            "no_referent",
            "unreachable",
            "bad_goal",
            "bad_goal",
            // What is not there cannot be kept away from, and several cannot either.
            "no_referent",
            "no_referent",
            "no_referent",
        ]
    );
    assert!(answers[4]["message"].as_str().unwrap().starts_with("column "), "{}", answers[4]);
}

#[test]
fn what_is_not_there_is_refused_in_its_place() {
    let cases = [
        (r#","slip_probability":1.5"#, "slip_probability: 1.5 is no probability"),
        (r#","lock_probability":-1"#, "lock_probability: -1 is no probability"),
        (r#","loss_probability":2"#, "loss_probability: 2 is no probability"),
        (r#","loss_probability":"often""#, "invalid type"),
        (r#","landmarks":"fred""#, "landmarks: `fred` is unknown"),
        (r#","solver":"magic""#, "solver: `magic` is unknown"),
        (r#","rollouts":1000000000"#, "rollouts: 1000000000 are too many"),
        (r#","steps":-1"#, "invalid value"),
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

/// A robot, a chair and a door that nobody tried between it and the other room.
fn corridor(goal: &str, more: &str) -> String {
    let initial = r#"{"agent":{"x":1,"y":1,"direction":"east"},"rooms":[
        {"name":"room0","color":"red","left":0,"bottom":0,"right":4,"top":2},
        {"name":"room1","color":"blue","left":4,"bottom":0,"right":8,"top":2}],
        "doors":[{"name":"door0","left":4,"bottom":1,"right":4,"top":1,"lock":"unknown"}],
        "objects":[{"name":"object0","shape":"chair","color":"tan","x":2,"y":1}]}"#;
    let initial = initial.replace(['\n', ' '], "");
    format!("{{\"goal\":{},\"initial\":{initial}{more}}}\n", serde_json::Value::from(goal))
}

const CHAIR_IN_BLUE: &str = "(in:<e,<e,t>> (the:<<e,t>,e> chair:<e,t>) (the:<<e,t>,e> (lambda $0:e (and:<t*,t> (blue:<e,t> $0) (room:<e,t> $0)))))";
const NEAR_CHAIR: &str =
    "(right:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) (the:<<e,t>,e> chair:<e,t>))";

#[test]
fn chance_has_a_value_and_no_length() {
    // Three pushes; the second one tries the door, and each is lost half of the time.
    let tries = 0.5 / (1.0 - 0.99 * 0.5);
    let worth = |lock: f64, push: f64| (1.0 - lock) * 0.99_f64.powi(2) * push.powi(3);
    let cases = [
        (r#","lock_probability":0.4"#, worth(0.4, 1.0)),
        (r#","loss_probability":0.5"#, worth(0.0, tries)),
        (r#","slip_probability":0.5"#, worth(0.0, tries)),
        (r#","lock_probability":0.4,"loss_probability":0.5"#, worth(0.4, tries)),
        (r#","lock_probability":1"#, 0.0),
    ];
    for (more, wanted) in cases {
        for solver in ["auto", "vi", "lrtdp"] {
            let line = corridor(CHAIR_IN_BLUE, &format!("{more},\"solver\":\"{solver}\""));
            let answer = &answers(&run("plan", &line))[0];
            assert_eq!((&answer["length"], &answer["actions"]), (&().into(), &().into()));
            let value = answer["value"].as_f64().unwrap();
            assert!((value - wanted).abs() < 1e-5, "{answer}, not {wanted}");
            assert_eq!(answer.get("why").is_some(), solver == "auto");
            let reason = answer.get("reason").and_then(|reason| reason.as_str());
            assert_eq!(reason, (wanted == 0.0).then_some("unreachable"), "{answer}");
        }
    }
    let line = corridor(CHAIR_IN_BLUE, r#","slip_probability":0.5,"solver":"astar""#);
    let refused = &answers(&run("plan", &line))[0];
    assert!(
        refused["error"].as_str().unwrap().starts_with("solver: astar plans only"),
        "{refused}"
    );
}

#[test]
fn every_solver_finds_the_length_where_nothing_is_left_to_chance() {
    for solver in ["auto", "astar", "vi", "lrtdp", "uct"] {
        let line = corridor(CHAIR_IN_BLUE, &format!(",\"solver\":\"{solver}\",\"steps\":200000"));
        let answer = &answers(&run("plan", &line))[0];
        assert_eq!(answer["length"], 3, "{answer}");
        assert_eq!(answer["actions"], serde_json::json!(["east", "east", "east"]));
        let named = if solver == "auto" { "astar" } else { solver };
        assert_eq!(answer["solver"], named);
        // Trials prove nothing.
        assert_eq!(answer.get("reason").is_some(), solver == "uct", "{answer}");
    }
}

#[test]
fn forms_landmarks_and_rollouts_are_heard() {
    let lines = [
        corridor(NEAR_CHAIR, ""),
        corridor(NEAR_CHAIR, r#","landmarks":"fixed""#),
        corridor(NEAR_CHAIR, r#","pull":true"#),
        corridor(CHAIR_IN_BLUE, r#","robot":true"#),
        corridor(CHAIR_IN_BLUE, r#","lock_probability":0.25,"rollouts":400,"seed":5"#),
        corridor(CHAIR_IN_BLUE, r#","steps":0"#),
    ];
    let answers = answers(&run("plan", &lines.concat()));
    // In a corridor nobody gets past the chair, but by pulling it.
    assert_eq!(
        (&answers[0]["reason"], &answers[1]["reason"]),
        (&"unreachable".into(), &"unreachable".into())
    );
    assert_eq!(answers[2]["actions"], serde_json::json!(["pull"]));
    assert_eq!(answers[3]["actions"], serde_json::json!(["forward", "forward", "forward"]));
    let runs = &answers[4]["rollouts"];
    let share = runs["successes"].as_f64().unwrap() / 400.0;
    let bound = |i: usize| runs["interval"][i].as_f64().unwrap();
    assert!(bound(0) < share && share < bound(1) && bound(0) < 0.75 && 0.75 < bound(1), "{runs}");
    assert_eq!(answers[5]["reason"], "budget");
    assert_eq!(answers[5]["bounds"], serde_json::json!([0.0, 0.9801]));
}

#[test]
fn a_solver_ends_where_nothing_helps_and_proves_nothing_by_giving_up() {
    // Every action slips: UCT has nowhere to go, and its budget ends all the same.
    let stuck = corridor(CHAIR_IN_BLUE, r#","solver":"uct","steps":1000,"slip_probability":1"#);
    let answer = &answers(&run("plan", &stuck))[0];
    assert_ne!(answer["value"].as_f64(), Some(1.0), "{answer}");
    assert!(["budget", "unreachable"].contains(&answer["reason"].as_str().unwrap()), "{answer}");
    // A budget that ends too soon leaves states worth nothing yet: runs plan again there instead of giving up.
    let few = r#","solver":"vi","steps":2,"rollouts":3"#;
    let answer = &answers(&run("plan", &corridor(CHAIR_IN_BLUE, few)))[0];
    assert_eq!((&answer["reason"], &answer["value"]), (&"budget".into(), &().into()));
    assert!(answer["rollouts"]["replans"].as_u64().unwrap() > 0, "{answer}");
}
