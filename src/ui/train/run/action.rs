//! What a person can do about training.

/// Something that a person did.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Action {
    /// Train on the corpus that is open.
    Train,
    /// Stop training.
    Cancel,
    /// Save the model that the robot uses as a file.
    SaveModel,
}
