//! Which column of a file says what, where the columns have names of their own: proposed from the names, mended by a
//! person, kept as a file of JSON. The same holds for the keys of JSON objects.

use super::flaw::{Wrong, some};
use super::header::{APPROVE, COMMAND, FORM, ID, POST, PRE, REASON, Role, STATUS, TASK, WORKER};
use super::limits::MAX_PAIRS;
use serde::{Deserialize, Serialize};

/// What a mapping's file calls itself.
const FORMAT: &str = "groundling mapping";
/// The version of its form.
const VERSION: u32 = 1;

/// Columns by name. The default names none: then every column is what its own name says, as batch results have it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(expecting = "a mapping: {command, pairs: [{pre, post}]}", deny_unknown_fields)]
pub struct Mapping {
    /// What was said.
    pub command: Option<String>,
    /// The label of the task.
    pub task: Option<String>,
    /// Who said it.
    pub worker: Option<String>,
    /// The name of the answer.
    pub id: Option<String>,
    /// Whether it was approved or rejected.
    pub status: Option<String>,
    /// A mark that it is to be approved.
    pub approve: Option<String>,
    /// Why it is rejected.
    pub reject: Option<String>,
    /// The states of each demonstration.
    pub pairs: Vec<States>,
}

/// The columns of one demonstration.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(missing_docs, reason = "before and after")]
pub struct States {
    pub pre: String,
    pub post: String,
}

/// A mapping as a file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    format: String,
    version: u32,
    columns: Mapping,
}

impl Mapping {
    /// Whether it names no column.
    pub fn is_empty(&self) -> bool {
        self.named().next().is_none()
    }

    /// Whether it names all that a table must have.
    pub fn is_complete(&self) -> bool {
        self.command.is_some() && !self.pairs.is_empty()
    }

    /// The columns that it names.
    pub fn named(&self) -> impl Iterator<Item = &str> {
        let Mapping { command, task, worker, id, status, approve, reject, pairs } = self;
        let single = [command, task, worker, id, status, approve, reject].into_iter().flatten();
        let pairs = pairs.iter().flat_map(|States { pre, post }| [pre, post]);
        single.chain(pairs).map(String::as_str)
    }

    /// What a column is to us.
    pub fn role(&self, column: &str) -> Role {
        if self.is_empty() {
            return Role::of(column);
        }
        let Mapping { command, task, worker, id, status, approve, reject, pairs } = self;
        let single = [
            (command, if column == FORM { Role::Form } else { Role::Command }),
            (task, Role::Task),
            (worker, Role::Worker),
            (id, Role::Id),
            (status, Role::Status),
            (approve, Role::Approve),
            (reject, Role::Reason),
        ];
        let is_it = |(name, _): &(&Option<String>, Role)| name.as_deref() == Some(column);
        if let Some((_, role)) = single.into_iter().find(is_it) {
            return role;
        }
        let numbered = (1..).zip(pairs);
        let state = |(n, states): (usize, &States)| match column {
            _ if states.pre == column => Some(Role::Pre(n)),
            _ if states.post == column => Some(Role::Post(n)),
            _ => None,
        };
        numbered.filter_map(state).next().unwrap_or(Role::Other)
    }

    /// Why it cannot be a mapping for columns of these names.
    ///
    /// # Errors
    /// The column that it names twice, or that is not there; or that it names too little, or too much.
    pub(super) fn check(&self, columns: &[String]) -> Result<(), Wrong> {
        if self.is_empty() {
            return Ok(());
        }
        let mend = "map the columns anew";
        if !self.is_complete() || self.pairs.len() > MAX_PAIRS {
            let what = format!("a mapping names the command and 1 to {MAX_PAIRS} pairs of states");
            return Err(Wrong::with_mend(what, mend));
        }
        let mut seen: Vec<&str> = Vec::new();
        for name in self.named() {
            if seen.contains(&name) {
                return Err(Wrong::with_mend(format!("the mapping names {name} twice"), mend));
            }
            if !columns.iter().any(|column| column == name) {
                let found = some(columns.iter().map(String::as_str));
                let what = format!("the mapped column {name} is missing (found: {found})");
                return Err(Wrong::with_mend(what, mend));
            }
            seen.push(name);
        }
        Ok(())
    }

