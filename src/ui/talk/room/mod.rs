//! The room, and what a person does in it.

pub mod point;
pub mod edit;
pub mod moved;
pub mod names;
pub mod state;
pub mod worlds;
pub mod hand;
pub mod overlay;
