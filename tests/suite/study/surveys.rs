//! What other programs collected: jsPsych's table with its quirks, psiTurk's three downloads, and what is refused.

use crate::corpus::PRE;
use groundling::study::survey::{SurveyMapping, convert, trials};

fn post() -> String {
    PRE.replacen("\"x\":2,\"y\":3", "\"x\":3,\"y\":3", 1)
}

/// Cells as jsPsych quotes them: all of them.
fn row(cells: &[&str]) -> String {
    let quoted: Vec<String> =
        cells.iter().map(|cell| format!("\"{}\"", cell.replace('"', "\"\""))).collect();
    quoted.join(",") + "\r\n"
}

/// A page of words, an answer, an answer that was left empty; a column without a name.
fn jspsych() -> String {
    let head =
        ["rt", "stimulus", "response", "trial_type", "", "task", "pre_1", "post_1", "subject"];
    let post = post();
    [
        row(&head),
        row(&["120", "Welcome", "null", "html-button-response", "", "null", "null", "null", "s=1"]),
        row(&[
            "900",
            "null",
            "{\"command\":\"go \\\"east\\\",\\nplease\"}",
            "survey-text",
            "",
            "step",
            PRE,
            &post,
            "s=1",
        ]),
        row(&["900", "null", "{\"command\":\"\"}", "survey-text", "", "step", PRE, &post, "s=1"]),
    ]
    .concat()
}

#[test]
fn jspsychs_table_is_read() {
    let text = jspsych();
    let found = trials([("data.csv", text.as_str())]);
    assert_eq!((found.rows.len(), found.flaws.len()), (3, 0), "{:?}", found.flaws);
    let mapping = SurveyMapping::propose(&found);
    assert_eq!(mapping.command, "response.command");
    assert_eq!(
        (mapping.worker.as_deref(), mapping.task.as_deref()),
        (Some("subject"), Some("task"))
    );
    assert_eq!(mapping.pairs.len(), 1);
    assert_eq!(SurveyMapping::read(&mapping.write()).unwrap(), mapping);
    let converted = convert(&found, &mapping).unwrap();
    assert_eq!((converted.answers.len(), converted.others), (1, 2));
    let answer = &converted.answers[0];
    assert_eq!(answer.command, "go \"east\",\nplease");
    assert_eq!((answer.worker.as_str(), answer.task.as_deref()), ("s=1", Some("step")));
}

#[test]
fn jspsychs_json_is_read_and_what_goes_by_column_is_refused() {
    let state: serde_json::Value = serde_json::from_str(PRE).unwrap();
    let after: serde_json::Value = serde_json::from_str(&post()).unwrap();
    let list = serde_json::json!([
        { "trial_type": "instructions", "rt": 3 },
        { "response": { "Q0": "go east" }, "pre_1": state, "post_1": after, "subject": 7 },
    ]);
    let text = list.to_string();
    let found = trials([("data.json", text.as_str())]);
    let mapping = SurveyMapping::propose(&found);
    assert_eq!(mapping.command, "response.Q0");
    let converted = convert(&found, &mapping).unwrap();
    assert_eq!(
        (converted.answers[0].command.as_str(), converted.answers[0].worker.as_str()),
        ("go east", "7")
    );
    let by_column = r#"{"rt":[1,2,3],"response":["a","b"]}"#;
    let refused = trials([("columns.json", by_column)]);
    assert!(refused.rows.is_empty());
    assert!(refused.flaws[0].1.to_string().contains("its rows no longer belong together"));
    for bad in ["[1,2]", "{", "[{\"a\":1},", "\"x\""] {
        let refused = trials([("bad.json", bad)]);
        assert!(!refused.flaws.is_empty() || refused.rows.is_empty(), "{bad}");
    }
}

#[test]
fn psiturks_downloads_are_read() {
    let cell = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
    let trial = |who: &str, n: usize, command: &str| {
        let data = serde_json::json!({
            "phase": "TEST", "command": command,
            "pre_1": PRE, "post_1": post(),
        });
        format!("{who},{n},1764390000000,{}\n", cell(&data.to_string()))
    };
    let data = [
        trial("A1:H1", 0, "go east"),
        "A1:H1,1,1764390000001,\"{\"\"phase\"\": \"\"postquestionnaire\"\"}\"\n".to_owned(),
        trial("B2:H1", 0, "step aside"),
    ]
    .concat();
    let questions = "A1:H1,language,'it\\'s English'\nA1:H1,ages,\"[1, None, True, {'a': 'ü'}]\"\n";
    let events = "A1:H1,focus,10,on,1764390000000\n";
    let found = trials([
        ("trialdata.csv", data.as_str()),
        ("questiondata.csv", questions),
        ("eventdata.csv", events),
    ]);
    assert_eq!(found.rows.len(), 3);
    assert_eq!(found.rows[0].1["question.language"], "it's English");
    assert_eq!(found.rows[0].1["question.ages"], serde_json::json!([1, null, true, { "a": "ü" }]));
    assert_eq!(found.unfinished.iter().collect::<Vec<_>>(), ["B2:H1"]);
    assert!(found.flaws[0].1.to_string().contains("these are events"));
    let mut mapping = SurveyMapping::propose(&found);
    assert_eq!(
        (mapping.command.as_str(), mapping.worker.as_deref()),
        ("command", Some("uniqueid"))
    );
    let converted = convert(&found, &mapping).unwrap();
    assert_eq!((converted.answers.len(), converted.unfinished, converted.others), (1, 1, 1));
    mapping.with_unfinished = true;
    assert_eq!(convert(&found, &mapping).unwrap().answers.len(), 2);
    assert!(convert(&found, &SurveyMapping::default()).is_err());
}

#[test]
fn values_in_pythons_notation_are_read_or_kept_as_text() {
    let questions = |text: &str| {
        let quoted = format!("\"{}\"", text.replace('"', "\"\""));
        let both = "a:b,0,1,\"{\"\"x\"\":1}\"\n";
        let found = trials([("t", both), ("q", format!("a:b,k,{quoted}\n").as_str())]);
        found.rows[0].1["question.k"].to_string()
    };
    for (text, wanted) in [
        ("'a'", "\"a\""),
        ("u'\\xe9\\u00fc\\U0001f916'", "\"éü🤖\""),
        ("\"it's\"", "\"it's\""),
        ("12L", "12"),
        ("(1, 'a',)", "[1,\"a\"]"),
        ("{}", "{}"),
        ("plain words", "\"plain words\""),
        ("'open", "\"'open\""),
        ("[1, 2", "\"[1, 2\""),
        ("'\\ud800'", "\"'\\\\ud800'\""),
    ] {
        assert_eq!(questions(text), wanted, "{text}");
    }
    let deep = "[".repeat(5_000);
    assert!(questions(&deep).starts_with("\"[["));
}
