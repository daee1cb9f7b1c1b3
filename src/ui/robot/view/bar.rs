//! The bar below, which is always in reach: how it stands, the dead man's key, and the stop.

use crate::robot::Stage;
use crate::ui::page::view::sends::sends;
use crate::ui::robot::action::Action;
use crate::ui::robot::state::{Link, State};
use crate::ui::robot::words::Text;
use web_sys::{Element, MouseEvent, PointerEvent};
use yew::{Callback, Html, TargetCast, html};

/// The bar.
pub(super) fn bar(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let stage = &state.pilot.driver.stage;
    let is_off = matches!(stage, Stage::Off | Stage::Halted(_));
    let is_halted = matches!(stage, Stage::Halted(_));
    let held = {
        let act = act.clone();
        Callback::from(move |event: PointerEvent| {
            if event.button() == 0
                && let Some(button) = event.target_dyn_into::<Element>()
            {
                // A pointer that is gone already is let go by itself.
                let _ = button.set_pointer_capture(event.pointer_id());
                act.emit(Action::Held(true));
            }
        })
    };
    let let_go = act.reform(|_: PointerEvent| Action::Held(false));
    let menu = Callback::from(|event: MouseEvent| event.prevent_default());
    let said = match (&state.told, stage) {
        (Some(told), Stage::Off | Stage::Ready) => {
            format!("{} {}", (text.told)(told), (text.stage)(stage))
        }
        _ => (text.stage)(stage),
    };
    html! {
        <section class="bar" aria-label={text.stop}>
            <p class="said" data-testid="stage">{ said }</p>
            if is_halted {
                <button type="button" class="primary" data-testid="release"
                    onclick={sends(act, Action::Release)}>{ text.release }</button>
            } else {
                <button type="button" class="hold" data-hold="" data-testid="hold" disabled={is_off}
                    onpointerdown={held} onpointerup={let_go.clone()} onpointercancel={let_go.clone()}
                    onlostpointercapture={let_go} oncontextmenu={menu}>
                    { text.hold }<small>{ text.hold_help }</small>
                </button>
            }
            <button type="button" class="stop" data-testid="stop" disabled={state.link == Link::Off}
                onclick={sends(act, Action::Stop)}>{ text.stop }<small>{ "Esc" }</small></button>
        </section>
    }
}
