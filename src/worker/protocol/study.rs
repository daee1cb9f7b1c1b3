//! What is asked of the learner about studies, and what it says: drawing pairs, and answers under review, which it keeps. A
//! study and its answers cross as their files; of each answer the page has what stands in a line of its table.

use super::learning::CorpusFile;
use crate::corpus::Decision;
use crate::study::Flag;
use crate::study::coverage::Coverage;
use crate::study::survey::SurveyMapping;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// Something to do about a study.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StudyAsk {
    /// Draw pairs for tasks → [`StudySaid::Making`] now and then, then [`StudySaid::Made`].
    Make {
        /// A study without items.
        study: String,
        /// The tasks, as a file of them; the corpus's own if it is empty.
        tasks: String,
        /// Pairs of each item.
        pairs: u32,
        /// Whether the robot's way is shown in their place, whatever the goal.
        has_ways: bool,
        /// Tasks that are there to see whether somebody looks, and the words that an answer must have.
        checks: Vec<(String, String)>,
    },
    /// Take in a file of answers → [`StudySaid::Bringing`] now and then, then [`StudySaid::Brought`].
    Bring(CorpusFile),
    /// Merge all that was brought, held against a study if there is one → [`StudySaid::Reviewed`], or
    /// [`StudySaid::Trials`] where nothing but another program's trials was brought since.
    Review(Option<CorpusFile>),
    /// Take another program's trials as answers → [`StudySaid::Converted`].
    Convert(SurveyMapping),
    /// Ask a model, by its file's text, about all answers → [`StudySaid::Judging`] now and then, then
    /// [`StudySaid::Reviewed`].
    Judge(String),
    /// Decide something of answers, by their names → [`StudySaid::Counted`].
    Decide(Vec<(String, Decision)>),
    /// What an answer was said of → [`StudySaid::Shown`].
    Show(String),
    /// Write a file → [`StudySaid::Written`], or [`StudySaid::Enough`].
    Write {
        /// Which.
        what: Sheet,
        /// What pseudonyms are made of; nothing for names as they are.
        key: String,
        /// Whether what is not approved is left out.
        approved_only: bool,
    },
}

/// A file that is made of answers under review.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Sheet {
    /// Batch results.
    Table,
    /// Lines of JSON.
    Lines,
    /// Lines of JSON for training, without answers that no corpus takes.
    Corpus,
    /// What is owed to whom.
    Pay,
    /// A study of what has fewer answers than this.
    TopUp(u32),
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StudySaid {
    /// So many items of so many have their pairs.
    Making(u32, u32),
    /// A study.
    Made {
        /// Its file.
        study: String,
        /// What the pairs of some items leave open.
        open: Vec<String>,
    },
    /// So many bytes of the file are read.
    Bringing(u32),
    /// A file was read.
    Brought,
    /// What was brought are another program's trials.
    Trials {
        /// How many.
        trials: u32,
        /// The paths of their values.
        paths: Vec<String>,
        /// Which value is what, as far as the names tell.
        mapping: SurveyMapping,
    },
    /// Trials were taken.
    Converted {
        /// Answers among them.
        answers: u32,
        /// Trials without one.
        others: u32,
        /// Answers of people who did not finish, which are left out.
        unfinished: u32,
    },
    /// So many answers of so many are judged.
    Judging(u32, u32),
    /// The answers as they stand.
    Reviewed(Box<Reviewed>),
    /// How far each task has come.
    Counted(Vec<Coverage>),
    /// What an answer was said of.
    Shown {
        /// Its name.
        id: String,
        /// JSON of its pairs and runs.
        shows: String,
    },
    /// A file.
    Written {
        /// Which.
        what: Sheet,
        /// It.
        file: CorpusFile,
        /// Answers left out of it that no corpus takes.
        unfit: u32,
    },
    /// Every task has enough answers.
    Enough,
}

/// Answers under review.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Reviewed {
    /// Each once.
    pub rows: Vec<AnswerLine>,
    /// How far each task has come.
    pub coverage: Vec<Coverage>,
    /// Answers that came again, and those to other studies.
    pub left_out: [u32; 2],
    /// What is wrong with files.
    pub flaws: Vec<String>,
    /// Whether a model was asked about them.
    pub is_judged: bool,
}

/// An answer as it stands in the table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct AnswerLine {
    /// Its name.
    pub id: String,
    /// What was said.
    pub command: String,
    /// The label of its task.
    pub task: Option<String>,
    /// Who said it.
    pub worker: String,
    /// What seems careless about it.
    pub flags: BTreeSet<Flag>,
    /// What was decided of it.
    pub decision: Decision,
}

impl StudyAsk {
    /// Whether it is answered at once and replaces nothing.
    pub const fn is_aside(&self) -> bool {
        matches!(self, StudyAsk::Decide(_) | StudyAsk::Show(_) | StudyAsk::Write { .. })
    }
}
