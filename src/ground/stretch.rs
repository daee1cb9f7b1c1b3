//! The states of a run and of its contrasts, each once, compiled for validation.

use super::view::{View, compile};
use crate::domain::{State, Way};
use indexmap::IndexSet;
use rustc_hash::FxBuildHasher;

/// States, and the ways that lead through them.
#[derive(Debug)]
pub(super) struct Stretch {
    states: IndexSet<State, FxBuildHasher>,
    /// `None` when there are too many entities.
    views: Option<Vec<View>>,
    /// The run, then its contrasts, by the places of their states.
    ways: Vec<Vec<u16>>,
}

impl Stretch {
    /// The states of a way from a start; `None` where that is too large a world, or they are too many.
    pub(super) fn of(start: &State, way: &Way) -> Option<Stretch> {
        let mut states = IndexSet::default();
        let mut ways = Vec::with_capacity(1 + way.contrasts.len());
        for through in way.states(start).ok()? {
            let places = through.into_iter().map(|state| states.insert_full(state).0);
            let places: Result<Vec<u16>, _> = places.map(u16::try_from).collect();
            ways.push(places.ok()?);
        }
        let views = compile(&states);
        Some(Stretch { states, views, ways })
    }

    /// How many states there are.
    pub(super) fn len(&self) -> usize {
        self.states.len()
    }

    /// The states, of which the first is the start.
    pub(super) fn states(&self) -> &IndexSet<State, FxBuildHasher> {
        &self.states
    }

    /// The same, compiled.
    pub(super) fn views(&self) -> Option<&[View]> {
        self.views.as_deref()
    }

    /// The run, then its contrasts.
    pub(super) fn ways(&self) -> &[Vec<u16>] {
        &self.ways
    }
}
