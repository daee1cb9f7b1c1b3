//! Logical forms meet the world: what each constant means, what a phrase refers to, which states earn a goal.
//! Determiners are resolved here and only here, in the initial state (invariant 4): a `Goal` (of states) or a `Course`
//! (of runs) cannot be made otherwise.

pub mod class;
pub mod shade;
pub mod thing;
pub mod predicate;
pub mod denote;
pub mod goal;
pub mod outline;
pub mod run;
pub mod monitor;
pub mod course;
pub mod constraint;
mod proposition;
pub mod equivalent;
mod landmarks;
mod cells;
mod distance;
mod wish;
mod grid;
mod pairs;
mod bound;
mod compile;
pub mod task;
mod itinerary;
pub mod errand;
mod strides;
pub mod undertaking;
pub mod lesser;
pub mod relax;
pub mod phrase;
pub mod claim;
mod view;
mod stretch;
pub mod validate;

pub use claim::{Article, Claim, Description, Noun, claim, noun};
pub use class::Class;
pub use constraint::Constraint;
pub use course::Course;
pub use denote::Failure;
pub use equivalent::{CompareError, Comparison, compare};
pub use errand::{Errand, ErrandError, errand};
pub use goal::{Formula, Goal, GoalError};
pub use lesser::lesser;
pub use monitor::{Monitor, Residual, TooMany};
pub use outline::{Outline, Part, Valuation, forbids_idly};
pub use phrase::{Phrase, phrases};
pub use predicate::{Meaning, Measure, ONTOLOGY, PREDICATES, Predicate, Property, Relation};
pub use run::Beginnings;
pub use shade::Shade;
pub use task::{Task, TaskError, World};
pub use thing::{Entity, Thing};
pub use undertaking::{Around, Undertaking};
pub use validate::{PairId, Side, Validator};
