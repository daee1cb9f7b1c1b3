//! What training does next with the command at work: new entries for what nothing explains, unknown words first.

use super::genlex::Scope;

/// Examples of one command for which entries are generated in an epoch: a command that contradicts itself is not
/// to be asked over and over.
const MAX_GENERATIONS: usize = 2;

/// What is done next with the command at work.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Phase {
    /// It is parsed with the lexicon; valid parses, or none to be hoped for, lead to the updates.
    Explain,
    /// New entries are generated first, for one of its examples.
    Generate(usize, Scope),
}

impl Phase {
    /// What to generate next: for an example without a valid reading unknown words first, then all.
    pub(super) fn next(self, judged: &[Vec<bool>]) -> Option<Phase> {
        let is_open = |example: &usize| !judged[*example].contains(&true);
        let first = match self {
            Phase::Generate(example, Scope::UnknownWords) if is_open(&example) => {
                return Some(Phase::Generate(example, Scope::AllWords));
            }
            Phase::Generate(example, _) => example + 1,
            Phase::Explain => 0,
        };
        let end = judged.len().min(MAX_GENERATIONS);
        (first..end).find(is_open).map(|example| Phase::Generate(example, Scope::UnknownWords))
    }
}
