//! The way from one state to another: actions from a start, a letter each ("nnes"), and other ways from the same start
//! that do not do what was asked. What they lead through is worked out when it is asked for, since a corpus has many.

use super::dynamics::Dynamics;
use super::packing::PackError;
use super::rules::{Action, Form, Rules};
use super::state::State;

/// Actions that a way may have.
pub const MOST_ACTIONS: usize = 1_000;
/// Contrasts that a way may have.
pub const MOST_CONTRASTS: usize = 100;

/// Actions from a start, and contrasts: what a robot would do that leaves out a part of what was said.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Way {
    /// What was done.
    pub actions: Box<[Action]>,
    /// Other actions from the same start, none of which does what was asked, nor does a part of it from the start.
    pub contrasts: Box<[Box<[Action]>]>,
}

impl Way {
    /// The same without contrasts.
    #[must_use]
    pub fn alone(&self) -> Way {
        Way { actions: self.actions.clone(), contrasts: Box::default() }
    }

    /// The states that it leads through from a legal start, the start among them, and those of each contrast.
    ///
    /// # Errors
    /// When the start is too large a world.
    pub fn states(&self, start: &State) -> Result<Vec<Vec<State>>, PackError> {
        let dynamics = Dynamics::new(start, self.rules())?;
        let begin = dynamics.pack(start)?;
        let walk = |actions: &[Action]| {
            let mut at = begin;
            let step = |action: &Action| {
                at = dynamics.step(at, *action);
                dynamics.unpack(at)
            };
            std::iter::once(start.clone()).chain(actions.iter().map(step)).collect()
        };
        Ok(std::iter::once(&self.actions).chain(&self.contrasts).map(|way| walk(way)).collect())
    }

    /// The rules by which its actions are what they are.
    fn rules(&self) -> Rules {
        let all = || std::iter::once(&self.actions).chain(&self.contrasts).flatten();
        let is_robot = |action: &Action| {
            matches!(action, Action::Forward | Action::TurnLeft | Action::TurnRight)
        };
        let form = if all().any(is_robot) { Form::Robot } else { Form::Compass };
        Rules { pull: all().any(|action| *action == Action::Pull), form, ..Rules::default() }
    }
}

/// Actions as letters.
pub fn letters(actions: &[Action]) -> String {
    actions.iter().map(|action| action.letter()).collect()
}

/// Actions of letters; the first letter that is none otherwise.
///
/// # Errors
/// That letter.
pub fn read_letters(text: &str) -> Result<Box<[Action]>, char> {
    let action = |letter: char| {
        Action::ALL.iter().copied().find(|action| action.letter() == letter).ok_or(letter)
    };
    text.chars().map(action).collect()
}
