//! The room: what it is for, its picture, what is held in it; driven by a pointer or by keys.
use super::canvas::Canvas;
use super::cells::Cells;
use super::over::{labels, question};
use crate::domain::Direction;
use crate::ui::page::shared::Shared;
use crate::ui::talk::action::Action;
use crate::ui::talk::room::overlay;
use crate::ui::talk::room::point::Key;
use crate::ui::talk::room::state::Mode;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use yew::{Callback, Html, KeyboardEvent, html};

/// The room's picture, which takes the keyboard's focus.
pub(super) fn stage(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let (shown, mode) = (state.shown(shared), state.room.mode);
    let press = {
        let act = act.clone();
        Callback::from(move |event: KeyboardEvent| {
            if event.ctrl_key() || event.alt_key() || event.meta_key() {
                return;
            }
            if let Some(key) = key(&event.key(), event.shift_key()) {
                event.prevent_default();
                act.emit(Action::Press(key));
            }
        })
    };
    html! {
        <>
            <div class="room-keys" tabindex="0" role="application" aria-label={text.room_keys}
                aria-describedby="room-help" data-testid="room" onkeydown={press}>
                <Canvas shown={shown.clone()} options={overlay::options(state, shared)} playing={state.watch.playback.as_ref().is_some_and(|plan| plan.playing())}
                    step_ms={state.watch.speed.step_ms()}
                    reduced_motion={shared.preferences.reduced_motion} label={text.phrases.world(shown)}
                    interactive={mode != Mode::Watch} on_point={act.reform(Action::Point)} labels={labels(state, shared)} />
                { question(state, shared, act) }
            </div>
            <p id="room-help" class="unseen">{ text.keys_help(mode) }</p>
            if state.watch.playback.is_none() && mode == Mode::Watch {
                <p class="caption" data-testid="robot-place">{ text.phrases.robot(shown) }</p>
            }
        </>
    }
}

/// What lies below it all: the room cell by cell, for those who do not see the picture, and which model reads.
pub(super) fn cells(state: &State, shared: &Shared) -> Html {
    let text = Text::of(shared.language);
    let model = shared.document.model.as_ref();
    html! {
        <div class="below">
            <Cells shown={state.shown(shared).clone()} language={shared.language} />
            if let Some(model) = model {
                <p class="dim" data-testid="model-in-use">
                    { (text.model_in_use)(&model.origin, model.report.entries, shared.document.lessons.len()) }
                </p>
            }
        </div>
    }
}

fn key(name: &str, shift: bool) -> Option<Key> {
    Some(match name {
        "ArrowUp" => Key::Arrow(Direction::North, shift),
        "ArrowDown" => Key::Arrow(Direction::South, shift),
        "ArrowLeft" => Key::Arrow(Direction::West, shift),
        "ArrowRight" => Key::Arrow(Direction::East, shift),
        "Enter" | " " => Key::Act,
        "Escape" => Key::Cancel,
        "r" | "R" => Key::Turn,
        _ => return None,
    })
}
