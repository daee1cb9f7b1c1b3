//! Simply typed λ-calculus with hash-consed normal forms: the language of goals. Knows no world.

pub mod order;
pub mod ty;
pub mod signature;
pub mod term;
pub mod sort;
mod reduce;
mod time;
pub mod read;
mod origin;
pub mod expression;
pub mod print;
pub mod mark;
pub mod steps;

pub use expression::Expression;
pub use mark::Marks;
pub use print::{print, print_human};
pub use read::{ReadError, read};
pub use signature::Signature;
pub use sort::Sorts;
pub use steps::steps;
pub use term::{ConstantId, LogicError, Node, TIME, TermId, Terms};
pub use ty::{TyId, Type, Types};
