//! Which robot it is, where its bridge listens, and how it is wired.

use crate::robot::session::{Role, Topic as Asked};
use crate::ui::page::view::fields::{choice, line};
use crate::ui::page::view::sends::sends;
use crate::ui::robot::action::Action;
use crate::ui::robot::state::{Kind, Link, State, TYPES, Topic};
use crate::ui::robot::words::Text;
use web_sys::{HtmlInputElement, InputEvent};
use yew::{Callback, Html, TargetCast, html};

/// The first step: the robot.
pub(super) fn robot(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let is_real = state.kind == Kind::Real;
    let is_off = state.link == Link::Off;
    let pick = |kind: Kind, words: &'static str, id: &'static str| {
        html! {
            <label class="pick"><input type="radio" name="robot" data-testid={id} checked={state.kind == kind}
                onchange={sends(act, Action::Pick(kind))} />{ words }</label>
        }
    };
    let words = match (is_real, is_off) {
        (true, true) => text.link,
        (true, false) => text.unlink,
        (false, true) => text.start,
        (false, false) => text.end,
    };
    html! {
        <section class="card step" aria-labelledby="robot-title">
            <h2 id="robot-title">{ text.robot }</h2>
            <div class="picks" role="radiogroup" aria-label={text.which}>
                { pick(Kind::Simulated, text.simulated, "simulated") }
                { pick(Kind::Real, text.real, "real") }
            </div>
            if is_real {
                { line("address", text.address, "url", &state.address, act.reform(Action::Address)) }
            }
            if let Some(fault) = state.fault {
                <p class="notice bad" role="alert" data-testid="address-fault">{ (text.fault)(fault) }</p>
            }
            <p class="buttons">
                <button type="button" class={if is_off { "primary" } else { "" }} data-testid="link"
                    onclick={sends(act, Action::Link(is_off))}>{ words }</button>
                <span class="dim" data-testid="linked">{ (text.linked)(state.link) }</span>
            </p>
            if is_real { { topics(state, act) } }
        </section>
    }
}

fn topics(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let wiring = &state.wiring;
    let chosen = wiring.types.and_then(|types| {
        TYPES.iter().position(|&(generation, command)| {
            (generation, command) == (types.generation, types.command)
        })
    });
    let name =
        |(generation, command): &(_, crate::robot::message::Command)| command.name(*generation);
    let names: Vec<String> =
        std::iter::once(text.types_asked.to_owned()).chain(TYPES.iter().map(name)).collect();
    let types = act.reform(|place: usize| Action::Types(place.checked_sub(1)));
    let known = |role: Role| {
        let topic: Option<&Asked> =
            state.pilot.session.topics().iter().find(|topic| topic.role == role);
        let is_open = state.link == Link::Open;
        html! {
            if let Some(topic) = topic.filter(|_| is_open) {
                <p class="dim known">{ (text.kind)(&topic.kind) }</p>
            }
        }
    };
    let own = |topic: Topic| act.reform(move |name: String| Action::Name(topic, name));
    let objects = wiring.bodies.iter().enumerate().filter_map(|(at, (_, topic))| {
        let object = state.world.objects.get(at)?;
        let typed = own(Topic::Object(at)).reform(|event: InputEvent| {
            event.target_dyn_into::<HtmlInputElement>().map_or(String::new(), |input| input.value())
        });
        Some(html! {
            <label class="field">
                <span>{ (text.object)(&text.grammar.object(object)) }</span>
                <input value={topic.clone()} oninput={typed} autocomplete="off" />
            </label>
        })
    });
    html! {
        <details data-testid="topics">
            <summary>{ text.topics }</summary>
            { line("velocity", text.velocity, "text", &wiring.velocity, own(Topic::Velocity)) }
            { known(Role::Velocity) }
            { line("pose", text.pose, "text", &wiring.pose, own(Topic::Pose)) }
            { known(Role::Robot) }
            { for objects }
            if !wiring.bodies.is_empty() { <p class="dim">{ text.objects }</p> }
            { choice("types".into(), text.types.into(), &names, chosen.map_or(0, |at| at + 1), types) }
        </details>
    }
}
