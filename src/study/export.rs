//! Reviewed answers as files: batch results as Mechanical Turk writes them (with what was decided, so that they can be
//! handed back there), lines of JSON, and either with pseudonyms for people. Cells that a spreadsheet would take for a
//! formula get a sign before them, which reading them takes away again.

use super::answer::{Answer, short};
use super::flags::Flag;
use super::review::{Review, Row};
use crate::corpus::{Cells, Decision, Example, Mapping, guarded, jsonl, table};
use std::borrow::Cow;
use std::io;

/// How answers are written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Style {
    /// Lines of JSON instead of batch results.
    pub is_json: bool,
    /// What pseudonyms are made of: whoever has it can tell whose each is. Nothing for the names as they are.
    pub pseudonyms: Option<String>,
    /// Whether what is not approved is left out.
    pub approved_only: bool,
    /// Whether what no corpus takes is left out.
    pub fit_only: bool,
}

/// The columns of batch results before the pairs, and what stands there.
const BEFORE: [&str; 7] = [
    "HITId",
    "AssignmentId",
    "WorkerId",
    "AssignmentStatus",
    "SubmitTime",
    "WorkTimeInSeconds",
    "Input.task",
];
/// Those behind.
const AFTER: [&str; 6] =
    ["Answer.command", "Answer.item", "Answer.turn", "Answer.flags", "Approve", "Reject"];

/// Writes reviewed answers.
///
/// # Errors
/// Those of `out`.
pub fn write(review: &Review, style: &Style, out: impl io::Write) -> io::Result<()> {
    let is_wanted = |row: &&Row| {
        (!style.approved_only || row.decision == Decision::Approved)
            && (!style.fit_only || !row.flags.contains(&Flag::Unfit))
    };
    let rows = || review.rows.iter().filter(is_wanted);
    if style.is_json {
        let examples: Vec<Example> =
            rows().map(|row| named(row.example(Cells::default()), style)).collect();
        return jsonl::write_rows(examples.iter().map(|e| (e, &e.decision)), out);
    }
    let most =
        |count: fn(&Answer) -> usize| rows().map(|row| count(&row.answer)).max().unwrap_or(0);
    let pairs = (1..=most(|answer| answer.pairs.len()))
        .flat_map(|n| [format!("Input.pre_{n}"), format!("Input.post_{n}")]);
    let runs = (1..=most(|answer| answer.runs.len())).map(|n| format!("Input.run_{n}"));
    let columns: Vec<String> = BEFORE
        .iter()
        .map(|&name| name.to_owned())
        .chain(pairs)
        .chain(runs)
        .chain(AFTER.map(str::to_owned))
        .collect();
    let examples: Vec<Example> = rows().map(|row| guard(row.example(rest(row, style)))).collect();
    let rows = examples.iter().map(|example| (example, &example.decision));
    table::write_rows(&columns, &Mapping::default(), rows, out)
}

/// A pseudonym for a person, or for what is named after one; the name itself where none are wanted.
fn alias(name: &str, style: &Style) -> String {
    match &style.pseudonyms {
        Some(key) if !name.is_empty() => format!("P{}", short(&[key, name])),
        _ => name.to_owned(),
    }
}

/// An example with the names that are wanted: a sitting's is made of its participant's.
fn named(example: Example, style: &Style) -> Example {
    let worker = example.worker.as_deref().map(|worker| alias(worker, style));
    Example { id: alias(&example.id, style), worker, ..example }
}

/// The cells of an answer that an example has no place for, in the order of their columns.
fn rest(row: &Row, style: &Style) -> Cells {
    let answer = &row.answer;
    let (id, worker) = (alias(&answer.id, style), alias(&answer.worker, style));
    let assignment = answer.assignment.as_deref().map(|name| alias(name, style));
    let flags: Vec<&str> = row.flags.iter().map(|flag| flag.name()).collect();
    let id = assignment.as_deref().filter(|_| answer.turn[1] == 1).unwrap_or(&id);
    let hit = answer.hit.as_deref().filter(|_| style.pseudonyms.is_none());
    let status = match row.decision {
        Decision::Open => "Submitted",
        Decision::Approved => "Approved",
        Decision::Rejected(_) => "Rejected",
    };
    let seconds = (answer.care.active_ms / 1000).to_string();
    let (approve, reject) = match &row.decision {
        Decision::Open => ("", ""),
        Decision::Approved => ("x", ""),
        Decision::Rejected(why) => ("", &**why),
    };
    let time = time(answer.at);
    let turn = format!("{} of {}", answer.turn[0], answer.turn[1]);
    let flags = flags.join(" ");
    let cells = [
        hit.unwrap_or_default(),
        id,
        &worker,
        status,
        &time,
        &seconds,
        &answer.item,
        &turn,
        &flags,
        approve,
        reject,
    ];
    let guarded: Vec<Cow<'_, str>> = cells.into_iter().map(guarded).collect();
    guarded.iter().map(|cell| &**cell).collect()
}

/// An example whose words no spreadsheet takes for a formula.
fn guard(mut example: Example) -> Example {
    example.command = guarded(&example.command).into_owned();
    example.task = example.task.map(|task| guarded(&task).into_owned());
    if let Decision::Rejected(why) = &mut example.decision {
        *why = guarded(why).into_owned().into();
    }
    example
}

/// Milliseconds since 1970 as a date and time of the world's clock (civil days: Hinnant); nothing for none.
fn time(at: f64) -> String {
    if !(1.0..4e12).contains(&at) {
        return String::new();
    }
    let seconds = (at / 1000.0) as i64;
    let (days, second) = (seconds.div_euclid(86_400), seconds.rem_euclid(86_400));
    let z = days + 719_468;
    let era = z.div_euclid(146_097);
    let doe = z.rem_euclid(146_097);
    let yoe = (doe - doe / 1_460 + doe / 36_524 - doe / 146_096) / 365;
    let doy = doe - (365 * yoe + yoe / 4 - yoe / 100);
    let mp = (5 * doy + 2) / 153;
    let day = doy - (153 * mp + 2) / 5 + 1;
    let month = if mp < 10 { mp + 3 } else { mp - 9 };
    let year = yoe + era * 400 + i64::from(month <= 2);
    let (hour, minute) = (second / 3_600, second % 3_600 / 60);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{:02}Z", second % 60)
}
