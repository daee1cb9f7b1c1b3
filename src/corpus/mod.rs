//! Examples in and out: commands with states before and after, as Mechanical Turk's batch-results CSV and as
//! JSON lines. A reader gives good rows and what is wrong with the bad ones; neither stops the other.

pub mod example;
pub mod admit;
pub mod cell;
pub mod record;
pub mod mturk;
pub mod jsonl;
pub mod read;
pub mod split;

pub use admit::Options;
pub use example::{Corpus, Example, Flaw, Pair, Row};
pub use read::{Form, Rows, read};
pub use split::{Fold, folds};
