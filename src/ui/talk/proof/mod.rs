//! A derivation drawn as the field draws it: the words on top, a category under each, and for every step a line with
//! the rule's name at its right and what was made below it (Steedman, *The Syntactic Process*, 2000).
//!
//! Invariants, tested: no two texts overlap, and a part lies within the breadth of what was made of it.

mod font;
mod layout;
mod walk;
mod svg;

pub use font::Kind;
pub use layout::{Area, Line, Proof, Text};
pub use svg::svg;
pub use walk::{Toward, step};
