//! What belongs together: words, the parts of a formula and a derivation that they carried, the phrases, and what
//! these stand for in the room. Pointing at one points at all.

use crate::worker::protocol::{Phrase, Reading};

/// A span of words that is pointed at: the first, and one past the last.
pub type Link = (usize, usize);

/// Whether a word is in the span.
pub const fn holds(link: Option<Link>, word: usize) -> bool {
    matches!(link, Some((start, end)) if start <= word && word < end)
}

/// Whether words are within the span.
pub const fn covers(link: Option<Link>, words: (usize, usize)) -> bool {
    matches!(link, Some((start, end)) if start <= words.0 && words.1 <= end)
}

/// The span of a phrase's words.
pub fn span(phrase: &Phrase) -> Option<Link> {
    Some((*phrase.words.first()?, phrase.words.last()? + 1))
}

/// The phrases that a span is about: those within it, else the shortest one around it.
pub fn phrases(reading: &Reading, link: Link) -> Vec<&Phrase> {
    let within: Vec<&Phrase> = reading
        .phrases
        .iter()
        .filter(|phrase| span(phrase).is_some_and(|own| covers(Some(link), own)))
        .collect();
    if !within.is_empty() {
        return within;
    }
    let around = reading.phrases.iter().filter(|p| p.words.iter().any(|&w| holds(Some(link), w)));
    around.min_by_key(|phrase| phrase.words.len()).into_iter().collect()
}

/// The cells of what a span of words stands for, or of what is in question.
pub fn cells(reading: &Reading, link: Link) -> Vec<(i32, i32)> {
    let referents = phrases(reading, link).into_iter().flat_map(|phrase| &phrase.referents);
    referents.flat_map(|referent| referent.cells.iter().copied()).collect()
}

/// The words that stand for what is on a cell: those of the smallest thing first, so that a block goes before its
/// room.
pub fn at_cell(reading: &Reading, cell: (i32, i32)) -> Option<Link> {
    let about = reading.phrases.iter().filter_map(|phrase| {
        let own = phrase.referents.iter().filter(|r| r.cells.contains(&cell));
        Some((own.map(|r| r.cells.len()).min()?, phrase))
    });
    about.min_by_key(|(size, _)| *size).and_then(|(_, phrase)| span(phrase))
}
