//! Learning a parser from commands and the states before and after them: coarse lexical generation and the
//! validation-driven updates (Artzi and Zettlemoyer 2013; Williams et al., Section IV-B). Never plans,
//! but in the baseline of `planning`.

pub mod seed;
pub mod novelty;
pub mod genlex;
pub mod gradient;
pub mod planning;
pub mod config;
pub mod fingerprint;
mod asked;
mod kept;
mod idioms;
mod phase;
mod place;
pub mod progress;
pub mod look;
pub mod settings;
pub mod trainer;
pub mod teach;
pub mod score;
pub mod confusion;
pub mod report;
pub mod reliability;
pub mod evaluate;
pub mod calibrate;
pub mod sheet;
pub mod asking;
pub mod audit;
pub mod inspect;
pub mod experiment;
pub mod paper;
pub mod runs;

pub use audit::Audit;
pub use config::Config;
pub use evaluate::{Evaluation, Judge};
pub use look::Look;
pub use planning::{PlannerCost, Planning, Validation};
pub use progress::{Epoch, Progress};
pub use reliability::Reliability;
pub use report::Report;
pub use score::{Mark, Score, Scores, Ties, Verdict};
pub use seed::{CLEANUP_LEXICON, DEMONSTRATION_LEXICON, seed_model};
pub use settings::{SeedLexicon, Settings};
pub use sheet::Sheet;
pub use teach::{Taught, Teaching, Unfinished, teach};
pub use trainer::Trainer;
