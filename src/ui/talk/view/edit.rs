//! Changing the room: tools, and other worlds: those that come with the page, random ones, and as text.
use crate::domain::{Blueprint, Color, Lock, Shape, Size, Style};
use crate::ui::page::shared::Shared;
use crate::ui::page::view::fields::number;
use crate::ui::page::view::select::select;
use crate::ui::page::view::sends::sends;
use crate::ui::talk::action::Action;
use crate::ui::talk::room::edit::Look;
use crate::ui::talk::room::state::{Room, Tool};
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use web_sys::{HtmlTextAreaElement, SubmitEvent};
use yew::{Callback, Html, InputEvent, TargetCast, html};

/// The tools, with what they are set to.
#[inline(never)] // It comes late: www/split.mjs.
pub(super) fn tools(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let room = &state.room;
    html! {
        <div class="toolbox">
            <div class="switch wrap" role="group" aria-label={text.tools}>
                { for Tool::ALL.into_iter().map(|tool| html! {
                    <button type="button" aria-pressed={(tool == room.tool).to_string()}
                        data-testid={format!("tool-{tool:?}").to_ascii_lowercase()}
                        onclick={sends(act, Action::Take(tool))}>{ text.tool_name(tool) }</button>
                }) }
            </div>
            { settings(text, room, act) }
            <p class="dim">{ text.tool_help(room.tool) }</p>
            if let Some(obstacle) = room.obstacle {
                <p class="notice" role="alert" data-testid="obstacle">{ text.obstacle(obstacle) }</p>
            }
        </div>
    }
}

/// What the tool is set to.
fn settings(text: &'static Text, room: &Room, act: &Callback<Action>) -> Html {
    let look = room.look;
    let colors = || Color::ALL.iter().map(|color| text.phrases.color(*color));
    match room.tool {
        Tool::Object => {
            let shapes = Shape::ALL.iter().map(|shape| text.phrases.shape(*shape));
            let size = sizes().position(|size| size == look.size).unwrap_or(0);
            let shaped =
                act.reform(move |n| Action::SetLook(Look { shape: at(Shape::ALL, n), ..look }));
            let colored =
                act.reform(move |n| Action::SetLook(Look { color: at(Color::ALL, n), ..look }));
            let sized = act
                .reform(move |n| Action::SetLook(Look { size: sizes().nth(n).flatten(), ..look }));
            html! {
                <div class="fields">
                    { select("look-shape", text.shape, shapes, look.shape as usize, shaped) }
                    { select("look-color", text.color, colors(), look.color as usize, colored) }
                    { select("look-size", text.size, sizes().map(|s| text.size_name(s)), size, sized) }
                </div>
            }
        }
        Tool::Room => {
            let painted = act.reform(|n| Action::SetPaint(at(Color::ALL, n)));
            html! {
                <div class="fields">
                    { select("paint", text.color, colors(), room.paint as usize, painted) }
                </div>
            }
        }
        _ => Html::default(),
    }
}

/// The sizes that an object may have; none goes first.
fn sizes() -> impl Iterator<Item = Option<Size>> {
    std::iter::once(None).chain(Size::ALL.iter().copied().map(Some))
}

/// The value at a place that a choice was made of; the first, should there be none.
fn at<T: Copy>(all: &[T], place: usize) -> T {
    all.get(place).copied().unwrap_or(all[0])
}

/// Random worlds, and the world as text.
#[inline(never)] // It comes late: www/split.mjs.
pub(super) fn worlds(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let Room { blueprint, seed, text: drawing, notice, .. } = &state.room;
    let blueprint = *blueprint;
    let draw = act.reform(|event: SubmitEvent| {
        event.prevent_default();
        Action::DrawWorld
    });
    let whole = |id: &'static str, label: &'static str, values: [u32; 3], set: Callback<u32>| {
        let [value, least, most] = values.map(f64::from);
        number(id.into(), label.into(), [value, least, most, 1.0], false, set.reform(|n| n as u32))
    };
    let count = |id, label, values, set: fn(Blueprint, u32) -> Blueprint| {
        let set = act.reform(move |n| Action::SetBlueprint(set(blueprint, n)));
        whole(id, label, values, set)
    };
    let seeded = act.reform(Action::SetSeed);
    let styled = act
        .reform(move |n| Action::SetBlueprint(Blueprint { style: at(Style::ALL, n), ..blueprint }));
    let locked = act
        .reform(move |n| Action::SetBlueprint(Blueprint { lock: at(Lock::ALL, n), ..blueprint }));
    html! {
        <details class="worlds" data-testid="worlds">
            <summary>{ text.random_world }</summary>
            <form class="fields" onsubmit={draw}>
                { select("world-style", text.style, text.styles.into_iter(), blueprint.style as usize, styled) }
                { count("world-rooms", text.rooms, [blueprint.rooms, 3, 12], |b, rooms| Blueprint { rooms, ..b }) }
                { count("world-columns", text.columns, [blueprint.columns, 7, 32], |b, columns| Blueprint { columns, ..b }) }
                { count("world-rows", text.rows, [blueprint.rows, 7, 32], |b, rows| Blueprint { rows, ..b }) }
                { count("world-objects", text.objects, [blueprint.objects, 0, 8], |b, objects| Blueprint { objects, ..b }) }
                { select("world-lock", text.doors, text.lock_names.into_iter(), blueprint.lock as usize, locked) }
                { whole("world-seed", text.seed, [*seed, 0, u32::MAX], seeded) }
                <button type="submit" class="plain" data-testid="draw-world">{ text.draw }</button>
            </form>
            <p class="buttons">
                <button type="button" class="quiet" data-testid="world-text" aria-expanded={drawing.is_some().to_string()}
                    onclick={sends(act, Action::ToggleText)}>
                    { if drawing.is_some() { text.hide_text } else { text.as_text } }</button>
            </p>
            if let Some(drawing) = drawing { { as_text(text, drawing, act) } }
            if let Some(notice) = notice {
                <p class="notice" role="alert" data-testid="world-notice">{ notice }</p>
            }
        </details>
    }
}

fn as_text(text: &'static Text, drawing: &str, act: &Callback<Action>) -> Html {
    let changed = act.reform(|event: InputEvent| {
        let area = event.target_dyn_into::<HtmlTextAreaElement>();
        Action::TypedText(area.map(|area| area.value()).unwrap_or_default())
    });
    let copied = Action::Copy(drawing.to_owned());
    html! {
        <div class="drawing">
            <label for="drawing">{ text.world_as_text }</label>
            <textarea id="drawing" spellcheck="false" rows="14" data-testid="drawing"
                value={drawing.to_owned()} oninput={changed} />
            <p class="buttons">
                <button type="button" class="plain" data-testid="apply-text"
                    onclick={sends(act, Action::ApplyText)}>{ text.open_this }</button>
                <button type="button" class="quiet" data-testid="copy-text"
                    onclick={sends(act, copied)}>{ text.copy }</button>
            </p>
        </div>
    }
}
