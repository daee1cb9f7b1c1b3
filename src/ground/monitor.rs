//! A monitor of a task by progression (Bacchus and Kabanza 1998): what is left of the task after the states so far, its
//! *residual*. Equal residuals are one id. It knows no terms and no states, but which guards hold.

use super::outline::{Outline, Part, Valuation};
use indexmap::IndexSet;
use rustc_hash::{FxBuildHasher, FxHashMap};

/// Residuals that a task may come to.
pub const MOST_RESIDUALS: usize = 64;
/// Parts that all residuals together may have.
const MOST_PARTS: usize = 100_000;

/// What is left of a task, by its place among those found so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Residual(u8);

/// The task has more residuals than [`MOST_RESIDUALS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the task has more than {MOST_RESIDUALS} stages")]
pub struct TooMany;

/// What is left of a task, state by state.
#[derive(Clone, Debug)]
pub struct Monitor {
    parts: IndexSet<Part, FxBuildHasher>,
    /// The part that each residual is.
    residuals: IndexSet<usize, FxBuildHasher>,
    known: FxHashMap<(Residual, Valuation), Residual>,
}

impl Residual {
    /// Its place among those found so far.
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// The one of a place.
    pub const fn at(index: u8) -> Residual {
        Residual(index)
    }
}

impl Monitor {
    /// What is left before any state was seen: the whole task.
    pub const START: Residual = Residual(0);

    /// A monitor of a task.
    ///
    /// # Errors
    /// [`TooMany`] when its parts alone are too many.
    pub fn new(outline: &Outline) -> Result<Monitor, TooMany> {
        let mut monitor = Monitor {
            parts: IndexSet::default(),
            residuals: IndexSet::default(),
            known: FxHashMap::default(),
        };
        let mut places = Vec::with_capacity(outline.parts().len());
        for part in outline.parts() {
            let place = match part {
                Part::Until { hold, reach, then } => monitor.until(*hold, *reach, places[*then])?,
                Part::All(parts) => monitor.join(true, parts.iter().map(|&part| places[part]))?,
                Part::Any(parts) => monitor.join(false, parts.iter().map(|&part| places[part]))?,
                Part::Done | Part::Failed | Part::Always(_) => monitor.part(part.clone())?,
            };
            places.push(place);
        }
        monitor.residual(places.last().copied().unwrap_or_default())?;
        Ok(monitor)
    }

    /// What is left after a state in which these guards hold.
    ///
    /// # Errors
    /// [`TooMany`] when the task comes to too many residuals.
    pub fn step(&mut self, from: Residual, holds: Valuation) -> Result<Residual, TooMany> {
        if let Some(&known) = self.known.get(&(from, holds)) {
            return Ok(known);
        }
        let part = self.residuals.get_index(from.index()).copied().unwrap_or_default();
        let part = self.progress(part, holds)?;
        let to = self.residual(part)?;
        self.known.insert((from, holds), to);
        Ok(to)
    }

    /// Whether a run that ends here satisfies the task.
    pub fn satisfies(&self, residual: Residual) -> bool {
        self.residuals.get_index(residual.index()).is_some_and(|&part| self.is_satisfied(part))
    }

    /// Whether no run that goes on from here does.
    pub fn fails(&self, residual: Residual) -> bool {
        let part = self.residuals.get_index(residual.index());
        part.and_then(|&part| self.parts.get_index(part)) == Some(&Part::Failed)
    }

    /// The part that a residual is, for [`Monitor::part_at`].
    pub fn part_of(&self, residual: Residual) -> Option<usize> {
        self.residuals.get_index(residual.index()).copied()
    }

    /// A part by its place.
    pub fn part_at(&self, place: usize) -> Option<&Part> {
        self.parts.get_index(place)
    }

    /// How many residuals were found so far.
    pub fn found(&self) -> usize {
        self.residuals.len()
    }

    fn is_satisfied(&self, part: usize) -> bool {
        match self.parts.get_index(part) {
            Some(Part::Done | Part::Always(_)) => true,
            Some(Part::All(parts)) => parts.iter().all(|&part| self.is_satisfied(part)),
            Some(Part::Any(parts)) => parts.iter().any(|&part| self.is_satisfied(part)),
            Some(Part::Failed | Part::Until { .. }) | None => false,
        }
    }

    fn progress(&mut self, part: usize, holds: Valuation) -> Result<usize, TooMany> {
        let is_so = |guard: usize| holds >> guard & 1 == 1;
        match self.parts.get_index(part).cloned() {
            None | Some(Part::Failed) => self.part(Part::Failed),
            Some(Part::Done) => Ok(part),
            Some(Part::Always(guard)) if is_so(guard) => Ok(part),
            Some(Part::Always(_)) => self.part(Part::Failed),
            Some(Part::Until { hold, reach, then }) => {
                let reached = if is_so(reach) { Some(self.progress(then, holds)?) } else { None };
                self.join(false, reached.into_iter().chain(is_so(hold).then_some(part)))
            }
            Some(Part::All(parts)) => {
                let parts: Result<Vec<usize>, TooMany> =
                    parts.into_iter().map(|part| self.progress(part, holds)).collect();
                self.join(true, parts?.into_iter())
            }
            Some(Part::Any(parts)) => {
                let parts: Result<Vec<usize>, TooMany> =
                    parts.into_iter().map(|part| self.progress(part, holds)).collect();
                self.join(false, parts?.into_iter())
            }
        }
    }

    fn until(&mut self, hold: usize, reach: usize, then: usize) -> Result<usize, TooMany> {
        let fails = self.parts.get_index(then) == Some(&Part::Failed);
        self.part(if fails { Part::Failed } else { Part::Until { hold, reach, then } })
    }

    /// All of some parts, or any: nested ones are taken apart, what decides it is it, what changes nothing is left out.
    fn join(&mut self, all: bool, of: impl Iterator<Item = usize>) -> Result<usize, TooMany> {
        let (unit, absorber) =
            if all { (Part::Done, Part::Failed) } else { (Part::Failed, Part::Done) };
        let mut flat = Vec::new();
        for place in of {
            match self.parts.get_index(place) {
                Some(part) if *part == absorber => return Ok(place),
                Some(part) if *part == unit => {}
                Some(Part::All(parts)) if all => flat.extend_from_slice(parts),
                Some(Part::Any(parts)) if !all => flat.extend_from_slice(parts),
                _ => flat.push(place),
            }
        }
        flat.sort_unstable();
        flat.dedup();
        match flat[..] {
            [] => self.part(unit),
            [only] => Ok(only),
            _ if all => self.part(Part::All(flat)),
            _ => self.part(Part::Any(flat)),
        }
    }

    fn part(&mut self, part: Part) -> Result<usize, TooMany> {
        if self.parts.len() >= MOST_PARTS {
            return Err(TooMany);
        }
        Ok(self.parts.insert_full(part).0)
    }

    fn residual(&mut self, part: usize) -> Result<Residual, TooMany> {
        let (at, is_new) = self.residuals.insert_full(part);
        if is_new && at >= MOST_RESIDUALS {
            self.residuals.pop();
            return Err(TooMany);
        }
        Ok(Residual(at as u8))
    }
}
