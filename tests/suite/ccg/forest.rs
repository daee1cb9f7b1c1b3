//! Shortcuts that must change nothing: forests scored anew against new charts, pairs tried best first against all pairs,
//! sentences read clause by clause against their clauses written out.

use super::brute::{self, NORMAL_FORM};
use super::chart::{WITHOUT_END, sentences, weighted};
use super::{AMBIGUOUS, model};
use groundling::ccg::chart::Derivations;
use groundling::ccg::clauses::Clauses;
use groundling::ccg::goals::Goals;
use groundling::ccg::lookup::lexical_items;
use groundling::ccg::parse::{Parse, fill};
use groundling::ccg::{
    ChartConfig, EntryId, Feature, Forest, Hearing, Model, Reading, RuleId, Vector, parse, words,
};
use groundling::logic::{TermId, print};
use proptest::prelude::{Strategy, any, prop};
use proptest::test_runner::Config;
use proptest::{prop_assert_eq, prop_assume, proptest};
use std::collections::BTreeSet;

/// Weights of which many are equal, so that scores tie.
fn reweigh(model: &mut Model, weights: &[i8]) {
    let entries = model.lexicon.entries().to_vec().into_iter().map(Feature::Entry);
    let rules = (0..9).map(|row| Feature::Rule(RuleId(row)));
    let features: Vec<Feature> = entries.chain(rules).chain([Feature::Lost]).collect();
    for (feature, weight) in features.into_iter().zip(weights.iter().cycle()) {
        let weight = f64::from(*weight);
        model.features.set(feature, if feature == Feature::Lost { -weight.abs() } else { weight });
    }
}

fn weights() -> impl Strategy<Value = Vec<i8>> {
    prop::collection::vec(-1..=1i8, 1..40)
}

/// Fills a chart with the lexicon alone.
fn filled(model: &mut Model, words: &[String], config: ChartConfig) -> Parse {
    let lexical = lexical_items(model, words);
    fill(model, words, lexical, |_, _, _| true, config)
}

/// Goals with their features, as a chart has them.
fn vectors(model: &mut Model, parse: &Parse, empty: &[Option<EntryId>]) -> Vec<(TermId, Vector)> {
    let of = |&reading| {
        let derivation = parse.derivation(reading);
        let features = derivation.features(model, reading.form, &parse.words, empty);
        (reading.form, model.features.vector(&features))
    };
    parse.readings.iter().map(of).collect()
}

/// Goals, scores and derivations.
fn told(model: &Model, parse: &Parse) -> Vec<String> {
    let tell = |&reading: &Reading| {
        let form = print(&model.grammar.terms, reading.form);
        let derivation = parse.derivation(reading).print(model, &parse.words);
        format!("{form} {}\n{derivation}", reading.score)
    };
    parse.readings.iter().map(tell).collect()
}

/// A command that begins with "go".
fn clauses() -> impl Strategy<Value = String> {
    let word = prop::sample::select(vec!["to", "the", "red", "room", "in", "now"]);
    let rest = prop::collection::vec(word, 1..=4).prop_map(|words| words.join(" "));
    (any::<bool>(), rest)
        .prop_map(|(not, rest)| format!("{}go {rest}", if not { "not " } else { "" }))
}

/// A model that can join two commands.
fn joining() -> Model {
    let and = r"and :- S\S/S : (lambda $0:t (lambda $1:t (and:<t*,t> $1 $0)))";
    let mut model = model(&format!("{AMBIGUOUS}{and}\n"));
    weighted(&mut model);
    model
}

