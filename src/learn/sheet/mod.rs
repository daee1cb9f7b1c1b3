//! A corpus as a person works on it: rows with what was decided of them, which half they are in and what a model makes
//! of them; looked at through filters a window at a time, changed in ways that can be undone. Pure data, no ids.

pub mod row;
pub mod rows;
pub mod view;
pub mod change;
pub mod care;
pub mod decided;

pub use care::Rules;
pub use change::{Deed, Done, Verdict};
pub use row::{Half, Line, Outcome, Rule, Source, Status};
pub use rows::{Care, Sheet};
pub use view::{Facet, Facets, Sort, View, Window};
