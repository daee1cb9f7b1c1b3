//! What the engine's parts cost, in CPU time on one thread, and how that compares with the reference system
//! (Java, a two-core machine of the same kind). Numbers are reported, never asserted: `make bench`.

#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "a bench prints, and stops when it cannot go on"
)]

#[path = "cpu.rs"]
mod cpu;

use cpu::{Row, print_table};
use groundling::domain::{Plan, generate};
use groundling::logic::{Terms, print, read};
use std::hint::black_box;

/// "Go to the blue room" and a term with redexes.
const TERMS: [&str; 2] = [
    "(in:<e,<e,t>> (the:<<e,t>,e> agent:<e,t>) (the:<<e,t>,e> (lambda $0:e (and:<t*,t> (room:<e,t> $0) (blue:<e,t> $0)))))",
    "((lambda $0:<e,t> (exists:<<e,t>,t> $0)) (lambda $0:e (and:<t*,t> (not:<t,t> (red:<e,t> $0)) (block:<e,t> $0))))",
];

fn main() {
    let rows = [
        Row::new("read, reduce and print 2 terms, new arena", 2_000, None, reduce),
        Row::new("generate a world", 2_000, None, world),
    ];
    print_table(&rows);
}

fn reduce(_round: u64) {
    let mut terms = Terms::new();
    for text in TERMS {
        let term = read(&mut terms, text).unwrap();
        black_box(print(&terms, term));
    }
}

fn world(round: u64) {
    black_box(generate(&Plan::default(), round));
}
