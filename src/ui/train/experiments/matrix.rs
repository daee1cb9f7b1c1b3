//! The experiments that can be chosen, with what they are to be told.

use crate::worker::protocol::{By, FeatureKind, Matrix};

/// States that the planner of a run of Table III may expand.
const BUDGET: u64 = 2_000;

/// The shares of a learning curve, in percent.
const SHARES: [u32; 5] = [10, 25, 50, 75, 100];

/// An experiment.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(missing_docs, reason = "as of `Matrix`")]
pub enum Kind {
    #[default]
    Cross,
    Curve,
    Features,
    Demonstrations,
    Seeds,
    /// Of the paper's two sets, the raw or the pruned one.
    Table2 {
        is_raw: bool,
    },
    Table3,
}

impl Kind {
    /// Those of one's own, in the order of a choice.
    pub const OWN: [Kind; 5] =
        [Kind::Cross, Kind::Curve, Kind::Features, Kind::Demonstrations, Kind::Seeds];

    /// Those of the paper.
    pub const PAPER: [Kind; 3] =
        [Kind::Table2 { is_raw: false }, Kind::Table2 { is_raw: true }, Kind::Table3];

    /// Whether it judges on what is held out, so that something must be.
    pub const fn needs_held_out(self) -> bool {
        !matches!(self, Kind::Cross)
    }

    /// The runs that it is of.
    pub fn matrix(self, folds: u32, by: By, seeds: u32) -> Matrix {
        match self {
            Kind::Cross => Matrix::Cross { folds, by },
            Kind::Curve => Matrix::Curve { percents: SHARES.into(), by },
            Kind::Features => {
                let kinds = FeatureKind::ALL.iter().map(|(_, kind)| *kind).collect();
                Matrix::Ablation { kinds, demonstrations: Vec::new() }
            }
            Kind::Demonstrations => {
                Matrix::Ablation { kinds: Vec::new(), demonstrations: vec![1, 2, 3] }
            }
            Kind::Seeds => Matrix::Seeds { count: seeds },
            Kind::Table2 { is_raw } => {
                let set = if is_raw { "raw" } else { "pruned" };
                Matrix::Table2 { set: set.to_owned() }
            }
            Kind::Table3 => Matrix::Table3 { budget: BUDGET },
        }
    }
}
