//! Reviewing: merging in any order, what is flagged and what is not, decisions, coverage, pay, and files that are read
//! back whole and hurt no spreadsheet.

use super::files::{showing, study};
use groundling::corpus::{Decision, Options, guarded, read, unguarded};
use groundling::study::answer::{FORMAT, code, lines};
use groundling::study::coverage::{coverage, top_up};
use groundling::study::export::{Style, write};
use groundling::study::file::{Example, Pay};
use groundling::study::judge::Verdict;
use groundling::study::pay::{dues, sheet};
use groundling::study::{Answer, Care, Flag, Review, Study, merge};
use proptest::prelude::{any, proptest};
use std::collections::BTreeSet;

/// A careful answer of somebody to an item.
pub(crate) fn answer(study: &Study, worker: &str, turn: usize, command: &str) -> Answer {
    let item = &study.items[turn];
    Answer {
        format: FORMAT.into(),
        id: format!("{worker}-{}", turn + 1),
        command: command.into(),
        task: item.task.clone(),
        worker: worker.into(),
        pairs: vec![showing(1); 3],
        runs: Vec::new(),
        study: study.fingerprint(),
        item: item.id.clone(),
        turn: [turn + 1, study.items.len()],
        assignment: Some(format!("as-{worker}")),
        hit: None,
        at: 1_764_390_000_000.0,
        care: Care { active_ms: 9_000, seen_ms: vec![2_000; 3], keys: 20, pasted: 0, changes: 0 },
        simulated: None,
    }
}

fn review(study: &Study, answers: &[Answer]) -> Review {
    Review::new(study, merge([("a.jsonl", lines(answers).as_str())]).answers).0
}

#[test]
fn files_are_merged_in_any_order() {
    let study = study(2);
    let all: Vec<Answer> = ["b", "a", "c"]
        .iter()
        .flat_map(|who| {
            [answer(&study, who, 1, "go \"east\""), answer(&study, who, 0, "=1+1\r\nx")]
        })
        .collect();
    let (first, second) = (lines(&all[..3]), lines(&all[2..]));
    let one = merge([("1", first.as_str()), ("2", second.as_str())]);
    let other = merge([("2", second.as_str()), ("1", first.as_str()), ("2", second.as_str())]);
    assert_eq!((one.doubles, other.doubles), (1, 5));
    assert_eq!(one.answers, other.answers);
    let ids: Vec<&str> = one.answers.iter().map(|(answer, _)| answer.id.as_str()).collect();
    assert_eq!(ids, ["a-1", "a-2", "b-1", "b-2", "c-1", "c-2"]);
    let posted = serde_json::json!({ "key": "k", "answers": all }).to_string();
    assert_eq!(merge([("p", posted.as_str())]).answers, one.answers);
    let list = serde_json::to_string(&all).unwrap();
    assert_eq!(merge([("l", list.as_str())]).answers, one.answers);
    let cell = lines(&all).replace('"', "\"\"");
    let table = format!("\u{feff}\"HITId\",\"Answer.answers\"\r\n\"h\",\"{cell}\"\r\n");
    assert_eq!(merge([("t.csv", table.as_str())]).answers, one.answers);
}

#[test]
fn what_is_no_answer_costs_itself_alone() {
    let study = study(1);
    let good = answer(&study, "a", 0, "go").line();
    let text = format!("{good}\n{{\"format\":\n{{\"x\":1}}\n{{\"format\":\"{FORMAT}\"}}\n");
    let merged = merge([("a.jsonl", text.as_str())]);
    assert_eq!(merged.answers.len(), 1);
    assert!(!merged.flaws.is_empty());
    let others = Review::new(&self::study(2), merge([("a", good.as_str())]).answers);
    assert_eq!((others.0.rows.len(), others.1.len()), (0, 1), "of another study");
}