    /// A mapping for columns of these names, as far as the names tell: those of batch results, or words in them such as
    /// `instruction`, `before_1` and `annotator`.
    pub fn propose(columns: &[String]) -> Mapping {
        let mut free: Vec<&String> = columns.iter().filter(|name| name.len() < 80).collect();
        let mut take = |usual: &[&str], words: &[&str]| {
            let by_name = |name: &&String| usual.iter().any(|usual| *usual == name.as_str());
            let by_word = |name: &&String| parts(name).iter().any(|part| words.contains(&&**part));
            let at = free.iter().position(by_name).or_else(|| free.iter().position(by_word))?;
            Some(free.remove(at).clone())
        };
        let command = take(
            &["command", COMMAND, FORM],
            &["command", "instruction", "utterance", "sentence", "text", "said"],
        );
        let task = take(&["task", TASK], &["task", "label"]);
        let worker =
            take(&["worker", WORKER], &["worker", "annotator", "participant", "user", "speaker"]);
        let id = take(&["id", ID], &["assignment", "id"]);
        let status = take(&[STATUS], &["status"]);
        let approve = take(&[APPROVE], &["approve", "approved"]);
        let reject = take(&[REASON], &["reject", "rejected", "reason"]);
        Mapping { command, task, worker, id, status, approve, reject, pairs: states(&free) }
    }

    /// Reads a mapping's file.
    ///
    /// # Errors
    /// What is wrong with it, and where.
    pub fn read(text: &str) -> Result<Mapping, Wrong> {
        let File { format, version, columns } = super::cell::json(text)?;
        if format != FORMAT || version != VERSION {
            let what = format!("this is {format:?}, version {version}, and no mapping of columns");
            let mend = format!("a mapping is {FORMAT:?}, version {VERSION}");
            return Err(Wrong::with_mend(what, mend));
        }
        Ok(columns)
    }

    /// The mapping as a file.
    pub fn write(&self) -> String {
        let file = File { format: FORMAT.to_owned(), version: VERSION, columns: self.clone() };
        // A mapping always has a JSON form: it is made of texts.
        serde_json::to_string_pretty(&file).unwrap_or_default() + "\n"
    }
}

/// The states that the names of columns tell: each before with the after of its number.
fn states(free: &[&String]) -> Vec<States> {
    let numbered = |words: &[&str], usual: &str| {
        let mut all: Vec<(usize, &String)> = Vec::new();
        for &name in free {
            let parts = parts(name);
            let is_state = name.starts_with(usual) || parts.iter().any(|p| words.contains(&&**p));
            let number = parts.iter().rev().find_map(|part| part.parse().ok()).unwrap_or(0);
            if is_state && !all.iter().any(|(other, _)| *other == number) {
                all.push((number, name));
            }
        }
        all
    };
    let before = numbered(&["pre", "before", "initial", "start", "from"], PRE);
    let after = numbered(&["post", "after", "final", "goal", "end", "to"], POST);
    let pair = |(n, pre): &(usize, &String)| {
        let (_, post) = after.iter().find(|(other, _)| other == n)?;
        Some((*n, States { pre: (*pre).clone(), post: (*post).clone() }))
    };
    let mut pairs: Vec<(usize, States)> = before.iter().filter_map(pair).collect();
    pairs.sort_by_key(|(n, _)| *n);
    pairs.into_iter().map(|(_, states)| states).collect()
}

/// The words and numbers of a name, in lower case: `preState_1` has three.
fn parts(name: &str) -> Vec<String> {
    let mut parts: Vec<String> = Vec::new();
    let mut before = ' ';
    for c in name.chars() {
        let goes_on = c.is_alphanumeric()
            && before.is_alphanumeric()
            && c.is_numeric() == before.is_numeric()
            && !(c.is_uppercase() && before.is_lowercase());
        if c.is_alphanumeric() {
            let lower = c.to_lowercase();
            match parts.last_mut() {
                Some(part) if goes_on => part.extend(lower),
                _ => parts.push(lower.collect()),
            }
        }
        before = c;
    }
    parts
}
