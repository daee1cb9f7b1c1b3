//! Charts: held against brute force; independent of the order of the lexicon; small beams and budgets; words that
//! are skipped; ties; symmetric twins.

use super::brute::{Admitted, NORMAL_FORM};
use super::{AMBIGUOUS, brute, model, model_over};
use groundling::ccg::chart::Derivations;
use groundling::ccg::clauses::Clauses;
use groundling::ccg::lookup::lexical_items;
use groundling::ccg::parse::fill;
use groundling::ccg::sentence::MAX_LETTERS;
use groundling::ccg::{ChartConfig, Feature, Model, Reason, RuleId, parse, words};
use groundling::ground::ONTOLOGY;
use groundling::logic::print;
use proptest::prelude::{Just, Strategy, any, prop};
use proptest::test_runner::Config;
use proptest::{prop_assert_eq, proptest};
use std::collections::BTreeMap;

pub(super) const WITHOUT_END: ChartConfig = ChartConfig {
    beam: usize::MAX,
    budget: usize::MAX,
    derivations: Derivations::Best,
    allow_vacuous: false,
    allow_throwing: false,
    clauses: Clauses::ONE,
    in_time: true,
};

const VOCABULARY: [&str; 10] =
    ["go", "to", "the", "red", "room", "in", "near", "robot", "now", "not"];

/// The ambiguous lexicon with weights that leave few ties.
fn ambiguous() -> Model {
    let mut model = model(AMBIGUOUS);
    weighted(&mut model);
    model
}

/// Gives a model weights that leave few ties.
pub(super) fn weighted(model: &mut Model) {
    for (place, entry) in model.lexicon.entries().to_vec().into_iter().enumerate() {
        model.features.set(Feature::Entry(entry), 1.0 + place as f64 * 0.37);
    }
    for row in 0..7 {
        model.features.set(Feature::Rule(RuleId(row)), f64::from(row) * 0.11 - 0.3);
    }
    let e_e_t = model.grammar.terms.types.read("<e,<e,t>>").unwrap();
    let e_t = model.grammar.terms.types.read("<e,t>").unwrap();
    let near = model.grammar.terms.constant("near", e_e_t);
    let red = model.grammar.terms.constant("red", e_t);
    model.features.set(Feature::Pair(near, red), -0.21);
}

/// Forms with scores, as a chart finds them.
fn ranked(model: &mut Model, command: &str, config: ChartConfig) -> Vec<(String, f64)> {
    let words = words(command);
    let lexical = lexical_items(model, &words);
    let parse = fill(model, &words, lexical, |_, _, _| true, config);
    let terms = &model.grammar.terms;
    parse.readings.iter().map(|reading| (print(terms, reading.form), reading.score)).collect()
}

pub(super) fn sentences() -> impl Strategy<Value = String> {
    let word = prop::sample::select(VOCABULARY.to_vec());
    prop::collection::vec(word, 1..=5).prop_map(|words| words.join(" "))
}

/// Holds a chart to brute force, with functors that add nothing and without; how many goals there are without.
#[track_caller]
fn agrees_with_brute_force(model: &mut Model, command: &str) -> usize {
    let n_words = words(command).len();
    let lexical = lexical_items(model, &words(command));
    let [_, n_goals] = [true, false].map(|vacuous| {
        let wanted = brute::goals(model, n_words, &lexical, Admitted { vacuous, ..NORMAL_FORM });
        finds(model, command, ChartConfig { allow_vacuous: vacuous, ..WITHOUT_END }, &wanted)
    });
    n_goals
}

/// Holds where nothing is rejected for its meaning: a composition can hide that a functor adds nothing (`the room`
/// composed, then `room`), or what does not fit below a negation.
#[track_caller]
fn normal_form_loses_no_goal(unsorted: &mut Model, command: &str) {
    let n_words = words(command).len();
    let lexical = lexical_items(unsorted, &words(command));
    let [normal, all] = [true, false].map(|normal_form| {
        let goals =
            brute::goals(unsorted, n_words, &lexical, Admitted { normal_form, vacuous: true });
        goals.into_keys().collect::<Vec<_>>()
    });
    assert_eq!(normal, all, "{command}");
}

