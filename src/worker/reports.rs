//! How often the page is told how far something is: a page that draws each report takes time from the work, on a machine
//! of two cores as much as the work itself at 25 a second. What is held back is never lost: it is told before the next
//! word of the same request, so work that rests or ends has said how far it came.

use super::protocol::Event;

/// Milliseconds between two reports of progress.
pub const REPORT_MS: f64 = 250.0;

/// What is told of what an engine says.
#[derive(Debug)]
pub struct Reports {
    /// When progress was told last, in milliseconds.
    told: f64,
    /// Progress that was too early to be told, with the id of its request.
    held: Option<(u32, Event)>,
}

impl Reports {
    /// Nothing was told yet.
    pub const fn new() -> Reports {
        Reports { told: f64::NEG_INFINITY, held: None }
    }

    /// What is to be told at `now` (milliseconds) of what was said of a request, in order.
    pub fn tell(
        &mut self,
        now: f64,
        id: u32,
        event: Event,
    ) -> impl Iterator<Item = (u32, Event)> + use<> {
        let (before, told) = if !is_progress(&event) {
            (self.held.take_if(|(of, _)| *of == id), Some((id, event)))
        } else if now - self.told >= REPORT_MS {
            (self.told, self.held) = (now, None);
            (None, Some((id, event)))
        } else {
            self.held = Some((id, event));
            (None, None)
        };
        before.into_iter().chain(told)
    }
}

impl Default for Reports {
    fn default() -> Reports {
        Reports::new()
    }
}

/// Whether an event is one of many that say how far something is; that an epoch has ended is told for certain.
const fn is_progress(event: &Event) -> bool {
    if let Event::Progress(progress) = event {
        return progress.example < progress.examples;
    }
    matches!(
        event,
        Event::Reading { .. }
            | Event::Auditing { .. }
            | Event::Experimenting(_)
            | Event::Planning(_)
            | Event::RollingOut(_)
    )
}
