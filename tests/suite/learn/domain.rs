//! The lexicon of the whole domain: with thirty commands as its only training, commands of every kind that it
//! has never seen are put together from what their words mean; and what it says of words can be read back.

use super::{six, train_from};
use crate::ccg::model_over;
use crate::logic::cases;
use groundling::ccg::{ChartConfig, Model, parse};
use groundling::corpus::{Example, Options, read};
use groundling::ground::ONTOLOGY;
use groundling::learn::{CLEANUP_LEXICON, Config, seed_model};
use groundling::logic::print_human;

/// The project's six commands and twenty-four of the crowd's.
fn thirty() -> Vec<Example> {
    let crowd = include_bytes!("../../data/corpus/crowd-learn.csv");
    let (crowd, flaws) = read(&crowd[..], Options::default());
    assert!(flaws.is_empty(), "{flaws:?}");
    six().into_iter().chain(crowd.examples).collect()
}

#[test]
fn words_of_the_whole_domain_compose() {
    let seed = seed_model(CLEANUP_LEXICON).unwrap();
    let examples = thirty();
    let (mut model, last) = train_from(seed, &examples, &Config { epochs: 8, ..Config::default() });
    assert_eq!(last.unwrap().so_far.valid, examples.len());
    let config = ChartConfig::of(&model);
    let mut wrong = Vec::new();
    cases(include_str!("../../data/ccg/commands.txt"), 33, |line, command, expected| {
        let (place, wanted) = expected.split_once(' ').unwrap();
        let parse = parse(&mut model, command, config);
        let terms = &model.grammar.terms;
        let mut forms = parse.readings.iter().map(|reading| print_human(terms, reading.form));
        let found = forms.position(|form| form == wanted).map(|at| at + 1);
        if found.is_none_or(|found| found > place.parse().unwrap()) {
            let answer = parse.readings.first().map(|r| print_human(terms, r.form));
            wrong.push(format!("line {line}: {command}: {found:?}, before it {answer:?}"));
        }
    });
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_entry_of_the_domain_s_lexicon_fits_its_sorts_and_reads_back() {
    let mut model: Model = seed_model(CLEANUP_LEXICON).unwrap();
    for &id in &model.lexicon.entries().to_vec() {
        let category = model.lexicon.category(id);
        let lexeme = model.lexicon.lexeme(model.lexicon.entry(id).lexeme);
        let words = lexeme.words.join(" ");
        let text = category.print(&model.grammar.syntaxes, &model.grammar.terms);
        assert!(model.grammar.fits(category.meaning), "{words}: {text} could never be used");
        let (syntax, meaning) = text.split_once(" : ").unwrap();
        let line = format!("{words} :- {syntax} : {meaning}");
        let again = model_over(ONTOLOGY, &format!("frame agent:<e,t>\nframe eq:<e,<e,t>>\n{line}"));
        let [entry] = again.lexicon.entries()[..] else { panic!("{line}") };
        let category = again.lexicon.category(entry);
        assert_eq!(category.print(&again.grammar.syntaxes, &again.grammar.terms), text, "{words}");
    }
}
