//! What wrong answers do instead, and ties that one form's phrases settle.

use crate::learn::six;
use groundling::ccg::ChartConfig;
use groundling::corpus::{Example, Pair};
use groundling::learn::{
    Config, DEMONSTRATION_LEXICON, Evaluation, Report, Score, Ties, Trainer, seed_model,
};

/// How a model that has learned the six answers.
fn evaluate(examples: &[Example]) -> Report {
    let seed = seed_model(DEMONSTRATION_LEXICON).unwrap();
    let mut trainer = Trainer::new(seed, &six(), Config::default());
    while !trainer.is_done() {
        trainer.step();
    }
    let mut model = trainer.averaged();
    let config = ChartConfig::of(&model);
    let mut evaluation = Evaluation::new(&mut model, examples, config);
    while evaluation.step().is_some() {}
    evaluation.into_report()
}

/// One of the six with another command.
fn said(like: &Example, command: &str) -> Example {
    Example { command: command.to_owned(), ..like.clone() }
}

#[test]
fn wrong_answers_are_known_by_what_they_do() {
    let six = six();
    let green = six.iter().find(|e| e.task.as_deref() == Some("green-room")).unwrap();
    let near = six.iter().find(|e| e.task.as_deref() == Some("near-block")).unwrap();
    let back = |pair: &Pair| Pair::of(pair.post.clone(), pair.pre.clone());
    let mut examples = six.clone();
    examples.extend([
        // Says what the other task does, twice.
        said(near, &green.command),
        said(near, &green.command),
        // Says what no task does.
        said(near, "go to the red room"),
        // Says what its task does, but shows something else.
        Example { pairs: near.pairs.iter().map(back).collect(), ..near.clone() },
        // Nobody knows what it was meant to do.
        Example { task: None, ..said(green, &near.command) },
        // No answer is no confusion.
        said(near, "colourless ideas"),
    ]);
    let report = evaluate(&examples);
    let scores = report.scores(Ties::Abstain);
    assert_eq!(scores.total, 12);
    assert_eq!(scores.plain, Score { answered: 11, correct: 6 });
    let cells: Vec<_> = report.confusion.cells().collect();
    let (green, near) = (Some("green-room"), Some("near-block"));
    assert_eq!(cells, [(None, near, 1), (near, None, 1), (near, green, 2), (near, near, 1)]);
    // The same of two halves put together, but for who stands for a task.
    let mut halves = evaluate(&examples[..6]);
    assert_eq!(halves.confusion.cells().count(), 0);
    halves.add(report.clone());
    assert_eq!(halves.scores(Ties::Abstain).total, 18);
    assert!(halves.confusion.cells().eq(report.confusion.cells()));
}

#[test]
fn a_tie_is_broken_by_the_one_form_that_refers() {
    // Two nouns for one word, and nothing that tells them apart but the world.
    let lexicon = "frame agent:<e,t>\n\
        thing :- N : block:<e,t>\n\
        thing :- N : backpack:<e,t>\n\
        the :- NP/N : (lambda $0:<e,t> (the:<<e,t>,e> $0))\n\
        reach :- S/NP : (lambda $0:e (near:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) $0))\n";
    let mut model = seed_model(lexicon).unwrap();
    let six = six();
    let near: Vec<Example> = six
        .iter()
        .filter(|e| e.task.as_deref() == Some("near-block"))
        .map(|e| said(e, "reach the thing"))
        .collect();
    let has_backpack = |example: &Example| {
        let backpacks = |pair: &Pair| {
            pair.pre.objects.iter().filter(|o| o.shape.name() == "backpack").count() == 1
        };
        example.pairs.iter().all(backpacks)
    };
    assert!(!near.iter().any(has_backpack), "the states tell the readings apart");
    let config = ChartConfig::of(&model);
    let mut evaluation = Evaluation::new(&mut model, &near, config);
    while evaluation.step().is_some() {}
    let report = evaluation.into_report();
    let total = near.len();
    assert_eq!(report.scores(Ties::Abstain).plain, Score::default(), "tied forms abstain");
    let resolved = report.scores(Ties::Refer);
    assert_eq!(resolved.plain, Score { answered: total, correct: total });
    assert_eq!(resolved.skipping, resolved.plain);
}
