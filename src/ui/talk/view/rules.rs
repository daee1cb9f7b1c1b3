//! What can happen in the world: how the robot is driven, what it may move, and what is left to chance.
use crate::ui::page::shared::Shared;
use crate::ui::page::view::sends::sends;
use crate::ui::talk::action::Action;
use crate::ui::talk::words::Text;
use crate::worker::protocol::WorldRules;
use web_sys::{Event, HtmlInputElement};
use yew::{Callback, Html, TargetCast, html};

/// The rules of the world.
#[inline(never)] // It comes late: www/split.mjs.
pub(super) fn rules(shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let rules = shared.document.rules;
    let switch = |id: &'static str,
                  label: &'static str,
                  on: bool,
                  set: fn(WorldRules, bool) -> WorldRules| {
        let changed = act.reform(move |event: Event| Action::SetRules(set(rules, checked(&event))));
        html! {
            <label class="check"><input type="checkbox" data-testid={id} checked={on} onchange={changed} />
                { label }</label>
        }
    };
    let chance = |id: &'static str,
                  label: &'static str,
                  value: f64,
                  set: fn(WorldRules, f64) -> WorldRules| {
        let changed = act.reform(move |event: Event| Action::SetRules(set(rules, number(&event))));
        html! {
            <label class="chance" for={id}>
                <span>{ label }</span>
                <input {id} type="range" min="0" max="0.9" step="0.05" value={value.to_string()} data-testid={id}
                    aria-valuetext={(text.percent)(value)} onchange={changed} />
                <output for={id}>{ (text.percent)(value) }</output>
            </label>
        }
    };
    html! {
        <section class="card" aria-labelledby="rules-title">
            <h2 id="rules-title">{ text.rules }</h2>
            <div class="rules">
                { switch("rule-landmarks", text.landmarks_stay, rules.landmarks_stay,
                    |r, landmarks_stay| WorldRules { landmarks_stay, ..r }) }
                { switch("rule-pull", text.can_pull, rules.pull, |r, pull| WorldRules { pull, ..r }) }
                { switch("rule-robot", text.drives, rules.robot, |r, robot| WorldRules { robot, ..r }) }
            </div>
            <h3>{ text.chance }</h3>
            { chance("rule-slip", text.slips, rules.slip, |r, slip| WorldRules { slip, ..r }) }
            { chance("rule-lock", text.locks, rules.lock, |r, lock| WorldRules { lock, ..r }) }
            { chance("rule-loss", text.loses, rules.loss, |r, loss| WorldRules { loss, ..r }) }
            <p class="buttons">
                <button type="button" class="quiet" data-testid="other-luck" disabled={rules.is_sure()}
                    onclick={sends(act, Action::SetRules(WorldRules { luck: rules.luck.wrapping_add(1), ..rules }))}>
                    { text.other_luck }</button>
            </p>
        </section>
    }
}

fn checked(event: &Event) -> bool {
    event.target_dyn_into::<HtmlInputElement>().is_some_and(|input| input.checked())
}

fn number(event: &Event) -> f64 {
    let value = event.target_dyn_into::<HtmlInputElement>().map(|input| input.value_as_number());
    value.filter(|value| (0.0..=1.0).contains(value)).unwrap_or(0.0)
}
