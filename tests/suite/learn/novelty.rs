//! What words may newly come to mean: those of the seed keep their kind, nouns stretch within their sort, and open
//! templates take what their holes ask for.

use groundling::ccg::{Atom, ChartConfig, Model, Origin, lexicon_text::read_lexicon, words};
use groundling::learn::genlex::{CoarseCharts, Domain, Generated, Scope, generate};
use groundling::learn::novelty::{Novelty, novelty};
use groundling::learn::{CLEANUP_LEXICON, seed_model};
use groundling::logic::ConstantId;

fn cleanup() -> Model {
    seed_model(CLEANUP_LEXICON).unwrap()
}

fn property(model: &mut Model, name: &str) -> ConstantId {
    let terms = &mut model.grammar.terms;
    let ty = terms.types.read("<e,t>").unwrap();
    terms.constant(name, ty)
}

#[test]
fn what_the_seed_says_of_words_stands() {
    let mut model = cleanup();
    let nouns = |model: &mut Model, names: &[&str]| {
        Novelty::Like(names.iter().map(|name| property(model, name)).collect())
    };
    for (span, like) in
        [("chair", &["chair"][..]), ("block", &["block", "object"]), ("room", &["room"])]
    {
        let wanted = nouns(&mut model, like);
        assert_eq!(novelty(&model, &words(span)), wanted, "{span}");
    }
    for (span, wanted) in [
        ("xyzzy", Novelty::Any),
        ("please", Novelty::Relation),
        ("side please", Novelty::Relation),
        ("please xyzzy", Novelty::Any),
        ("the", Novelty::Silence),
        ("move", Novelty::Silence),
        ("go xyzzy", Novelty::Silence),
        ("red", Novelty::None),
        ("inside", Novelty::None),
        ("red chair", Novelty::None),
        ("chair xyzzy", Novelty::None),
    ] {
        assert_eq!(novelty(&model, &words(span)), wanted, "{span}");
    }
}

#[test]
fn a_noun_stretches_within_its_sort() {
    let mut model = cleanup();
    let chair = novelty(&model, &words("chair"));
    for (name, may) in [
        ("chair", true),
        ("box", true),
        ("object", true),
        ("room", false),
        ("agent", false),
        ("red", false),
    ] {
        let constant = property(&mut model, name);
        assert_eq!(chair.admits(&model, &[constant]), may, "a chair that is {name}");
        assert!(Novelty::Any.admits(&model, &[constant]));
        assert!(!Novelty::Silence.admits(&model, &[constant]));
        assert!(!Novelty::None.admits(&model, &[constant]));
    }
    let [n, s] = [Atom::N, Atom::S].map(|atom| model.grammar.syntaxes.atom(atom));
    assert!(chair.admits_syntax(&model, n) && !chair.admits_syntax(&model, s));
    assert!(Novelty::Any.admits_syntax(&model, s) && !Novelty::None.admits_syntax(&model, n));
    assert!(!Novelty::Silence.admits_syntax(&model, n) && !Novelty::Silence.admits(&model, &[]));
    assert!(Novelty::Any.admits_silence() && Novelty::Silence.admits_silence());
    assert!(!chair.admits_silence() && !Novelty::None.admits_silence());
    let of = model.grammar.syntaxes.read("PP/NP").unwrap();
    let relation = Novelty::Relation;
    assert!(relation.admits_syntax(&model, of) && !relation.admits_syntax(&model, n));
    assert!(relation.admits(&model, &[]) && relation.admits_silence());
}

#[test]
fn a_shade_is_one_of_the_colours_that_it_is_like() {
    let mut model = cleanup();
    for (span, like, other) in [("pink", "red", "blue"), ("the purple", "blue", "red")] {
        let shade = novelty(&model, &words(span));
        let [like, other] = [like, other].map(|name| property(&mut model, name));
        assert!(shade.admits(&model, &[like]) && !shade.admits(&model, &[other]), "{span}");
        assert!(!shade.admits_silence() && !shade.admits(&model, &[]), "{span}");
    }
    assert_eq!(novelty(&model, &words("orange")), Novelty::None, "the seed knows it");
}

fn generated(model: &mut Model, command: &str, scope: Scope) -> Generated {
    generate(
        model,
        &words(command),
        (scope, Domain::States),
        ChartConfig { beam: 75, ..ChartConfig::default() },
        &mut CoarseCharts::default(),
    )
}

/// The candidates: words, category, and the names of the constants.
fn candidates(model: &Model, generated: &Generated) -> Vec<(String, String, Vec<String>)> {
    let text = |id| {
        let entry = model.lexicon.entry(id);
        let lexeme = model.lexicon.lexeme(entry.lexeme);
        let names = lexeme.constants.iter().map(|&c| model.grammar.terms.name(c).to_owned());
        let syntax = model.grammar.syntaxes.text(model.lexicon.template(entry.template).syntax);
        (lexeme.words.join(" "), syntax.to_owned(), names.collect())
    };
    generated.candidates.iter().map(|candidate| text(candidate.entry)).collect()
}

#[test]
fn holes_take_nouns_or_adjectives_and_nothing_of_the_frame() {
    let mut model = cleanup();
    let found = generated(&mut model, "go to the xyzzy room", Scope::UnknownWords);
    let found = candidates(&model, &found);
    assert!(found.iter().all(|(words, ..)| words.contains("xyzzy")), "known words stay");
    assert!(found.iter().any(|(words, syntax, constants)| {
        words == "xyzzy" && syntax == "N/N" && constants == &["blue"]
    }));
    for (words, syntax, constants) in &found {
        for constant in constants {
            let is_noun = model.grammar.sorts.is_noun(constant);
            assert_ne!(constant, "agent", "{words}: the frame's");
            assert!(syntax != "N/N" || !is_noun, "{words} is no adjective by {constant}");
            assert!(syntax != "N" || constants.len() > 1 || is_noun, "{words} by {constant}");
        }
    }
}

#[test]
fn seed_words_get_no_candidates_but_nouns_of_their_sort() {
    let mut model = cleanup();
    let found = generated(&mut model, "go to the red chair", Scope::AllWords);
    let found = candidates(&model, &found);
    assert!(found.iter().any(|(words, ..)| words == "chair"));
    for (words, syntax, constants) in found {
        assert!(!words.contains("red"), "{words} :- {syntax} by {constants:?}");
        if words.contains("chair") {
            assert_eq!((&*words, &*syntax), ("chair", "N"), "{constants:?}");
            let sorts = |name: &str| model.grammar.sorts.of(name).map(<[_]>::to_vec);
            assert!(constants.iter().all(|name| sorts(name) == sorts("chair")), "{constants:?}");
        }
    }
}

#[test]
fn only_a_word_that_nothing_settles_may_turn_out_empty() {
    let mut model = cleanup();
    let found = generated(&mut model, "xyzzy go to the red chair", Scope::UnknownWords);
    let [Some(xyzzy), _, _, Some(the), None, None] = found.empty[..] else {
        panic!("{:?}", found.empty)
    };
    assert_eq!(model.lexicon.origin(xyzzy), Origin::Candidate, "nothing is believed yet");
    assert_eq!(model.lexicon.origin(the), Origin::Seed);
    // A lexicon that does not open the template has no such candidates.
    let mut closed = seed_model("the :- NP/N : the:<<e,t>,e>").unwrap();
    read_lexicon(&mut closed, "* :- N : ?:<e,t>").unwrap();
    let found = generated(&mut closed, "xyzzy the chair", Scope::UnknownWords);
    assert_eq!(found.empty, [None; 3]);
}
