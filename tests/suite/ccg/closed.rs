//! Closed words: the list has a kind for each; no seed entry throws away what one of them takes, none is learned, and none
//! goes without meaning or is heard where nothing was said; what is heard otherwise is said.

use crate::commands::{asked, shipped};
use crate::learn::six;
use groundling::ccg::closed::{Kind, closed_words};
use groundling::ccg::{
    ChartConfig, EntryId, Hearing, Model, Origin, Trace, alternatives, any_closed, closed, parse,
    words,
};
use groundling::corpus::{Example, Pair};
use groundling::learn::genlex::{CoarseCharts, Domain, Scope, generate};
use groundling::learn::{CLEANUP_LEXICON, Config, DEMONSTRATION_LEXICON, Trainer, seed_model};
use groundling::logic::print_human;
use proptest::prelude::{ProptestConfig, prop};
use proptest::prop_assert;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use std::cell::RefCell;

const LIST: &str = include_str!("../../../assets/lexicon/closed.txt");

/// The list's lines: a kind and its phrases.
fn lines() -> impl Iterator<Item = (&'static str, Vec<String>)> {
    let lines = LIST.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
    lines.map(|line| {
        let (kind, phrases) = line.split_once(": ").expect("a kind and phrases");
        let phrases = alternatives(phrases).expect("brackets that fit");
        let words = phrases.iter().map(|phrase| phrase.split_whitespace().collect::<Vec<_>>());
        (kind, words.map(|words| words.join(" ")).collect())
    })
}

#[test]
fn every_line_of_the_list_has_a_kind_and_every_phrase_is_closed() {
    for (kind, phrases) in lines() {
        let wanted = match kind {
            "turns" => Kind::Turns,
            "joins" => Kind::Joins,
            "orders" => Kind::Orders,
            "limits" => Kind::Limits,
            "bars" => Kind::Bars,
            _ => panic!("{kind} is no kind"),
        };
        for phrase in phrases {
            // An ending stands for any word that ends so; what begins a sentence is tried at its beginning.
            let phrase = phrase.replace('-', "xx").replace('^', "");
            let own = words(&phrase);
            assert_eq!(own.join(" "), phrase, "a phrase is written as its words are");
            // A phrase may begin with one of another kind: the first of the list stands.
            let found = closed(&own);
            assert!(found.iter().all(Option::is_some), "{phrase}: {found:?}");
            let is_first = lines()
                .find(|(_, all)| all.iter().any(|one| one.trim_start_matches('^') == phrase))
                .is_none_or(|(name, _)| name == kind);
            let [found] = found[..] else { continue };
            assert!(!is_first || found == Some(wanted), "{phrase}: {found:?}");
        }
    }
    let kinds = |text: &str| closed(&words(text));
    assert_eq!(kinds("go to red room"), [None; 4]);
    assert_eq!(kinds("as well"), [None; 2], "a phrase is closed as a whole");
    assert_eq!(kinds("as well as"), [Some(Kind::Joins); 3]);
    assert_eq!(kinds("you mustn't"), [None, Some(Kind::Turns)]);
    assert_eq!(kinds("is it red"), [Some(Kind::Limits), None, None]);
    assert_eq!(kinds("it is red"), [None; 3], "what is asked begins so");
    assert!(closed_words().all(|word| any_closed(&[word])));
    assert_eq!(closed(&[] as &[&str]), []);
}

/// Whether a word of an entry is closed wherever it stands.
fn is_closed(own: &[String]) -> bool {
    let all: Vec<&str> = std::iter::once("x").chain(own.iter().map(String::as_str)).collect();
    any_closed(&all)
}

/// The words of an entry.
fn said(model: &Model, entry: EntryId) -> Vec<String> {
    let lexeme = model.lexicon.lexeme(model.lexicon.entry(entry).lexeme);
    lexeme.words.iter().map(|word| word.to_string()).collect()
}

#[test]
fn no_seed_entry_of_a_closed_word_throws_away_what_it_takes_or_means_nothing() {
    let mut seen = 0;
    for lexicon in [CLEANUP_LEXICON, DEMONSTRATION_LEXICON] {
        let model = seed_model(lexicon).unwrap();
        for &entry in model.lexicon.entries() {
            let own = said(&model, entry);
            if !is_closed(&own) {
                continue;
            }
            let category = model.lexicon.category(entry);
            let arity = model.grammar.syntaxes.arity(category.syntax);
            let text = category.print(&model.grammar.syntaxes, &model.grammar.terms);
            for at in 0..arity {
                assert!(!model.grammar.throws(category.meaning, at), "{}: {text}", own.join(" "));
            }
            assert!(!model.lexicon.is_empty_entry(entry), "{}: {text}", own.join(" "));
            seen += 1;
        }
    }
    assert!(seen > 1_000, "{seen} entries");
}

