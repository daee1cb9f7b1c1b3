//! The room: which world is open, its picture, undo and reset.

use super::canvas::Canvas;
use super::cells::Cells;
use crate::domain::State;
use crate::render::Options;
use crate::ui::action::Preferences;
use crate::ui::playback::STEP_MS;
use crate::ui::world::WORLDS;
use crate::ui::{Action, describe};
use yew::{Callback, Html, Properties, component, html};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) shown: State,
    pub(super) choice: usize,
    pub(super) can_undo: bool,
    pub(super) preferences: Preferences,
    pub(super) act: Callback<Action>,
}

/// The room and what can be done to it.
#[component]
pub(super) fn Stage(props: &Props) -> Html {
    let Props { shown, choice, can_undo, preferences, act } = props;
    let options = Options { theme: preferences.theme, letters: true, ..Options::default() };
    html! {
        <>
            <div class="card-head">
                <h2 id="room-title">{"The room"}</h2>
                <div class="switch" role="group" aria-label="Choose a world">
                    { for WORLDS.iter().enumerate().map(|(i, world)| html! {
                        <button type="button" aria-pressed={(i == *choice).to_string()}
                            data-testid={format!("world-{i}")}
                            onclick={act.reform(move |_| Action::PickWorld(i))}>{ world.name }</button>
                    }) }
                </div>
            </div>
            <Canvas shown={shown.clone()} options={options} step_ms={STEP_MS}
                label={describe::world(shown)} reduced_motion={preferences.reduced_motion} />
            <div class="caption">
                <p data-testid="robot-place">{ describe::robot(shown) }</p>
                <div class="buttons">
                    <button type="button" class="quiet" data-testid="undo" disabled={!can_undo}
                        onclick={act.reform(|_| Action::Undo)}>{"Undo"}</button>
                    <button type="button" class="quiet" data-testid="reset-world"
                        onclick={act.reform(|_| Action::ResetWorld)}>{"Reset world"}</button>
                </div>
            </div>
            <Cells shown={shown.clone()} />
        </>
    }
}
