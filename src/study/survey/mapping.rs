//! Which values of another program's trials are the command, who said it, and the states: proposed from their names,
//! mended by a person, kept as a file.

use super::trials::{Trials, UNIQUE, at, paths};
use crate::corpus::{Mapping, States, Wrong, json};
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// What its file calls itself.
const FORMAT: &str = "groundling survey mapping";
/// The version of its form.
const VERSION: u32 = 1;

/// Values by their paths.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SurveyMapping {
    /// What was said.
    pub command: String,
    /// Who said it.
    pub worker: Option<String>,
    /// The label of the task.
    pub task: Option<String>,
    /// The states of each pair.
    pub pairs: Vec<States>,
    /// Whether those who did not finish are kept.
    pub with_unfinished: bool,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    format: String,
    version: u32,
    values: SurveyMapping,
}

impl SurveyMapping {
    /// A mapping for these trials, as far as the names tell.
    pub fn propose(trials: &Trials) -> SurveyMapping {
        let paths = paths(&trials.rows);
        let Mapping { command, task, worker, pairs, .. } = Mapping::propose(&paths);
        let is_text = |path: &&String| {
            trials.rows.iter().any(|(_, trial)| matches!(at(trial, path), Some(Value::String(_))))
        };
        let answers = || paths.iter().filter(|path| path.starts_with("response.")).find(is_text);
        let named = |names: &[&str]| paths.iter().find(|path| names.contains(&path.as_str()));
        let who = named(&["PROLIFIC_PID", "workerId", "subject", "subject_id", UNIQUE]);
        SurveyMapping {
            command: command.as_ref().or_else(answers).cloned().unwrap_or_default(),
            worker: who.cloned().or(worker),
            task,
            pairs,
            with_unfinished: false,
        }
    }

    /// Whether it names all that there must be.
    pub fn is_complete(&self) -> bool {
        !self.command.is_empty() && !self.pairs.is_empty()
    }

    /// Reads a mapping's file.
    ///
    /// # Errors
    /// What is wrong with it, and where.
    pub fn read(text: &str) -> Result<SurveyMapping, Wrong> {
        let File { format, version, values } = json::json(text)?;
        if format != FORMAT || version != VERSION {
            let what = format!("this is {format:?}, version {version}, and no mapping of trials");
            return Err(Wrong::with_mend(what, format!("one is {FORMAT:?}, version {VERSION}")));
        }
        Ok(values)
    }

    /// The mapping as a file.
    pub fn write(&self) -> String {
        let file = File { format: FORMAT.to_owned(), version: VERSION, values: self.clone() };
        // A mapping always has a JSON form: it is made of texts.
        serde_json::to_string_pretty(&file).unwrap_or_default() + "\n"
    }
}
