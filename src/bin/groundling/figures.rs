//! Scores as JSON and as lines for a person; the keys of `evaluate --json` are a contract.

use groundling::learn::reliability::{Bin, Cut};
use groundling::learn::{Reliability, Report, Score, Scores, Ties};
use serde_json::{Map, Value, json};

/// The six figures, and the six with the skipping parse counted.
pub(crate) fn scores_json(scores: Scores) -> Value {
    let mut object = Map::new();
    insert_scores(&mut object, "", scores);
    Value::Object(object)
}

/// [`scores_json`], and everything else that follows from how each command was answered: `intervals`, `tasks`,
/// `confusion`, and `resolved_…`, the figures when a tie is broken by which form refers.
pub(crate) fn report_json(report: &Report) -> Value {
    let mut object = Map::new();
    insert_scores(&mut object, "", report.scores(Ties::Abstain));
    insert_scores(&mut object, "resolved_", report.scores(Ties::Refer));
    let names = ["precision", "recall", "f1"];
    let names = [names.map(str::to_owned), names.map(|name| format!("skipping_{name}"))];
    let intervals = report.intervals(Ties::Abstain);
    let intervals: Map<String, Value> =
        names.into_iter().flatten().zip(intervals.map(|(low, high)| json!([low, high]))).collect();
    object.insert("intervals".into(), intervals.into());
    let tasks = report.tasks(Ties::Abstain).into_iter().map(|(task, scores)| {
        let mut object = Map::from_iter([("task".to_owned(), json!(task))]);
        insert_scores(&mut object, "", scores);
        Value::Object(object)
    });
    object.insert("tasks".into(), tasks.collect());
    let Reliability { asked, unasked_precision, ece, bins, risk_coverage } =
        Reliability::of(&report.marks);
    object.insert("asked".into(), asked.into());
    object.insert("unasked_precision".into(), unasked_precision.into());
    object.insert("ece".into(), ece.into());
    let cut = |Cut { threshold, coverage, risk }: Cut| json!({ "threshold": threshold, "coverage": coverage, "risk": risk });
    object.insert("risk_coverage".into(), risk_coverage.into_iter().map(cut).collect());
    let bin = |Bin { answers, said, right }: Bin| json!({ "answers": answers, "probability": said, "precision": right });
    object.insert("reliability".into(), bins.into_iter().map(bin).collect());
    let cells = report.confusion.cells();
    let cells = cells.map(|(task, does, n)| json!({ "task": task, "does": does, "count": n }));
    object.insert("confusion".into(), cells.collect());
    Value::Object(object)
}

fn insert_scores(object: &mut Map<String, Value>, before: &str, scores: Scores) {
    for (prefix, score) in [("", scores.plain), ("skipping_", scores.skipping)] {
        let mut add =
            |name: &str, value: Value| object.insert(format!("{before}{prefix}{name}"), value);
        let [precision, recall, f1] = score.figures(scores.total);
        add("total", scores.total.into());
        add("answered", score.answered.into());
        add("correct", score.correct.into());
        add("precision", precision.into());
        add("recall", recall.into());
        add("f1", f1.into());
    }
}

/// Everything of a report, in lines.
pub(crate) fn report_text(report: &Report) -> String {
    let paper = report.scores(Ties::Abstain);
    let resolved = report.scores(Ties::Refer);
    let intervals = report.intervals(Ties::Abstain);
    let commands = if paper.total == 1 { "command" } else { "commands" };
    let mut lines = vec![format!("{} {commands} (95 % intervals in brackets)", paper.total)];
    let (plain, skipping) = intervals.split_at(3);
    lines.push(line("without skipping", paper.plain, paper.total, plain));
    lines.push(line("with skipping", paper.skipping, paper.total, skipping));
    lines.push("ties broken by which form refers".to_owned());
    lines.push(line("without skipping", resolved.plain, paper.total, &[]));
    lines.push(line("with skipping", resolved.skipping, paper.total, &[]));
    if report.marks.iter().any(|mark| mark.task.is_some()) {
        lines.extend(task_lines(report));
    }
    lines.join("\n")
}

fn line(name: &str, score: Score, total: usize, intervals: &[(f64, f64)]) -> String {
    let names = ["precision", "recall", "F1"];
    let mut text =
        format!("  {name:<16}  answered {:>5}  correct {:>5}", score.answered, score.correct);
    for (i, (name, figure)) in names.into_iter().zip(score.figures(total)).enumerate() {
        text += &format!("  {name} {figure:.3}");
        if let Some((low, high)) = intervals.get(i) {
            text += &format!(" [{low:.3}, {high:.3}]");
        }
    }
    text
}

/// A line a task, and what its wrong answers would have done.
fn task_lines(report: &Report) -> Vec<String> {
    let name = |task: Option<&str>| task.unwrap_or("(no label)").to_owned();
    let tasks = report.tasks(Ties::Abstain);
    let width = tasks.keys().map(|task| name(*task).chars().count()).max().unwrap_or(0);
    let mut lines = vec![format!(
        "{:<width$}  total  answered  correct     F1  F1 with skipping  wrong answers do",
        "task"
    )];
    for (task, scores) in tasks {
        let (plain, skipping) = (scores.plain, scores.skipping);
        let cells = report.confusion.cells().filter(|(of, _, _)| *of == task);
        let wrong: Vec<String> =
            cells.map(|(_, does, n)| format!("{}: {n}", does.unwrap_or("none"))).collect();
        let line = format!(
            "{:<width$}  {:>5}  {:>8}  {:>7}  {:.3}  {:>16.3}  {}",
            name(task),
            scores.total,
            plain.answered,
            plain.correct,
            plain.f1(scores.total),
            skipping.f1(scores.total),
            wrong.join(", "),
        );
        lines.push(line.trim_end().to_owned());
    }
    lines
}
