//! Misspelt words are heard as the known words next to them; what is skipped is named as it was written.

use super::model;
use groundling::ccg::{ChartConfig, Hearing, parse, words};
use groundling::logic::print;

const LEXICON: &str = "
go :- S/PP : (lambda $0:<e,t> ($0 (the:<<e,t>,e> agent:<e,t>)))
into :- PP/NP : (lambda $0:e (lambda $1:e (in:<e,<e,t>> $1 $0)))
the :- NP/N : (lambda $0:<e,t> (the:<<e,t>,e> $0))
yellow :- N/N : (lambda $0:<e,t> (lambda $1:e (and:<t*,t> (yellow:<e,t> $1) ($0 $1))))
room | roam | backpack | all rooms :- N : room:<e,t>";

#[test]
fn unknown_words_are_heard_as_their_nearest_neighbours() {
    let model = model(LEXICON);
    for (said, wanted) in [
        ("yellw rooom", "yellow room"),
        ("yelolw yallow", "yellow yellow"),
        ("bakpakc backpakc bacpackk", "bakpakc backpack backpack"),
        // A known word stands; of two that are as near, the first of the alphabet is heard.
        ("room roam", "room roam"),
        ("rom roxm", "rom roam"),
        // Short words are too close to each other, and two edits are too many for all but long ones.
        ("teh og int", "teh og int"),
        ("yelwo brickpick", "yelwo brickpick"),
        // A noun is heard in the plural, but not within words that are known together.
        ("rooms backpacks", "room backpack"),
        ("all rooms two rooms", "all rooms two room"),
        ("", ""),
    ] {
        assert_eq!(Hearing::new(&model, &words(said)).words.join(" "), wanted, "{said}");
    }
}

#[test]
fn a_misspelt_command_means_what_the_right_one_does() {
    let mut model = model(LEXICON);
    let mut form = |command: &str| {
        let parse = parse(&mut model, command, ChartConfig::default());
        assert_eq!(parse.words, words(command), "the words are shown as they were written");
        let form = print(&model.grammar.terms, parse.answer().unwrap().form);
        (form, parse.skipped)
    };
    let (right, none) = form("go into the yellow room");
    assert!(none.is_empty());
    assert_eq!(form("go into the yelow room"), (right.clone(), Vec::new()));
    assert_eq!(form("go quikly into the yelow room"), (right, vec!["quikly".to_owned()]));
}
