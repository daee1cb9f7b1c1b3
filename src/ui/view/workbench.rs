//! The view in which a parser is trained: the corpus, training, and what came of it.

use super::corpus::corpus;
use super::train::training;
use crate::ui::{Action, State};
use yew::{Callback, Html, html};

/// The workbench.
pub(super) fn workbench(state: &State, act: &Callback<Action>) -> Html {
    html! {
        <main class="columns train">
            { training(state, act) }
            { corpus(state, act) }
        </main>
    }
}
