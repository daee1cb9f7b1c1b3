//! Training: the button, how far it is, and what came of it.

use super::files::OpenFile;
use super::notice::Notice;
use super::words::use_text;
use crate::ui::Action;
use crate::ui::document::Model;
use crate::ui::text::Text;
use crate::ui::train::SETTINGS;
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
    let text = use_text();
    let Props { progress, model, notice, training, can_train, commands, act } = props;
    let (word, id, action) = match training {
        true => (text.cancel, "cancel", Action::CancelTraining),
        false => (text.begin_training, "train", Action::Train),
    };
    let weight = if *training { "plain" } else { "primary" };
    html! {
        <section class="card train" aria-labelledby="train-title">
            <div class="card-head">
                <h2 id="train-title">{ text.training }</h2>
                <button type="button" class={classes!(weight)} data-testid={id}
                    disabled={!training && !can_train} onclick={act.reform(move |_| action.clone())}>
                    { word }
                </button>
            </div>
            { match (progress, *training) {
                (Some(progress), _) => bar(text, progress),
                (None, true) => html! { <p class="dim">{ text.beginning }</p> },
                (None, false) => html! { <p>{ (text.train_help)(*commands, SETTINGS.epochs) }</p> },
            } }
            if let Some(model) = model { <p data-testid="trained">{ (text.model_is)(model) }</p> }
            <Notice text={notice.clone()} id="model-notice" />
            <div class="files">
                <OpenFile id="model-file" label={text.open_model} accept=".model,.txt,.json" act={act.clone()} />
                if model.is_some() {
                    <button type="button" class="quiet" data-testid="save-model"
                        onclick={act.reform(|_| Action::SaveModel)}>{ text.save_model }</button>
                }
            </div>
        </section>
    }
}

fn bar(text: &Text, p: &Progress) -> Html {
    let examples = p.examples.max(1);
    let epoch = usize::try_from(p.epoch.saturating_sub(1)).unwrap_or(0);
    let epochs = usize::try_from(p.epochs).unwrap_or(1);
    let (done, all) = (epoch * examples + p.example, epochs * examples);
    html! {
        <div class="bar" data-testid="progress">
            <progress aria-label={text.training} max={all.to_string()} value={done.to_string()} />
            <p class="dim">{ (text.training_at)(p) }</p>
        </div>
    }
}
