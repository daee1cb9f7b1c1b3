//! The view in which a parser is trained: the corpus, training, and what came of it.

use super::corpus::corpus;
use super::training::training;
use crate::ui::page::shared::Shared;
use crate::ui::train::action::Action;
use crate::ui::train::state::State;
use yew::{Callback, Html, html};

/// The workbench.
pub(crate) fn workbench(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    html! {
        <main class="columns train">
            { training(state, shared, act) }
            { corpus(state, shared, act) }
        </main>
    }
}
