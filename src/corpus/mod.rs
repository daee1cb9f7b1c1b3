//! Examples in and out: commands with states before and after, as Mechanical Turk's batch-results CSV and as JSON. A
//! file goes from bytes to text (`source`), to records or objects (`record`, `items`), to rows (`mturk`, `jsonl`,
//! `draft`) and examples (`read`), in steps. A reader gives good rows and what is wrong with the bad ones; neither stops
//! the other.

pub mod cells;
pub mod limits;
pub mod flaw;
pub mod example;
pub mod admit;
pub mod json;
pub mod cell;
pub mod run;
pub mod formula;
mod packed;
pub mod source;
pub mod role;
pub mod mapping;
pub mod header;
mod draft;
pub mod record;
mod items;
mod form;
mod object;
mod mturk;
pub mod table;
pub mod jsonl;
pub mod read;
pub mod preview;
pub mod split;

pub use admit::Options;
pub use cells::Cells;
pub use example::{BadRows, Corpus, Decision, Example, Pair, Row};
pub use flaw::{Flaw, Wrong};
pub use formula::{guarded, unguarded};
pub use header::Header;
pub use mapping::{Mapping, States};
pub use preview::{Preview, preview};
pub use read::{Reading, Rows, read};
pub use role::Role;
pub use source::text_of;
pub use split::{Fold, folds, leave, share};
