//! What lies beyond the language, by the words that it is said with: named as what it is, and not as an unknown word.

use super::reading::{Fate, Word};

/// What lies beyond.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// Numbers.
    Number,
    /// A place between two things.
    Between,
    /// Conditions.
    Condition,
    /// A place beside a door, which is a place itself.
    Door,
    /// The robot's own steps and directions.
    Direction,
    /// How, how fast and how often.
    Manner,
    /// Deeds that the robot cannot do.
    Deed,
}

const WORDS: [(Beyond, &str); 7] = [
    (Beyond::Number, "two three four five six seven eight nine ten dozen twice thrice half count"),
    (Beyond::Between, "between betwixt among amongst"),
    (Beyond::Door, "door doors doorway doorways entrance opening"),
    (Beyond::Condition, "if unless whether when whenever"),
    (
        Beyond::Direction,
        "north south up down forward forwards backward backwards turn spin rotate degrees steps clockwise",
    ),
    (
        Beyond::Manner,
        "slowly slow quickly quick fast faster carefully again repeat times always forever",
    ),
    (
        Beyond::Deed,
        "open close lock unlock paint throw break eat build jump dance sing color colour",
    ),
];

impl Beyond {
    /// Whether what a word says has no part in what was understood. That it may go without meaning is known of words that
    /// frame others, such as “up”; of numbers and places it was only learned.
    pub const fn is_lost(self, fate: Fate) -> bool {
        match fate {
            Fate::Skipped | Fate::Unknown | Fate::Idle => true,
            Fate::Empty => matches!(self, Beyond::Number | Beyond::Between),
            Fate::Meant => false,
        }
    }
}

/// What a word says that lies beyond the language and has no part in what was understood.
pub fn lost(word: &Word) -> Option<Beyond> {
    beyond(&word.text).filter(|beyond| beyond.is_lost(word.fate))
}

/// What a word says that lies beyond the language.
pub fn beyond(word: &str) -> Option<Beyond> {
    if word.bytes().all(|byte| byte.is_ascii_digit()) {
        return Some(Beyond::Number);
    }
    let is_said = |(_, words): &&(Beyond, &str)| words.split(' ').any(|known| known == word);
    WORDS.iter().find(is_said).map(|(beyond, _)| *beyond)
}
