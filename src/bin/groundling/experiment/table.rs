//! A table of runs, ours beside the paper's, as lines and as JSON.

use crate::figures::report_json;
use crate::parallel::Finished;
use groundling::learn::{Report, Ties};
use serde_json::{Value, json};

/// A run, and the F1 that the paper reports for it.
pub(super) struct Line {
    pub(super) run: Finished,
    pub(super) paper: Option<f64>,
}

/// A line a run, under a head.
pub(super) fn text(lines: &[Line]) -> String {
    let width = lines.iter().map(|line| line.run.name.chars().count()).max().unwrap_or(0);
    let mut text = vec![format!(
        "{:<width$}  learned  entries  judged  paper F1  our F1  [95 %]          \
         skipping counted         ties resolved  seconds      CPU",
        "run"
    )];
    for line in lines {
        let Finished { name, outcome, learning, judging } = &line.run;
        let paper = line.paper.map_or("–".to_owned(), |f1| format!("{f1:.2}"));
        text.push(format!(
            "{name:<width$}  {:>7}  {:>7}  {:>6}  {paper:>8}  {}  {:>7.1}  {:>7.1}",
            outcome.examples,
            outcome.last.entries,
            outcome.report.marks.len(),
            f1s(&outcome.report),
            learning.wall + judging.wall,
            learning.cpu + judging.cpu,
        ));
    }
    text.join("\n")
}

/// The F1 figures with their intervals.
fn f1s(report: &Report) -> String {
    let paper = report.scores(Ties::Abstain);
    let resolved = report.scores(Ties::Refer);
    let [.., (low, high), _, _, (skipping_low, skipping_high)] = report.intervals(Ties::Abstain);
    let plain = paper.plain.f1(paper.total);
    let skipping = paper.skipping.f1(paper.total);
    let ties = resolved.skipping.f1(paper.total);
    format!(
        "{plain:>6.3}  [{low:.3}, {high:.3}]  {skipping:.3} [{skipping_low:.3}, {skipping_high:.3}]  \
         {ties:>13.3}"
    )
}

/// An object a run.
pub(super) fn json(lines: &[Line]) -> Value {
    let line = |line: &Line| {
        let Finished { name, outcome, learning, judging } = &line.run;
        let mut object = report_json(&outcome.report);
        object["name"] = name.as_str().into();
        object["paper_f1"] = line.paper.into();
        object["examples"] = outcome.examples.into();
        object["valid"] = outcome.last.valid.into();
        object["entries"] = outcome.last.entries.into();
        object["seconds"] = json!({ "learning": learning.wall, "judging": judging.wall });
        object["cpu_seconds"] = json!({ "learning": learning.cpu, "judging": judging.cpu });
        object
    };
    lines.iter().map(line).collect()
}
