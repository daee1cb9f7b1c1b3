//! Shades: every name of the table by the colours that it is taken for, `tests/data/ground/shades.txt`; what the
//! answer says of them.

use groundling::domain::Color;
use groundling::ground::predicate::predicate;
use groundling::ground::{Failure, Meaning, Measure, ONTOLOGY, Shade, phrases};
use groundling::logic::{Signature, Terms, Types, read};

use super::{holds, world};

/// The only red room, as the one most like a shade.
const ONLY: &str = "(argmax:<<e,t>,<<e,n>,e>> (lambda $0:e (and:<t*,t> (red:<e,t> $0) (room:<e,t> $0))) firebrick:<e,n>)";

const CASES: &str = include_str!("../../data/ground/shades.txt");

#[test]
fn shades_are_taken_for_the_colours_that_people_would_take_them_for() {
    for line in CASES.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let (name, wanted) = line.split_once(" => ").unwrap();
        let shade = Shade::named(name).unwrap_or_else(|| panic!("no shade {name}"));
        let found: Vec<&str> = shade.colors().map(|(color, _)| color.name()).collect();
        let wanted: Vec<&str> = wanted.split(' ').collect();
        assert!(found.starts_with(&wanted), "{name}: {found:?}");
    }
}

#[test]
fn the_table_is_in_order_and_ranks_without_ties() {
    let names: Vec<&str> = Shade::all().map(Shade::name).collect();
    assert!(names.len() > 100 && names.is_sorted_by(|a, b| a < b), "{names:?}");
    for shade in Shade::all() {
        let name = shade.name();
        assert!(name.bytes().all(|b| b.is_ascii_lowercase()), "{name}");
        assert!(name.parse::<Color>().is_err(), "{name} is a colour itself");
        assert_eq!(predicate(name).unwrap().meaning, Meaning::Measure(Measure::Shade(shade)));
        let likeness: Vec<i64> = shade.colors().map(|(_, likeness)| likeness).collect();
        assert!(!likeness.is_empty() && likeness.iter().all(|n| (1..=1000).contains(n)), "{name}");
        assert!(likeness.is_sorted_by(|a, b| a >= b), "{name}: best first");
        assert!(likeness.get(1) != likeness.first(), "{name}: one is best");
        let text = serde_json::to_string(&shade).unwrap();
        assert_eq!(serde_json::from_str::<Shade>(&text).unwrap(), shade);
    }
    assert!(serde_json::from_str::<Shade>("\"plaid\"").is_err());
}

#[test]
fn the_ontology_admits_shades_as_measures_and_as_nothing_else() {
    let ontology = Signature::read(ONTOLOGY).unwrap();
    let mut types = Types::default();
    let [measure, property] = ["<e,n>", "<e,t>"].map(|ty| types.read(ty));
    assert_eq!(ontology.ty(&mut types, "violet"), measure);
    assert_eq!(ontology.ty(&mut types, "red"), property);
    assert!(ontology.iter().all(|(name, _)| name != "*" && name != "violet"));
}

#[test]
fn an_answer_says_which_colour_a_shade_was_taken_for() {
    let mut terms = Terms::new();
    let state = world(|_| {});
    for (phrase, wanted) in [
        ("(argmax:<<e,t>,<<e,n>,e>> room:<e,t> violet:<e,n>)", Some(("violet", Color::Blue))),
        ("(argmax:<<e,t>,<<e,n>,e>> room:<e,t> firebrick:<e,n>)", Some(("firebrick", Color::Red))),
        ("(argmax:<<e,t>,<<e,n>,e>> room:<e,t> lime:<e,n>)", None),
        // A single thing is the most like a shade if it is like it at all.
        (ONLY, Some(("firebrick", Color::Red))),
        ("(argmin:<<e,t>,<<e,n>,e>> room:<e,t> violet:<e,n>)", None),
        ("(argmax:<<e,t>,<<e,n>,e>> chair:<e,t> size:<e,n>)", None),
    ] {
        let goal = format!("(red:<e,t> {phrase})");
        holds(&mut terms, &goal, &state, &state);
        let term = read(&mut terms, &goal).unwrap();
        let found = phrases(&terms, term, &state).unwrap();
        let taken = found.last().unwrap().taken.map(|(shade, color)| (shade.name(), color));
        assert_eq!(taken, wanted, "{phrase}");
        let is_lost = found.last().unwrap().referent == Err(Failure::None);
        assert_eq!(is_lost, phrase.contains("lime"), "{phrase}: nothing is like it");
    }
}