#[test]
fn flags_are_raised_for_what_they_say() {
    let mut study = study(2);
    study.words.example =
        Some(Example { shows: vec![showing(1)], command: "Go to the bag.".into() });
    study.items[1].must = vec![vec!["red".into(), "crimson".into()]];
    let good = |who: &str| {
        [answer(&study, who, 0, "go to the room"), answer(&study, who, 1, "the red room")]
    };
    let of = |answers: &[Answer], verdicts: &[Verdict]| -> Vec<BTreeSet<&str>> {
        let mut review = review(&study, answers);
        review.judged(&study, verdicts.to_vec());
        review.rows.iter().map(|row| row.flags.iter().map(|flag| flag.name()).collect()).collect()
    };
    assert_eq!(of(&good("a"), &[]), [BTreeSet::new(), BTreeSet::new()]);
    let with = |change: &dyn Fn(&mut Answer)| {
        let mut answers = good("a");
        change(&mut answers[0]);
        of(&answers, &[])[0].iter().copied().collect::<Vec<&str>>()
    };
    assert_eq!(with(&|a| a.care.active_ms = 900), ["fast"]);
    assert_eq!(with(&|a| a.care.seen_ms[2] = 0), ["unseen"]);
    assert_eq!(with(&|a| a.care.seen_ms.clear()), ["unseen"]);
    assert_eq!(with(&|a| a.care.pasted = 12), ["pasted"]);
    assert_eq!(with(&|a| a.care.pasted = 2), [""; 0]);
    assert_eq!(with(&|a| a.command = " go to THE bag".into()), ["copied"]);
    assert_eq!(with(&|a| a.command = "geh in den roten raum".into()), ["foreign"]);
    assert_eq!(with(&|a| a.command = "иди в комнату".into()), ["foreign"]);
    assert_eq!(with(&|a| a.simulated = Some(false)), ["simulated"]);
    assert_eq!(with(&|a| a.command = "?!".into()), ["unfit"]);
    assert_eq!(with(&|a| a.command = "go east ".repeat(300)), ["unfit"]);
    let mut missed = good("a");
    missed[1].command = "somewhere".into();
    assert!(of(&missed, &[]).iter().all(|flags| flags.contains("missed")));
    missed[1].command = "go to the CRIMSON room".into();
    assert!(!of(&missed, &[])[0].contains("missed"));
    let mut same = good("a");
    same[0].command = "the red room!".into();
    assert!(of(&same, &[]).iter().all(|flags| flags.contains("same")));
    let twins = [good("a"), good("b")].concat();
    assert!(of(&twins, &[]).iter().all(|flags| flags.contains("twin")));
    let mut again = [good("a"), good("b")].concat();
    again[3].command = "the red room, please".into();
    again[2..].iter_mut().for_each(|answer| answer.worker = "a".into());
    assert!(of(&again, &[]).iter().all(|flags| flags.iter().eq(["again"].iter())));
    let verdicts = [Verdict::Some(vec![true, false, false]), Verdict::Unread];
    assert_eq!(of(&good("a"), &verdicts), [["some_pairs"].into(), ["unread"].into()]);
    for flag in Flag::ALL {
        assert_eq!(Flag::of(flag.name()), Some(flag));
    }
}

#[test]
fn a_rule_decides_what_is_open_and_says_why() {
    let study = study(1);
    let mut answers: Vec<Answer> =
        ["a", "b", "c"].iter().map(|who| answer(&study, who, 0, who)).collect();
    answers[1].care.active_ms = 1;
    let mut review = review(&study, &answers);
    review.decide(2, Decision::Rejected("rude".into()));
    let rule = BTreeSet::from([Flag::Fast]);
    assert_eq!(review.decide_by(&rule, |flag| format!("too {}", flag.name())), (1, 1));
    let decided: Vec<&Decision> = review.rows.iter().map(|row| &row.decision).collect();
    assert_eq!(
        decided,
        [
            &Decision::Approved,
            &Decision::Rejected("too fast".into()),
            &Decision::Rejected("rude".into())
        ]
    );
    assert_eq!(review.decide_by(&rule, |_| String::new()), (0, 0), "it is all decided");
}

#[test]
fn coverage_tells_what_is_missing() {
    let mut study = study(3);
    study.items[2].must = vec![vec!["red".into()]];
    let answers = [
        answer(&study, "a", 0, "go to the red room"),
        answer(&study, "b", 0, "go to the red hall"),
        answer(&study, "c", 2, "red"),
    ];
    let mut review = review(&study, &answers);
    let found = coverage(&study, &review);
    let counts: Vec<_> = found.iter().map(|c| (c.task.as_str(), c.items, c.answers)).collect();
    assert_eq!(counts, [("task-i0", 1, 2), ("task-i1", 1, 0)], "checks are no tasks");
    assert!((found[0].agreement - 0.8).abs() < 1e-9);
    let more = top_up(&study, &review, 2).unwrap();
    let ids: Vec<&str> = more.items.iter().map(|item| item.id.as_str()).collect();
    assert_eq!(ids, ["i1", "i2"]);
    Study::read(&more.write()).unwrap();
    review.decide(0, Decision::Rejected("".into()));
    assert_eq!(top_up(&study, &review, 2).unwrap().items.len(), 3);
    assert_eq!(top_up(&study, &review, 0), None);
}

