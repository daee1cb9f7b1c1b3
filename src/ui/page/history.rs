//! What undo and redo go through: whole documents, cheap because they share what did not change.

/// Undo goes back at most so many changes.
const DEPTH: usize = 100;

/// The documents before the one that is open, and those that were undone.
#[derive(Clone, Debug, PartialEq)]
pub struct History<T> {
    past: Vec<T>,
    future: Vec<T>,
}

impl<T> History<T> {
    /// Nothing to undo or redo.
    pub const fn new() -> History<T> {
        History { past: Vec::new(), future: Vec::new() }
    }

    /// Remembers what was, before it changes. What was undone is forgotten.
    pub fn record(&mut self, before: T) {
        self.future.clear();
        if self.past.len() == DEPTH {
            self.past.remove(0);
        }
        self.past.push(before);
    }

    /// Goes back from `now`, if there is anywhere to go.
    pub fn undo(&mut self, now: &mut T) -> bool {
        Self::step(&mut self.past, &mut self.future, now)
    }

    /// Goes forward again from `now`, if there is anywhere to go.
    pub fn redo(&mut self, now: &mut T) -> bool {
        Self::step(&mut self.future, &mut self.past, now)
    }

    /// Whether there is something to undo.
    pub const fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether there is something to redo.
    pub const fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// Every document but the one that is open.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.past.iter_mut().chain(&mut self.future)
    }

    fn step(from: &mut Vec<T>, to: &mut Vec<T>, now: &mut T) -> bool {
        let Some(next) = from.pop() else { return false };
        to.push(std::mem::replace(now, next));
        true
    }
}

impl<T> Default for History<T> {
    fn default() -> History<T> {
        History::new()
    }
}