/// Holds a chart to the goals that it should find; how many there are.
#[track_caller]
fn finds(
    model: &mut Model,
    command: &str,
    config: ChartConfig,
    wanted: &BTreeMap<String, f64>,
) -> usize {
    let mut found = ranked(model, command, config);
    assert!(found.is_sorted_by(|a, b| a.1 >= b.1), "{command}: best first");
    found.sort_by(|a, b| a.0.cmp(&b.0));
    let forms = found.iter().map(|(form, _)| form);
    assert_eq!(forms.collect::<Vec<_>>(), wanted.keys().collect::<Vec<_>>(), "{command}");
    for (form, score) in &found {
        let difference = (score - wanted[form]).abs();
        assert!(difference < 1e-9, "{command}: {form} scores {score}, not {}", wanted[form]);
    }
    found.len()
}

#[test]
fn charts_find_what_brute_force_finds() {
    let mut model = ambiguous();
    let goals = [
        "go to the red room",
        "go to red room",
        "go the room",
        "robot in the red room",
        "robot in red room now",
        "the robot in room near",
        "not robot near robot now",
        "the red room",
        "go the room room",
        "red in red go red",
        "go red not go to red",
    ]
    .map(|command| (command, agrees_with_brute_force(&mut model, command)));
    assert_eq!(goals.map(|(_, n)| n), [2, 2, 1, 1, 1, 0, 1, 0, 0, 1, 1], "{goals:?}");
}

proptest! {
    #![proptest_config(Config { cases: 100, ..Config::default() })]

    #[test]
    fn charts_find_what_brute_force_finds_for_any_words(command in sentences()) {
        agrees_with_brute_force(&mut ambiguous(), &command);
        normal_form_loses_no_goal(&mut ambiguous(), &command);
        let mut sorted = model_over(ONTOLOGY, AMBIGUOUS);
        weighted(&mut sorted);
        agrees_with_brute_force(&mut sorted, &command);
    }

    #[test]
    fn the_order_of_the_lexicon_does_not_matter(
        command in sentences(),
        lines in Just(AMBIGUOUS.trim().lines().collect::<Vec<_>>()).prop_shuffle(),
    ) {
        let everything = |lexicon: &str| {
            let mut model = model(lexicon);
            let parse = parse(&mut model, &command, ChartConfig { beam: 4, ..ChartConfig::default() });
            let readings: Vec<String> = parse.readings.iter().map(|&reading| {
                let form = print(&model.grammar.terms, reading.form);
                let derivation = parse.derivation(reading).print(&model, &parse.words);
                format!("{form} {}\n{derivation}", reading.score)
            }).collect();
            (readings, parse.skipped, parse.reason, parse.tried)
        };
        prop_assert_eq!(everything(&lines.join("\n")), everything(AMBIGUOUS));
    }

    #[test]
    fn no_beam_and_no_budget_is_too_small(
        command in sentences(), beam in 0..4usize, budget in 0..40usize, skip in any::<bool>(),
    ) {
        let mut model = ambiguous();
        let command = if skip { format!("please {command}") } else { command };
        let config = ChartConfig { beam, budget, ..ChartConfig::default() };
        let parse = parse(&mut model, &command, config);
        prop_assert_eq!(parse.reason.is_none(), parse.answer().is_some());
        for reading in &parse.readings {
            parse.derivation(*reading).print(&model, &parse.words);
        }
    }
}

#[test]
fn a_budget_that_ran_out_is_said() {
    let mut model = ambiguous();
    let command = "go to the red room";
    let with = |model: &mut Model, budget| {
        parse(model, command, ChartConfig { budget, ..ChartConfig::default() })
    };
    let none = with(&mut model, 0);
    assert_eq!((none.reason, none.tried, none.readings.len()), (Some(Reason::Budget), 0, 0));
    let whole = with(&mut model, usize::MAX);
    assert!(whole.answer().is_some() && !whole.over_budget());
    let enough = with(&mut model, whole.tried);
    assert!(!enough.over_budget());
    assert_eq!(enough.readings, whole.readings);
    let short = with(&mut model, whole.tried - 1);
    assert!(short.over_budget() && short.tried < whole.tried);
}

