//! The numbers of the states that a solver has met. States are kept in blocks by their families ([`Mdp::family`]): those
//! that an action leads to from one state mostly stand in one line of the cache. One hash look-up a block, none a state.

use crate::mdp::Mdp;
use hashbrown::HashTable;
use rustc_hash::FxBuildHasher;
use std::hash::BuildHasher;

/// The number of a state.
pub(super) type Id = u32;

/// No number.
const NONE: Id = Id::MAX;

/// See the head of this file.
#[derive(Clone)]
pub(super) struct Numbers<P: Mdp> {
    /// States of a block, as a power of two.
    bits: u32,
    /// The family of each block, and which members are in it.
    blocks: Vec<(P::State, u32)>,
    index: HashTable<u32>,
    ids: Vec<Id>,
}

impl<P: Mdp> Numbers<P> {
    /// No numbers yet. Blocks of many are for those who meet nearly all states.
    pub(super) const fn new(bits: u32) -> Self {
        Self { bits, blocks: Vec::new(), index: HashTable::new(), ids: Vec::new() }
    }

    /// The number of a state, if it has one.
    pub(super) fn find(&self, problem: &P, state: P::State) -> Option<Id> {
        let (family, member) = problem.family(state);
        let block = (family, member >> self.bits);
        let key = FxBuildHasher.hash_one(block);
        let at = self.index.find(key, |&i| self.blocks[i as usize] == block)?;
        Some(self.ids[self.slot(*at, member)]).filter(|&id| id != NONE)
    }

    /// The number of a state, which is `next` if it had none.
    pub(super) fn number(&mut self, problem: &P, state: P::State, next: Id) -> Id {
        let (family, member) = problem.family(state);
        let block = (family, member >> self.bits);
        let key = FxBuildHasher.hash_one(block);
        let blocks = &self.blocks;
        let at = match self.index.find(key, |&i| blocks[i as usize] == block) {
            Some(&at) => at,
            None => {
                let at = blocks.len() as u32;
                self.blocks.push(block);
                self.ids.resize(self.blocks.len() << self.bits, NONE);
                let blocks = &self.blocks;
                self.index.insert_unique(key, at, |&i| FxBuildHasher.hash_one(blocks[i as usize]));
                at
            }
        };
        let slot = self.slot(at, member);
        if self.ids[slot] == NONE {
            self.ids[slot] = next;
        }
        self.ids[slot]
    }

    const fn slot(&self, block: u32, member: u32) -> usize {
        ((block as usize) << self.bits) | (member & ((1 << self.bits) - 1)) as usize
    }
}
