//! Tests in a page of a headless browser.
#![cfg(target_arch = "wasm32")]
#![allow(clippy::expect_used, reason = "a failing test panics")]

mod same;

use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

#[wasm_bindgen_test]
fn results_are_those_of_every_machine() {
    same::holds();
}