#[test]
fn skipped_words_are_named_and_cost_one_each() {
    let mut model = ambiguous();
    let plain = parse(&mut model, "go to the red room", ChartConfig::default());
    let wanted = plain.answer().unwrap();
    assert!(plain.skipped.is_empty());
    for (command, skipped) in [
        ("please go to the red room", vec!["please"]),
        ("go to the red room quickly", vec!["quickly"]),
        ("go to the big red room", vec!["big"]),
        (
            "kindly, robby, go over to the red room at length",
            vec!["kindly", "robby", "over", "at", "length"],
        ),
        ("go to the red the room", vec!["the"]),
    ] {
        let parse = parse(&mut model, command, ChartConfig::default());
        assert_eq!(parse.skipped, skipped, "{command}");
        let best = parse.readings[0];
        if skipped != ["the"] {
            assert_eq!(best.form, wanted.form, "{command}");
            let cost = wanted.score - best.score;
            assert!((cost - skipped.len() as f64).abs() < 1e-9, "{command} costs {cost}");
        }
    }
}

#[test]
fn a_command_without_an_answer_says_why() {
    let mut model = ambiguous();
    let long = "go ".repeat(51);
    let letters = |n: usize| format!("go {}", "a".repeat(n - 2));
    let (fits, more) = (letters(MAX_LETTERS), letters(MAX_LETTERS + 1));
    for (command, reason) in [
        ("", Some(Reason::Empty)),
        ("🤖 … !", Some(Reason::Empty)),
        (&*long, Some(Reason::TooLong)),
        (&*fits, Some(Reason::UnknownWords)),
        (&*more, Some(Reason::TooLong)),
        ("xyzzy", Some(Reason::UnknownWords)),
        ("the xyzzy", Some(Reason::UnknownWords)),
        ("the room", Some(Reason::NoParse)),
        ("go to the red room", None),
        ("go to the red xyzzy room", None),
    ] {
        let parse = parse(&mut model, command, ChartConfig::default());
        assert_eq!(parse.reason, reason, "{command}");
        assert_eq!(parse.answer().is_some(), reason.is_none(), "{command}");
    }
}

#[test]
fn ties_stand_in_the_order_of_their_printed_forms() {
    let mut model = model(AMBIGUOUS);
    let parse = parse(&mut model, "go to the room", ChartConfig::default());
    assert_eq!(parse.reason, Some(Reason::Tie));
    assert_eq!((parse.tied(), parse.answer()), (2, None));
    let terms = &model.grammar.terms;
    let forms: Vec<String> = parse.readings.iter().map(|r| print(terms, r.form)).collect();
    assert!(forms[0].starts_with("(in:") && forms[1].starts_with("(near:"), "{forms:?}");
    assert!(forms[..parse.tied()].is_sorted());
}

#[test]
fn readings_that_differ_only_in_the_order_of_a_symmetric_relation_are_one() {
    let twins = "
go :- S/PP  : (lambda $0:<e,t> ($0 (the:<<e,t>,e> agent:<e,t>)))
by :- PP/NP : (lambda $0:e (lambda $1:e (near:<e,<e,t>> $1 $0)))
by :- PP/NP : (lambda $0:e (lambda $1:e (near:<e,<e,t>> $0 $1)))
doors :- NP : (the:<<e,t>,e> door:<e,t>)";
    let mut apart = model(twins);
    let two = parse(&mut apart, "go by doors", ChartConfig::default());
    assert_eq!((two.tied(), two.reason), (2, Some(Reason::Tie)));
    let mut together = model(&format!("commutative near:<e,<e,t>>\n{twins}"));
    let one = parse(&mut together, "go by doors", ChartConfig::default());
    assert_eq!(one.readings.len(), 1);
    assert_eq!(one.reason, None);
    let form = print(&together.grammar.terms, one.readings[0].form);
    let first = print(&apart.grammar.terms, two.readings[0].form);
    assert_eq!(form, first, "the twin that comes first in print is shown");
    // The better twin is shown as its derivation has it.
    let better = together.lexicon.entries()[2];
    together.features.set(Feature::Entry(better), 50.0);
    let one = parse(&mut together, "go by doors", ChartConfig::default());
    let form = print(&together.grammar.terms, one.readings[0].form);
    assert_eq!(form, print(&apart.grammar.terms, two.readings[1].form));
}
