//! The dry run, with what was found of each thing that must be well; and driving itself.

use crate::robot::{Check, Stage};
use crate::ui::page::view::select::select;
use crate::ui::page::view::sends::sends;
use crate::ui::robot::action::Action;
use crate::ui::robot::state::{Link, SPEEDS, State};
use crate::ui::robot::words::Text;
use yew::{Callback, Html, html};

/// The third step: the dry run.
pub(super) fn dry(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let pilot = &state.pilot;
    let is_waiting = matches!(&pilot.driver.stage, Stage::Trying(trial) if trial.is_waiting());
    let one = |check: Check| {
        // Where no link is wanted nothing is amiss.
        let found = pilot.check(check, state.now).filter(|_| state.link != Link::Off);
        let (sign, words, class) = match found {
            Some(true) => ("✓", text.good, "good"),
            Some(false) => ("✗", text.bad, "bad"),
            None => ("·", text.open, "open"),
        };
        html! {
            <li class={class} data-check={format!("{check:?}").to_ascii_lowercase()} data-found={class}>
                <span aria-hidden="true">{ sign }</span>{ (text.check)(check) }<span class="unseen">{ ": " }{ words }</span>
            </li>
        }
    };
    html! {
        <section class="card step" aria-labelledby="dry-title">
            <h2 id="dry-title">{ text.dry }</h2>
            <p class="dim">{ text.dry_help }</p>
            <ul class="checks" data-testid="checks">{ for Check::ALL.into_iter().map(one) }</ul>
            if is_waiting { <p class="notice" data-testid="try-help">{ text.try_help }</p> }
            if let Some(bad) = &pilot.bad { <p class="dim" data-testid="bad">{ (text.came_wrong)(bad) }</p> }
            if let Some(rehearsal) = &state.rehearsal {
                <p class={if rehearsal.is_done { "good" } else { "notice" }} role="status" data-testid="rehearsed">
                    { (text.rehearsed)(rehearsal) }</p>
            }
            <p class="buttons">
                <button type="button" data-testid="try" disabled={!pilot.can_try(state.now)}
                    onclick={sends(act, Action::Try)}>{ text.try_stop }</button>
                <button type="button" data-testid="rehearse" disabled={state.plan().is_none()}
                    onclick={sends(act, Action::Rehearse)}>{ text.rehearse }</button>
            </p>
        </section>
    }
}

/// The fourth step: driving.
pub(super) fn drive(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let pilot = &state.pilot;
    let is_armed = matches!(pilot.driver.stage, Stage::Ready | Stage::Driving);
    let can_arm = is_armed || pilot.driver.stage == Stage::Off && pilot.is_fit(state.now);
    let chosen = SPEEDS.iter().position(|speed| *speed == state.limits().speed).unwrap_or(1);
    let speed =
        act.reform(|place: usize| Action::Speed(SPEEDS.get(place).copied().unwrap_or_default()));
    html! {
        <section class="card step" aria-labelledby="drive-title">
            <h2 id="drive-title">{ text.drive }</h2>
            <p class="dim">{ text.drive_help }</p>
            { select("speed", text.speed, text.speeds.into_iter(), chosen, speed) }
            <p class="buttons">
                <button type="button" class={if is_armed { "" } else { "primary" }} data-testid="arm" disabled={!can_arm}
                    onclick={sends(act, Action::Arm(!is_armed))}>
                    { if is_armed { text.disarm } else { text.arm } }</button>
            </p>
        </section>
    }
}
