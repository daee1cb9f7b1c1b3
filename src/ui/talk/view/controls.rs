//! The plan and how it is played: play, pause, step, scrub, speed; what happened that nobody expected.
use crate::ui::page::shared::Shared;
use crate::ui::page::view::sign::{Sign, sign};
use crate::ui::talk::action::Action;
use crate::ui::talk::state::State;
use crate::ui::talk::watch::state::Speed;
use crate::ui::talk::words::Text;
use web_sys::{Event, HtmlInputElement, HtmlSelectElement};
use yew::{Callback, Html, InputEvent, TargetCast, html};

/// The plan's controls; nothing when there is no plan.
pub(super) fn controls(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let Some(plan) = &state.watch.playback else { return Html::default() };
    let (at, steps) = (plan.at(), plan.steps());
    let scrub = act.reform(|event: InputEvent| {
        let value = event.target_dyn_into::<HtmlInputElement>().map(|input| input.value());
        Action::Seek(value.and_then(|v| v.parse().ok()).unwrap_or(0))
    });
    let hurry = act.reform(|event: Event| {
        let place = event.target_dyn_into::<HtmlSelectElement>().map(|s| s.selected_index());
        let place = place.and_then(|place| usize::try_from(place).ok()).unwrap_or(1);
        Action::SetSpeed(Speed::ALL.get(place).copied().unwrap_or_default())
    });
    let (word, shown) =
        if plan.playing() { (text.pause, Sign::Pause) } else { (text.play, Sign::Play) };
    let label = text.step(plan);
    html! {
        <div class="plan" role="group" aria-label={text.the_plan} data-testid="plan" data-at={at.to_string()}
            data-steps={steps.to_string()} data-playing={plan.playing().to_string()}>
            <div class="plan-buttons">
                { sign("plan-first", text.to_start, Sign::First, at == 0, act.reform(|()| Action::Seek(0))) }
                { sign("plan-back", text.step_back, Sign::Back, at == 0,
                    act.reform(move |()| Action::Seek(at.saturating_sub(1)))) }
                { sign("plan-play", word, shown, false, act.reform(|()| Action::TogglePlay)) }
                { sign("plan-forward", text.step_forward, Sign::Forward, at == steps,
                    act.reform(move |()| Action::Seek(at + 1))) }
            </div>
            <input type="range" min="0" max={steps.to_string()} step="1" value={at.to_string()}
                aria-label={text.step_of_plan} aria-valuetext={label.clone()} data-testid="plan-scrub"
                oninput={scrub} />
            <select aria-label={text.speed} data-testid="plan-speed" onchange={hurry}>
                { for Speed::ALL.into_iter().map(|one| html! {
                    <option selected={one == state.watch.speed}>{ one.name() }</option>
                }) }
            </select>
            <output data-testid="plan-step">
                { label }
                if let Some(surprise) = plan.surprise() {
                    {" "}<strong class="surprise" data-testid="surprise">{ text.surprise(surprise) }</strong>
                }
            </output>
        </div>
    }
}
