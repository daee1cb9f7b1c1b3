//! How fast pictures come. Where the browser does not say that it draws in software, time tells it: a machine that takes
//! a good part of a second for a picture is better served by plainer ones.
use crate::ui::page::view::host;

/// From one frame to the next, in milliseconds: longer is slow.
const SLOW_MS: f64 = 90.0;

/// So many slow ones in a row, and pictures are to be plainer.
const MOST: u32 = 3;

/// How fast pictures come.
#[derive(Default)]
pub(super) struct Pace {
    drawn: Option<f64>,
    slow: u32,
}

impl Pace {
    /// A picture was drawn.
    pub(super) fn drawn(&mut self) {
        self.drawn = Some(host::now());
    }

    /// Another could be: whether they come too slowly.
    pub(super) fn frame(&mut self) -> bool {
        if let Some(drawn) = self.drawn.take() {
            let is_slow = host::now() - drawn > SLOW_MS;
            self.slow = if is_slow { self.slow + 1 } else { 0 };
        }
        self.slow >= MOST
    }
}
