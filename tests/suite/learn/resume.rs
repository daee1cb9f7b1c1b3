//! Runs that stop and go on from a checkpoint end in the same bytes; a checkpoint of another run is refused.

use super::{six, train, trainer};
use groundling::ccg::{Kinds, Model};
use groundling::learn::{Config, Trainer};

const CONFIG: Config = Config {
    epochs: 5,
    beam: 150,
    lexical_beam: 75,
    demonstrations: None,
    margin: 1.0,
    seed: 3,
    budget: 200_000,
    lexical_budget: 60_000,
    generations: 2,
    idioms: true,
    contrasts: true,
    without: Kinds::NONE,
    planning: None,
};

/// Steps until so many examples were seen.
fn run(trainer: &mut Trainer, examples: usize) {
    let mut seen = 0;
    while seen < examples {
        seen += usize::from(trainer.step().is_some());
    }
}

fn end(mut trainer: Trainer) -> String {
    while !trainer.is_done() {
        trainer.step();
    }
    trainer.averaged().print()
}

#[test]
fn a_run_that_was_interrupted_ends_in_the_same_bytes() {
    let examples = six();
    let uninterrupted = train(&examples, &CONFIG).0.print();
    for moment in [0, 1, 5, 6, 7, 17, 29, 30, 31, 35, 36, 37, 41] {
        let mut trainer = trainer(&examples, &CONFIG);
        run(&mut trainer, moment);
        let file = trainer.checkpoint();
        let checkpoint = Model::read(&file).unwrap();
        let resumed = Trainer::resume(checkpoint, &examples, CONFIG).unwrap();
        assert_eq!(resumed.checkpoint(), file, "nothing is lost after {moment} examples");
        assert!(
            end(resumed) == uninterrupted,
            "stopped after {moment} examples, it ends otherwise"
        );
        assert!(end(trainer) == uninterrupted, "a checkpoint after {moment} changes the run");
    }
}

#[test]
fn a_run_may_be_interrupted_within_an_example_and_again_and_again() {
    let examples = six();
    let mut trainer = trainer(&examples, &CONFIG);
    let (mut steps, mut begun, mut looked) = (0, 0, 0);
    while !trainer.is_done() {
        let progress = trainer.step();
        let within = progress.is_none();
        begun = if within { begun + 1 } else { 0 };
        // The search for idioms, last, is begun anew after an interruption: one is enough.
        looked += u32::from(progress.is_some_and(|progress| progress.epoch > CONFIG.epochs));
        if within || (looked == 0 && steps % 4 == 0) || looked == 3 {
            let checkpoint = Model::read(&trainer.checkpoint()).unwrap();
            trainer = Trainer::resume(checkpoint, &examples, CONFIG).unwrap();
            // What was begun is begun again; as many steps bring it to where it was.
            for _ in 0..begun {
                assert!(trainer.step().is_none());
            }
        }
        steps += 1;
    }
    assert!(trainer.averaged().print() == train(&examples, &CONFIG).0.print());
}

#[test]
fn a_checkpoint_of_another_run_is_refused_in_words() {
    let examples = six();
    let mut trainer = trainer(&examples, &CONFIG);
    run(&mut trainer, 8);
    let checkpoint = trainer.checkpoint();
    let refused = |text: &str, examples: &[_], config: Config| {
        let error = Trainer::resume(Model::read(text).unwrap(), examples, config).err().unwrap();
        error.to_string()
    };
    let said = "the checkpoint does not fit: its";
    for (config, fact) in [
        (Config { epochs: 6, ..CONFIG }, "epochs is 5, that of this run is 6"),
        (Config { beam: 20, ..CONFIG }, "beam is 150, that of this run is 20"),
        (Config { lexical_beam: 7, ..CONFIG }, "lexical_beam is 75, that of this run is 7"),
        (
            Config { demonstrations: Some(1), ..CONFIG },
            "demonstrations is all, that of this run is 1",
        ),
        (Config { margin: 0.5, ..CONFIG }, "margin is 1, that of this run is 0.5"),
        (Config { seed: 4, ..CONFIG }, "seed is 3, that of this run is 4"),
        (Config { budget: 9, ..CONFIG }, "budget is 200000, that of this run is 9"),
    ] {
        assert_eq!(refused(&checkpoint, &examples, config), format!("{said} {fact}"));
    }
    let fewer = refused(&checkpoint, &examples[1..], CONFIG);
    assert_eq!(fewer, format!("{said} examples is 6, that of this run is 5"));
    let mut other = examples.clone();
    other.swap(0, 1);
    assert!(refused(&checkpoint, &other, CONFIG).starts_with(&format!("{said} corpus is ")));
    // A finished model says nothing of where a run was; what a damaged one says cannot be.
    let finished = train(&examples, &CONFIG).0.print();
    let no_place = refused(&finished, &examples, CONFIG);
    assert_eq!(no_place, format!("{said} at_epoch is missing, that of this run is 1"));
    for (fact, was, damaged) in [
        ("at_epoch", "2", "7"),
        ("at_epoch", "2", "0"),
        ("at_epoch", "2", "two"),
        ("at_example", "2", "6"),
        ("at_valid", "", "-1"),
    ] {
        let at = checkpoint.find(&format!("fact\t{fact}\t{was}")).unwrap();
        let line = checkpoint[at..].lines().next().unwrap();
        let text = checkpoint.replace(line, &format!("fact\t{fact}\t{damaged}"));
        let words = refused(&text, &examples, CONFIG);
        assert!(words.starts_with(&format!("{said} {fact} is {damaged}, ")), "{words}");
    }
}
