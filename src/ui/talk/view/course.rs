//! A task over time as a strip of its steps, what it forbids behind them; and in the room's picture the cells that are
//! forbidden and the way so far.
use crate::ui::page::shared::Shared;
use crate::ui::page::view::picture::line;
use crate::ui::page::way::states;
use crate::ui::talk::state::State;
use crate::ui::talk::watch::course::{Stand, forbidden, strip, way};
use crate::ui::talk::words::Text;
use yew::{Html, html};

/// The steps, of which one is next.
pub(super) fn course(state: &State, shared: &Shared) -> Html {
    let Some(strip) = strip(state, shared) else { return Html::default() };
    let text = Text::of(shared.language);
    html! {
        <ol class="course" aria-label={text.course} data-testid="course">
            { for strip.steps.into_iter().map(|(words, stand)| {
                let name = match stand { Stand::Done => "done", Stand::Next => "next", Stand::Later => "later" };
                html! { <li class={name} aria-current={(stand == Stand::Next).then_some("step")} data-testid="step" data-stand={name}>{ words }</li> }
            }) }
            { for strip.never.into_iter().map(|words| html! {
                <li class="never" data-testid="never">{ text.never }<s>{ words }</s></li>
            }) }
        </ol>
    }
}

/// What of a task over time is seen in the picture, in its own units.
pub(super) fn drawn(state: &State, shared: &Shared) -> Html {
    html! {
        <>
            if !forbidden(state, shared).is_empty() {
                <pattern id="forbidden" width=".25" height=".25" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
                    <path d="M.06 0v.25" />
                </pattern>
            }
            { for forbidden(state, shared).iter().map(|(x, y)| html! {
                <rect class="forbidden" x={(f64::from(*x) - 0.5).to_string()} y={(f64::from(-y) - 0.5).to_string()} width="1" height="1" />
            }) }
            { line("way", way(state, shared)) }
        </>
    }
}

/// The ways of a demonstration: the one that is driven, the ones that are not meant, and the one that the page would have
/// taken.
pub(super) fn shown_ways(state: &State, shared: &Shared) -> Html {
    let Some(draft) = &shared.document.draft else { return Html::default() };
    let unlike = draft.contrasts.iter().chain(&state.teach.straight);
    html! {
        <>
            { for unlike.map(|way| line("way unlike", &states(&draft.before, way))) }
            { for draft.way.iter().map(|way| line("way", &states(&draft.before, way))) }
        </>
    }
}
