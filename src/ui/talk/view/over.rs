//! What lies over the room's picture: the names of the rooms, what a finger can take hold of, and the question what
//! something means that was taken elsewhere.
use super::course::{drawn, shown_ways};
use crate::render::Extent;
use crate::ui::page::shared::Shared;
use crate::ui::page::view::sends::sends;
use crate::ui::talk::action::Action;
use crate::ui::talk::room::moved::Meant;
use crate::ui::talk::room::names::names;
use crate::ui::talk::room::state::{Mode, QUESTION};
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use yew::{Callback, Html, html};

/// Where the question stands, across and down: one of so many places each way.
const PLACES: f32 = 8.0;

/// Names on the walls, and what can be taken hold of, in the picture's own units.
pub(super) fn labels(state: &State, shared: &Shared) -> Html {
    let shown = state.shown(shared);
    let things = shown.objects.iter().map(|object| (object.x, object.y));
    let things = things.chain([(shown.agent.x, shown.agent.y)]);
    let is_watched = state.room.mode == Mode::Watch;
    html! {
        <>
            if is_watched { { drawn(state, shared) } }
            if state.room.mode == Mode::Teach { { shown_ways(state, shared) } }
            { for names(shown, Text::of(shared.language).phrases).into_iter().map(|name| html! {
                <text class="room-name" x={name.x.to_string()} y={(-name.y).to_string()} font-size=".28">{ name.text }</text>
            }) }
            if is_watched { { for things.map(|(x, y)| html! {
                <circle class="handle" cx={x.to_string()} cy={(-y).to_string()} r=".5" />
            }) } }
        </>
    }
}

/// What something means that was taken elsewhere: a lesson, or just that.
pub(super) fn question(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let Some(moved) = &state.room.moved else { return Html::default() };
    let text = Text::of(shared.language);
    let extent = Extent::of(&moved.world);
    let place = |at: i32, from: i32, count: u32| {
        let share = (at - from) as f32 / count.max(1) as f32;
        ((share * PLACES) as i32).clamp(0, PLACES as i32 - 1).to_string()
    };
    let (x, y) = moved.at;
    let mean = |meant: Meant| sends(act, Action::Mean(meant));
    html! {
        <div class="moved" role="group" aria-label={text.moved} data-testid="moved"
            data-x={place(x, extent.left, extent.columns)} data-y={place(y, extent.bottom, extent.rows)}>
            <button type="button" class="primary" id={QUESTION} data-testid="moved-teach"
                onclick={mean(Meant::Lesson)}>{ text.moved_teach }</button>
            <button type="button" data-testid="moved-keep" onclick={mean(Meant::World)}>{ text.moved_keep }</button>
            <button type="button" data-testid="moved-back" onclick={mean(Meant::Nothing)}>{ text.moved_back }</button>
        </div>
    }
}