#[test]
fn the_pay_sheet_says_what_is_owed() {
    let mut study = study(2);
    study.pay = Some(Pay { cents: 125, currency: "€".into() });
    let mut answers = vec![
        answer(&study, "=b", 0, "go"),
        answer(&study, "=b", 1, "step"),
        answer(&study, "s", 0, "x"),
    ];
    answers[2].simulated = Some(true);
    let mut review = review(&study, &answers);
    review.decide(0, Decision::Approved);
    review.decide(1, Decision::Rejected("".into()));
    let due = &dues(&study, &review)[0];
    assert_eq!((due.answers, due.cents, due.active_ms), ([2, 1, 1], Some(125), 18_000));
    let text = sheet(&study, &review);
    let code = code(&study.fingerprint(), review.answers().take(2));
    let line = format!("\"'=b\",2,1,1,0.3,1.25,\"€\",{code}");
    assert_eq!(text.lines().nth(1), Some(line.as_str()));
    assert_eq!(text.lines().count(), 2, "nobody pays a simulation");
}

#[test]
fn what_is_saved_is_read_back_whole() {
    let study = study(1);
    let long = "go east ".repeat(1_250);
    let commands = [
        "=SUM(1;2)",
        "+1 step",
        "@me",
        "-1",
        "'=x",
        "a\nb\r\nc",
        "\u{202e}שלום \u{200f}go",
        "\"q\", 'r'",
        long.trim(),
    ];
    let mut answers: Vec<Answer> =
        (0..).zip(commands).map(|(n, words)| answer(&study, &format!("w{n}"), 0, words)).collect();
    answers[0].worker = "=cmd|' /C calc'!A0".into();
    let mut review = review(&study, &answers);
    review.decide(0, Decision::Rejected("=bad".into()));
    review.decide(1, Decision::Approved);
    let said: Vec<String> = review.rows.iter().map(|row| row.answer.command.clone()).collect();
    assert_eq!(said[8].chars().count(), 9_999);
    for is_json in [false, true] {
        let mut bytes = Vec::new();
        write(&review, &Style { is_json, ..Style::default() }, &mut bytes).unwrap();
        let text = String::from_utf8(bytes.clone()).unwrap();
        assert!(text.contains(long.trim()), "whole");
        if !is_json {
            let mut table = csv::Reader::from_reader(text.as_bytes());
            for cell in table
                .records()
                .flat_map(|record| record.unwrap().iter().map(str::to_owned).collect::<Vec<_>>())
            {
                assert!(!cell.starts_with(['=', '+', '@', '-', '\t', '\r']), "{cell}");
            }
        }
        let (corpus, flaws) =
            read(&bytes[..], Options { with_rejected: true, ..Options::default() });
        // The reader of corpora takes 2,000 characters a command, and says so.
        assert_eq!((corpus.examples.len(), flaws.iter().filter(|flaw| !flaw.kept).count()), (8, 1));
        for (example, said) in corpus.examples.iter().zip(&said) {
            assert_eq!(&example.command, said, "json {is_json}");
        }
        let back = merge([("back", text.as_str())]);
        if !is_json {
            assert_eq!(back.answers[0].0.worker, "=cmd|' /C calc'!A0");
            assert!(back.answers[..2].iter().all(|(_, decided)| *decided != Decision::Open));
        }
    }
}

#[test]
fn pseudonyms_hide_people_and_nothing_else() {
    let study = study(2);
    let answers = [
        answer(&study, "anna", 0, "go"),
        answer(&study, "anna", 1, "step"),
        answer(&study, "bert", 0, "go"),
    ];
    let review = review(&study, &answers);
    let saved = |key: &str| {
        let mut bytes = Vec::new();
        let style = Style { pseudonyms: Some(key.into()), ..Style::default() };
        write(&review, &style, &mut bytes).unwrap();
        String::from_utf8(bytes).unwrap()
    };
    let text = saved("k");
    assert!(!text.contains("anna") && !text.contains("bert"), "{text}");
    assert_ne!(text, saved("l"));
    let (corpus, _) = read(text.as_bytes(), Options::default());
    let people: Vec<_> = corpus.examples.iter().map(|example| example.worker.clone()).collect();
    assert_eq!(people[0], people[1]);
    assert_ne!(people[0], people[2]);
}

proptest! {
    #[test]
    fn what_is_guarded_is_read_back(text in any::<String>()) {
        assert_eq!(unguarded(&guarded(&text)), text);
    }
}
