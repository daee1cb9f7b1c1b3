//! What is done to an element that may only be in what is drawn next. Yew breaks a long drawing off and goes on with it in
//! a task of its own, so no microtask is sure to come behind it: this waits for the root's `rendered`.

use super::host;

/// What is done to an element.
#[derive(Clone, Copy)]
pub(crate) enum Deed {
    Focus,
    /// Focus, where that brings up no keyboard on the screen.
    FocusOnDesk,
    Reveal,
}

/// What waits for the next drawing.
#[derive(Default)]
pub(crate) struct Drawn(Vec<(Deed, &'static str)>);

impl Drawn {
    /// It is done to the element of this id once that is drawn.
    pub(crate) fn then(&mut self, deed: Deed, id: &'static str) {
        self.0.push((deed, id));
    }

    /// It is drawn.
    pub(crate) fn is(&mut self) {
        for (deed, id) in self.0.drain(..) {
            match deed {
                Deed::Focus => host::focus(id),
                Deed::FocusOnDesk if host::is_desk() => host::focus(id),
                Deed::FocusOnDesk => {}
                Deed::Reveal => host::reveal(id),
            }
        }
    }
}
