//! The general resource: what it takes words for, `tests/data/ccg/general.txt`, and which are real ones,
//! `tests/data/ccg/real.txt`; that it touches no closed word; and the entries it makes.

use super::{model, model_over};
use crate::logic::cases;
use groundling::ccg::{EntryId, Feature, General, Hearing, Model, Near, Target, words};
use groundling::ground::{ONTOLOGY, Shade};
use groundling::learn::seed_model;
use groundling::logic::print;
use std::collections::BTreeSet;
use std::sync::Arc;

const WORDS: &str = include_str!("../../../assets/lexicon/words.txt");
const SEED: &str = include_str!("../../../assets/lexicon/cleanup.txt");
const CLOSED_WORDS: &str = include_str!("../../../assets/lexicon/closed.txt");

/// Words that turn round, exclude, join or order, or take a thing or the robot away from where it is.
const CLOSED: [&str; 62] = [
    "not",
    "n't",
    "cannot",
    "never",
    "no",
    "none",
    "neither",
    "nor",
    "without",
    "except",
    "but",
    "other",
    "non",
    "instead",
    "unless",
    "stop",
    "refrain",
    "forbidden",
    "out",
    "away",
    "off",
    "avoid",
    "leave",
    "vacate",
    "depart",
    "remove",
    "keep",
    "stay",
    "longer",
    "then",
    "first",
    "afterwards",
    "after",
    "before",
    "until",
    "while",
    "through",
    "via",
    "pass",
    "or",
    "either",
    "both",
    "well",
    "only",
    "and",
    "exit",
    "abandon",
    "flee",
    "escape",
    "withdraw",
    "retreat",
    "back",
    "from",
    "leaving",
    "leaves",
    "exits",
    "avoiding",
    "removing",
    "stopping",
    "passing",
    "quit",
    "evacuate",
];

fn general() -> General {
    General::read(WORDS).unwrap()
}

/// The entries of words that stand for something together, with what each scores.
fn understood(model: &mut Model, said: &str) -> Vec<(EntryId, f64)> {
    let words = words(said);
    let items = Hearing::new(model, &words).items(model).into_iter();
    let whole = items.filter(|item| (item.start, item.end) == (0, words.len()));
    whole.map(|item| (EntryId::from_item(item.item), item.score)).collect()
}

fn target(near: &Near) -> &str {
    match &near.target {
        Target::Word(text) | Target::Measure(text) => text,
    }
}

#[test]
fn words_stand_for_what_people_mean_by_them() {
    let general = general();
    cases(include_str!("../../data/ccg/general.txt"), 100, |line, input, expected| {
        let found: Vec<&str> = general.near(input).iter().map(target).collect();
        let wanted = if expected == "-" { "" } else { expected };
        assert_eq!(found.join(" "), wanted, "line {line}: {input}");
    });
}

#[test]
fn real_words_are_their_own_and_misspellings_are_none() {
    let general = general();
    cases(include_str!("../../data/ccg/real.txt"), 40, |line, word, expected| {
        let found = match (general.is_word(word), general.near(word)) {
            (false, _) => "-",
            (true, []) => "own",
            (true, _) => "near",
        };
        assert_eq!(found, expected, "line {line}: {word}");
    });
}

#[test]
fn a_word_of_its_own_is_near_to_one_of_the_seed_lexicon_and_none_of_them() {
    let general = general();
    let seed = SEED.lines().filter_map(|line| line.split(" :- ").next());
    let lines = seed.chain(CLOSED_WORDS.lines()).filter(|line| !line.starts_with('#'));
    let known: BTreeSet<&str> =
        lines.flat_map(|line| line.split([' ', '|', '(', ')', '^'])).collect();
    let own = |line: &&str| !line.contains([' ', '\t', '#']);
    for word in WORDS.lines().filter(own) {
        assert!(general.is_word(word) && general.near(word).is_empty(), "{word}");
        assert!(!known.contains(word), "{word}: the seed has it");
        let bound = if word.len() < 8 { 1 } else { 2 };
        let is_near = |other: &&str| strsim::damerau_levenshtein(word, other) <= bound;
        assert!(word.len() >= 4 && known.iter().any(is_near), "{word}");
    }
}

