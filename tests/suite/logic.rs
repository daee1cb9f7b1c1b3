//! The language of goals: normal forms, errors and human forms as data; what no text may bring about; and the
//! invariant of the arena (equal ids exactly when terms mean the same) against a second way to normal forms.

#[path = "logic/hostile.rs"]
mod hostile;
#[path = "logic/order.rs"]
mod order;
#[path = "logic/properties.rs"]
mod properties;
#[path = "logic/reference.rs"]
mod reference;
#[path = "logic/sorts.rs"]
mod sorts;

use groundling::logic::{Terms, print, print_human, read};

/// Calls `check(line, input, expected)` on each case of a data file: an input line, then `=> expected`. Lines that
/// begin with `#` and empty lines are none, except that an empty line before `=>` is an empty input.
#[track_caller]
pub(crate) fn cases(data: &str, at_least: usize, mut check: impl FnMut(usize, &str, &str)) {
    let mut input = "";
    let mut count = 0;
    for (line, text) in (1..).zip(data.lines()) {
        match text.strip_prefix("=>") {
            Some(expected) => {
                check(line, input, expected.strip_prefix(' ').unwrap_or(expected));
                count += 1;
            }
            None if text.starts_with('#') => {}
            None => input = text,
        }
    }
    assert!(count >= at_least, "only {count} cases were found");
}

#[test]
fn terms_come_to_their_normal_forms() {
    let check = |line, input: &str, expected: &str| {
        let mut terms = Terms::new();
        let term = read(&mut terms, input).unwrap_or_else(|e| panic!("line {line}: {input}: {e}"));
        let printed = print(&terms, term);
        assert_eq!(printed, expected, "line {line}: the normal form of {input}");
        let again = read(&mut terms, &printed).unwrap();
        assert_eq!(again, term, "line {line}: {printed} reads as {}", print(&terms, again));
    };
    cases(include_str!("../data/logic/reductions.txt"), 60, check);
}

#[test]
fn what_is_no_term_is_refused_with_column_and_words() {
    let check = |line, input: &str, expected: &str| {
        let said = match read(&mut Terms::new(), input) {
            Ok(_) => "it was read".to_owned(),
            Err(error) => error.to_string(),
        };
        assert_eq!(said, format!("column {expected}"), "line {line}: {input}");
    };
    cases(include_str!("../data/logic/errors.txt"), 45, check);
}

#[test]
fn people_read_goals_as_they_write_logic() {
    let check = |line, input: &str, expected: &str| {
        let mut terms = Terms::new();
        let term = read(&mut terms, input).unwrap_or_else(|e| panic!("line {line}: {input}: {e}"));
        assert_eq!(print_human(&terms, term), expected, "line {line}: {input}");
    };
    cases(include_str!("../data/logic/human.txt"), 20, check);
}
