//! What the workbench tells the page. It crosses between two programs as words, so here is a printer and its reader.

use super::files::Given;

/// What the workbench tells the page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum News {
    /// A screen reader is to tell these words.
    Say(String),
    /// A file that was opened there is for the robot.
    Give(Given),
    /// The robot is to use the model that was learned there.
    Use {
        /// The model.
        text: String,
        /// The name of the corpus that it was learned from.
        corpus: String,
    },
}

impl News {
    /// The news as a kind, a text, and the name of a corpus.
    pub fn words(&self) -> [&str; 3] {
        match self {
            News::Say(words) => ["say", words, ""],
            News::Give(Given::Model(text)) => ["model", text, ""],
            News::Give(Given::Session(text)) => ["session", text, ""],
            News::Use { text, corpus } => ["use", text, corpus],
        }
    }

    /// The news that words are; of a kind that there is not, none.
    pub fn of(kind: &str, text: String, corpus: String) -> Option<News> {
        Some(match kind {
            "say" => News::Say(text),
            "model" => News::Give(Given::Model(text)),
            "session" => News::Give(Given::Session(text)),
            "use" => News::Use { text, corpus },
            _ => return None,
        })
    }
}
