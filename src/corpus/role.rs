//! What the columns of batch results are to us, by their names. The same names are the fields of JSON that programs make
//! of such a table.

use super::limits::MAX_PAIRS;

pub(super) const TASK: &str = "Input.task";
pub(super) const COMMAND: &str = "Answer.command";
pub(super) const FORM: &str = "Answer.taskAnswers";
pub(super) const PRE: &str = "Input.pre_";
pub(super) const POST: &str = "Input.post_";
pub(super) const RUN: &str = "Input.run_";
pub(super) const ID: &str = "AssignmentId";
pub(super) const WORKER: &str = "WorkerId";
pub(super) const STATUS: &str = "AssignmentStatus";
pub(super) const APPROVE: &str = "Approve";
pub(super) const REASON: &str = "Reject";

/// What a column is to us.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the names say it; see `Header`")]
pub enum Role {
    Task,
    Command,
    Form,
    Id,
    Worker,
    Status,
    Approve,
    Reason,
    Pre(usize),
    Post(usize),
    Run(usize),
    Other,
}

impl Role {
    /// What a column of this name is to us. States are numbered from 1.
    pub fn of(column: &str) -> Role {
        let number = |prefix: &str| {
            let digits = column.strip_prefix(prefix)?;
            let canonical = !digits.starts_with(['0', '+']);
            digits.parse::<usize>().ok().filter(|n| canonical && *n <= MAX_PAIRS)
        };
        match column {
            TASK => Role::Task,
            COMMAND => Role::Command,
            FORM => Role::Form,
            ID => Role::Id,
            WORKER => Role::Worker,
            STATUS => Role::Status,
            APPROVE => Role::Approve,
            REASON => Role::Reason,
            _ => {
                let state =
                    [(PRE, Role::Pre as fn(usize) -> Role), (POST, Role::Post), (RUN, Role::Run)];
                let role = |(prefix, role): (&str, fn(usize) -> Role)| number(prefix).map(role);
                state.into_iter().find_map(role).unwrap_or(Role::Other)
            }
        }
    }

    /// Whether an example has a place of its own for it; the others are kept as they are.
    pub(super) const fn is_kept_apart(self) -> bool {
        matches!(self, Role::Task | Role::Command | Role::Pre(_) | Role::Post(_) | Role::Run(_))
    }
}
