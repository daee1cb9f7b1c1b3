//! The normal form that words are read in, against the one of the crate whose tables it uses.

use groundling::ccg::sentence::nfc;
use proptest::strategy::Strategy;
use proptest::{collection, prop_oneof, proptest};
use unicode_normalization::UnicodeNormalization;

/// Letters, marks of several classes, Hangul parts and whatever else there is.
fn texts() -> impl Strategy<Value = String> {
    let marks = proptest::char::range('\u{300}', '\u{36f}');
    let hangul = proptest::char::range('\u{1100}', '\u{11ff}');
    let letters = proptest::char::range('A', '\u{1ef9}');
    let any = proptest::char::any();
    collection::vec(prop_oneof![3 => marks, 1 => hangul, 3 => letters, 1 => any], 0..12)
        .prop_map(|chars| chars.into_iter().collect())
}

proptest! {
    #[test]
    fn text_comes_into_the_standard_normal_form(text in texts()) {
        assert_eq!(nfc(&text), text.nfc().collect::<Vec<char>>());
    }
}
