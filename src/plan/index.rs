//! Finds the numbers of states that have one: a table of u32 with open addressing and linear probing (Knuth, volume 3,
//! section 6.4, algorithm L), at most half full. A slot holds a number, and in the bits that numbers leave over a part of the
//! hash, so that a state is looked at only where it is almost surely the one.
//! States are kept by who numbers them, 0 first. Many are looked up faster at once: see [`Index::probe`].

use rustc_hash::FxBuildHasher;
use std::hash::{BuildHasher, Hash};

/// The number of a state.
pub(super) type Id = u32;

/// A slot that holds nothing: no number is as large, for a table is never full.
const EMPTY: u32 = Id::MAX;
/// Slots of the first table.
const FIRST: usize = 16;

/// See the head of this file.
#[derive(Clone, Debug)]
pub(super) struct Index {
    slots: Vec<u32>,
}

/// The hash of a state, and what its first slot holds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Probe {
    hash: u32,
    slot: u32,
}

impl Index {
    /// An index of nothing.
    pub(super) fn new() -> Self {
        Self { slots: vec![EMPTY; FIRST] }
    }

    /// Begins to look for a state. Who begins with many before going on with [`Index::find`] waits for memory once; no more
    /// may be added between than there is room for.
    #[inline]
    pub(super) fn probe<S: Hash>(&self, state: S) -> Probe {
        let hash = hash(state);
        Probe { hash, slot: self.slots[hash as usize & self.mask()] }
    }

    /// The number of a state.
    #[inline]
    pub(super) fn find<S: Copy + Eq>(&self, state: S, probe: Probe, states: &[S]) -> Option<Id> {
        let mask = self.mask();
        let tag = self.tag(probe.hash);
        let mut at = probe.hash as usize & mask;
        // What was added since stands in slots that were empty.
        let mut slot = if probe.slot == EMPTY { self.slots[at] } else { probe.slot };
        while slot != EMPTY {
            let id = slot & mask as u32;
            if slot ^ id == tag && states[id as usize] == state {
                return Some(id);
            }
            at = (at + 1) & mask;
            slot = self.slots[at];
        }
        None
    }

    /// Adds the last of these states, which has no number yet.
    pub(super) fn add<S: Copy + Hash>(&mut self, probe: Probe, states: &[S]) {
        if 2 * states.len() > self.slots.len() {
            self.reserve(1, states);
        } else {
            self.put(probe.hash, states.len() as Id - 1);
        }
    }

    /// Makes room for so many states more than these.
    pub(super) fn reserve<S: Copy + Hash>(&mut self, more: usize, states: &[S]) {
        let wanted = 2 * (states.len() + more);
        if wanted > self.slots.len() {
            // The old table goes first, for there may not be room for both.
            self.slots = Vec::new();
            self.slots.resize(wanted.next_power_of_two(), EMPTY);
            for (id, &state) in states.iter().enumerate() {
                self.put(hash(state), id as Id);
            }
        }
    }

    fn put(&mut self, hash: u32, id: Id) {
        let mask = self.mask();
        let mut at = hash as usize & mask;
        while self.slots[at] != EMPTY {
            at = (at + 1) & mask;
        }
        self.slots[at] = self.tag(hash) | id;
    }

    fn mask(&self) -> usize {
        self.slots.len() - 1
    }

    /// The part of a hash that stands beside a number: bits that do not choose the slot.
    #[inline]
    fn tag(&self, hash: u32) -> u32 {
        hash & !(self.mask() as u32)
    }
}

#[inline]
fn hash<S: Hash>(state: S) -> u32 {
    let hash = FxBuildHasher.hash_one(state);
    (hash ^ hash >> 32) as u32
}
