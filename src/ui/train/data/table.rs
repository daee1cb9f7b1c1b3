//! The rows that are looked at: which, in which order, and of them the few that the engine was asked for, since a
//! corpus may have a hundred thousand.

use crate::worker::protocol::{Line, View, Window};
use std::collections::BTreeSet;
use std::rc::Rc;

/// So many rows before and behind those in sight are drawn, too.
pub const SPARE: u32 = 10;

/// So many rows before and behind those in sight are asked for.
const MARGIN: u32 = 60;

/// The rows that are looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Which rows, and in which order.
    pub view: View,
    /// The rows of the view that are known.
    pub window: Rc<Window>,
    /// Whether it may be old.
    stale: bool,
    /// What was asked for last and has not come.
    asked: Option<(View, u32)>,
    /// The first row in sight, and how many are.
    pub sight: (u32, u32),
    /// Where the keyboard has gone and the page has not scrolled yet: what it says of before is old.
    goal: Option<u32>,
    /// The row that the keyboard is at, by its place in the view.
    pub current: u32,
    /// The rows that were picked.
    pub picked: Rc<BTreeSet<u32>>,
}

impl Table {
    /// All rows, of which none is known yet.
    pub fn new() -> Table {
        Table {
            view: View::default(),
            window: Rc::default(),
            stale: true,
            asked: None,
            sight: (0, 30),
            goal: None,
            current: 0,
            picked: Rc::default(),
        }
    }

    /// Rows of the view.
    pub fn total(&self) -> u32 {
        self.window.total
    }

    /// The row at a place of the view, if it is known.
    pub fn line(&self, place: u32) -> Option<&Line> {
        let at = place.checked_sub(self.window.offset)?;
        self.window.lines.get(usize::try_from(at).ok()?)
    }

    /// The places that are drawn.
    pub fn drawn(&self) -> std::ops::Range<u32> {
        let (top, count) = self.sight;
        top.saturating_sub(SPARE)..(top + count + SPARE).min(self.total())
    }

    /// Rows are looked at in another way, from the first.
    pub fn look(&mut self, change: impl FnOnce(&mut View)) {
        change(&mut self.view);
        (self.stale, self.sight.0, self.current) = (true, 0, 0);
    }

    /// The page has scrolled: this row is the first in sight, of so many.
    pub fn scrolled(&mut self, top: u32, count: u32) {
        match self.goal.take() {
            Some(goal) if goal != top => self.sight = (goal, count),
            _ => self.sight = (top, count),
        }
    }

    /// The keyboard goes to a place, which is brought into sight.
    pub fn go(&mut self, place: i64) {
        let last = self.total().saturating_sub(1);
        let place = u32::try_from(place.max(0)).unwrap_or(last).min(last);
        self.current = place;
        let (top, count) = self.sight;
        // The last row in sight may be cut.
        let whole = count.saturating_sub(2);
        let to = match place {
            place if place < top => place,
            place if place > top + whole => place - whole,
            _ => return,
        };
        (self.sight.0, self.goal) = (to, Some(to));
    }

    /// The rows have changed.
    pub fn changed(&mut self) {
        self.stale = true;
    }

    /// What is to be asked for, if anything: the place of the first row and how many.
    pub fn ask(&mut self) -> Option<(View, u32, u32)> {
        let drawn = self.drawn();
        let known = self.window.offset..self.window.offset + self.window.lines.len() as u32;
        let is_known = drawn.start >= known.start && drawn.end <= known.end;
        if is_known && !self.stale {
            return None;
        }
        let offset = self.sight.0.saturating_sub(MARGIN);
        let asked = (self.view.clone(), offset);
        if !self.stale && self.asked.as_ref() == Some(&asked) {
            return None;
        }
        (self.stale, self.asked) = (false, Some(asked.clone()));
        Some((asked.0, offset, self.sight.1 + 2 * MARGIN))
    }

    /// Rows have come; those of what was asked before are none of its business.
    pub fn came(&mut self, view: &View, window: Window) {
        if *view != self.view || self.asked.as_ref().is_some_and(|(_, at)| *at != window.offset) {
            return;
        }
        self.asked = None;
        let last = window.total.saturating_sub(1);
        (self.current, self.sight.0) = (self.current.min(last), self.sight.0.min(last));
        self.window = Rc::new(window);
    }

    /// Picks a row, or no more.
    pub fn pick(&mut self, row: u32, is_picked: bool) {
        let picked = Rc::make_mut(&mut self.picked);
        if is_picked {
            picked.insert(row)
        } else {
            picked.remove(&row)
        };
    }
}

impl Default for Table {
    fn default() -> Table {
        Table::new()
    }
}