#[test]
fn no_learned_entry_speaks_for_a_closed_word() {
    let model = shipped();
    let learned = |&&entry: &&EntryId| model.lexicon.origin(entry) == Origin::Learned;
    let learned: Vec<Vec<String>> =
        model.lexicon.entries().iter().filter(learned).map(|&entry| said(&model, entry)).collect();
    assert!(learned.len() > 100, "{} were learned", learned.len());
    assert!(!learned.iter().any(|own| is_closed(own)));
}

#[test]
fn a_learned_entry_of_a_closed_word_is_not_used() {
    // A model file may have one, if another program made it.
    let mut model = seed_model(CLEANUP_LEXICON).unwrap();
    let text = model.print();
    let go = text.lines().find(|line| line.starts_with("entry\tenter\t")).unwrap();
    let learned = go.replace("entry\tenter\t", "entry\tavoid\t").replace("\tseed", "\tlearned");
    let end = format!("weight\t{}\t100\nend\n", learned.strip_suffix("\tlearned").unwrap());
    model = Model::read(&text.replace("\nend\n", &format!("\n{learned}\n{end}"))).unwrap();
    let parse = parse(&mut model, "avoid the red room", ChartConfig::default());
    assert!(!parse.readings.is_empty());
    for reading in &parse.readings {
        let form = print_human(&model.grammar.terms, reading.form);
        assert!(form.starts_with('¬'), "{form}");
    }
}

#[test]
fn generation_has_no_candidate_with_a_closed_word() {
    let mut model = seed_model(CLEANUP_LEXICON).unwrap();
    for command in [
        "leave the red room",
        "xyzzy leave the red room",
        "go plugh not to the red room",
        "avoid xyzzy and go to the blue plugh",
        "put the xyzzy in the red or blue room",
    ] {
        let words = words(command);
        let closed = closed(&words);
        for scope in [Scope::UnknownWords, Scope::AllWords] {
            let generated = generate(
                &mut model,
                &words,
                (scope, Domain::Runs),
                ChartConfig::default(),
                &mut CoarseCharts::default(),
            );
            for candidate in generated.candidates {
                let own = &closed[candidate.start..candidate.end];
                assert!(own.iter().all(Option::is_none), "{command}: {candidate:?}");
            }
            for (empty, closed) in generated.empty.iter().zip(&closed) {
                assert!(closed.is_none() || empty.is_none(), "{command}");
            }
        }
    }
}

/// Three rows that say "leave", shown by the pairs of going to the rooms: truly, the other way round, or not.
fn leaving(truly: bool) -> Vec<Example> {
    let rooms = six().into_iter().filter(|example| example.command.ends_with("room"));
    let row = |mut example: Example| {
        let color = ["blue", "red", "green"].into_iter();
        let color = color.clone().find(|color| example.command.contains(color))?;
        example.command = format!("leave the {color} room");
        if truly {
            let back = |Pair { pre, post, .. }| Pair::of(post, pre);
            example.pairs = example.pairs.into_iter().map(back).collect();
        }
        Some(example)
    };
    let mut rows: Vec<Example> = rooms.filter_map(row).collect();
    let again = rows.clone();
    rows.extend(again);
    rows.truncate(3);
    rows
}

#[test]
fn learning_turns_no_closed_word_round() {
    for truly in [true, false] {
        let examples = leaving(truly);
        assert_eq!(examples.len(), 3);
        let config = Config { epochs: 1, ..Config::default() };
        let seed = seed_model(CLEANUP_LEXICON).unwrap();
        let mut trainer = Trainer::new(seed, &examples, config);
        while !trainer.is_done() {
            trainer.step();
        }
        let mut model = trainer.averaged();
        for color in ["red", "yellow"] {
            let command = format!("leave the {color} room");
            let parse = parse(&mut model, &command, ChartConfig::default());
            let form = print_human(&model.grammar.terms, parse.answer().unwrap().form);
            let rooms = ["room(x) ∧ yellow(x)", "red(x) ∧ room(x)"];
            let room = rooms.iter().find(|room| room.contains(color)).unwrap();
            assert_eq!(form, format!("¬in(the agent, the λx. {room})"), "shown truly: {truly}");
        }
        assert!(model.lexicon.entries().iter().all(|&entry| {
            model.lexicon.origin(entry) == Origin::Seed || !any_closed(&said(&model, entry))
        }));
    }
}

/// Everything that one deletion, one swap of neighbours or one substitution makes of a word.
fn misspelt(word: &str) -> Vec<String> {
    let letters: Vec<char> = word.chars().collect();
    let mut found = Vec::new();
    for at in 0..letters.len() {
        let mut deleted = letters.clone();
        deleted.remove(at);
        let mut substituted = letters.clone();
        substituted[at] = 'q';
        found.extend([deleted, substituted]);
        if at + 1 < letters.len() {
            let mut swapped = letters.clone();
            swapped.swap(at, at + 1);
            found.push(swapped);
        }
    }
    found.into_iter().map(String::from_iter).collect()
}

