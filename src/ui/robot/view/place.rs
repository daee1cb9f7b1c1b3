//! Where the robot is: its rooms, how large a cell is, and how metres are mapped to cells.

use crate::ui::page::view::fields::number;
use crate::ui::page::view::sends::sends;
use crate::ui::page::world::WORLDS;
use crate::ui::robot::action::Action;
use crate::ui::robot::place::corner;
use crate::ui::robot::state::{Kind, State};
use crate::ui::robot::words::Text;
use web_sys::{Event, HtmlSelectElement, HtmlTextAreaElement, InputEvent};
use yew::{Callback, Html, TargetCast, html};

/// The second step: where it is.
pub(super) fn place(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let pick = act.reform(|event: Event| {
        let place = event.target_dyn_into::<HtmlSelectElement>().map(|s| s.selected_index());
        Action::World(place.and_then(|place| usize::try_from(place).ok()).unwrap_or(usize::MAX))
    });
    let drawn = act.reform(|event: InputEvent| {
        let field = event.target_dyn_into::<HtmlTextAreaElement>();
        Action::Drawing(field.map(|field| field.value()).unwrap_or_default())
    });
    html! {
        <section class="card step" aria-labelledby="place-title">
            <h2 id="place-title">{ text.place }</h2>
            <div class="fields">
                <label class="field" for="world">
                    <span>{ text.world }</span>
                    <select id="world" data-testid="world" onchange={pick}>
                        { for WORLDS.iter().enumerate().map(|(place, world)| html! {
                            <option selected={state.preset == Some(place)}>{ (text.world_name)(world.name) }</option>
                        }) }
                        if state.preset.is_none() { <option selected=true disabled=true>{ text.own_world }</option> }
                    </select>
                </label>
                { number("size".into(), text.size.into(), [state.size, 0.2, 3.0, 0.05], false, act.reform(Action::Size)) }
            </div>
            <details data-testid="own-rooms">
                <summary>{ text.drawing }</summary>
                <label class="unseen" for="drawing">{ text.drawing }</label>
                <textarea id="drawing" data-testid="drawing" rows="8" spellcheck="false" value={state.drawing.clone()}
                    oninput={drawn} aria-describedby="drawing-help" />
                <p class="dim" id="drawing-help">{ text.drawing_help }</p>
                if let Some(why) = &state.undrawn { <p class="notice bad" role="alert">{ why }</p> }
                <p class="buttons"><button type="button" data-testid="draw" onclick={sends(act, Action::Draw)}>
                    { text.draw }</button></p>
            </details>
            if state.kind == Kind::Real { { calibration(state, act) } }
            if let Some(found) = state.pilot.driver.calibration {
                <p class="good" data-testid="calibrated">{ (text.calibrated)(found.cell(), found.off) }</p>
                if state.is_recalled { <p class="notice" data-testid="recalled">{ text.recalled }</p> }
            }
        </section>
    }
}

fn calibration(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let is_seen = state.pilot.driver.pose().is_some();
    if let (Some(cell), Some(marks)) = (corner(state), &state.marks) {
        let cell = text.grammar.coordinates(cell);
        return html! {
            <>
                <p data-testid="corner">{ (text.corner)(marks.len() + 1, 4, &cell) }</p>
                <p class="buttons">
                    <button type="button" class="primary" data-testid="note" disabled={!is_seen}
                        onclick={sends(act, Action::Corner)}>{ text.note }</button>
                </p>
            </>
        };
    }
    html! {
        <>
            if let Some(why) = state.uncalibrated {
                <p class="notice bad" role="alert" data-testid="uncalibrated">{ (text.uncalibrated)(why) }</p>
            }
            <p class="buttons">
                <button type="button" data-testid="here" disabled={!is_seen} title={text.here_help}
                    onclick={sends(act, Action::Here)}>{ text.here }</button>
                <button type="button" data-testid="corners" disabled={!is_seen} title={text.corners_help}
                    onclick={sends(act, Action::Corners)}>{ text.corners }</button>
            </p>
            <p class="dim">{ text.here_help }{ " " }{ text.corners_help }</p>
        </>
    }
}
