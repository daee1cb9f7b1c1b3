//! The plan and how it is played: play, pause, step, scrub.

use crate::ui::Action;
use crate::ui::playback::Playback;
use web_sys::HtmlInputElement;
use yew::{Callback, Html, InputEvent, Properties, TargetCast, component, html};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) playback: Option<Playback>,
    pub(super) act: Callback<Action>,
}

/// The plan's controls; nothing when there is no plan.
#[component]
pub(super) fn Controls(props: &Props) -> Html {
    let act = &props.act;
    let Some(plan) = &props.playback else { return Html::default() };
    let (at, steps) = (plan.at(), plan.steps());
    let scrub = act.reform(|event: InputEvent| {
        let value = event.target_dyn_into::<HtmlInputElement>().map(|input| input.value());
        Action::Seek(value.and_then(|v| v.parse().ok()).unwrap_or(0))
    });
    let (word, sign) = if plan.playing() { ("Pause", PAUSE) } else { ("Play", PLAY) };
    let label = match plan.latest() {
        None => format!("Plan of {steps} steps"),
        Some(action) => format!("Step {at} of {steps}: {action}"),
    };
    html! {
        <div class="plan" role="group" aria-label="The plan" data-testid="plan" data-at={at.to_string()}
            data-steps={steps.to_string()} data-playing={plan.playing().to_string()}>
            <div class="plan-buttons">
                { button("plan-first", "To the start", FIRST, at == 0, act.reform(|()| Action::Seek(0))) }
                { button("plan-back", "Step back", BACK, at == 0,
                    act.reform(move |()| Action::Seek(at.saturating_sub(1)))) }
                { button("plan-play", word, sign, false, act.reform(|()| Action::TogglePlay)) }
                { button("plan-forward", "Step forward", FORWARD, at == steps,
                    act.reform(move |()| Action::Seek(at + 1))) }
            </div>
            <input type="range" min="0" max={steps.to_string()} step="1" value={at.to_string()}
                aria-label="Step of the plan" aria-valuetext={label.clone()} data-testid="plan-scrub"
                oninput={scrub} />
            <output data-testid="plan-step">{ label }</output>
        </div>
    }
}

const FIRST: &str = "M5 5h2v14H5zM19 5v14L9 12z";
const BACK: &str = "M16 5v14L6 12z";
const PLAY: &str = "M7 4v16l13-8z";
const PAUSE: &str = "M6 5h4v14H6zM14 5h4v14h-4z";
const FORWARD: &str = "M8 5l10 7L8 19z";

fn button(
    id: &'static str,
    label: &'static str,
    path: &'static str,
    off: bool,
    go: Callback<()>,
) -> Html {
    html! {
        <button type="button" class="sign" aria-label={label} title={label} data-testid={id} disabled={off}
            onclick={go.reform(|_| ())}>
            <svg viewBox="0 0 24 24" aria-hidden="true"><path d={path} /></svg>
        </button>
    }
}
