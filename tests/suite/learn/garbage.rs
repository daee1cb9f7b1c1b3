//! Corpora of garbage: random words, empty commands, examples without demonstrations or with such as contradict each
//! other. Training ends, says how much of it made sense, and leaves a model that can be used.

use super::{example, six};
use groundling::ccg::{ChartConfig, Model, Reason, parse};
use groundling::corpus::{Example, Pair};
use groundling::learn::{
    CLEANUP_LEXICON, Config, DEMONSTRATION_LEXICON, Progress, Trainer, seed_model,
};
use proptest::prelude::{Strategy, any, prop};
use proptest::{prop_assert, prop_assert_eq, proptest};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;

/// Words that the seed knows, words that nobody knows, and what is no word.
const WORDS: [&str; 24] = [
    "go",
    "to",
    "the",
    "red",
    "green",
    "room",
    "block",
    "chair",
    "in",
    "near",
    "and",
    "move",
    "biggest",
    "of",
    "'s",
    "with",
    "xyzzy",
    "plugh",
    "frobnicate",
    "redd",
    "🤖",
    "…",
    "ß",
    "去",
];

/// One row that makes no sense, or by accident a little.
fn row(random: &mut Pcg32, good: &[Pair]) -> Example {
    let length = *[0, 1, 2, 3, 4, 5, 6, 9, 60].get(random.random_range(0..9_u32) as usize).unwrap();
    let mut word = || WORDS[random.random_range(0..WORDS.len() as u32) as usize];
    let command: Vec<&str> = (0..length).map(|_| word()).collect();
    let mut pairs: Vec<Pair> = Vec::new();
    for _ in 0..random.random_range(0..4_u32) {
        let Pair { pre, post, .. } =
            good[random.random_range(0..good.len() as u32) as usize].clone();
        pairs.push(match random.random_range(0..3_u32) {
            0 => Pair::of(pre, post),
            1 => Pair::of(post.clone(), pre),
            _ => Pair::of(pre.clone(), pre),
        });
    }
    example(&command.join(" "), pairs)
}

/// So many rows; every fifth says again what another says, about other demonstrations.
fn garbage(rows: usize, seed: u64) -> Vec<Example> {
    let good: Vec<Pair> = six().into_iter().flat_map(|example| example.pairs).collect();
    let mut random = Pcg32::seed_from_u64(seed);
    let mut all: Vec<Example> = Vec::with_capacity(rows);
    for at in 0..rows {
        let mut next = row(&mut random, &good);
        if at % 5 == 4 {
            next.command.clone_from(&all[at - 4].command);
        }
        all.push(next);
    }
    all
}

/// Trains to the end; the model and everything that was said of the way.
fn train(lexicon: &str, examples: &[Example], config: &Config) -> (Model, Vec<Progress>) {
    let seed = seed_model(lexicon).unwrap();
    let mut trainer = Trainer::new(seed, examples, config.clone());
    let mut said = Vec::new();
    while !trainer.is_done() {
        said.extend(trainer.step());
    }
    (trainer.averaged(), said)
}

/// What must be so of a run over garbage, whatever was in it.
#[track_caller]
fn ends_well(lexicon: &str, examples: &[Example], config: &Config) -> Model {
    let (model, said) = train(lexicon, examples, config);
    let last = said.last().unwrap();
    assert_eq!((last.epoch, last.example), (config.passes(), examples.len()));
    for Progress { example, so_far, .. } in said.iter().filter(|p| p.epoch <= config.epochs) {
        assert!(so_far.valid <= *example && so_far.updates <= so_far.valid, "{so_far:?}");
        assert!(so_far.over_budget <= *example, "{so_far:?}");
    }
    assert_eq!(last.so_far.entries, model.lexicon.len());
    assert_eq!(
        model.facts["valid"],
        last.so_far.valid.to_string(),
        "the model says what made sense"
    );
    assert_eq!(model.facts["examples"], examples.len().to_string());
    let text = model.print();
    let mut again = Model::read(&text).unwrap();
    assert_eq!(again.print(), text);
    for example in examples.iter().take(20) {
        let config = ChartConfig { beam: 20, budget: 20_000, ..ChartConfig::default() };
        let parse = parse(&mut again, &example.command, config);
        assert_eq!(parse.answer().is_some(), parse.reason.is_none(), "{}", example.command);
    }
    model
}

