//! German claims: what is to be so, and the things that it is about, in plain words.

use super::claims::{Words, denied, held, joined, related};
use super::german_words::Case::{self, Dative, Nominative};
use super::german_words::Gender::{self, Feminine, Masculine, Neuter};
use super::german_words::{adjective, article, definite, every, indefinite, property};
use crate::domain::Color;
use crate::worker::protocol::{Article, Claim, Description, Noun};

const WORDS: Words = Words { noun: |told| noun(told, Nominative), place, claim, is: "ist" };

/// "der Roboter ist im blauen Raum"
pub(super) fn claim(told: &Claim) -> String {
    match told {
        Claim::All(all) => joined(&WORDS, all, "und", "sind"),
        Claim::Any(any) => joined(&WORDS, any, "oder", "ist"),
        Claim::Not(inner) => match &**inner {
            Claim::Exists(description) => counted(true, description),
            Claim::Related { nouns, .. } => {
                format!("{} ist {}", noun(&nouns[0], Nominative), place(told))
            }
            Claim::Is(property, thing) => {
                format!("{} ist nicht {}", noun(thing, Nominative), adjective(property))
            }
            other => format!("es gilt nicht: {}", claim(other)),
        },
        Claim::Related { nouns, .. } => {
            format!("{} ist {}", noun(&nouns[0], Nominative), place(told))
        }
        Claim::Is(property, thing) => {
            format!("{} ist {}", noun(thing, Nominative), adjective(property))
        }
        Claim::Exists(description) => counted(false, description),
        Claim::Then(all) => {
            let (first, next) = all.split_at(all.len().min(1));
            let next = next.iter().map(|told| format!(", dann {}", inverted(told)));
            first.iter().map(claim).chain(next).collect()
        }
        Claim::Never(inner) => match related(inner) {
            Some((_, nouns)) => format!("{} ist nie {}", noun(&nouns[0], Nominative), place(inner)),
            None => format!("nie gilt: {}", claim(inner)),
        },
        Claim::Until(both) => {
            format!("{}, und bis dahin {}", claim(&both[1]), inverted(&both[0]))
        }
        Claim::Formula(formula) => format!("es gilt: {formula}"),
    }
}

/// "ist der Roboter im blauen Raum": a claim behind a word that goes before its verb.
fn inverted(told: &Claim) -> String {
    match related(told).or_else(|| denied(told)) {
        Some((_, nouns)) => format!("ist {} {}", noun(&nouns[0], Nominative), place(told)),
        None => format!("gilt: {}", claim(told)),
    }
}

/// "Ich bleibe dem blauen Raum fern.", where a claim keeps the robot from something.
pub(super) fn keeps(told: &Claim) -> Option<String> {
    match denied(told)? {
        ("in" | "near", [Noun::Robot, other]) => {
            Some(format!("Ich bleibe {} fern.", noun(other, Dative)))
        }
        _ => None,
    }
}

/// "der größte Raum", "dem größten Raum"
pub(super) fn noun(told: &Noun, case: Case) -> String {
    match told {
        Noun::Robot => definite(&[], "Roboter", Masculine, case),
        Noun::It | Noun::Outer => "es".to_owned(),
        Noun::Described(description) => described(description, case),
        Noun::Formula(formula) => formula.clone(),
    }
}

/// "im blauen Raum", "nicht im roten Raum": where a claim has its first thing.
fn place(told: &Claim) -> String {
    match (related(told), denied(told)) {
        (Some((relation, nouns)), _) => to(relation, &nouns[1]),
        (_, Some((relation, nouns))) => format!("nicht {}", to(relation, &nouns[1])),
        _ => claim(told),
    }
}

/// "neben dem roten Stuhl"
fn to(relation: &str, other: &Noun) -> String {
    if relation == "eq" {
        return noun(other, Nominative);
    }
    by(relation, &noun(other, Dative))
}

/// A relation to something that stands in the dative already.
fn by(relation: &str, other: &str) -> String {
    match relation {
        "in" => match other.strip_prefix("dem ") {
            Some(rest) => format!("im {rest}"),
            None => format!("in {other}"),
        },
        "near" => format!("neben {other}"),
        "left" => format!("links von {other}"),
        "right" => format!("rechts von {other}"),
        _ => other.to_owned(),
    }
}

