//! What the columns of a table are to us, by number: found once, by their names, or by what a person says.

use super::flaw::{Wrong, some};
use super::json::did_you_mean;
use super::limits::MAX_PAIRS;
use super::mapping::Mapping;
use super::role::{COMMAND, POST, PRE, Role};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// The columns of a table by number: which of them are read, and as what.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Header {
    /// The names of all columns, in the file's order.
    pub columns: Vec<String>,
    /// What each is to us.
    pub roles: Vec<Role>,
    /// The columns of each demonstration, before and after, in the order of their numbers.
    pub pairs: Vec<(usize, usize)>,
    /// The columns of each run, in the order of their numbers.
    pub runs: Vec<usize>,
    /// Where the command is said.
    pub command: Option<usize>,
    /// Where a crowd form's answers are, as JSON.
    pub form: Option<usize>,
    /// The label of the task.
    pub task: Option<usize>,
    /// Who said it.
    pub worker: Option<usize>,
    /// The name of the answer.
    pub id: Option<usize>,
    /// Whether it was approved or rejected.
    pub status: Option<usize>,
    /// A mark that it is to be approved.
    pub approve: Option<usize>,
    /// Why it is rejected.
    pub reason: Option<usize>,
}

impl Header {
    /// What the columns of these names are to us.
    ///
    /// # Errors
    /// Which column is missing, or stands there twice.
    pub fn new(columns: Vec<String>, mapping: &Mapping) -> Result<Header, Wrong> {
        mapping.check(&columns)?;
        let roles: Vec<Role> = columns.iter().map(|column| mapping.role(column)).collect();
        let mut header = Header { roles, ..Header::default() };
        let mut states: [FxHashMap<usize, usize>; 2] = Default::default();
        let mut runs: BTreeMap<usize, usize> = BTreeMap::new();
        for (at, (role, column)) in header.roles.iter().zip(&columns).enumerate() {
            let before = match *role {
                Role::Task => header.task.replace(at),
                Role::Command => header.command.replace(at),
                Role::Form => header.form.replace(at),
                Role::Id => header.id.replace(at),
                Role::Worker => header.worker.replace(at),
                Role::Status => header.status.replace(at),
                // Nothing is lost with a second one.
                Role::Approve => header.approve.replace(at).and(None),
                Role::Reason => header.reason.replace(at),
                Role::Pre(n) => states[0].insert(n, at),
                Role::Post(n) => states[1].insert(n, at),
                Role::Run(n) => runs.insert(n, at),
                Role::Other => None,
            };
            if before.is_some() {
                let what = format!("the column {column} stands twice in the header");
                return Err(Wrong::with_mend(what, "delete one"));
            }
        }
        let [before, after] = &states;
        if before.is_empty() && after.is_empty() && runs.is_empty() {
            return Err(missing(&format!("{PRE}1"), &columns));
        }
        for n in 1..=MAX_PAIRS {
            match (before.get(&n), after.get(&n)) {
                (Some(&pre), Some(&post)) => header.pairs.push((pre, post)),
                (None, Some(_)) => return Err(missing(&format!("{PRE}{n}"), &columns)),
                (Some(_), None) => return Err(missing(&format!("{POST}{n}"), &columns)),
                (None, None) => {}
            }
        }
        if header.command.is_none() && header.form.is_none() {
            return Err(missing(COMMAND, &columns));
        }
        header.runs = runs.into_values().collect();
        header.columns = columns;
        Ok(header)
    }

    /// The name of a column, by number.
    pub fn name(&self, at: usize) -> &str {
        self.columns.get(at).map_or("?", String::as_str)
    }

    /// Whether anything is read of a column.
    pub fn is_read(&self, at: usize) -> bool {
        self.roles.get(at).is_some_and(|role| !matches!(role, Role::Other | Role::Approve))
    }
}

fn missing(name: &str, columns: &[String]) -> Wrong {
    let strangers = columns.iter().map(String::as_str);
    let strangers = strangers.filter(|column| column.len() < 80 && Role::of(column) == Role::Other);
    let near = did_you_mean(name, strangers);
    let found = some(columns.iter().map(String::as_str));
    let what = format!("the column {name} is missing (found: {found})");
    match near {
        Some(near) => Wrong::with_mend(what, format!("rename {near}?")),
        None => Wrong::with_mend(
            what,
            format!(
                "the first line names the columns; {PRE}1, {POST}1 and {COMMAND} must be there"
            ),
        ),
    }
}
