//! Writes batch results: rows under their own columns with what was decided of them, or under the platform's.

use super::admit::decision;
use super::example::{Corpus, Decision, Example, Pair};
use super::mapping::Mapping;
use super::role::{APPROVE, COMMAND, POST, PRE, REASON, RUN, Role, STATUS, TASK};
use super::run;
use crate::domain::State;
use std::io::Write;

/// The columns of a batch-results file before those of the task's own inputs and answers.
const PLATFORM: [&str; 27] = [
    "HITId",
    "HITTypeId",
    "Title",
    "Description",
    "Keywords",
    "Reward",
    "CreationTime",
    "MaxAssignments",
    "RequesterAnnotation",
    "AssignmentDurationInSeconds",
    "AutoApprovalDelayInSeconds",
    "Expiration",
    "NumberOfSimilarHITs",
    "LifetimeInSeconds",
    "AssignmentId",
    "WorkerId",
    "AssignmentStatus",
    "AcceptTime",
    "SubmitTime",
    "AutoApprovalTime",
    "ApprovalTime",
    "RejectionTime",
    "RequesterFeedback",
    "WorkTimeInSeconds",
    "LifetimeApprovalRate",
    "Last30DaysApprovalRate",
    "Last7DaysApprovalRate",
];

/// Writes a corpus as a batch-results file.
///
/// # Errors
/// Those of `out`.
pub fn write(corpus: &Corpus, out: impl Write) -> std::io::Result<()> {
    let rows = corpus.examples.iter().map(|example| (example, &example.decision));
    write_rows(&corpus.columns, &corpus.mapping, rows, out)
}

/// Writes rows, each with what was decided of it, as a batch-results file: with these columns, if there are any, and those
/// that the decisions need; otherwise with the platform's. Every cell is quoted, lines end in CR LF, as the platform
/// writes them.
///
/// # Errors
/// Those of `out`.
pub fn write_rows<'a>(
    columns: &[String],
    mapping: &Mapping,
    rows: impl Iterator<Item = (&'a Example, &'a Decision)> + Clone,
    out: impl Write,
) -> std::io::Result<()> {
    let own: Vec<Role> = columns.iter().map(|column| mapping.role(column)).collect();
    let is_decided =
        |(example, decision): &(&Example, &Decision)| kept_decision(&own, example) != **decision;
    let missing = match columns {
        [] => {
            let most = |count: fn(&Example) -> usize| {
                rows.clone().map(|(example, _)| count(example)).max().unwrap_or(0)
            };
            standard_columns(most(|row| pairs(row).count()), most(|row| runs(row).count()))
        }
        _ if rows.clone().any(|row| is_decided(&row)) => missing_columns(columns, &own),
        _ => Vec::new(),
    };
    let mut out = csv::WriterBuilder::new()
        .quote_style(csv::QuoteStyle::Always)
        .terminator(csv::Terminator::CRLF)
        .from_writer(out);
    out.write_record(columns.iter().chain(&missing))?;
    let roles: Vec<Role> =
        own.iter().copied().chain(missing.iter().map(|name| Role::of(name))).collect();
    for row in rows {
        let (example, decision) = row;
        let is_decided = is_decided(&row);
        let mut rest = example.rest.iter();
        for &role in &roles {
            let kept = if role.is_kept_apart() { None } else { rest.next() };
            let state = |n: usize, pick: fn(&Pair) -> &State| {
                pairs(example).nth(n - 1).map(|pair| pick(pair).write()).unwrap_or_default()
            };
            let cell = match (role, kept) {
                (Role::Task, _) => example.task.clone().unwrap_or_default(),
                (Role::Pre(n), _) => state(n, |pair| &pair.pre),
                (Role::Post(n), _) => state(n, |pair| &pair.post),
                (Role::Run(n), _) => runs(example).nth(n - 1).unwrap_or_default(),
                (Role::Command, _) => example.command.clone(),
                (Role::Status | Role::Approve | Role::Reason, _) if is_decided => {
                    decided(role, decision).to_owned()
                }
                (_, Some(kept)) => kept.to_owned(),
                (Role::Id, None) => example.id.clone(),
                (Role::Worker, None) => example.worker.clone().unwrap_or_default(),
                // What came from no table was approved.
                (Role::Status | Role::Approve, None) if columns.is_empty() => {
                    decided(role, &Decision::Approved).to_owned()
                }
                (_, None) => String::new(),
            };
            out.write_field(cell)?;
        }
        out.write_record(None::<&[u8]>)?;
    }
    out.flush()
}

/// What a cell says of a decision.
fn decided(role: Role, decision: &Decision) -> &str {
    match (role, decision) {
        (Role::Status, Decision::Open) => "Submitted",
        (Role::Status, Decision::Approved) => "Approved",
        (Role::Status, Decision::Rejected(_)) => "Rejected",
        (Role::Approve, Decision::Approved) => "x",
        (Role::Reason, Decision::Rejected(reason)) => reason,
        _ => "",
    }
}

/// What the cells that an example kept of its table say was decided.
fn kept_decision(roles: &[Role], example: &Example) -> Decision {
    let kept = roles.iter().filter(|role| !role.is_kept_apart()).zip(example.rest.iter());
    let mut cells = [None; 3];
    for (role, cell) in kept {
        match role {
            Role::Status => cells[0] = Some(cell),
            Role::Approve => cells[1] = Some(cell),
            Role::Reason => cells[2] = Some(cell),
            _ => {}
        }
    }
    let [status, approve, reason] = cells;
    decision(status, approve, reason)
}

/// The columns that a table lacks to say what was decided.
fn missing_columns(columns: &[String], roles: &[Role]) -> Vec<String> {
    let wanted = [(STATUS, Role::Status), (APPROVE, Role::Approve), (REASON, Role::Reason)];
    let lacks = |(name, role): &(&str, Role)| {
        !roles.contains(role) && !columns.iter().any(|column| column == name)
    };
    wanted.into_iter().filter(lacks).map(|(name, _)| name.to_owned()).collect()
}

/// Demonstrations whose way is not known.
fn pairs(example: &Example) -> impl Iterator<Item = &Pair> {
    example.pairs.iter().filter(|pair| pair.way.is_none())
}

/// The others, as cells.
fn runs(example: &Example) -> impl Iterator<Item = String> {
    example.pairs.iter().filter_map(|pair| run::write(&pair.pre, pair.way.as_deref()?))
}

/// The platform's columns for so many pairs and runs; for a pair where there is neither.
fn standard_columns(n_pairs: usize, n_runs: usize) -> Vec<String> {
    let mut columns: Vec<String> = PLATFORM.iter().map(|&name| name.to_owned()).collect();
    columns.push(TASK.to_owned());
    for i in 1..=if n_runs == 0 { n_pairs.max(1) } else { n_pairs } {
        columns.push(format!("{PRE}{i}"));
        columns.push(format!("{POST}{i}"));
    }
    columns.extend((1..=n_runs).map(|i| format!("{RUN}{i}")));
    columns.extend([COMMAND, APPROVE, REASON].map(str::to_owned));
    columns
}
