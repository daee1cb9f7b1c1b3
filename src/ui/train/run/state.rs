//! The state of training.

use crate::ui::train::desk::Desk;
use crate::worker::protocol::{Progress, Request, TrainSettings};

/// The paper's settings, which the page trains with.
pub const SETTINGS: TrainSettings =
    TrainSettings { epochs: 15, beam: 150, lexical_beam: 75, demonstrations: None, seed: 0 };

/// All that is known of training.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// How far training is, while it runs.
    pub progress: Option<Progress>,
    /// What came of training, when it is not a model.
    pub notice: Option<String>,
}

/// Whether it is training, or will be as soon as it can.
pub fn is_training(desk: &Desk) -> bool {
    desk.learner.is_at(|request| matches!(request, Request::Train { .. }))
}

/// Whether training on so many commands can begin.
pub fn can_train(desk: &Desk, commands: usize) -> bool {
    commands > 0 && desk.is_ready() && !is_training(desk)
}
