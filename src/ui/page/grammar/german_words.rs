//! German words: gender and case of nouns, endings of adjectives.

use crate::domain::Direction;

/// The gender of a noun.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Gender {
    Masculine,
    Feminine,
    Neuter,
}

/// The cases that the page needs.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Case {
    Nominative,
    Dative,
    Accusative,
}

use Case::{Accusative, Dative, Nominative};
use Gender::{Feminine, Masculine, Neuter};

pub(super) const fn article(gender: Gender, case: Case) -> &'static str {
    match (gender, case) {
        (Masculine, Nominative) => "der",
        (Masculine, Accusative) => "den",
        (Feminine, Nominative | Accusative) => "die",
        (Neuter, Nominative | Accusative) => "das",
        (Feminine, Dative) => "der",
        (_, Dative) => "dem",
    }
}

pub(super) fn definite(adjectives: &[&str], word: &str, gender: Gender, case: Case) -> String {
    let ending = match (gender, case) {
        (_, Dative) | (Masculine, Accusative) => "en",
        _ => "e",
    };
    let adjectives = adjectives.iter().map(|stem| format!("{stem}{ending} ")).collect::<String>();
    format!("{} {adjectives}{word}", article(gender, case))
}

pub(super) fn indefinite(adjectives: &[&str], word: &str, gender: Gender, case: Case) -> String {
    let (article, ending) = match (gender, case) {
        (Masculine, Nominative) => ("ein", "er"),
        (Masculine, Accusative) => ("einen", "en"),
        (Neuter, Nominative | Accusative) => ("ein", "es"),
        (Feminine, Nominative | Accusative) => ("eine", "e"),
        (Feminine, Dative) => ("einer", "en"),
        (_, Dative) => ("einem", "en"),
    };
    let adjectives = adjectives.iter().map(|stem| format!("{stem}{ending} ")).collect::<String>();
    format!("{article} {adjectives}{word}")
}

/// "jeder rote Stuhl", "jedem roten Stuhl"
pub(super) fn every(adjectives: &[&str], word: &str, gender: Gender, case: Case) -> String {
    let phrase = definite(adjectives, word, gender, case);
    let rest = phrase.get(3..).unwrap_or_default();
    let article = match (gender, case) {
        (Masculine, Nominative) | (Feminine, Dative) => "jeder",
        (Masculine, Accusative) => "jeden",
        (Feminine, Nominative | Accusative) => "jede",
        (Neuter, Nominative | Accusative) => "jedes",
        (_, Dative) => "jedem",
    };
    format!("{article}{rest}")
}

/// A class or a shape with its gender.
pub(super) fn property(name: &str) -> (&'static str, Gender) {
    match name {
        "agent" => ("Roboter", Masculine),
        "room" => ("Raum", Masculine),
        "door" => ("Tür", Feminine),
        "object" => ("Gegenstand", Masculine),
        "chair" => ("Stuhl", Masculine),
        "basket" => ("Korb", Masculine),
        "block" => ("Block", Masculine),
        "bag" => ("Beutel", Masculine),
        "backpack" => ("Rucksack", Masculine),
        "box" => ("Kiste", Feminine),
        _ => ("Ding", Neuter),
    }
}

/// A colour's stem, which takes endings.
pub(super) fn adjective(name: &str) -> &'static str {
    match name {
        "red" => "rot",
        "green" => "grün",
        "blue" => "blau",
        "yellow" => "gelb",
        "magenta" => "magentafarben",
        "brown" => "braun",
        "orange" => "orangefarben",
        "tan" => "hellbraun",
        "teal" => "blaugrün",
        other => property(other).0,
    }
}

pub(super) const fn compass(direction: Direction) -> &'static str {
    match direction {
        Direction::North => "Norden",
        Direction::South => "Süden",
        Direction::East => "Osten",
        Direction::West => "Westen",
    }
}
