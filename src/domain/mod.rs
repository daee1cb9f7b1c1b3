//! Cleanup World as an object-oriented MDP (MacGlashan et al. 2015; Diuk et al. 2008). Knows no language.

pub(crate) mod name;
pub mod object;
pub mod layout;
pub mod state;
pub mod dynamics;
pub mod generate;
pub mod text;

pub use dynamics::{Action, Dynamics, PackError, Packed, Rules};
pub use generate::{Plan, generate};
pub use layout::{Cell, Layout, cell_at};
pub use name::UnknownName;
pub use object::{Agent, Bounds, Color, Direction, Door, Lock, Object, Room, Shape, Size};
pub use state::{ReadError, State, StateError};
pub use text::TextError;