#[test]
fn every_line_leads_from_a_word_that_the_seed_gives_no_meaning_to_one_that_it_does() {
    let (general, model) = (general(), seed_model(SEED).unwrap());
    let shades: BTreeSet<String> =
        Shade::all().map(|shade| format!("{}:<e,n>", shade.name())).collect();
    let means = |entries: &[EntryId]| entries.iter().any(|&e| !model.lexicon.is_empty_entry(e));
    let mut named = BTreeSet::new();
    for line in WORDS.lines().filter(|line| line.contains('\t')) {
        let words = line.split('\t').next().unwrap();
        let parts: Vec<Box<str>> = words.split(' ').map(Box::from).collect();
        assert!(parts.iter().all(|part| !CLOSED.contains(&&**part)), "{line}");
        assert!(parts.len() <= general.longest());
        assert!(!means(model.lexicon.entries_for(&parts)), "{line}: the seed has it");
        let near = general.near(words);
        assert!(near.is_sorted_by_key(|near| near.price) && near.len() <= 4, "{line}");
        for near in near {
            match &near.target {
                Target::Word(word) => {
                    assert!(means(model.lexicon.entries_for_word(word)), "{line}: {word}");
                    assert!(!CLOSED.contains(&&**word), "{line}");
                }
                Target::Measure(constant) => {
                    assert!(shades.contains(&**constant), "{line}: {constant}");
                    named.insert(constant.to_string());
                }
            }
        }
    }
    assert_eq!(named, shades, "every shade has its name");
}

#[test]
fn entries_are_those_of_the_target_at_a_price() {
    let mut model = model_over(ONTOLOGY, "chair | box :- N : chair:<e,t>\nbox :- EMPTY : true:t");
    let general = General::read("stool\tchair\nhamper\tbox=3 basket\nchair\tbox\n").unwrap();
    model.attach(Arc::new(general));
    let [chair, box_] = ["chair", "box"].map(|word| model.lexicon.entries_for_word(word)[0]);
    let (whole, step) = (model.entry_score(chair), model.value(&[Feature::Far]));
    assert!(step < 0.0, "a step away costs");
    assert_eq!(understood(&mut model, "stool"), [(chair, whole + step)]);
    // The entry by which a target may mean nothing is none; a target that the lexicon lacks gives nothing.
    assert_eq!(understood(&mut model, "hamper"), [(box_, whole + step + step + step)]);
    assert_eq!(understood(&mut model, "chair"), [(chair, whole)], "what the lexicon knows stands");
}

#[test]
fn a_measure_is_put_into_the_frames_and_stays_out_of_the_lexicon() {
    let mut model = seed_model(SEED).unwrap();
    model.attach(Arc::new(general()));
    let (before, known) = (model.print(), model.lexicon.len());
    let found = understood(&mut model, "navy blue");
    let texts: Vec<String> = found
        .iter()
        .map(|&(entry, score)| {
            let category = model.lexicon.category(entry);
            let syntax = model.grammar.syntaxes.text(category.syntax);
            format!("{syntax} {} {score}", print(&model.grammar.terms, category.meaning))
        })
        .collect();
    let measure = "(lambda $0:<e,t> (argmax:<<e,t>,<<e,n>,e>> (lambda $1:e ($0 $1)) (lambda $1:e (navy:<e,n> $1))))";
    let score = model.value(&[Feature::Measure, Feature::Far]);
    assert_eq!(texts[..2], [format!("NP/N {measure} {score}"), format!("NP\\N {measure} {score}")]);
    assert!(texts[2].starts_with("N/N ") && texts[2].contains("(blue:<e,t> $1)"), "{texts:?}");
    assert_eq!(model.lexicon.len(), known);
    assert!(!model.lexicon.knows("navy"));
    assert_eq!(model.print(), before);
}

#[test]
fn a_resource_that_cannot_be_read_says_where() {
    for (text, line, reason) in [
        ("stool chair", 1, "between words and targets is a tab"),
        ("# words\nstool\tchair\nstool\tbox", 3, "these words have a line already"),
        ("bread\nstool\nbread", 3, "these words have a line already"),
        ("stool\tchair=0", 1, "a price is a number from 1"),
        ("stool\tchair=x", 1, "a price is a number from 1"),
        ("stool\t=2", 1, "a target is a word, or name:<e,n>"),
        ("violet\tviolet:<e,t>", 1, "a measure has type <e,n>"),
        ("* :- N", 1, "between category and meaning stands a colon"),
        ("* :- Q : ?:<e,n>", 1, "a frame has a syntactic category"),
        ("* :- N : (", 1, "a frame's meaning is a term"),
        ("* :- N : room:<e,t>", 1, "a frame has a hole ?:<e,n>"),
    ] {
        let error = General::read(text).unwrap_err();
        assert_eq!((error.line, error.reason), (line, reason), "{text}");
    }
    assert_eq!(General::read("").unwrap(), General::default());
    assert_eq!(model("").lexicon.len(), 0);
}
