//! What outcomes weigh, each weight that there is kept once: few differ, for walks are short and few things go wrong.

use super::index::{Id, Index};
use crate::mdp::Leap;

/// An outcome: where it leads, and the number of its weight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) target: Id,
    /// Twice the number of the weight, and 1 more where another outcome of the same row follows.
    weight: u32,
}

impl Edge {
    pub(super) const fn new(target: Id, weight: u32) -> Self {
        Self { target, weight: 2 * weight + 1 }
    }

    /// Whether no other outcome of the same row follows.
    #[inline]
    pub(super) const fn is_last(self) -> bool {
        self.weight & 1 == 0
    }

    pub(super) const fn end_row(&mut self) {
        self.weight &= !1;
    }
}

/// See the head of this file.
#[derive(Clone)]
pub(super) struct Weights {
    discount: f64,
    index: Index,
    /// What each is made of: slip, stay, probability and cost.
    parts: Vec<[u64; 4]>,
    weights: Vec<f64>,
}

impl Weights {
    /// None yet.
    pub(super) fn new(discount: f64) -> Self {
        Self { discount, index: Index::new(), parts: Vec::new(), weights: Vec::new() }
    }

    /// The number of the weight of an outcome of a leap: its probability, less what the way there costs, over what staying
    /// takes.
    pub(super) fn of(&mut self, leap: &Leap, probability: f64) -> u32 {
        let Leap { slip, stay, cost, .. } = leap;
        let parts = [slip.to_bits(), stay.to_bits(), probability.to_bits(), u64::from(*cost)];
        let probe = self.index.probe(parts);
        self.index.find(parts, probe, &self.parts).unwrap_or_else(|| {
            self.weights.push(leap.scale(self.discount) * probability);
            self.parts.push(parts);
            self.index.add(probe, &self.parts);
            self.parts.len() as u32 - 1
        })
    }

    /// The weight of an outcome.
    #[inline]
    pub(super) fn get(&self, edge: Edge) -> f64 {
        self.weights[edge.weight as usize / 2]
    }

    /// How many actions the leap takes that an outcome is of, when all goes well.
    pub(super) fn cost(&self, edge: Edge) -> u32 {
        self.parts[edge.weight as usize / 2][3] as u32
    }
}
