//! Cleanup World as an object-oriented MDP (MacGlashan et al. 2015; Diuk et al. 2008). Knows no language.

pub(crate) mod name;
pub mod misread;
pub mod object;
pub mod cell;
pub mod state;
pub mod layout;
pub mod rules;
pub mod packing;
pub mod dynamics;
mod outcomes;
mod flood;
pub mod leaps;
pub mod generate;
pub mod blueprint;
mod quote;
pub mod text;
pub mod way;
pub mod straight;

pub use blueprint::{Blueprint, BlueprintError, Style};
pub use cell::{Cell, cell_at};
pub use dynamics::Dynamics;
pub use generate::{Plan, generate};
pub use layout::Layout;
pub use leaps::{Carry, Entry, Walks};
pub use name::UnknownName;
pub use object::{Agent, Bounds, Color, Direction, Door, Lock, Object, Room, Shape, Size};
pub use packing::{PackError, Packed};
pub use rules::{Action, Chances, Form, Movable, NotAProbability, Rules};
pub use state::{ReadError, State, StateError};
pub use straight::straight;
pub use text::TextError;
pub use way::{Way, letters, read_letters};
