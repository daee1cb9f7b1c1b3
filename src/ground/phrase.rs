//! Says, as data and in plain words, which phrases of a goal do not refer and why, and what a person calls an
//! entity.

use super::denote::{Denotation, Failure, meaning};
use super::goal::{GoalError, check};
use super::predicate::{Class, Meaning, Property, Relation};
use super::thing::{Entity, Thing};
use crate::domain::State;
use crate::logic::{Node, TermId, Terms, print};

/// The most entities that a sentence lists.
const MAX_LISTED: usize = 4;

/// A phrase that does not refer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Explanation {
    /// The phrase as an s-expression.
    pub phrase: String,
    /// Why it does not refer; the entities in question are in it.
    pub failure: Failure,
    /// The same for a person: "there is no yellow chair".
    pub sentence: String,
}

/// Explains every closed phrase of a goal that does not refer in the initial state, in the order of the goal.
/// Of a phrase inside another only the inner one is blamed.
///
/// # Errors
/// Why the term is no goal.
pub fn explain(
    terms: &Terms,
    goal: TermId,
    initial: &State,
) -> Result<Vec<Explanation>, GoalError> {
    check(terms, goal)?;
    let mut denotation = Denotation::new(terms, initial);
    let mut found: Vec<(TermId, Failure)> = Vec::new();
    visit(terms, goal, &mut denotation, &mut found);
    if denotation.exhausted() {
        return Err(GoalError::TooLarge);
    }
    let explain = |(phrase, failure): (TermId, Failure)| {
        let sentence = sentence(terms, phrase, &failure, &denotation.things);
        Explanation { phrase: print(terms, phrase), failure, sentence }
    };
    Ok(found.into_iter().map(explain).collect())
}

/// What a person calls an entity: "the red room", "the robot", "the blue chair at column 2, row 3" where its
/// look is not enough.
pub fn human(entity: &Entity, state: &State) -> String {
    name(entity, &Thing::all(state))
}

/// Whether some phrase at or below `term` failed; the innermost are put into `found`.
fn visit(
    terms: &Terms,
    term: TermId,
    denotation: &mut Denotation<'_>,
    found: &mut Vec<(TermId, Failure)>,
) -> bool {
    let mut failed = false;
    match terms.node(term) {
        Node::Constant(_) | Node::Variable(_) => {}
        Node::Lambda { body, .. } => failed = visit(terms, body, denotation, found),
        Node::Apply { args, .. } => {
            for &arg in args {
                failed |= visit(terms, arg, denotation, found);
            }
            let phrase = meaning(terms, term).is_some_and(|(meaning, _)| {
                matches!(meaning, Meaning::The | Meaning::Argmax | Meaning::Argmin)
            });
            if phrase
                && !failed
                && terms.free(term) == 0
                && let Err(failure) = denotation.referent(term, &mut Vec::new())
            {
                failed = true;
                if !found.iter().any(|(known, _)| *known == term) {
                    found.push((term, failure));
                }
            }
        }
    }
    failed
}