proptest! {
    #![proptest_config(Config { cases: 200, ..Config::default() })]

    #[test]
    fn a_forest_scored_anew_is_a_new_chart(
        command in sentences(),
        all in prop::collection::vec(weights(), 1..4),
        beam in prop::sample::select(vec![0, 1, 2, 3, 5, 8, usize::MAX]),
    ) {
        let mut model = model(AMBIGUOUS);
        weighted(&mut model);
        let words = words(&command);
        let empty = vec![None; words.len()];
        let keeping = ChartConfig { derivations: Derivations::Whole, ..WITHOUT_END };
        let first = filled(&mut model, &words, keeping);
        let mut goals = Goals::default();
        let mut forest = Forest::of(&model.grammar, first.chart(), beam);
        for weights in all {
            reweigh(&mut model, &weights);
            let anew = filled(&mut model, &words, ChartConfig { beam, ..WITHOUT_END });
            let lexical = lexical_items(&model, &words);
            forest.rescore(&model.grammar, &model.features, &lexical);
            let (found, wanted) = (forest.readings(&mut model, &mut goals), &anew.readings);
            let scored = |readings: &[Reading]| {
                readings.iter().map(|r| (r.form, r.score.to_bits())).collect::<Vec<_>>()
            };
            prop_assert_eq!(scored(&found), scored(wanted));
            prop_assert_eq!(Forest::answer(&found), anew.answer().map(|reading| reading.form));
            let found = forest.vectors(&mut model, &mut goals, &words, &empty);
            let found: Vec<_> = found.iter().map(|(form, vector)| (*form, (**vector).clone())).collect();
            prop_assert_eq!(found, vectors(&mut model, &anew, &empty));
        }
    }

    #[test]
    fn what_is_tried_best_first_is_what_all_pairs_give(
        command in sentences(),
        again in sentences(),
        beam in 0..6usize,
        weights in weights(),
    ) {
        let mut model = model(AMBIGUOUS);
        reweigh(&mut model, &weights);
        let words = words(&format!("{command} {again}"));
        let [best, all] = [Derivations::Best, Derivations::All].map(|derivations| {
            let parse = filled(&mut model, &words, ChartConfig { beam, derivations, ..WITHOUT_END });
            told(&model, &parse)
        });
        prop_assert_eq!(best, all);
    }

    #[test]
    fn joined_clauses_mean_what_each_means(
        commands in prop::collection::vec(clauses(), 2..=3),
    ) {
        // Behind another clause "the room", or "in" alone, may be of what was named there: that is not read by clause.
        let names_again = |command: &str| command.contains("the room") || command.ends_with(" in");
        prop_assume!(commands.iter().skip(1).all(|command| !names_again(command)));
        let mut model = joining();
        let (mut wanted, mut most) = (vec![None], 0);
        for command in &commands {
            let words = words(command);
            let lexical = lexical_items(&model, &words);
            // "Not go red, red in red" is two commands already, which no clause is here.
            prop_assume!(!brute::is_several(&mut model, words.len(), &lexical));
            let own = brute::commands(&mut model, words.len(), &lexical, NORMAL_FORM);
            let terms = &mut model.grammar.terms;
            let mut joined = Vec::new();
            for before in &wanted {
                for &goal in &own {
                    let goals: Vec<TermId> = before.iter().copied().chain([goal]).collect();
                    let both = terms.conjoin(&goals).unwrap();
                    // What adds nothing to what was said, or takes it back, is no reading.
                    if *before != Some(both) && brute::is_meant(terms, both) {
                        joined.push(Some(both));
                    }
                }
            }
            wanted = joined;
            most = most.max(wanted.len());
        }
        let words = words(&commands.join(" and "));
        let hearing = Hearing::new(&model, &words);
        let clauses = hearing.clauses(&model);
        let begins = commands.iter().scan(0, |at, command| {
            *at += groundling::ccg::words(command).len() + 1;
            Some(*at - 1)
        });
        let begins = begins.take(commands.len() - 1).fold(Clauses::ONE, Clauses::with);
        prop_assert_eq!(clauses, begins);
        let by_clause = filled(&mut model, &words, ChartConfig { clauses, ..WITHOUT_END });
        let terms = &model.grammar.terms;
        let found: BTreeSet<String> = by_clause.readings.iter().map(|r| print(terms, r.form)).collect();
        let wanted: BTreeSet<String> = wanted.into_iter().flatten().map(|form| print(terms, form)).collect();
        if most <= 32 {
            prop_assert_eq!(found, wanted);
        }
    }
}

#[test]
fn a_sentence_that_cannot_be_read_by_clause_is_read_as_a_whole() {
    let lexicon = format!(
        "{AMBIGUOUS}and :- NP\\NP/NP : (lambda $0:e (lambda $1:e (the:<<e,t>,e> (lambda $2:e (and:<t*,t> (near:<e,<e,t>> $2 $0) (near:<e,<e,t>> $2 $1))))))\ngo :- NP : (the:<<e,t>,e> door:<e,t>)\n"
    );
    let mut model = model(&lexicon);
    weighted(&mut model);
    let command = "go to robot and go";
    let hearing = Hearing::new(&model, &words(command));
    assert_eq!(hearing.clauses(&model), Clauses::ONE.with(3));
    let parse = parse(&mut model, command, ChartConfig::default());
    assert!(!parse.readings.is_empty() && parse.skipped.is_empty());
}
