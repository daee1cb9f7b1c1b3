//! What is asked of the learner about studies, and what it says: drawing pairs, and judging answers by a model. A study
//! and its answers cross as the texts of their files.

use crate::study::judge::Verdict;
use serde::{Deserialize, Serialize};

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
    },
    /// Ask a model about answers → [`StudySaid::Judging`] now and then, then [`StudySaid::Judged`].
    Judge {
        /// The model file's text.
        model: String,
        /// The answers, one a line.
        answers: String,
    },
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
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
    /// So many answers of so many are judged.
    Judging(u32, u32),
    /// What the model made of each answer, in order.
    Judged(Vec<Verdict>),
}
