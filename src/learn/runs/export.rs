//! Results as tables: CSV for other programs, Markdown for a report. Figures stand beside settings and seed, with the
//! ends of their 95 % intervals.

use super::results::RunResult;
use super::spec::{Plan, RunSpec};
use crate::ccg::Kind;
use crate::learn::report::Report;
use crate::learn::score::Ties;
use crate::learn::settings::{Lexicon, SeedLexicon};

/// The columns before those of the figures.
const SETTINGS: [&str; 13] = [
    "run",
    "examples",
    "commands",
    "lexicon",
    "epochs",
    "beam",
    "lexical_beam",
    "demonstrations",
    "margin",
    "seed",
    "generations",
    "idioms",
    "without",
];

/// The six figures, of which each has a lower and an upper end.
const FIGURES: [&str; 6] =
    ["precision", "recall", "f1", "skipping_precision", "skipping_recall", "skipping_f1"];

/// The columns behind them.
const REST: [&str; 7] = [
    "answered",
    "correct",
    "skipping_answered",
    "skipping_correct",
    "valid",
    "entries",
    "paper_f1",
];

/// A row a run, and one for all where they judge one corpus together.
pub fn csv(plan: &Plan, results: &[RunResult]) -> String {
    let figures =
        FIGURES.iter().flat_map(|name| ["", "_low", "_high"].map(|end| format!("{name}{end}")));
    let header: Vec<String> = SETTINGS
        .iter()
        .map(|&name| name.to_owned())
        .chain(figures)
        .chain(REST.map(str::to_owned))
        .collect();
    let mut rows = vec![header];
    for (spec, result) in plan.runs.iter().zip(results) {
        rows.push(row(spec, result));
    }
    if plan.pooled {
        let report = all(results);
        let commands = report.marks.len().to_string();
        let mut row = vec!["all".to_owned(), String::new(), commands];
        row.resize(SETTINGS.len(), String::new());
        row.extend(figures_of(&report));
        row.extend(counts_of(&report));
        row.resize(SETTINGS.len() + 3 * FIGURES.len() + REST.len(), String::new());
        rows.push(row);
    }
    let quoted = |cell: &String| format!("\"{}\"", cell.replace('"', "\"\""));
    let line = |row: &Vec<String>| row.iter().map(quoted).collect::<Vec<_>>().join(",") + "\r\n";
    rows.iter().map(line).collect()
}

/// A report to be read: the plan, a table of the runs, and how to repeat it.
pub fn markdown(plan: &Plan, results: &[RunResult]) -> String {
    let mut lines = vec![
        format!("# {}", plan.name),
        String::new(),
        format!("{} rows, fingerprint `{}`. 95 % intervals in brackets (bootstrap by command).", plan.rows, plan.corpus),
        String::new(),
        "| run | learned from | judged on | precision | recall | F1 | F1, words skipped | entries | seed | paper's F1 |".to_owned(),
        "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|".to_owned(),
    ];
    let cells = |report: &Report| {
        let scores = report.scores(Ties::Abstain).figures();
        let ends = report.intervals(Ties::Abstain);
        let cell = |at: usize| {
            let (low, high) = ends[at];
            format!("{:.3} [{low:.3}, {high:.3}]", scores[at])
        };
        [0, 1, 2, 5].map(cell).join(" | ")
    };
    for (spec, result) in plan.runs.iter().zip(results) {
        let paper = spec.paper_f1.map_or(String::new(), |f1| format!("{f1:.3}"));
        lines.push(format!(
            "| {} | {} | {} | {} | {} | {} | {paper} |",
            spec.name.replace('|', "\\|"),
            result.examples,
            result.marks.len(),
            cells(&result.report()),
            result.entries,
            spec.settings.seed,
        ));
    }
    if plan.pooled {
        let report = all(results);
        lines.push(format!("| all | | {} | {} | | | |", report.marks.len(), cells(&report)));
    }
    lines.extend([
        String::new(),
        "Repeat it with the plan's file: `groundling experiment run --plan FILE --corpus FILE…`"
            .to_owned(),
        String::new(),
    ]);
    lines.join("\n")
}

/// What all runs found together.
pub fn all(results: &[RunResult]) -> Report {
    let mut all = Report::default();
    results.iter().for_each(|result| all.add(result.report()));
    all
}

fn row(spec: &RunSpec, result: &RunResult) -> Vec<String> {
    let settings = &spec.settings;
    let without: Vec<&str> = settings.without.iter().map(|&kind| Kind::name(kind)).collect();
    let lexicon = match &settings.lexicon {
        Lexicon::Here(SeedLexicon::Domain) => "domain",
        Lexicon::Here(SeedLexicon::Demonstration) => "demonstration",
        Lexicon::Own(_) => "own",
    };
    let report = result.report();
    let mut row = vec![
        spec.name.clone(),
        result.examples.to_string(),
        result.marks.len().to_string(),
        lexicon.to_owned(),
        settings.epochs.to_string(),
        settings.beam.to_string(),
        settings.lexical_beam.to_string(),
        settings.demonstrations.map_or("all".to_owned(), |n| n.to_string()),
        settings.margin.to_string(),
        settings.seed.to_string(),
        settings.generations.to_string(),
        settings.idioms.to_string(),
        without.join(" "),
    ];
    row.extend(figures_of(&report));
    row.extend(counts_of(&report));
    row.extend([
        result.valid.to_string(),
        result.entries.to_string(),
        spec.paper_f1.map_or(String::new(), |f1| f1.to_string()),
    ]);
    row
}

fn figures_of(report: &Report) -> Vec<String> {
    let figures = report.scores(Ties::Abstain).figures();
    let ends = report.intervals(Ties::Abstain);
    let cells = figures.into_iter().zip(ends).flat_map(|(figure, (low, high))| [figure, low, high]);
    cells.map(|value| format!("{value:.6}")).collect()
}

fn counts_of(report: &Report) -> [String; 4] {
    let scores = report.scores(Ties::Abstain);
    let (plain, skipping) = (scores.plain, scores.skipping);
    [plain.answered, plain.correct, skipping.answered, skipping.correct].map(|n| n.to_string())
}
