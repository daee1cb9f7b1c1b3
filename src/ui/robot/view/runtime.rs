//! The page's runtime, as in the Elm architecture: every action is reduced, and its effects carried out, in the listener that
//! saw it. Only drawing is left to Yew, whose queue a busy machine holds up: a word to stop does not wait for a drawing, and a
//! page that is left would be gone before it.

use super::effects::Effects;
use crate::ui::page::view::host;
use crate::ui::robot::action::Action;
use crate::ui::robot::state::{Link, State};
use crate::ui::robot::update::reduce;
use std::cell::{Ref, RefCell};
use std::collections::VecDeque;
use std::rc::{Rc, Weak};
use yew::Callback;

/// The state, and what acts on it.
pub(super) struct Runtime {
    state: RefCell<State>,
    effects: RefCell<Effects>,
    /// Actions that came while another was taken, in order.
    inbox: RefCell<VecDeque<Action>>,
    /// Where its actions go.
    pub(super) act: Callback<Action>,
    draw: Callback<()>,
}

impl Runtime {
    /// A page in its first state; `draw` asks for it to be drawn anew.
    pub(super) fn new(draw: Callback<()>) -> Rc<Runtime> {
        Rc::new_cyclic(|runtime: &Weak<Runtime>| {
            let runtime = runtime.clone();
            let act = Callback::from(move |action| {
                if let Some(runtime) = runtime.upgrade() {
                    runtime.take(action);
                }
            });
            Runtime {
                state: RefCell::new(State::new()),
                effects: RefCell::new(Effects::new(act.clone())),
                inbox: RefCell::default(),
                act,
                draw,
            }
        })
    }

    /// The state, to be drawn.
    pub(super) fn state(&self) -> Ref<'_, State> {
        self.state.borrow()
    }

    /// Takes an action now; or after those that are being taken, where one of their effects or a drawing tells of it.
    fn take(&self, action: Action) {
        self.inbox.borrow_mut().push_back(action);
        let (Ok(mut state), Ok(mut effects)) =
            (self.state.try_borrow_mut(), self.effects.try_borrow_mut())
        else {
            return;
        };
        loop {
            let Some(action) = self.inbox.borrow_mut().pop_front() else { break };
            let is_passing = matches!(action, Action::Tick(_) | Action::LinkHeard(_));
            let action = match action {
                Action::Tick(_) if state.link != Link::Open => continue,
                // How much waits to leave is known when the tick is taken.
                Action::Tick(_) => Action::Tick(effects.backlog()),
                other => other,
            };
            let wanted = reduce(&mut state, action, host::now());
            effects.run(wanted);
            if !is_passing {
                self.draw.emit(());
            }
        }
    }
}
