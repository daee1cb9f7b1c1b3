//! What learning a corpus costs: time at an eighth, a quarter, half and all of it, parsing with what was learned, and
//! the most memory that was held. `CORPUS=FILE make bench` takes a corpus kept elsewhere; otherwise rows of the crowd.

use crate::cpu::{Row, seconds};
use groundling::ccg::{ChartConfig, Model, parse};
use groundling::corpus::{Example, Options, read};
use groundling::learn::{CLEANUP_LEXICON, Config, Trainer, seed_model};
use std::fs;
use std::hint::black_box;

/// Rows of the crowd that the project keeps.
const CROWD: [&str; 2] = [
    include_str!("../data/corpus/crowd-learn.csv"),
    include_str!("../data/corpus/crowd-judge.csv"),
];

/// Epochs of the runs that show growth.
const EPOCHS: u32 = 3;
/// The reference system on fifty commands, 15 epochs, in CPU seconds (400 to 600, extrapolated).
const REFERENCE_FIFTY: f64 = 500.0;
/// The reference system on the pruned corpus, 15 epochs (3.5 to 5 hours, extrapolated), a fifth of it for 3 epochs.
const REFERENCE_PRUNED: f64 = 15_300.0 / 5.0;

/// The rows of the table.
pub(crate) fn rows() -> Vec<Row> {
    let crowd = crowd();
    let mut rows = vec![Row::of(
        "train: 36 rows of the crowd, 15 epochs",
        3,
        Some(REFERENCE_FIFTY * crowd.len() as f64 / 50.0),
        |_| drop(black_box(trained(&crowd, 15))),
    )];
    let own = std::env::var("CORPUS").ok();
    let corpus = match &own {
        Some(path) => examples(&fs::read_to_string(path).unwrap()),
        None => crowd.clone(),
    };
    let mut model = None;
    let names = [
        "train: 1/8 of the corpus, 3 epochs",
        "train: 1/4 of the corpus, 3 epochs",
        "train: 1/2 of the corpus, 3 epochs",
        "train: all of the corpus, 3 epochs",
    ];
    for (name, part) in names.into_iter().zip([8, 4, 2, 1]) {
        // Every eighth row and so on: corpora come sorted by task.
        let some: Vec<Example> = corpus.iter().step_by(part).cloned().collect();
        let cost = seconds(|| model = Some(trained(&some, EPOCHS)));
        rows.push(Row::from_seconds(name, vec![cost]));
    }
    if own.is_some_and(|path| path.contains("pruned"))
        && let Some(whole) = rows.last_mut()
    {
        whole.set_reference(REFERENCE_PRUNED);
    }
    let mut model = model.unwrap_or_default();
    let config = ChartConfig::of(&model);
    let latency = corpus
        .iter()
        .map(|example| seconds(|| drop(black_box(parse(&mut model, &example.command, config)))));
    rows.push(Row::from_seconds("parse: a command, with that model", latency.collect()));
    rows
}

/// Rows of the crowd.
pub(crate) fn crowd() -> Vec<Example> {
    CROWD.iter().flat_map(|text| examples(text)).collect()
}

fn examples(text: &str) -> Vec<Example> {
    read(text.as_bytes(), Options::default()).0.examples
}

/// The model of a run.
pub(crate) fn trained(examples: &[Example], epochs: u32) -> Model {
    let config = Config { epochs, ..Config::default() };
    let mut trainer = Trainer::new(seed_model(CLEANUP_LEXICON).unwrap(), examples, config);
    while !trainer.is_done() {
        trainer.step();
    }
    trainer.end()
}

/// The most memory that this process held, in megabytes, where the system tells.
pub(crate) fn peak_memory() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kilobytes / 1e3)
}
