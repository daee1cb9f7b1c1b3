//! Cleanup World as an object-oriented MDP (MacGlashan et al. 2015; Diuk et al. 2008). Knows no language.

pub mod object;
pub mod state;

pub use object::{Agent, Bounds, Color, Direction, Door, Lock, Object, Room, Shape, Size};
pub use state::State;
