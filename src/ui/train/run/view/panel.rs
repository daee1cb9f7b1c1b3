//! Training: begun, paused, gone on with step by step; how far it is, and the model that the robot uses.

use super::curves::curves;
use super::now::now;
use super::press::press;
use super::settings::settings;
use crate::ui::page::files::Offered;
use crate::ui::page::view::files::open_file;
use crate::ui::page::view::notice::notice;
use crate::ui::train::desk::Desk;
use crate::ui::train::run::action::Action;
use crate::ui::train::run::clock::Clock;
use crate::ui::train::run::state::{Pace, Run, State, can_train};
use crate::ui::train::run::words::Text;
use crate::worker::protocol::Progress;
use yew::{Callback, Html, html};

/// Training on so many commands; `kept` says what there is to say of how the run is kept.
pub(crate) fn panel(
    state: &State,
    desk: &Desk,
    commands: usize,
    kept: Html,
    act: &Callback<Action>,
    offer: &Callback<Vec<Offered>>,
) -> Html {
    let text = Text::of(desk.language);
    html! {
        <div class="columns train">
            <div class="column">
                { training(state, desk, commands, kept, act, offer) }
                { settings(state, text, act) }
            </div>
            <div class="column">
                if let Some(run) = &state.run {
                    { curves(run, text, act) }
                    if !run.is_still() {
                        { now(run, text) }
                    }
                }
            </div>
        </div>
    }
}

fn training(
    state: &State,
    desk: &Desk,
    commands: usize,
    kept: Html,
    act: &Callback<Action>,
    offer: &Callback<Vec<Offered>>,
) -> Html {
    let text = Text::of(desk.language);
    let model = desk.in_use.as_ref();
    let own = state.notice.as_deref().or(desk.model_notice.as_deref());
    let run = state.run.as_ref();
    html! {
        <section class="card" aria-labelledby="train-title">
            <h2 id="train-title">{ text.training }</h2>
            <p>{ (text.help)(commands, &state.settings) }</p>
            { buttons(state, desk, commands, text, act) }
            { kept }
            { match run {
                Some(Run { progress: Some(progress), clock, pace, .. }) if *pace != Pace::Over => bar(text, progress, clock),
                Some(Run { progress: None, pace: Pace::Goes, .. }) => html! { <p class="dim">{ text.beginning }</p> },
                _ => Html::default(),
            } }
            if let Some(model) = model { <p data-testid="trained">{ (text.model_is)(model) }</p> }
            { notice(own, "model-notice") }
            <div class="files">
                { open_file("model-file", text.open_model, ".model,.txt,.json", None, offer) }
                if model.is_some() { { press("quiet", "save-model", text.save_model, false, act, Action::SaveModel) } }
            </div>
        </section>
    }
}

/// The buttons. Train, pause and go on are one, so that the keyboard's focus stays.
fn buttons(
    state: &State,
    desk: &Desk,
    commands: usize,
    text: &Text,
    act: &Callback<Action>,
) -> Html {
    let live = state.live();
    let cannot = live.is_none() && !can_train(desk, commands);
    let (id, words, action) = match live.map(|run| run.pace) {
        None => ("train", text.train, Action::Go),
        Some(Pace::Goes) => ("pause", text.pause, Action::Pause),
        Some(Pace::Pauses) => ("pausing", text.pausing, Action::Pause),
        Some(_) => ("go-on", text.go_on, Action::Go),
    };
    let goes = live.is_some_and(|run| run.pace == Pace::Goes);
    let can_resume = state
        .run
        .as_ref()
        .is_some_and(|run| run.pace == Pace::Stopped && run.checkpoint.is_some() && !cannot);
    html! {
        <p class="buttons">
            { press("primary", id, words, cannot, act, action) }
            { press("quiet", "step-example", text.step_example, cannot || goes, act, Action::StepExample) }
            { press("quiet", "step-epoch", text.step_epoch, cannot || goes, act, Action::StepEpoch) }
            if live.is_some() {
                { press("quiet", "stop", text.stop, false, act, Action::Stop) }
                { press("quiet", "use-so-far", text.use_so_far, false, act, Action::UseSoFar) }
            }
            if can_resume { { press("quiet", "resume", text.resume, false, act, Action::GoOn) } }
        </p>
    }
}

fn bar(text: &Text, p: &Progress, clock: &Clock) -> Html {
    let examples = p.examples.max(1);
    let epoch = usize::try_from(p.epoch.saturating_sub(1)).unwrap_or(0);
    let epochs = usize::try_from(p.epochs).unwrap_or(1);
    let (done, all) = (epoch * examples + p.example, epochs * examples);
    html! {
        <div class="bar" data-testid="progress">
            <progress aria-label={text.training} max={all.to_string()} value={done.to_string()} />
            <p class="dim">{ (text.at)(p) }{" "}{ (text.times)(clock.worked(), clock.left(p)) }</p>
        </div>
    }
}
