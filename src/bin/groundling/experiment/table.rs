//! A table of runs, ours beside the paper's, as lines and as JSON.

use crate::figures::report_json;
use crate::parallel::Finished;
use groundling::learn::{PlannerCost, Report, Ties};
use serde_json::{Value, json};

/// A line a run, under a head.
pub(super) fn text(runs: &[Finished]) -> String {
    let width = runs.iter().map(|done| done.run.name.chars().count()).max().unwrap_or(0);
    let mut text = vec![format!(
        "{:<width$}  learned  entries  judged  paper F1  our F1  {:<14}  {:<21}  {:>13}  {:>7}  {:>7}",
        "run", "[95 %]", "with skipping [95 %]", "ties resolved", "seconds", "CPU"
    )];
    for Finished { run, outcome, learning, judging } in runs {
        text.push(format!(
            "{:<width$}  {:>7}  {:>7}  {:>6}  {:>8}  {}  {:>7.1}  {:>7.1}",
            run.name,
            outcome.examples,
            outcome.last.entries,
            outcome.report.marks.len(),
            figure(run.paper_f1),
            f1s(&outcome.report),
            learning.wall + judging.wall,
            learning.cpu + judging.cpu,
        ));
    }
    text.join("\n")
}

/// A figure of the paper's, where there is one.
pub(super) fn figure(figure: Option<f64>) -> String {
    figure.map_or("–".to_owned(), |figure| format!("{figure:.2}"))
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
        "{plain:>6.3}  [{low:.3}, {high:.3}]  {skipping:.3}  [{skipping_low:.3}, {skipping_high:.3}]  \
         {ties:>13.3}"
    )
}

/// An object a run.
pub(super) fn json(runs: &[Finished]) -> Value {
    let line = |done: &Finished| {
        let Finished { run, outcome, learning, judging } = done;
        let mut object = report_json(&outcome.report);
        object["name"] = run.name.as_str().into();
        object["demonstrations"] = run.config.demonstrations.into();
        object["paper_f1"] = run.paper_f1.into();
        object["examples"] = outcome.examples.into();
        object["valid"] = outcome.last.valid.into();
        object["entries"] = outcome.last.entries.into();
        object["seconds"] = json!({ "learning": learning.wall, "judging": judging.wall });
        object["cpu_seconds"] = json!({ "learning": learning.cpu, "judging": judging.cpu });
        if let Some(planning) = run.config.planning {
            object["horizon"] = planning.horizon.into();
            object["memo"] = planning.memo.into();
        }
        if let Some(PlannerCost { calls, saved, expanded, given_up }) = outcome.planner {
            object["planner"] = json!({
                "calls": calls, "saved": saved, "expanded": expanded, "given_up": given_up,
            });
        }
        object
    };
    runs.iter().map(line).collect()
}
