//! What long sentences cost with the model that the page opens with, each the first that a model is asked, and what
//! "please" before every command costs training. The reference is the same work without: clauses alone, no "please".

use crate::cpu::{Row, seconds};
use crate::learning::{crowd, trained};
use groundling::ccg::{ChartConfig, Model, parse};
use std::hint::black_box;

/// Commands that are joined by "and".
const CLAUSES: [&str; 5] = [
    "go to the red room",
    "move the chair to the blue room",
    "push the block into the green room",
    "bring the bag to the yellow room",
    "take the basket to the orange room",
];
/// Sentences of thirty to forty words.
const LONG: &str = include_str!("../data/ccg/long.txt");
/// Rounds of each.
const ROUNDS: usize = 20;

/// The rows of the table.
pub(crate) fn rows(model: &Model) -> Vec<Row> {
    let mut rows = Vec::new();
    for (name, n) in [("parse: two clauses, and alone", 2), ("parse: five clauses, and alone", 5)] {
        let joined = CLAUSES[..n].join(" and ");
        let mut alone: Vec<f64> = (0..ROUNDS).map(|_| cost(model, &CLAUSES[..n])).collect();
        alone.sort_by(f64::total_cmp);
        let together = (0..ROUNDS).map(|_| cost(model, &[&joined])).collect();
        let mut row = Row::from_seconds(name, together);
        row.set_reference(alone[ROUNDS / 2]);
        rows.push(row);
    }
    let long = LONG.lines().skip(1).map(|sentence| cost(model, &[sentence])).collect();
    rows.push(Row::from_seconds("parse: 30 to 40 words, worst of ten", long));
    let plain = crowd();
    let mut polite = plain.clone();
    polite.iter_mut().for_each(|example| example.command.insert_str(0, "please "));
    let mut row = Row::of("train: \"please\" before each, and without", 3, None, |_| {
        black_box(trained(&polite, 15));
    });
    row.set_reference(seconds(|| drop(black_box(trained(&plain, 15)))));
    rows.push(row);
    rows
}

/// The CPU seconds of parsing commands, the first that the model is asked.
fn cost(model: &Model, commands: &[&str]) -> f64 {
    let mut model = model.clone();
    let config = ChartConfig::of(&model);
    let parse = |command: &&str| drop(black_box(parse(&mut model, command, config)));
    seconds(|| commands.iter().for_each(parse))
}
