//! The room: which world is open and what the room is for, the picture, and what goes with that.
use super::controls::controls;
use super::edit::{tools, worlds};
use super::stage::stage;
use super::teach::lesson;
use crate::ui::page::shared::Shared;
use crate::ui::page::view::sends::sends;
use crate::ui::page::view::sign::{Sign, picture, sign};
use crate::ui::page::world::WORLDS;
use crate::ui::talk::action::Action;
use crate::ui::talk::room::state::Mode;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use web_sys::{Event, HtmlSelectElement};
use yew::{Callback, Html, TargetCast, html};

/// The room.
pub(super) fn room(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let mode = state.room.mode;
    let pick = act.reform(|event: Event| {
        let place = event.target_dyn_into::<HtmlSelectElement>().map(|s| s.selected_index());
        Action::PickWorld(place.and_then(|place| usize::try_from(place).ok()).unwrap_or(usize::MAX))
    });
    let preset = shared.document.preset;
    html! {
        <section id="room" class="room" aria-labelledby="room-title" tabindex="-1">
            <div class="room-head">
                <h2 id="room-title" class="unseen">{ text.the_room }</h2>
                <div class="tools">
                    <label class="unseen" for="world">{ text.choose_world }</label>
                    <select id="world" data-testid="world" onchange={pick}>
                        { for WORLDS.iter().enumerate().map(|(place, world)| html! {
                            <option selected={preset == Some(place)}>{ text.world_name(world.name) }</option>
                        }) }
                        if preset.is_none() { <option selected=true disabled=true>{ text.own_world }</option> }
                    </select>
                    { sign("dice", text.another_world, Sign::Dice, false, act.reform(|()| Action::DrawWorld)) }
                    { sign("reset-world", text.reset, Sign::Reset, shared.document.world == *shared.document.origin
                        && state.watch.playback.is_none(), act.reform(|()| Action::ResetWorld)) }
                </div>
                <div class="tools" role="group" aria-label={text.room_is_for}>
                    { turn(Mode::Teach, Sign::Hand, text, mode, act) }
                    { turn(Mode::Edit, Sign::Pencil, text, mode, act) }
                </div>
            </div>
            if mode == Mode::Edit { { tools(state, shared, act) } }
            <div id="scene">
                { stage(state, shared, act) }
                if mode == Mode::Watch { { controls(state, shared, act) } }
            </div>
            { match mode {
                Mode::Watch => Html::default(),
                Mode::Edit => worlds(state, shared, act),
                Mode::Teach => lesson(state, shared, act),
            } }
        </section>
    }
}

/// Turns the room over to something, and back to watching when it is pressed again.
fn turn(to: Mode, sign: Sign, text: &'static Text, mode: Mode, act: &Callback<Action>) -> Html {
    let next = if mode == to { Mode::Watch } else { to };
    html! {
        <button type="button" class="turn" aria-pressed={(to == mode).to_string()} title={text.mode_help(to)}
            data-testid={format!("mode-{to:?}").to_ascii_lowercase()}
            onclick={sends(act, Action::SetMode(next))}>
            { picture(sign) }<span>{ text.mode_name(to) }</span></button>
    }
}
