//! The settings of training, and how a model file tells them.

use super::planning::Planning;
use crate::ccg::{ChartConfig, Kind, Kinds, Model};

/// The settings of a training run; the default is the paper's.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// Passes over the corpus.
    pub epochs: u32,
    /// Edges kept per span when parsing.
    pub beam: u32,
    /// Edges kept per span when generating lexical entries.
    pub lexical_beam: u32,
    /// Pairs of each example that are looked at, from the first; all when `None`.
    pub demonstrations: Option<u32>,
    /// By how much a valid reading is to outscore an invalid one.
    pub margin: f64,
    /// The seed of the order of examples, which is another in each epoch: corpora come sorted by task.
    pub seed: u32,
    /// Derivations tried in a chart.
    pub budget: usize,
    /// Derivations tried in each chart of lexical generation: what is longer is not learned from.
    pub lexical_budget: usize,
    /// Epochs, from the first, in which entries are generated for sentences that the lexicon cannot explain.
    pub generations: u32,
    /// Whether commands that recur may become idioms when training is over.
    pub idioms: bool,
    /// Whether the contrasts of runs are looked at.
    pub contrasts: bool,
    /// Kinds of features that are done without.
    pub without: Kinds,
    /// The planner that the paper's Table III compares against; `None` learns as the paper does.
    pub planning: Option<Planning>,
}

impl Default for Config {
    fn default() -> Self {
        Config {
            epochs: 15,
            beam: 150,
            lexical_beam: 75,
            demonstrations: None,
            margin: 2.0,
            seed: 0,
            budget: ChartConfig::default().budget,
            lexical_budget: 20_000,
            generations: 2,
            idioms: true,
            contrasts: true,
            without: Kinds::NONE,
            planning: None,
        }
    }
}

impl Config {
    /// Passes over the corpus in all: in the last one, idioms are looked for.
    pub fn passes(&self) -> u32 {
        self.epochs + u32::from(self.idioms)
    }

    /// The settings that a model was trained with, as far as its facts tell, otherwise the default.
    pub fn of(model: &Model) -> Self {
        fn fact<T: std::str::FromStr>(model: &Model, name: &str, default: T) -> T {
            model.facts.get(name).and_then(|text| text.parse().ok()).unwrap_or(default)
        }
        let default = Config::default();
        Config {
            epochs: fact(model, "epochs", default.epochs),
            beam: fact(model, "beam", default.beam),
            lexical_beam: fact(model, "lexical_beam", default.lexical_beam),
            demonstrations: model.facts.get("demonstrations").and_then(|n| n.parse().ok()),
            margin: fact(model, "margin", default.margin),
            seed: fact(model, "seed", default.seed),
            budget: fact(model, "budget", default.budget),
            lexical_budget: fact(model, "lexical_budget", default.lexical_budget),
            generations: fact(model, "generations", default.generations),
            idioms: fact(model, "idioms", default.idioms),
            contrasts: fact(model, "contrasts", default.contrasts),
            without: model.facts.get("without").map(|names| kinds(names)).unwrap_or_default(),
            planning: None,
        }
    }

    /// The settings as facts of a model file.
    pub(super) fn facts(&self) -> Vec<(&'static str, String)> {
        let demonstrations = self.demonstrations.map_or("all".to_owned(), |n| n.to_string());
        let mut facts = vec![
            ("epochs", self.epochs.to_string()),
            ("beam", self.beam.to_string()),
            ("lexical_beam", self.lexical_beam.to_string()),
            ("demonstrations", demonstrations),
            ("margin", self.margin.to_string()),
            ("seed", self.seed.to_string()),
            ("budget", self.budget.to_string()),
            ("lexical_budget", self.lexical_budget.to_string()),
            ("generations", self.generations.to_string()),
            ("idioms", self.idioms.to_string()),
        ];
        if !self.contrasts {
            facts.push(("contrasts", self.contrasts.to_string()));
        }
        if !self.without.is_empty() {
            let names: Vec<&str> = self.without.iter().map(Kind::name).collect();
            facts.push(("without", names.join(" ")));
        }
        facts
    }
}

/// Kinds by their names; other names are none.
fn kinds(names: &str) -> Kinds {
    names.split(' ').filter_map(Kind::named).collect()
}
