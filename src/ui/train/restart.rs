//! A new engine takes an old one's place.

use super::state::State;
use super::{data, run, study};
use crate::ui::page::engines;
use crate::worker::protocol::Program;

/// Starts a new engine: it is given its corpus and its answers, asked all that was done to them, and goes on with the
/// run that was at work.
pub(super) fn restart(State { desk, data, run, study, .. }: &mut State, program: Program) {
    engines::restart(desk, program);
    data::open::restore(data, desk);
    study::files::restore(study, desk);
    run::update::restore(run, desk);
}
