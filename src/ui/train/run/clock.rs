//! How long training has worked, and how long it will still take: the later epochs take less than the first ones, so what
//! is left is told from the epoch before.

use crate::worker::protocol::Progress;

/// The clock of a run. Times are in milliseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Clock {
    /// When it was looked at last, while the run goes.
    last: Option<f64>,
    /// How long the run has worked.
    worked: f64,
    /// The epoch at work, and how long had been worked before it.
    epoch: (u32, f64),
    /// How long the epoch before took.
    before: Option<f64>,
}

impl Clock {
    /// The clock of a run that comes back after so many milliseconds of work.
    pub fn worked_so_long(worked: f64) -> Clock {
        Clock { worked, ..Clock::default() }
    }

    /// The run rests: the time that goes by is not its own.
    pub fn rest(&mut self) {
        self.last = None;
    }

    /// The run is so far, at this time.
    pub fn tick(&mut self, now: f64, progress: &Progress) {
        let went = self.last.map_or(0.0, |last| (now - last).max(0.0));
        (self.last, self.worked) = (Some(now), self.worked + went);
        let (epoch, since) = self.epoch;
        if progress.epoch != epoch {
            self.before = (epoch > 0).then_some(self.worked - since);
            self.epoch = (progress.epoch, self.worked);
        }
    }

    /// How long the run will still take, once that can be told.
    pub fn left(&self, progress: &Progress) -> Option<f64> {
        let of_epoch = progress.example as f64 / progress.examples.max(1) as f64;
        let in_epoch = self.worked - self.epoch.1;
        let more = f64::from(progress.epochs.saturating_sub(progress.epoch));
        let whole = match self.before {
            Some(before) => before,
            None if of_epoch >= 0.05 => in_epoch / of_epoch,
            None => return None,
        };
        Some((whole * (1.0 - of_epoch)).max(0.0) + whole * more)
    }

    /// How long it has worked.
    pub const fn worked(&self) -> f64 {
        self.worked
    }
}
