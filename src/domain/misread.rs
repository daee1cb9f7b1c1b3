//! What serde says of a text of JSON, in the words of whoever wrote the text: it names types of the program, of which they
//! have never heard. What it quotes is theirs, and stays.

use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::Error;

/// What serde calls the kinds of values, and what a person does.
const KINDS: [(&str, &str); 14] = [
    ("internally", "an object"),
    ("struct", "an object"),
    ("map", "an object"),
    ("tuple", "a list"),
    ("array", "a list"),
    ("sequence", "a list"),
    ("unit", "a word alone"),
    ("newtype", "a word with a value"),
    ("enum", "a word"),
    ("variant", "a word"),
    ("string", "a text"),
    ("boolean", "true or false"),
    ("f32", "a number"),
    ("f64", "a number"),
];

/// Reads JSON.
///
/// # Errors
/// In words, what is wrong, and where.
pub fn read<'a, T: Deserialize<'a>>(text: &'a str) -> Result<T, String> {
    serde_json::from_str(text).map_err(|error| placed(text, &error))
}

fn placed(text: &str, error: &Error) -> String {
    let said = in_words(error, is_broken(text, error));
    format!("{said} (line {}, column {})", error.line(), error.column())
}

/// Whether a text that cannot be read is no JSON at all. A value where there should be a word of a closed set is a mistake of
/// syntax to serde, and so is a number beyond all numbers.
pub fn is_broken(text: &str, error: &Error) -> bool {
    (error.is_syntax() || error.is_eof()) && serde_json::from_str::<IgnoredAny>(text).is_err()
}

/// What is wrong, but not where.
pub fn in_words(error: &Error, is_broken: bool) -> String {
    let full = error.to_string();
    let place = format!(" at line {} column {}", error.line(), error.column());
    let said = full.strip_suffix(&place).unwrap_or(&full);
    if said == "expected value" && !is_broken {
        return "invalid type, expected a word".to_owned();
    }
    if let Some(rest) = said.strip_prefix("unknown variant") {
        return ["unknown word", rest].concat();
    }
    let Some((found, wanted)) = said.rsplit_once(", expected ") else { return said.to_owned() };
    let (what, found) = if let Some(length) = found.strip_prefix("invalid length ") {
        ("invalid type", ["a list of ", length].concat())
    } else if let Some((what, found)) = found.split_once(": ") {
        (what, value(found))
    } else {
        return said.to_owned();
    };
    // A whole number, as is said, but too far from 0.
    let is_far = what == "invalid value" && is_whole(wanted);
    let wanted = match found.starts_with("`-") {
        true if is_far => "a larger whole number".to_owned(),
        false if is_far => "a smaller whole number".to_owned(),
        _ => kind(wanted),
    };
    [what, ": ", &found, ", expected ", &wanted].concat()
}

/// What was found: itself where it is quoted, or its kind.
fn value(found: &str) -> String {
    match found.find(['`', '"']) {
        Some(quoted) => found[quoted..].to_owned(),
        None => kind(found),
    }
}

/// The kind of value that serde means; what it does not call by a name of its own stays.
fn kind(said: &str) -> String {
    if is_whole(said) {
        return "a whole number".to_owned();
    }
    let known = |word| KINDS.iter().find(|(name, _)| *name == word);
    let Some((_, words)) = said.split(' ').find_map(known) else { return said.to_owned() };
    match said.rsplit(' ').next().filter(|length| is_count(length)) {
        Some(length) => [words, " of ", length].concat(),
        None => (*words).to_owned(),
    }
}

/// Whether serde names a type of whole numbers.
fn is_whole(said: &str) -> bool {
    let bits = said.strip_prefix(['i', 'u']);
    bits.is_some_and(|bits| bits == "size" || is_count(bits))
}

fn is_count(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}
