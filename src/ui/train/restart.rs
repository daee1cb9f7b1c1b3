//! A new engine takes an old one's place.

use super::state::State;
use super::{data, run};
use crate::ui::page::engines;
use crate::worker::protocol::Program;

/// Starts a new engine: it is given its corpus, asked all that was done to it, and goes on with the
/// run that was at work.
pub(super) fn restart(State { desk, data, run, .. }: &mut State, program: Program) {
    engines::restart(desk, program);
    data::open::restore(data, desk);
    run::update::restore(run, desk);
}
