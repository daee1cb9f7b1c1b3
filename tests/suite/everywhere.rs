//! The results that every machine must come to, natively; `tests/browser` holds the same in Chromium.

#[path = "../browser/same.rs"]
mod same;

#[test]
fn results_are_those_of_every_machine() {
    same::holds();
}
