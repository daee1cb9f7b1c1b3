//! How far answers can be trusted: what reliability counts, by hand; what calibration makes of marks whose answer is known;
//! and what idioms of the model that ships may say.

use crate::commands::{asked, shipped};
use crate::wide::rows;
use groundling::ccg::{ChartConfig, Parse, any_closed};
use groundling::learn::calibrate::{self, calibrate};
use groundling::learn::{Evaluation, Mark, Reliability, Ties, Verdict};
use groundling::logic::print;

fn mark(answer: Verdict, probability: f64, asked: bool) -> Mark {
    let probability = (answer != Verdict::Silent).then_some(probability);
    Mark { task: None, answer, resolved: answer, skipped: false, probability, asked }
}

#[test]
fn reliability_counts_what_is_asked_and_how_far_saying_is_from_being() {
    let of = Reliability::of(&[
        mark(Verdict::Right, 0.92, false),
        mark(Verdict::Right, 0.98, false),
        mark(Verdict::Wrong, 0.91, false),
        mark(Verdict::Wrong, 0.35, true),
        mark(Verdict::Silent, 0.0, false),
    ]);
    assert_eq!(of.asked, 1);
    assert!((of.unasked_precision - 2.0 / 3.0).abs() < 1e-12);
    // Three answers say .937 and two of them are right; one says .35 and is wrong.
    let ece = 0.75 * ((0.92 + 0.98 + 0.91) / 3.0 - 2.0 / 3.0) + 0.25 * 0.35;
    assert!((of.ece - ece).abs() < 1e-12, "{}", of.ece);
    assert_eq!((of.bins[9].answers, of.bins[3].answers), (3, 1));
    let cut = of.risk_coverage.iter().find(|cut| cut.threshold == 0.5).unwrap();
    assert!((cut.coverage - 0.6).abs() < 1e-12, "three of five commands");
    assert!((cut.risk - 1.0 / 3.0).abs() < 1e-12);
    let none = Reliability::of(&[]);
    assert_eq!((none.asked, none.unasked_precision, none.ece), (0, 0.0, 0.0));
}

#[test]
fn calibration_finds_what_signs_are_worth_and_from_where_on_answers_are_right() {
    let signs = |sign: &str| vec![("bias".to_owned(), 1.0), (sign.to_owned(), 1.0)];
    let marks = |sign: &'static str, right: usize| {
        (0..100).map(move |n| calibrate::Mark { signs: signs(sign), right: n < right })
    };
    let doubt = calibrate(&[marks("sure", 95).chain(marks("odd", 20)).collect(), vec![]], 0.9);
    for (sign, share) in [("sure", 0.95), ("odd", 0.2)] {
        let found = doubt.probability(&signs(sign));
        assert!((found - share).abs() < 0.02, "{sign}: {found}");
        assert_eq!(doubt.asks(found), share < 0.9);
    }
    // Where no share of answers is right enough, everything is asked.
    let never = calibrate(&[marks("odd", 20).collect()], 0.9);
    assert!(never.asks(never.probability(&signs("odd"))));
}

#[test]
fn evaluation_abstains_exactly_where_a_parse_gives_a_reason() {
    let mut model = shipped();
    let examples: Vec<_> = rows().examples.into_iter().step_by(3).collect();
    let parses: Vec<(bool, bool)> = examples
        .iter()
        .map(|example| {
            let parse = asked(&mut model, &example.command);
            (parse.reason.is_none(), parse.skipped.is_empty())
        })
        .collect();
    let config = ChartConfig::of(&model);
    let mut evaluation = Evaluation::new(&mut model, &examples, config);
    while evaluation.step().is_some() {}
    let scores = evaluation.into_report().scores(Ties::Abstain);
    let answered = |whole: bool| parses.iter().filter(|&&(no, all)| no && (all || !whole)).count();
    assert_eq!(scores.skipping.answered, answered(false));
    assert_eq!(scores.plain.answered, answered(true));
    assert!(scores.total > answered(false) && answered(true) > 300, "both happen");
}

#[test]
fn idioms_hold_no_closed_word_deny_nothing_and_are_heard_alone() {
    let mut model = shipped();
    let idioms: Vec<(String, String)> = model
        .lexicon
        .idioms()
        .map(|(words, entry)| {
            let goal = model.lexicon.category(entry).meaning;
            (words.join(" "), print(&model.grammar.terms, goal))
        })
        .collect();
    assert!(idioms.len() > 20, "{} idioms", idioms.len());
    let mut heard = 0;
    for (command, goal) in idioms {
        let words: Vec<&str> = command.split(' ').collect();
        assert!(!any_closed(&words), "{command}");
        assert!(!goal.contains("(not:"), "{command}: {goal}");
        let best = |parse: Parse| parse.readings.first().map(|best| best.form);
        let alone = best(asked(&mut model, &command));
        heard += usize::from(alone.is_some_and(|form| print(&model.grammar.terms, form) == goal));
    }
    assert!(heard > 20, "{heard} are heard so");
}