/// That there is such a thing, or none: "kein Stuhl ist im roten Raum".
fn counted(none: bool, description: &Description) -> String {
    let all = |case| head(description, case, every);
    let a = |case| {
        let no = if none { "k" } else { "" };
        format!("{no}{}", head(description, case, indefinite))
    };
    let there = || {
        let somewhere = if none { "nirgends" } else { "irgendwo" };
        format!("{somewhere} ist {}", described(description, Nominative))
    };
    match &description.claims[..] {
        [told] => match (related(told), denied(told)) {
            (Some((relation, [Noun::It, other])), _) => {
                format!("{} ist {}", a(Nominative), to(relation, other))
            }
            (Some((relation, [other, Noun::It])), _) => {
                format!("{} ist {}", noun(other, Nominative), by(relation, &a(Dative)))
            }
            (_, Some((relation, [Noun::It, other]))) if none => {
                format!("{} ist {}", all(Nominative), to(relation, other))
            }
            (_, Some((relation, [other, Noun::It]))) if none => {
                format!("{} ist {}", noun(other, Nominative), by(relation, &all(Dative)))
            }
            _ => there(),
        },
        _ => there(),
    }
}

fn described(description: &Description, case: Case) -> String {
    let article = if description.article == Article::A { indefinite } else { definite };
    head(description, case, article) + &after(description)
}

/// "dem größten roten Raum", with the article that is wanted.
fn head(
    description: &Description,
    case: Case,
    article: fn(&[&str], &str, Gender, Case) -> String,
) -> String {
    let mut adjectives: Vec<&str> = match description.article {
        Article::Biggest => vec!["größt"],
        Article::Smallest => vec!["kleinst"],
        Article::A | Article::The | Article::Closest(_) => Vec::new(),
    };
    let (colors, nouns) = parted(description);
    let (word, gender) = nouns.first().map_or(("Ding", Neuter), |noun| property(noun));
    let others = nouns.iter().skip(1).map(|noun| format!(" und {}", property(noun).0));
    adjectives.extend(colors.into_iter().map(adjective));
    article(&adjectives, &format!("{word}{}", others.collect::<String>()), gender, case)
}

/// The colours of a description, and what else it names.
fn parted(description: &Description) -> (Vec<&str>, Vec<&str>) {
    let properties = description.properties.iter().map(String::as_str);
    properties.partition(|property| property.parse::<Color>().is_ok())
}

/// What is said of a thing behind its noun.
fn after(description: &Description) -> String {
    let gender = parted(description).1.first().map_or(Neuter, |noun| property(noun).1);
    // The shades have English names only.
    let shade = match (description.article, gender) {
        (Article::Closest(shade), Feminine) => Some(("deren", shade.name())),
        (Article::Closest(shade), _) => Some(("dessen", shade.name())),
        _ => None,
    };
    let shade = shade.map(|(whose, name)| format!("{whose} Farbe „{name}“ am nächsten kommt"));
    let claims = description.claims.iter().map(|claim| relative(claim, gender));
    let all: Vec<String> = shade.into_iter().chain(claims).collect();
    if all.is_empty() { String::new() } else { format!(", {}", all.join(" und ")) }
}

/// A claim about the thing at hand, behind its noun: "der im roten Raum ist".
fn relative(told: &Claim, gender: Gender) -> String {
    let (who, whom) = (article(gender, Nominative), article(gender, Dative));
    let (positive, not) = match told {
        Claim::Not(inner) => (&**inner, "nicht "),
        _ => (told, ""),
    };
    match positive {
        Claim::Is(property, thing) if **thing == Noun::It => {
            format!("{who} {not}{} ist", adjective(property))
        }
        Claim::Exists(_) => match held(positive) {
            Some(inside) => {
                let no = if not.is_empty() { "" } else { "k" };
                format!("in {whom} {no}{} ist", head(inside, Nominative, indefinite))
            }
            None => format!("wofür gilt: {}", claim(told)),
        },
        Claim::Related { relation, nouns } => match (&**nouns, relation.as_str()) {
            ([Noun::It, other], relation) => format!("{who} {not}{} ist", to(relation, other)),
            ([Noun::Robot, Noun::It], "in") => format!("in {whom} der Roboter jetzt {not}ist"),
            ([other, Noun::It], "in") => {
                format!("in {whom} {} {not}ist", noun(other, Nominative))
            }
            ([other, Noun::It], "left") => format!("{who} {not}{} ist", to("right", other)),
            ([other, Noun::It], "right") => format!("{who} {not}{} ist", to("left", other)),
            ([other, Noun::It], relation) => format!("{who} {not}{} ist", to(relation, other)),
            _ => format!("wofür gilt: {}", claim(told)),
        },
        _ => format!("wofür gilt: {}", claim(told)),
    }
}
