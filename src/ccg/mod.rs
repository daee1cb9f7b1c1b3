//! Weighted combinatory categorial grammar (Steedman 2000; Clark and Curran 2007) with a factored lexicon
//! (Kwiatkowski et al. 2011). Knows no world: constants are names with types.

pub mod syntax;
pub mod category;
pub mod combinator;
pub mod sentence;
pub mod closed;
pub mod lexicon;
pub mod factor;
pub mod lexicon_text;
pub mod features;
pub mod general;
pub mod doubt;
pub mod model;
mod reach;
mod filling;
pub mod chart;
pub mod absorb;
pub mod lookup;
mod spelling;
pub mod hearing;
pub mod parse;
pub mod derivation;
pub mod forest;
pub mod signs;
pub mod trace;
pub mod explain;

pub use category::Category;
pub use chart::{Chart, ChartConfig, Lexical};
pub use closed::{any_closed, closed};
pub use combinator::{Grammar, RULES, RuleId, Shift};
pub use derivation::Derivation;
pub use doubt::{Doubt, Signs};
pub use explain::{EntryText, Explanation, Part};
pub use features::{Feature, FeatureId, Features, Vector};
pub use forest::Forest;
pub use general::{General, GeneralError, Near, Target};
pub use hearing::Hearing;
pub use lexicon::{EntryId, Hole, LexemeId, Lexicon, Origin, TemplateId};
pub use model::Model;
pub use parse::{Parse, Reading, Reason, parse, parse_words};
pub use sentence::{MAX_WORDS, composed_words, words};
pub use signs::{probability, signs};
pub use spelling::alike;
pub use syntax::{Atom, Direction, Syntax, SyntaxId, Syntaxes};
pub use trace::{Trace, Traced};
