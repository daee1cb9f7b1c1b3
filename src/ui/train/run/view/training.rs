//! Training: the button, how far it is, and what came of it.

use crate::ui::page::files::Offered;
use crate::ui::page::view::files::open_file;
use crate::ui::page::view::notice::notice;
use crate::ui::train::desk::Desk;
use crate::ui::train::run::action::Action;
use crate::ui::train::run::state::{SETTINGS, State, can_train, is_training};
use crate::ui::train::words::Text;
use crate::worker::protocol::Progress;
use yew::{Callback, Html, classes, html};

/// The training panel, on so many commands. Train and Cancel are one button, so that the keyboard's focus stays.
pub(crate) fn training(
    state: &State,
    desk: &Desk,
    commands: usize,
    act: &Callback<Action>,
    offer: &Callback<Vec<Offered>>,
) -> Html {
    let text = Text::of(desk.language);
    let State { progress, notice: own } = state;
    let model = desk.in_use.as_ref();
    let training = is_training(desk);
    let (word, id, action) = match training {
        true => (text.cancel, "cancel", Action::Cancel),
        false => (text.begin_training, "train", Action::Train),
    };
    let weight = if training { "plain" } else { "primary" };
    html! {
        <section class="card train" aria-labelledby="train-title">
            <div class="card-head">
                <h2 id="train-title">{ text.training }</h2>
                <button type="button" class={classes!(weight)} data-testid={id}
                    disabled={!training && !can_train(desk, commands)} onclick={act.reform(move |_| action.clone())}>
                    { word }
                </button>
            </div>
            { match (progress, training) {
                (Some(progress), _) => bar(text, progress),
                (None, true) => html! { <p class="dim">{ text.beginning }</p> },
                (None, false) => html! { <p>{ (text.train_help)(commands, SETTINGS.epochs) }</p> },
            } }
            if let Some(model) = model { <p data-testid="trained">{ (text.model_is)(model) }</p> }
            { notice(own.as_deref().or(desk.model_notice.as_deref()), "model-notice") }
            <div class="files">
                { open_file("model-file", text.open_model, ".model,.txt,.json", None, offer) }
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