fn quick(seed: u32) -> Config {
    Config {
        epochs: 2,
        beam: 15,
        lexical_beam: 10,
        seed,
        budget: 4_000,
        lexical_budget: 2_000,
        ..Config::default()
    }
}

/// Some hundred rows; as many as random cases are asked for, where those are more (`make test-long`).
fn many() -> usize {
    proptest::test_runner::Config::default().cases.clamp(300, 10_000) as usize
}

#[test]
fn any_number_of_rows_of_garbage_trains_to_an_end() {
    let examples = garbage(many(), 1);
    let model = ends_well(CLEANUP_LEXICON, &examples, &quick(0));
    let again = ends_well(CLEANUP_LEXICON, &examples, &quick(0));
    assert!(model.print() == again.print(), "the same seed gives the same bytes");
    let other = ends_well(CLEANUP_LEXICON, &examples, &quick(1));
    assert!(model.print() != other.print(), "the seed is part of the model");
}

#[test]
fn commands_without_demonstrations_teach_nothing() {
    let mut examples = garbage(100, 2);
    examples.iter_mut().for_each(|example| example.pairs.clear());
    let model = ends_well(CLEANUP_LEXICON, &examples, &quick(0));
    assert_eq!(model.facts["valid"], "0");
    assert_eq!(model.lexicon.len(), seed_model(CLEANUP_LEXICON).unwrap().lexicon.len());
}

#[test]
fn what_contradicts_itself_is_not_believed() {
    let pairs = six()[0].pairs.clone();
    let back = pairs.iter().map(|Pair { pre, post, .. }| Pair::of(post.clone(), pre.clone()));
    let both: Vec<Pair> = pairs.iter().cloned().chain(back).collect();
    let examples: Vec<Example> =
        (0..20).map(|i| example(&format!("word{i} the green room"), both.clone())).collect();
    let model = ends_well(CLEANUP_LEXICON, &examples, &quick(0));
    assert_eq!(model.facts["valid"], "0");
    assert!(!model.lexicon.knows("word7"));
}

proptest! {
    #![proptest_config(proptest::test_runner::Config { cases: 12, ..Default::default() })]

    #[test]
    fn no_garbage_stops_training(seed in any::<u64>(), rows in 1..40usize, small in any::<bool>()) {
        let lexicon = if small { DEMONSTRATION_LEXICON } else { CLEANUP_LEXICON };
        ends_well(lexicon, &garbage(rows, seed), &quick(seed as u32));
    }

    #[test]
    fn the_order_of_ties_is_that_of_print_whatever_was_learned(
        seed in any::<u64>(), words in prop::sample::subsequence(WORDS.to_vec(), 1..6).prop_shuffle(),
    ) {
        let (mut model, _) = train(CLEANUP_LEXICON, &garbage(10, seed), &quick(0));
        let config = ChartConfig { beam: 20, budget: 20_000, ..ChartConfig::default() };
        let parse = parse(&mut model, &words.join(" "), config);
        let ranked: Vec<(i64, String)> = parse.ranked()
            .map(|(rank, reading)| (rank, groundling::logic::print(&model.grammar.terms, reading.form)))
            .collect();
        prop_assert!(ranked.is_sorted_by(|a, b| a.0 > b.0 || (a.0 == b.0 && a.1 < b.1)), "{ranked:?}");
        let is_whole = parse.reason != Some(Reason::LeftOut);
        prop_assert_eq!(parse.answer().is_some(), parse.tied() == 1 && is_whole);
    }
}
