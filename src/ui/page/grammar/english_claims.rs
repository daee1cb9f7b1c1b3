//! English claims: what is to be so, and the things that it is about, in plain words.

use super::claims::{Words, denied, held, joined, related};
use crate::domain::Color;
use crate::worker::protocol::{Article, Claim, Description, Noun};

const WORDS: Words = Words { noun, place, claim, is: "is" };

/// "the robot is in the blue room"
pub(super) fn claim(told: &Claim) -> String {
    match told {
        Claim::All(all) => joined(&WORDS, all, "and", "are"),
        Claim::Any(any) => joined(&WORDS, any, "or", "is"),
        Claim::Not(inner) => match &**inner {
            Claim::Exists(description) => counted("no", description),
            Claim::Related { nouns, .. } => format!("{} is {}", noun(&nouns[0]), place(told)),
            Claim::Is(property, thing) => {
                format!("{} is not {}", noun(thing), property_words(property))
            }
            other => format!("it is not so that {}", claim(other)),
        },
        Claim::Related { nouns, .. } => format!("{} is {}", noun(&nouns[0]), place(told)),
        Claim::Is(property, thing) => format!("{} is {}", noun(thing), property_words(property)),
        Claim::Exists(description) => counted("a", description),
        Claim::Then(all) => all.iter().map(claim).collect::<Vec<_>>().join(", then "),
        Claim::Never(inner) => match related(inner) {
            Some((_, nouns)) => format!("{} is never {}", noun(&nouns[0]), place(inner)),
            None => format!("at no time {}", claim(inner)),
        },
        Claim::Until(both) => format!("{}, and until then {}", claim(&both[1]), claim(&both[0])),
        Claim::Formula(formula) => format!("this holds: {formula}"),
    }
}

/// "I stay out of the blue room", where a claim keeps the robot from something.
pub(super) fn keeps(told: &Claim) -> Option<String> {
    let (relation, nouns) = denied(told).filter(|(_, nouns)| nouns[0] == Noun::Robot)?;
    match relation {
        "in" => Some(format!("I stay out of {}.", noun(&nouns[1]))),
        "near" => Some(format!("I stay away from {}.", noun(&nouns[1]))),
        _ => None,
    }
}

/// "the biggest room"
pub(super) fn noun(told: &Noun) -> String {
    match told {
        Noun::Robot => "the robot".to_owned(),
        Noun::It | Noun::Outer => "it".to_owned(),
        Noun::Described(description) => described(description),
        Noun::Formula(formula) => formula.clone(),
    }
}

/// "in the blue room", "outside the red room": where a claim has its first thing.
fn place(told: &Claim) -> String {
    match (related(told), denied(told)) {
        (Some((relation, nouns)), _) => {
            format!("{} {}", relation_words(relation), noun(&nouns[1]))
        }
        (_, Some(("in", nouns))) => format!("outside {}", noun(&nouns[1])),
        (_, Some((relation, nouns))) => {
            format!("not {} {}", relation_words(relation), noun(&nouns[1]))
        }
        _ => claim(told),
    }
}

/// That there is such a thing, or none: "no chair is in the red room".
fn counted(article: &str, description: &Description) -> String {
    let head = head(description);
    let a = with_article(article, &head);
    match &description.claims[..] {
        [told] => match (related(told), denied(told)) {
            (Some((relation, [Noun::It, other])), _) => {
                format!("{a} is {} {}", relation_words(relation), noun(other))
            }
            (Some((relation, [other, Noun::It])), _) => {
                format!("{} is {} {a}", noun(other), relation_words(relation))
            }
            (_, Some((relation, [Noun::It, other]))) if article == "no" => {
                format!("every {head} is {} {}", relation_words(relation), noun(other))
            }
            (_, Some((relation, [other, Noun::It]))) if article == "no" => {
                format!("{} is {} every {head}", noun(other), relation_words(relation))
            }
            _ => format!("there is {a} {}", relative(told)),
        },
        claims => format!("there is {a}{}", after(claims)),
    }
}

fn described(description: &Description) -> String {
    let article = if description.article == Article::A { "a" } else { "the" };
    with_article(article, &head(description)) + &after(&description.claims)
}

fn with_article(article: &str, head: &str) -> String {
    let vowel = article == "a" && head.starts_with(['a', 'e', 'i', 'o', 'u']);
    format!("{article}{} {head}", if vowel { "n" } else { "" })
}

/// "biggest red room"
fn head(description: &Description) -> String {
    let Description { article, properties, .. } = description;
    let (mut words, mut nouns): (Vec<&str>, Vec<&str>) =
        properties.iter().map(String::as_str).partition(|p| p.parse::<Color>().is_ok());
    if nouns.is_empty() {
        nouns.push("thing");
    }
    match article {
        Article::Biggest => words.insert(0, "biggest"),
        Article::Smallest => words.insert(0, "smallest"),
        Article::Closest(shade) => words.insert(0, shade.name()),
        Article::A | Article::The => {}
    }
    let noun = nouns.into_iter().map(property_words).collect::<Vec<_>>().join(" and ");
    words.push(&noun);
    words.join(" ")
}

/// What is said of a thing behind its noun.
fn after(claims: &[Claim]) -> String {
    let all: Vec<String> = claims.iter().map(relative).collect();
    if all.is_empty() { String::new() } else { format!(" {}", all.join(" and ")) }
}

/// A claim about the thing at hand, behind its noun: "that is in the red room".
fn relative(told: &Claim) -> String {
    if let Claim::Is(property, thing) = told
        && **thing == Noun::It
    {
        return format!("that is {}", property_words(property));
    }
    if let Some(inside) = held(told) {
        return format!("with {} in it", with_article("a", &head(inside)));
    }
    if let Claim::Not(inner) = told {
        match &**inner {
            Claim::Is(property, thing) if **thing == Noun::It => {
                return format!("that is not {}", property_words(property));
            }
            inner => {
                if let Some(inside) = held(inner) {
                    return format!("without {} in it", with_article("a", &head(inside)));
                }
            }
        }
    }
    match (related(told), denied(told)) {
        (Some((relation, [Noun::It, other])), _) => {
            format!("that is {} {}", relation_words(relation), noun(other))
        }
        (Some(("in", [Noun::Robot, Noun::It])), _) => "where the robot is now".to_owned(),
        (Some(("in", [other, Noun::It])), _) => format!("that has {} in it", noun(other)),
        (Some(("left", [other, Noun::It])), _) => format!("that is right of {}", noun(other)),
        (Some(("right", [other, Noun::It])), _) => format!("that is left of {}", noun(other)),
        (Some((relation, [other, Noun::It])), _) => {
            format!("that is {} {}", relation_words(relation), noun(other))
        }
        (_, Some(("eq", [Noun::It, other] | [other, Noun::It]))) => {
            format!("other than {}", noun(other))
        }
        (_, Some((relation, [Noun::It, other]))) => {
            format!("that is not {} {}", relation_words(relation), noun(other))
        }
        (_, Some(("in", [other, Noun::It]))) => format!("without {} in it", noun(other)),
        _ => format!("for which {}", claim(told)),
    }
}

pub(super) fn relation_words(relation: &str) -> &str {
    match relation {
        "near" => "next to",
        "left" => "left of",
        "right" => "right of",
        "eq" => "the same as",
        other => other,
    }
}

fn property_words(property: &str) -> &str {
    match property {
        "agent" => "robot",
        other => other,
    }
}
