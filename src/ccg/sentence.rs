//! A command's words: Unicode NFC, lower case, split on white space and hyphens, outer punctuation stripped,
//! `'s` a word of its own, digits kept. Two commands are the same when their words are.

use unicode_normalization::UnicodeNormalization;

/// Words that a command may have.
pub const MAX_WORDS: usize = 50;

/// The words of a command, at most `MAX_WORDS` + 1 of them (one more than can be parsed tells that it is too long).
pub fn words(command: &str) -> Vec<String> {
    let text: String = command.nfc().flat_map(char::to_lowercase).collect();
    let mut words = Vec::new();
    let is_outer = |c: char| !c.is_alphanumeric();
    for token in text.split(is_separator) {
        let word = match token.trim_end_matches(is_outer) {
            owner @ ("'s" | "\u{2019}s") => owner,
            other => other.trim_start_matches(is_outer),
        };
        match word.strip_suffix("'s").or_else(|| word.strip_suffix("\u{2019}s")) {
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
    words
}

fn is_separator(c: char) -> bool {
    c.is_whitespace() || matches!(c, '-' | '\u{2010}'..='\u{2015}')
}
