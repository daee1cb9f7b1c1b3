//! What must come out the same everywhere (invariant 3): a report of the engine's work as text, held against
//! `tests/data/same.txt` natively, in the page and in a dedicated worker.

use groundling::domain::{Plan, generate};
use groundling::logic::{Terms, print, read};
use std::fmt::Write;

/// What the report was when it was last looked at.
const WANTED: &str = include_str!("../data/same.txt");

/// Terms whose normal forms are part of the report.
const TERMS: [&str; 3] = [
    "(in:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) (the:<<e,t>,e> (lambda $0:e (and:<t*,t> (room:<e,t> $0) (blue:<e,t> $0)))))",
    "((lambda $0:<e,t> (exists:<<e,t>,t> $0)) (lambda $0:e (not:<t,t> (not:<t,t> (red:<e,t> $0)))))",
    "(or:<t*,t> (and:<t*,t> true:t false:t) (eq:<e,<e,t>> (argmax:<<e,t>,<<e,n>,e>> room:<e,t> size:<e,n>) (the:<<e,t>,e> door:<e,t>)))",
];

/// Fails when this machine does not come to the same results as all others.
pub(crate) fn holds() {
    let report = report();
    assert!(report == WANTED, "tests/data/same.txt should read\n{report}");
}

fn report() -> String {
    let mut out = String::new();
    let mut terms = Terms::new();
    for text in TERMS {
        match read(&mut terms, text) {
            Ok(term) => writeln!(out, "term {}", print(&terms, term)),
            Err(error) => writeln!(out, "term {error}"),
        }
        .expect("a string takes any text");
    }
    let worlds: String = (0..200).map(|seed| generate(&Plan::default(), seed).write()).collect();
    writeln!(out, "worlds {:016x}", fnv1a(&worlds)).expect("a string takes any text");
    out
}

/// Fowler, Noll and Vo's hash, 64 bits.
fn fnv1a(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}
