//! Changing the room: tools, and other worlds: those that come with the page, random ones, and as text.

use super::select::Select;
use super::words::use_text;
use crate::domain::{Blueprint, Color, Lock, Shape, Size, Style};
use crate::ui::Action;
use crate::ui::edit::Look;
use crate::ui::room::{Room, Tool};
use crate::ui::text::Text;
use web_sys::{HtmlInputElement, HtmlTextAreaElement, SubmitEvent};
use yew::{Callback, Html, InputEvent, Properties, TargetCast, component, html};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) room: Room,
    pub(super) act: Callback<Action>,
}

/// The tools, with what they are set to.
#[component]
pub(super) fn Tools(props: &Props) -> Html {
    let text = use_text();
    let Props { room, act } = props;
    html! {
        <div class="toolbox">
            <div class="switch wrap" role="group" aria-label={text.tools}>
                { for Tool::ALL.into_iter().map(|tool| html! {
                    <button type="button" aria-pressed={(tool == room.tool).to_string()}
                        data-testid={format!("tool-{tool:?}").to_lowercase()}
                        onclick={act.reform(move |_| Action::Take(tool))}>{ text.tool_name(tool) }</button>
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

fn settings(text: &'static Text, room: &Room, act: &Callback<Action>) -> Html {
    let look = room.look;
    match room.tool {
        Tool::Object => {
            let sizes: Vec<Option<Size>> =
                std::iter::once(None).chain(Size::ALL.iter().copied().map(Some)).collect();
            html! {
                <div class="fields">
                    <Select<Shape> id="look-shape" label={text.shape} all={Shape::ALL.to_vec()} chosen={look.shape}
                        name={Callback::from(|s| text_shape(text, s))}
                        choose={act.reform(move |shape| Action::SetLook(Look { shape, ..look }))} />
                    <Select<Color> id="look-color" label={text.color} all={Color::ALL.to_vec()} chosen={look.color}
                        name={Callback::from(|c: Color| text.color_name(c).to_owned())}
                        choose={act.reform(move |color| Action::SetLook(Look { color, ..look }))} />
                    <Select<Option<Size>> id="look-size" label={text.size} all={sizes} chosen={look.size}
                        name={Callback::from(|s| text.size_name(s).to_owned())}
                        choose={act.reform(move |size| Action::SetLook(Look { size, ..look }))} />
                </div>
            }
        }
        Tool::Room => html! {
            <div class="fields">
                <Select<Color> id="paint" label={text.color} all={Color::ALL.to_vec()} chosen={room.paint}
                    name={Callback::from(|c: Color| text.color_name(c).to_owned())}
                    choose={act.reform(Action::SetPaint)} />
            </div>
        },
        _ => Html::default(),
    }
}

fn text_shape(text: &Text, shape: Shape) -> String {
    text.shape_name(shape).to_owned()
}

/// Random worlds, and the world as text.
#[component]
pub(super) fn Worlds(props: &Props) -> Html {
    let text = use_text();
    let Props { room, act } = props;
    let Room { blueprint, seed, text: drawing, notice, .. } = room;
    let blueprint = *blueprint;
    let draw = act.reform(|event: SubmitEvent| {
        event.prevent_default();
        Action::DrawWorld
    });
    let number = |id: &'static str,
                  label: &'static str,
                  value: u32,
                  range: (u32, u32),
                  set: fn(Blueprint, u32) -> Blueprint| {
        let typed = act.reform(move |event: InputEvent| {
            Action::SetBlueprint(set(blueprint, typed(&event).unwrap_or(value)))
        });
        field(id, label, value, range, typed)
    };
    let seeded = {
        let seed = *seed;
        act.reform(move |event: InputEvent| Action::SetSeed(typed(&event).unwrap_or(seed)))
    };
    html! {
        <details class="worlds" data-testid="worlds">
            <summary>{ text.random_world }</summary>
            <form class="fields" onsubmit={draw}>
                <Select<Style> id="world-style" label={text.style} all={Style::ALL.to_vec()} chosen={blueprint.style}
                    name={Callback::from(|s: Style| text.style_name(s).to_owned())}
                    choose={act.reform(move |style| Action::SetBlueprint(Blueprint { style, ..blueprint }))} />
                { number("world-rooms", text.rooms, blueprint.rooms, (3, 12), |b, rooms| Blueprint { rooms, ..b }) }
                { number("world-columns", text.columns, blueprint.columns, (7, 32), |b, columns| Blueprint { columns, ..b }) }
                { number("world-rows", text.rows, blueprint.rows, (7, 32), |b, rows| Blueprint { rows, ..b }) }
                { number("world-objects", text.objects, blueprint.objects, (0, 8), |b, objects| Blueprint { objects, ..b }) }
                <Select<Lock> id="world-lock" label={text.doors} all={Lock::ALL.to_vec()} chosen={blueprint.lock}
                    name={Callback::from(|l: Lock| text.lock_name(l).to_owned())}
                    choose={act.reform(move |lock| Action::SetBlueprint(Blueprint { lock, ..blueprint }))} />
                { field("world-seed", text.seed, *seed, (0, u32::MAX), seeded) }
                <button type="submit" class="plain" data-testid="draw-world">{ text.draw }</button>
            </form>
            <p class="buttons">
                <button type="button" class="quiet" data-testid="world-text" aria-expanded={drawing.is_some().to_string()}
                    onclick={act.reform(|_| Action::ToggleText)}>
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
                    onclick={act.reform(|_| Action::ApplyText)}>{ text.open_this }</button>
                <button type="button" class="quiet" data-testid="copy-text"
                    onclick={act.reform(move |_| copied.clone())}>{ text.copy }</button>
            </p>
        </div>
    }
}

fn typed(event: &InputEvent) -> Option<u32> {
    event.target_dyn_into::<HtmlInputElement>()?.value().parse().ok()
}

fn field(
    id: &'static str,
    label: &'static str,
    value: u32,
    (min, max): (u32, u32),
    typed: Callback<InputEvent>,
) -> Html {
    html! {
        <label class="field" for={id}>
            <span>{ label }</span>
            <input {id} type="number" inputmode="numeric" min={min.to_string()} max={max.to_string()}
                value={value.to_string()} data-testid={id} oninput={typed} />
        </label>
    }
}
