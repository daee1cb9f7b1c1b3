//! Words that mean nothing: absorbed in one way each, held against leaving them out; what is skipped beyond them; and
//! what it is scored by.

use super::brute::NORMAL_FORM;
use super::chart::{WITHOUT_END, weighted};
use super::{AMBIGUOUS, brute, model_over};
use groundling::ccg::absorb::{Leniency, absorbing, absorption, empty_entries};
use groundling::ccg::lookup::lexical_items;
use groundling::ccg::parse::fill;
use groundling::ccg::{ChartConfig, Feature, Lexical, Model, Reason, parse, words};
use groundling::ground::ONTOLOGY;
use groundling::logic::print;
use proptest::prelude::{Strategy, prop};
use proptest::{prop_assert, proptest};
use std::collections::BTreeMap;

const EMPTY: &str = "please | now | the | to :- EMPTY : true:t";

/// The ambiguous lexicon with weights and empty words, over constants that have sorts.
fn polite() -> Model {
    let mut model = model_over(ONTOLOGY, &format!("{AMBIGUOUS}\n{EMPTY}"));
    weighted(&mut model);
    model
}

/// The goals of a sentence when any of its empty words may be left out, each with its best score.
fn goals_without(model: &mut Model, words: &[String]) -> BTreeMap<String, f64> {
    let empty = empty_entries(model, words);
    let costs = absorption(model, words, &empty, Leniency::Learned);
    let items = lexical_items(model, words);
    let mut best = BTreeMap::new();
    for left_out in 0..1_u32 << words.len() {
        let is_out = |at: &usize| left_out & (1 << at) != 0;
        let place = |at: usize| (0..at).filter(|at| !is_out(at)).count();
        let cost: Option<f64> = (0..words.len()).filter(is_out).map(|at| costs[at]).sum();
        let Some(cost) = cost else { continue };
        let whole = items.iter().filter(|item| !(item.start..item.end).any(|at| is_out(&at)));
        let items: Vec<Lexical> = whole
            .map(|item| Lexical { start: place(item.start), end: place(item.end), ..*item })
            .collect();
        for (form, score) in brute::goals(model, place(words.len()), &items, NORMAL_FORM) {
            let known = best.entry(form).or_insert(f64::NEG_INFINITY);
            *known = known.max(score + cost);
        }
    }
    best
}

/// The goals that a chart without end finds.
fn goals(model: &mut Model, words: &[String]) -> BTreeMap<String, f64> {
    let empty = empty_entries(model, words);
    let costs = absorption(model, words, &empty, Leniency::Learned);
    let items = absorbing(lexical_items(model, words), &costs);
    let parse = fill(model, words, items, |_, _, _| true, WITHOUT_END);
    let terms = &model.grammar.terms;
    parse.readings.iter().map(|reading| (print(terms, reading.form), reading.score)).collect()
}

fn sentences() -> impl Strategy<Value = String> {
    let word = prop::sample::select(vec![
        "go", "to", "the", "red", "room", "in", "near", "robot", "now", "please", "not",
    ]);
    prop::collection::vec(word, 1..=5).prop_map(|words| words.join(" "))
}

#[track_caller]
fn agree(command: &str) -> usize {
    let mut model = polite();
    let words = words(command);
    let (found, wanted) = (goals(&mut model, &words), goals_without(&mut model, &words));
    let forms = |goals: &BTreeMap<String, f64>| goals.keys().cloned().collect::<Vec<_>>();
    assert_eq!(forms(&found), forms(&wanted), "{command}");
    for (form, score) in &found {
        assert!((score - wanted[form]).abs() < 1e-9, "{command}: {form}: {score}, not {wanted:?}");
    }
    found.len()
}

