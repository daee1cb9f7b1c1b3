//! Training: the button, how far it is, and what came of it.

use super::files::OpenFile;
use super::notice::Notice;
use crate::ui::Action;
use crate::ui::state::{Model, SETTINGS};
use crate::worker::protocol::Progress;
use yew::{Callback, Html, Properties, classes, component, html};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) progress: Option<Progress>,
    pub(super) model: Option<Model>,
    pub(super) notice: Option<String>,
    pub(super) training: bool,
    pub(super) can_train: bool,
    pub(super) commands: usize,
    pub(super) act: Callback<Action>,
}

/// The training panel. Train and Cancel are one button, so that the keyboard's focus stays.
#[component]
pub(super) fn TrainPanel(props: &Props) -> Html {
    let Props { progress, model, notice, training, can_train, commands, act } = props;
    let (word, id, action) = match (training, model) {
        (true, _) => ("Cancel", "cancel", Action::CancelTraining),
        (false, None) => ("Train", "train", Action::Train),
        (false, Some(_)) => ("Train again", "train", Action::Train),
    };
    let weight = if model.is_none() && !training { "primary" } else { "plain" };
    html! {
        <section class="card train" aria-labelledby="train-title">
            <div class="card-head">
                <h2 id="train-title">{"Teach it"}</h2>
                <button type="button" class={classes!(weight)} data-testid={id}
                    disabled={!training && !can_train} onclick={act.reform(move |_| action.clone())}>
                    { word }
                </button>
            </div>
            { match (progress, training, model) {
                (Some(progress), ..) => bar(progress),
                (None, true, _) => html! { <p class="dim">{"Beginning…"}</p> },
                (None, false, Some(model)) => learned(model),
                (None, false, None) => html! {
                    <p>{ format!(
                        "It knows no words for things or deeds yet. It can learn them from {commands} commands, \
                         each shown with the room before and after, in {} passes.", SETTINGS.epochs) }</p>
                },
            } }
            <Notice text={notice.clone()} id="model-notice" />
            <div class="files">
                <OpenFile id="model-file" label="Open a model" accept=".model,.txt,.json" act={act.clone()} />
                if model.is_some() {
                    <button type="button" class="quiet" data-testid="save-model"
                        onclick={act.reform(|_| Action::SaveModel)}>{"Save the model"}</button>
                }
            </div>
        </section>
    }
}

fn bar(p: &Progress) -> Html {
    let examples = p.examples.max(1);
    let epoch = usize::try_from(p.epoch.saturating_sub(1)).unwrap_or(0);
    let epochs = usize::try_from(p.epochs).unwrap_or(1);
    let (done, all) = (epoch * examples + p.example, epochs * examples);
    html! {
        <div class="bar" data-testid="progress">
            <progress aria-label="Training" max={all.to_string()} value={done.to_string()} />
            <p class="dim">{ format!(
                "Pass {} of {}, command {} of {}. {} with a valid meaning, {} entries in the lexicon.",
                p.epoch, p.epochs, p.example, p.examples, p.valid, p.entries) }</p>
        </div>
    }
}

fn learned(model: &Model) -> Html {
    let report = &model.report;
    html! {
        <p data-testid="trained">{ format!(
            "Learned from {}: {} of {} commands have a valid meaning, {} entries in its lexicon.",
            model.origin, report.valid, report.examples, report.entries) }</p>
    }
}
