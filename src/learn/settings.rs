//! The settings of a run as a person gives them, and as files and messages carry them: plain data, with what is known
//! beforehand among them.

use super::config::Config;
use super::seed::{CLEANUP_LEXICON, DEMONSTRATION_LEXICON, seed_model};
use crate::ccg::{Kind, Model};
use serde::{Deserialize, Serialize};

/// What is known before training.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SeedLexicon {
    /// A few colours and function words: nouns and verbs are learned, as in the paper's Section VII.
    Demonstration,
    /// The English of the whole domain.
    Domain,
}

/// What is known before training, or a text of one's own.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Lexicon {
    /// One of the two that are here.
    Here(SeedLexicon),
    /// The text of another.
    Own(String),
}

/// The settings of a training run; the default is the paper's, with the lexicon of the whole domain.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(expecting = "the settings of a run", deny_unknown_fields)]
pub struct Settings {
    /// What is known beforehand.
    pub lexicon: Lexicon,
    /// See [`Config`], as for all that follow.
    pub epochs: u32,
    /// Edges kept per span when parsing.
    pub beam: u32,
    /// Edges kept per span when generating lexical entries.
    pub lexical_beam: u32,
    /// Pairs of each row that are looked at, from the first; all when `None`.
    pub demonstrations: Option<u32>,
    /// By how much a valid reading is to outscore an invalid one.
    pub margin: f64,
    /// The seed of the order of examples.
    pub seed: u32,
    /// Derivations tried in a chart.
    pub budget: u32,
    /// Derivations tried in each chart of lexical generation.
    pub lexical_budget: u32,
    /// Epochs in which entries are generated.
    pub generations: u32,
    /// Whether commands that recur may become idioms.
    pub idioms: bool,
    /// Whether the contrasts of runs are looked at.
    #[serde(default = "contrasts")]
    pub contrasts: bool,
    /// Kinds of features that are done without.
    pub without: Vec<Kind>,
}

/// Settings that say nothing of contrasts look at them.
const fn contrasts() -> bool {
    true
}

impl Default for Settings {
    fn default() -> Self {
        let paper = Config::default();
        Settings {
            lexicon: Lexicon::Here(SeedLexicon::Domain),
            epochs: paper.epochs,
            beam: paper.beam,
            lexical_beam: paper.lexical_beam,
            demonstrations: paper.demonstrations,
            margin: paper.margin,
            seed: paper.seed,
            budget: paper.budget as u32,
            lexical_budget: paper.lexical_budget as u32,
            generations: paper.generations,
            idioms: paper.idioms,
            contrasts: paper.contrasts,
            without: paper.without.iter().collect(),
        }
    }
}

impl Settings {
    /// The settings as training takes them.
    ///
    /// # Errors
    /// In words, which of them cannot be.
    pub fn config(&self) -> Result<Config, String> {
        let limits = [
            ("epochs", self.epochs, 1..=1_000),
            ("beam", self.beam, 1..=10_000),
            ("lexical beam", self.lexical_beam, 1..=10_000),
            ("demonstrations", self.demonstrations.unwrap_or(1), 1..=1_000),
            ("budget", self.budget, 1..=10_000_000),
            ("lexical budget", self.lexical_budget, 1..=10_000_000),
            ("epochs with new entries", self.generations, 0..=1_000),
        ];
        for (name, value, range) in limits {
            if !range.contains(&value) {
                let (least, most) = range.into_inner();
                return Err(format!("The {name} must be between {least} and {most}."));
            }
        }
        if !(0.0..=1_000.0).contains(&self.margin) {
            return Err("The margin must be between 0 and 1000.".to_owned());
        }
        Ok(Config {
            epochs: self.epochs,
            beam: self.beam,
            lexical_beam: self.lexical_beam,
            demonstrations: self.demonstrations,
            margin: self.margin,
            seed: self.seed,
            budget: self.budget as usize,
            lexical_budget: self.lexical_budget as usize,
            generations: self.generations,
            idioms: self.idioms,
            contrasts: self.contrasts,
            without: self.without.iter().copied().collect(),
            planning: None,
        })
    }

    /// The model that knows what is known beforehand, and nothing else.
    ///
    /// # Errors
    /// In words, with the line of the lexicon that is wrong.
    pub fn seed_model(&self) -> Result<Model, String> {
        let text = match &self.lexicon {
            Lexicon::Here(SeedLexicon::Demonstration) => DEMONSTRATION_LEXICON,
            Lexicon::Here(SeedLexicon::Domain) => CLEANUP_LEXICON,
            Lexicon::Own(text) => text,
        };
        seed_model(text).map_err(|error| format!("The seed lexicon cannot be read: {error}."))
    }
}
