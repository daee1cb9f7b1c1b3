//! Learning: the paper's demonstration with six sentences, the gradient by hand, runs that stop and go on, and
//! corpora from which nothing can be learned.

#[path = "learn/care.rs"]
mod care;
#[path = "learn/domain.rs"]
mod domain;
#[path = "learn/garbage.rs"]
mod garbage;
#[path = "learn/gradient.rs"]
mod gradient;
#[path = "learn/novelty.rs"]
mod novelty;
#[path = "learn/resume.rs"]
mod resume;
#[path = "learn/trust.rs"]
mod trust;

use groundling::ccg::{ChartConfig, Model, parse};
use groundling::corpus::{Cells, Corpus, Decision, Example, Options, Pair, read};
use groundling::learn::{
    Config, DEMONSTRATION_LEXICON, Evaluation, Progress, Score, Trainer, seed_model,
};
use groundling::logic::print_human;

/// The project's own six commands.
pub(crate) const SIX: &str = include_str!("../../assets/corpus/six.csv");

pub(crate) fn six() -> Vec<Example> {
    let (Corpus { examples, .. }, flaws) = read(SIX.as_bytes(), Options::default());
    assert!(flaws.is_empty(), "{flaws:?}");
    examples
}

fn trainer(examples: &[Example], config: &Config) -> Trainer {
    Trainer::new(seed_model(DEMONSTRATION_LEXICON).unwrap(), examples, config.clone())
}

/// Trains to the end; the model, and the last that was said of the way.
fn train(examples: &[Example], config: &Config) -> (Model, Option<Progress>) {
    train_from(seed_model(DEMONSTRATION_LEXICON).unwrap(), examples, config)
}

fn train_from(seed: Model, examples: &[Example], config: &Config) -> (Model, Option<Progress>) {
    let mut trainer = Trainer::new(seed, examples, config.clone());
    let mut last = None;
    while !trainer.is_done() {
        last = trainer.step().or(last);
    }
    (trainer.averaged(), last)
}

#[track_caller]
fn means(model: &mut Model, command: &str, wanted: &str) {
    let parse = parse(model, command, ChartConfig::of(model));
    let answer = parse.answer().unwrap_or_else(|| panic!("{command}: {:?}", parse.reason));
    assert_eq!(print_human(&model.grammar.terms, answer.form), wanted, "{command}");
    assert!(parse.skipped.is_empty(), "{command}: skipped {:?}", parse.skipped);
}

#[track_caller]
fn has_learned_the_six(model: &mut Model) {
    means(model, "go to the blue room", "in(the agent, the λx. blue(x) ∧ room(x))");
    means(model, "walk to the red room", "in(the agent, the λx. red(x) ∧ room(x))");
    let examples = six();
    let config = ChartConfig::of(model);
    let mut evaluation = Evaluation::new(model, &examples, config);
    while evaluation.step().is_some() {}
    let scores = evaluation.scores();
    assert_eq!(scores.total, 6);
    assert_eq!(scores.plain, Score { answered: 6, correct: 6 }, "without skipping words");
    assert_eq!(scores.skipping, scores.plain);
}

#[test]
fn six_sentences_teach_a_room_that_none_of_them_names() {
    let (mut model, last) = train(&six(), &Config::default());
    let last = last.unwrap();
    assert_eq!((last.epoch, last.example, last.so_far.valid), (16, 6, 6), "{last:?}");
    has_learned_the_six(&mut model);
}

#[test]
fn the_same_corpus_settings_and_seed_give_the_same_bytes() {
    let config = Config { epochs: 4, ..Config::default() };
    let text = |config: &Config| train(&six(), config).0.print();
    assert_eq!(text(&config), text(&config));
    let longer = Config { epochs: 5, ..Config::default() };
    assert_ne!(text(&config), text(&longer), "the settings are part of the model");
}

#[test]
fn another_order_of_examples_learns_as_well() {
    for seed in [1, 2, 77] {
        let (mut model, last) = train(&six(), &Config { seed, ..Config::default() });
        assert_eq!(last.unwrap().so_far.valid, 6, "seed {seed}");
        has_learned_the_six(&mut model);
    }
}

/// An example with the demonstrations of one of the six.
fn example(command: &str, pairs: Vec<Pair>) -> Example {
    let (task, worker) = (None, None);
    Example {
        id: command.to_owned(),
        line: 0,
        command: command.to_owned(),
        task,
        worker,
        decision: Decision::Open,
        pairs,
        rest: Cells::default(),
        keys: Cells::default(),
    }
}

#[test]
fn from_what_makes_no_sense_nothing_is_learned() {
    let six = six();
    let pairs = &six[0].pairs;
    let still = pairs.iter().map(|p| Pair::of(p.pre.clone(), p.pre.clone())).collect();
    let there_and_back =
        pairs.iter().flat_map(|p| [p.clone(), Pair::of(p.post.clone(), p.pre.clone())]);
    let nonsense = [
        example("", pairs.clone()),
        example("🤖 …", pairs.clone()),
        example(&"go to the green room ".repeat(40), pairs.clone()),
        example("sleep furiously", pairs.clone()),
        example("the the", pairs.clone()),
        example("go to the green room", still),
        example("walk to the green room", there_and_back.collect()),
    ];
    let (model, last) = train(&nonsense, &Config { epochs: 4, ..Config::default() });
    let last = last.unwrap();
    // The fifth pass looks for idioms.
    assert_eq!((last.epoch, last.example, last.so_far.valid), (5, 7, 0), "{last:?}");
    let seed = seed_model(DEMONSTRATION_LEXICON).unwrap();
    assert_eq!(model.lexicon.len(), seed.lexicon.len(), "no entry is believed");
    assert_eq!(Model::read(&model.print()).unwrap().print(), model.print());
    // The good learn among the bad.
    let mixed: Vec<Example> = nonsense.into_iter().chain(six.iter().cloned()).collect();
    let (mut model, last) = train(&mixed, &Config::default());
    assert_eq!(last.unwrap().so_far.valid, 6);
    means(&mut model, "go to the blue room", "in(the agent, the λx. blue(x) ∧ room(x))");
}

#[test]
fn what_sounds_like_nonsense_may_be_a_language_never_heard() {
    let pairs = six()[0].pairs.clone();
    let (_, last) =
        train(&[example("colourless ideas sleep furiously", pairs)], &Config::default());
    assert_eq!(last.unwrap().so_far.valid, 1, "four words are enough for `go-in the green room`");
}

#[test]
fn a_run_without_examples_or_without_demonstrations_ends() {
    let (model, last) = train(&[], &Config::default());
    assert_eq!(last, None);
    let (other, _) = train(&[example("go to the green room", Vec::new())], &Config::default());
    assert_eq!(model.lexicon.len(), other.lexicon.len(), "what nothing shows is not believed");
}

#[test]
fn scores_are_ratios_and_of_nothing_zero() {
    let none = Score::default();
    assert_eq!(
        [none.precision(), none.recall(0), none.f1(0), none.recall(5), none.f1(5)],
        [0.0; 5]
    );
    let wrong = Score { answered: 4, correct: 0 };
    assert_eq!([wrong.precision(), wrong.recall(5), wrong.f1(5)], [0.0; 3]);
    let some = Score { answered: 4, correct: 3 };
    assert_eq!([some.precision(), some.recall(6)], [0.75, 0.5]);
    assert!((some.f1(6) - 0.6).abs() < 1e-15);
    let all = Score { answered: 6, correct: 6 };
    assert_eq!([all.precision(), all.recall(6), all.f1(6)], [1.0; 3]);
}
