//! The view in which a parser is trained: the corpus, training, and what came of it.

use super::corpus::CorpusPanel;
use super::train::TrainPanel;
use crate::ui::{Action, State};
use yew::{Callback, Html, html};

/// The workbench.
pub(super) fn workbench(state: &State, act: &Callback<Action>) -> Html {
    let train = &state.train;
    html! {
        <main class="columns train">
            <TrainPanel progress={train.progress.clone()} model={state.document.model.clone()}
                notice={train.notice.clone().or_else(|| state.model_notice.clone())}
                training={state.is_training()} can_train={state.can_train()}
                commands={train.corpus.as_ref().map_or(0, |c| c.report.rows.len())} act={act.clone()} />
            <CorpusPanel corpus={train.corpus.clone()} notice={train.file_notice.clone()}
                theme={state.preferences.theme} act={act.clone()} />
        </main>
    }
}
