//! The grammar of a language: goals and what they speak of in its words.

use super::scenes::Scenes;
use crate::worker::protocol::{Claim, Noun, Phrase, Referent};

/// The grammar of a language.
pub trait Phrases: Scenes {
    /// A goal: "the robot is in the blue room".
    fn claim(&self, claim: &Claim) -> String;
    /// What the robot does about a goal, names between asterisks: "go to *the blue room*".
    fn deed(&self, claim: &Claim) -> String;
    /// What the robot does about a claim that keeps it from something: "I stay out of the blue room."
    fn keeps(&self, claim: &Claim) -> Option<String>;
    /// A thing: "the biggest room".
    fn noun(&self, noun: &Noun) -> String;
    /// Why a phrase does not refer: "there are two chairs".
    fn failure(&self, phrase: &Phrase) -> String;
    /// A thing of the world: "the red chair".
    fn referent(&self, referent: &Referent) -> String;

    /// A goal as a sentence: "The robot is in the blue room."
    fn sentence(&self, claim: &Claim) -> String {
        format!("{}.", capitalised(&self.claim(claim)))
    }
}

/// Words with a capital at their head. Knows the letters of these languages: the tables for all letters there are would
/// be as large as a view.
pub fn capitalised(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map(|letter| match letter {
        'ä' => 'Ä',
        'ö' => 'Ö',
        'ü' => 'Ü',
        other => other.to_ascii_uppercase(),
    });
    first.into_iter().chain(letters).collect()
}
