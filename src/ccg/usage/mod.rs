//! How words are used where they stand: by what stands around them some of their categories are none that they have there.

mod standing;
mod denials;
mod joints;
mod limits;
mod verbs;
pub(crate) mod rules;
