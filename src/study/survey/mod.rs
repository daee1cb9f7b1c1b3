//! What other programs collected: jsPsych's data as CSV or JSON, and psiTurk's three downloads. Files become trials
//! (`trials`), each a set of named values; a mapping (`mapping`) says which of them are the command and the states; and
//! the trials that have both become lines of a corpus (`convert`).

mod python;
pub mod trials;
pub mod mapping;
pub mod convert;

pub use convert::{Converted, convert};
pub use mapping::SurveyMapping;
pub use trials::{Trials, trials};
