//! A command's words: Unicode NFC, lower case, split on white space and hyphens, outer punctuation stripped,
//! `'s` a word of its own, digits kept; an apostrophe is straight. Two commands are the same when their words are.

use crate::logic::order;
use unicode_normalization::char::{canonical_combining_class, compose, decompose_canonical};

/// Words that a command may have.
pub const MAX_WORDS: usize = 50;

/// Letters that a command's words may have in all.
pub const MAX_LETTERS: usize = 2_000;

/// The words of a command, at most `MAX_WORDS` + 1 of them, and at most `MAX_LETTERS` + 1 letters (one more than can be
/// parsed tells that it is too long).
pub fn words(command: &str) -> Vec<String> {
    composed_words(&nfc(command).into_iter().collect::<String>())
}

/// The words of a command that is in NFC already, as text of the page is: the browser has the tables for that, and a
/// program that needs none of its own is a tenth smaller.
pub fn composed_words(command: &str) -> Vec<String> {
    let straight = command.chars().map(|c| if c == '\u{2019}' { '\'' } else { c });
    let text: String = straight.map(lower).collect();
    let mut words = Vec::new();
    let is_outer = |c: char| !c.is_alphanumeric();
    for token in text.split(is_separator) {
        let word = match token.trim_end_matches(is_outer) {
            owner @ "'s" => owner,
            other => other.trim_start_matches(is_outer),
        };
        match word.strip_suffix("'s") {
            Some("") => words.push("'s".to_owned()),
            Some(owner) => words.extend([owner.to_owned(), "'s".to_owned()]),
            None if word.is_empty() => {}
            None => words.push(word.to_owned()),
        }
        if words.len() > MAX_WORDS {
            words.truncate(MAX_WORDS + 1);
            break;
        }
    }
    cut(&mut words);
    words
}

/// Whether words are more than can be parsed.
pub(super) fn is_too_long(words: &[String]) -> bool {
    let letters: usize = words.iter().map(|word| word.chars().count()).sum();
    words.len() > MAX_WORDS || letters > MAX_LETTERS
}

/// Cuts words where they have one letter too many.
fn cut(words: &mut Vec<String>) {
    let mut left = MAX_LETTERS + 1;
    for (at, word) in words.iter_mut().enumerate() {
        let end = word.char_indices().nth(left).map_or(word.len(), |(end, _)| end);
        word.truncate(end);
        left -= word.chars().count();
        if left == 0 {
            return words.truncate(at + 1);
        }
    }
}

/// A letter in lower case, in the Latin, Greek and Cyrillic alphabets: the tables for all that there are would be a
/// twentieth of what the page loads.
const fn lower(c: char) -> char {
    let apart = match c {
        'A'..='Z' | 'À'..='Ö' | 'Ø'..='Þ' | 'Α'..='Ρ' | 'Σ'..='Ϋ' | 'А'..='Я' => 32,
        'Ѐ'..='Џ' => 80,
        'Ā'..='į' | 'Ĳ'..='ķ' | 'Ŋ'..='ŷ' => 1 - c as u32 % 2,
        'Ĺ'..='ň' | 'Ź'..='ž' => c as u32 % 2,
        'Ÿ' => return 'ÿ',
        _ => 0,
    };
    match char::from_u32(c as u32 + apart) {
        Some(low) => low,
        None => c,
    }
}

fn is_separator(c: char) -> bool {
    c.is_whitespace() || matches!(c, '-' | '\u{2010}'..='\u{2015}')
}

/// Unicode NFC (Standard Annex 15): decomposed, each run of marks put in canonical order, composed again. Written
/// out because the crate's own iterator also links the compatibility tables, which the page would load for nothing.
pub fn nfc(text: &str) -> Vec<char> {
    let mut decomposed: Vec<(u8, char)> = Vec::with_capacity(text.len());
    for c in text.chars() {
        decompose_canonical(c, |part| decomposed.push((canonical_combining_class(part), part)));
    }
    for marks in decomposed.chunk_by_mut(|a, b| a.0 > 0 && b.0 > 0) {
        order::sort_by_key(marks, |(class, _)| *class);
    }
    let mut out: Vec<char> = Vec::with_capacity(decomposed.len());
    // The last starter's place in `out`, and the class of what stands after it there.
    let (mut starter, mut after) = (None, None);
    for (class, c) in decomposed {
        let reaches = after.is_none_or(|before| before < class);
        let base = starter.filter(|_| reaches).and_then(|at: usize| out.get_mut(at));
        if let Some(base) = base
            && let Some(whole) = compose(*base, c)
        {
            *base = whole;
            continue;
        }
        (starter, after) =
            if class == 0 { (Some(out.len()), None) } else { (starter, Some(class)) };
        out.push(c);
    }
    out
}
