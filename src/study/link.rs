//! The link by which a person comes: which study, and who they are. Prolific's names, those of a frame as on Mechanical
//! Turk, or none. A value is cut off at its first `=` only, since identifiers may hold more of them.

use super::url::decoded;

/// What a frame's assignment is called while it is only looked at.
const PREVIEW: &str = "ASSIGNMENT_ID_NOT_AVAILABLE";
/// The longest identifier that is taken from a link, in bytes: a longer one is none.
const LONGEST_ID: usize = 200;

/// What stands before a study that is in the link itself, deflated and in letters that an address need not escape.
pub const INLINE: &str = "#study=";
/// The longest study that a link may hold, in letters.
pub const LONGEST: usize = 60_000;

/// What a link says.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Link {
    /// The study's file, beside the page.
    pub study: Option<String>,
    /// Who takes part; nothing where the link does not say.
    pub worker: Option<String>,
    /// What the platform calls this turn of theirs.
    pub assignment: Option<String>,
    /// What the platform calls the whole.
    pub hit: Option<String>,
    /// Where a frame's platform wants its form.
    pub submit_to: Option<String>,
    /// Whether it is only looked at, and nothing recorded.
    pub is_preview: bool,
    /// The seed of a participant that is simulated.
    pub simulate: Option<u32>,
    /// The language that the page is wanted in.
    pub language: Option<String>,
}

impl Link {
    /// What a query says, with or without its `?`.
    pub fn of(query: &str) -> Link {
        let query = query.strip_prefix('?').unwrap_or(query);
        let mut link = Link::default();
        for part in query.split('&').filter(|part| !part.is_empty()) {
            let (name, value) = part.split_once('=').unwrap_or((part, ""));
            let (name, value) = (decoded(name), decoded(value));
            let id = || Some(value.clone()).filter(|v| !v.is_empty() && v.len() <= LONGEST_ID);
            match name.as_str() {
                "study" => link.study = Some(value),
                "workerId" | "PROLIFIC_PID" | "participant" => link.worker = id(),
                "assignmentId" if value == PREVIEW => link.is_preview = true,
                "assignmentId" | "SESSION_ID" => link.assignment = id(),
                "hitId" | "STUDY_ID" => link.hit = id(),
                "turkSubmitTo" => link.submit_to = Some(value),
                "preview" => link.is_preview = true,
                "simulate" => link.simulate = value.parse().ok(),
                "language" => link.language = Some(value),
                _ => {}
            }
        }
        link
    }

    /// Whether the study's file is one beside the page: a name, perhaps in a folder, of this very site.
    pub fn is_beside(file: &str) -> bool {
        let is_name = |c: char| c.is_alphanumeric() || "-_./ ".contains(c);
        !file.is_empty()
            && !file.starts_with('/')
            && file.chars().all(is_name)
            && !file.split('/').any(|part| part == "..")
    }
}