#[test]
fn nothing_is_heard_as_a_word_that_means_nothing() {
    let model = shipped();
    let seed = seed_model(CLEANUP_LEXICON).unwrap();
    let mut heard = 0;
    for &entry in seed.lexicon.entries() {
        let own = said(&seed, entry);
        let [word] = &own[..] else { continue };
        for said in misspelt(word) {
            let [found] = &Hearing::new(&model, std::slice::from_ref(&said)).words[..] else {
                panic!("{said} is one word");
            };
            let is_said = *found == said;
            assert!(
                is_said || model.lexicon.has_meaning(found) || any_closed(&[found]),
                "{said}: {found}"
            );
            heard += usize::from(!is_said);
        }
    }
    assert!(heard > 500, "{heard} were heard otherwise");
    for word in ["pink", "black", "four", "don't", "dont", "cant", "read", "past", "over"] {
        let own = [word.to_owned()];
        assert_eq!(Hearing::new(&model, &own).words, own, "it is a word of its own");
    }
}

#[test]
fn closed_words_are_heard_through_their_misspelling() {
    let model = shipped();
    for (said, wanted) in [
        ("aviod the red room", "avoid the red room"),
        ("go to any room exept the red one", "go to any room except the red one"),
        ("nevr go there", "never go there"),
        ("go wihtout it", "go without it"),
        // Nothing turns round unheard, however short: what is skipped would say the opposite.
        ("do nto go there", "do not go there"),
        ("dnt go, pls dotn", "dont go pls dont"),
        ("otu of it, nott in it", "out of it not in it"),
        ("the bot and the grid", "the bot and the grid"),
    ] {
        assert_eq!(Hearing::new(&model, &words(said)).words.join(" "), wanted);
    }
}

#[test]
fn what_is_heard_otherwise_is_said() {
    let mut model = shipped();
    for (command, wanted) in [
        ("go to the red room", vec![]),
        ("go to the gren room", vec![((3, 4), "green")]),
        (
            "shove the settee into the violet rooom",
            vec![((2, 3), "chair"), ((5, 6), "violet"), ((6, 7), "room")],
        ),
        ("go to the dark green room", vec![((3, 5), "darkgreen")]),
        ("aviod the red room", vec![((0, 1), "avoid")]),
    ] {
        let parse = asked(&mut model, command);
        let heard: Vec<_> = parse.heard.iter().map(|(place, name)| (*place, &**name)).collect();
        assert_eq!(heard, wanted, "{command}");
    }
}

#[test]
fn the_pieces_of_a_meaning_come_from_the_words_that_were_taken_for_others() {
    let mut model = shipped();
    let parse = asked(&mut model, "shove the settee into the dark violet room");
    let derivation = parse.derivation(parse.answer().unwrap());
    let trace = Trace::of(&model, &derivation).unwrap();
    let root = trace.nodes.last().unwrap();
    let pieces = trace.pieces(root, &mut model.grammar.terms);
    let from =
        |wanted: &str| pieces.iter().find(|(text, _)| text == wanted).and_then(|(_, words)| *words);
    assert_eq!(from("chair"), Some((2, 3)), "{pieces:?}");
    assert_eq!(from("darkviolet"), Some((5, 7)), "{pieces:?}");
    assert_eq!(from("room"), Some((7, 8)), "{pieces:?}");
}

/// Words that turn, order and join, and what stands around them.
const ANY: [&str; 40] = [
    "go", "push", "pushing", "take", "put", "stay", "keep", "leave", "bring", "is", "should",
    "the", "a", "red", "blue", "biggest", "room", "block", "bag", "it", "there", "one", "other",
    "to", "into", "in", "of", "out", "away", "from", "with", "not", "don't", "without", "and",
    "or", "then", "while", "until", "when",
];

#[test]
fn any_words_have_an_answer_or_a_reason() {
    let model = RefCell::new(shipped());
    let sentence = prop::collection::vec(prop::sample::select(ANY.to_vec()), 1..13);
    let mut runner = TestRunner::new_with_rng(
        ProptestConfig { failure_persistence: None, cases: 1_500, ..ProptestConfig::default() },
        TestRng::deterministic_rng(RngAlgorithm::ChaCha),
    );
    runner
        .run(&sentence, |said| {
            let command = said.join(" ");
            let parse = asked(&mut model.borrow_mut(), &command);
            prop_assert!(parse.answer().is_some() || parse.reason.is_some(), "{}", command);
            Ok(())
        })
        .unwrap();
}