fn sentence(terms: &Terms, phrase: TermId, failure: &Failure, things: &[Thing<'_>]) -> String {
    let Some((meaning, &[property, ..])) = meaning(terms, phrase) else {
        return "a phrase does not refer".to_owned();
    };
    let noun = noun(terms, property);
    let most = if meaning == Meaning::Argmin { "smallest" } else { "biggest" };
    match failure {
        Failure::None => format!("there is no {noun}"),
        Failure::Several(which) => {
            let count = count(which.len());
            format!("there are {count} {}: {}", plural(&noun), list(which, things))
        }
        Failure::Tie(which) => {
            let (count, size) =
                (count(which.len()), if most == "biggest" { "big" } else { "small" });
            format!("{count} {} are equally {size}: {}", plural(&noun), list(which, things))
        }
        Failure::Single(_) => format!("there is only one {noun}, so none is the {most}"),
        Failure::Mixed => format!("there is no {most} {noun}: they cannot be compared in size"),
        Failure::Inner => format!("the {noun} hangs on a phrase that does not refer"),
    }
}

fn list(which: &[Entity], things: &[Thing<'_>]) -> String {
    let mut names: Vec<String> =
        which.iter().take(MAX_LISTED).map(|entity| name(entity, things)).collect();
    if which.len() > MAX_LISTED {
        names.push("…".to_owned());
    }
    names.join(", ")
}

fn name(entity: &Entity, things: &[Thing<'_>]) -> String {
    let look = |thing: &Thing<'_>| {
        let color = thing.color().map(|color| format!("{} ", color.name())).unwrap_or_default();
        match thing.class() {
            Class::Agent => "robot".to_owned(),
            Class::Room => format!("{color}room"),
            Class::Door => "door".to_owned(),
            Class::Object => {
                let shape = thing.shape().map_or("object", |shape| shape.name());
                format!("{color}{shape}")
            }
        }
    };
    let Some(thing) = things.iter().find(|thing| thing.is(entity)) else {
        return "something that is not there".to_owned();
    };
    let own = look(thing);
    let twins = things.iter().filter(|other| look(other) == own).count();
    match (twins > 1, thing.cell(), thing.bounds()) {
        (true, Some((x, y)), _) => format!("the {own} at column {x}, row {y}"),
        (true, _, Some(b)) if thing.class() == Class::Door => {
            format!("the {own} at column {}, row {}", b.left, b.bottom)
        }
        (true, _, Some(b)) => {
            format!(
                "the {own} of columns {} to {}, rows {} to {}",
                b.left, b.right, b.bottom, b.top
            )
        }
        _ => format!("the {own}"),
    }
}

/// A noun phrase without its article for a term of type `<e,t>`: "yellow chair in the red room".
fn noun(terms: &Terms, property: TermId) -> String {
    let Node::Lambda { body, .. } = terms.node(property) else { return "such thing".to_owned() };
    let conjuncts = match meaning(terms, body) {
        Some((Meaning::And, all)) => all,
        _ => std::slice::from_ref(&body),
    };
    let (mut colors, mut shapes, mut classes) = (Vec::new(), Vec::new(), Vec::new());
    let mut after = Vec::new();
    for &conjunct in conjuncts {
        match meaning(terms, conjunct) {
            Some((Meaning::Property(Property::Color(color)), _)) => colors.push(color.name()),
            Some((Meaning::Property(Property::Shape(shape)), _)) => shapes.push(shape.name()),
            Some((Meaning::Property(Property::Class(class)), _)) => classes.push(class),
            Some((Meaning::Relation(relation), &[a, b])) => {
                after.push(related(terms, relation, a, b))
            }
            _ => after.push(format!("with {}", crate::logic::print_human(terms, conjunct))),
        }
    }
    let class = classes.iter().map(|class| match class {
        Class::Agent => "robot",
        Class::Room => "room",
        Class::Door => "door",
        Class::Object => "object",
    });
    let nouns: Vec<&str> = if shapes.is_empty() { class.collect() } else { shapes };
    let noun = if nouns.is_empty() { "thing".to_owned() } else { nouns.join(" and ") };
    let before = colors.into_iter().map(str::to_owned);
    before.chain([noun]).chain(after).collect::<Vec<_>>().join(" ")
}

/// "in the red room", for a relation of the thing at hand (variable 0) to another.
fn related(terms: &Terms, relation: Relation, a: TermId, b: TermId) -> String {
    let own = |term| terms.node(term) == Node::Variable(0);
    let (words, other) = match (relation, own(a)) {
        (Relation::In, true) => ("in", b),
        (Relation::In, false) => ("around", a),
        (Relation::Near, true) => ("near", b),
        (Relation::Near, false) => ("near", a),
        (Relation::Left, true) | (Relation::Right, false) => {
            ("left of", if own(a) { b } else { a })
        }
        (Relation::Right, true) | (Relation::Left, false) => {
            ("right of", if own(a) { b } else { a })
        }
        (Relation::Eq, own) => ("that is", if own { b } else { a }),
    };
    format!("{words} {}", described(terms, other))
}

/// A noun phrase with its article for a term of type `e`.
fn described(terms: &Terms, term: TermId) -> String {
    match meaning(terms, term) {
        Some((Meaning::The, &[property])) => format!("the {}", noun(terms, property)),
        Some((Meaning::Argmax, &[property, _])) => format!("the biggest {}", noun(terms, property)),
        Some((Meaning::Argmin, &[property, _])) => {
            format!("the smallest {}", noun(terms, property))
        }
        _ => "it".to_owned(),
    }
}

fn count(n: usize) -> String {
    let words =
        ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"];
    words.get(n).map_or_else(|| n.to_string(), |word| (*word).to_owned())
}

/// The plural of a noun phrase: its head noun is the word before the first preposition.
fn plural(noun: &str) -> String {
    let prepositions = ["in", "around", "near", "left", "right", "that", "with"];
    let mut words: Vec<String> = noun.split(' ').map(str::to_owned).collect();
    let head = words.iter().skip(1).position(|word| prepositions.contains(&word.as_str()));
    let head = head.unwrap_or(words.len() - 1);
    if let Some(word) = words.get_mut(head) {
        word.push_str(if word.ends_with('x') { "es" } else { "s" });
    }
    words.join(" ")
}
