//! Reviewed answers as files: batch results as Mechanical Turk writes them (with what was decided, so that they can be
//! handed back there), lines of JSON, and either with pseudonyms for people. Cells that a spreadsheet would take for a
//! formula get a sign before them, which reading them takes away again.

use super::answer::short;
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
    /// Whether rejected answers are left out.
    pub approved_only: bool,
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
    let alias = |name: &str| match &style.pseudonyms {
        Some(key) if !name.is_empty() => format!("P{}", short(&[key, name])),
        _ => name.to_owned(),
    };
    let mut review = review.clone();
    if style.approved_only {
        review.rows.retain(|row| row.decision == Decision::Approved);
    }
    for row in &mut review.rows {
        let answer = &mut row.answer;
        answer.worker = alias(&answer.worker);
        if style.pseudonyms.is_some() {
            // A sitting's name is made of its participant's.
            answer.id = alias(&answer.id);
            answer.assignment = answer.assignment.as_deref().map(alias);
            answer.hit = None;
        }
    }
    if style.is_json {
        let examples = review.examples(|_| Cells::default());
        return jsonl::write_rows(examples.iter().map(|e| (e, &e.decision)), out);
    }
    let most = review.rows.iter().map(|row| row.answer.pairs.len()).max().unwrap_or(1);
    let pairs = (1..=most).flat_map(|n| [format!("Input.pre_{n}"), format!("Input.post_{n}")]);
    let columns: Vec<String> = BEFORE
        .iter()
        .map(|&name| name.to_owned())
        .chain(pairs)
        .chain(AFTER.map(str::to_owned))
        .collect();
    let examples: Vec<Example> = review.examples(rest).into_iter().map(guard).collect();
    let rows = examples.iter().map(|example| (example, &example.decision));
    table::write_rows(&columns, &Mapping::default(), rows, out)
}

/// The cells of an answer that an example has no place for, in the order of their columns.
fn rest(row: &Row) -> Cells {
    let answer = &row.answer;
    let flags: Vec<&str> = row.flags.iter().map(|flag| flag.name()).collect();
    let id = answer.assignment.as_deref().filter(|_| answer.turn[1] == 1).unwrap_or(&answer.id);
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
        answer.hit.as_deref().unwrap_or_default(),
        id,
        &answer.worker,
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