proptest! {
    #[test]
    fn to_absorb_a_word_is_to_leave_it_out(command in sentences()) {
        agree(&command);
    }

    #[test]
    fn a_reading_scores_what_its_features_add_up_to(command in sentences(), odd in 0..6usize) {
        let mut model = polite();
        let mut words = words(&command);
        words.insert(odd.min(words.len()), "xyzzy".to_owned());
        let parse = parse(&mut model, &words.join(" "), ChartConfig::default());
        let empty = empty_entries(&model, &words);
        for &reading in &parse.readings {
            let derivation = parse.derivation(reading);
            let occurring = derivation.features(&model, reading.form, &words, &empty);
            let vector = model.features.vector(&occurring);
            let sum = model.features.dot(&vector);
            prop_assert!((sum - reading.score).abs() < 1e-9, "{sum} is not {}", reading.score);
        }
    }
}

#[test]
fn empty_words_stand_anywhere_and_are_absorbed_once() {
    for (command, n) in [
        ("please go to red room", 1),
        ("go please to red room", 1),
        ("go to red room please", 1),
        ("please now please please", 0),
        ("go the room", 0),
        ("go the robot", 1),
    ] {
        assert_eq!(agree(command), n, "{command}");
    }
    let mut model =
        model_over(ONTOLOGY, &format!("{AMBIGUOUS}\nplease | kindly :- EMPTY : true:t"));
    let mut derivations = |command: &str| {
        let words = words(command);
        let empty = empty_entries(&model, &words);
        let costs = absorption(&model, &words, &empty, Leniency::Learned);
        let items = absorbing(lexical_items(&model, &words), &costs);
        brute::derivations(&mut model, words.len(), &items)
    };
    let plain = derivations("go in the room");
    assert!(plain > 0);
    for command in [
        "please go in the room",
        "please kindly please go in the room",
        "go please in kindly the please room",
        "go in the room please kindly",
        "kindly go please please in the room kindly",
    ] {
        assert_eq!(derivations(command), plain, "{command}: no reading twice");
    }
}

#[test]
fn what_no_entry_calls_empty_is_skipped_and_named() {
    let mut model = polite();
    for (command, skipped) in [
        ("please go to the red room now", vec![]),
        ("please go frobnicate to the red room please", vec!["frobnicate"]),
        ("xyzzy please go to the red room plugh", vec!["xyzzy", "plugh"]),
    ] {
        let parse = parse(&mut model, command, ChartConfig::default());
        assert_eq!(parse.skipped, skipped, "{command}");
        assert!(!parse.readings.is_empty(), "{command}");
    }
    for command in ["please", "please now the", "to to to please"] {
        let parse = parse(&mut model, command, ChartConfig::default());
        assert_eq!(parse.reason, Some(Reason::NoParse), "{command} asks for nothing");
        assert!(parse.readings.is_empty() && parse.skipped.is_empty());
    }
}

#[test]
fn absorbed_words_are_scored_by_their_entry_or_as_skipped_and_as_dropped() {
    let red = "red :- N/N : (lambda $0:<e,t> (lambda $1:e (and:<t*,t> (red:<e,t> $1) ($0 $1))))";
    let mut model = model_over(ONTOLOGY, &format!("{red}\nplease | a :- EMPTY : true:t"));
    let words = words("please red xyzzy a");
    let empty = empty_entries(&model, &words);
    let [please, None, None, Some(a)] = empty[..] else { panic!("{empty:?}") };
    let features = |at: usize| model.absorption_features(&words[at], empty[at]);
    assert_eq!(features(0), model.entry_features(please.unwrap()));
    assert_eq!(features(1), [Feature::Skip, Feature::Dropped], "what is said is meant");
    assert_eq!(features(2), [Feature::Skip]);
    assert_eq!(features(3), model.entry_features(a));
    for (leniency, may) in [
        (Leniency::Learned, [true, false, false, true]),
        (Leniency::Unknown, [true, false, true, true]),
        (Leniency::Any, [true; 4]),
    ] {
        assert_eq!(
            absorption(&model, &words, &empty, leniency)
                .iter()
                .map(Option::is_some)
                .collect::<Vec<_>>(),
            may
        );
    }
    model.features.set(Feature::Skip, -0.25);
    let costs = absorption(&model, &words, &empty, Leniency::Any);
    assert_eq!(costs[1..3], [Some(-3.25), Some(-0.25)]);
}
