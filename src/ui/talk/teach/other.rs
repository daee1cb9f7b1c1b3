//! Lessons in other words, as they are typed in place of a command.

use crate::worker::protocol::{Lesson, Meaning};

/// A phrase and what it means in other words, if a command says that: `tidy up means: put the block in the blue room`.
pub fn in_other_words(command: &str) -> Option<Lesson> {
    let (phrase, words) =
        command.split_once(" means: ").or_else(|| command.split_once(" means "))?;
    // “By all means” and the like say nothing.
    if phrase.split(' ').rev().nth(1).is_some_and(|before| before.eq_ignore_ascii_case("by")) {
        return None;
    }
    let quotes = ['“', '”', '„', '"', '\'', ' '];
    let (command, words) = (phrase.trim_matches(quotes).to_owned(), words.trim().to_owned());
    let means = Some(Meaning::Words(words));
    (!command.is_empty()).then(|| Lesson { command, pairs: Vec::new(), runs: Vec::new(), means })
}
