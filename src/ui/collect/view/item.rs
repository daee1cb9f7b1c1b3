//! A turn: its pictures, what changed in them, and the box for the command. And the worked example, which looks alike.

use crate::domain::State as World;
use crate::render::Options;
use crate::study::Showing;
use crate::ui::collect::action::Action;
use crate::ui::collect::change::changed;
use crate::ui::collect::runs::on_view;
use crate::ui::collect::state::State;
use crate::ui::collect::words::Text;
use crate::ui::page::view::picture::Picture;
use js_sys::Reflect;
use web_sys::{HtmlTextAreaElement, InputEvent, KeyboardEvent, SubmitEvent};
use yew::{AttrValue, Callback, Html, TargetCast, html};

/// A turn, from 0.
pub(super) fn turn(state: &State, at: usize, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let Some(sitting) = &state.sitting else {
        return Html::default();
    };
    let shows = on_view(state);
    let typed = act.reform(|event: InputEvent| {
        // Not every program that types for a person says how.
        let kind = Reflect::get(&event, &"inputType".into()).ok().and_then(|kind| kind.as_string());
        let pasted = match kind.as_deref().unwrap_or_default() {
            "insertFromPaste" | "insertFromDrop" => {
                let data = event.data().map_or(0, |data| data.chars().count());
                // Some browsers do not say what was pasted.
                (data as u32).max(1)
            }
            _ => 0,
        };
        let field = event.target_dyn_into::<HtmlTextAreaElement>();
        let value = field.map(|field| field.value()).unwrap_or_default();
        let pasted = if pasted == 1 { value.chars().count() as u32 } else { pasted };
        Action::Typed(value, pasted)
    });
    let sent = act.reform(|event: SubmitEvent| {
        event.prevent_default();
        Action::Answer
    });
    let pressed = {
        let act = act.clone();
        Callback::from(move |event: KeyboardEvent| {
            if event.key() == "Enter" && !event.shift_key() && !event.is_composing() {
                event.prevent_default();
                act.emit(Action::Answer);
            }
        })
    };
    let of = sitting.turns.len();
    let is_empty = state.text.trim().is_empty();
    html! {
        <section class="turn" aria-labelledby="heading">
            <p class="progress">
                <progress max={of.to_string()} value={at.to_string()} aria-label={(text.item)(at + 1, of)} />
                <span>{ (text.item)(at + 1, of) }</span>
            </p>
            <h1 id="heading" tabindex="-1">{ (text.ask)(shows.len()) }</h1>
            { showings(state, &shows, act) }
            <form class="answer-box" onsubmit={sent}>
                <label for="command">{ text.command }</label>
                <textarea id="command" data-testid="command" rows="2" maxlength="20000" value={state.text.clone()} oninput={typed}
                    onkeydown={pressed} aria-describedby="hint" autocomplete="off" spellcheck="false" />
                <p class="dim" id="hint">{ text.hint }</p>
                <button type="submit" class="primary" data-testid="next" disabled={is_empty}>
                    { text.next }
                </button>
            </form>
        </section>
    }
}

/// Showings beside one another, each with what changed on demand.
pub(super) fn showings(state: &State, shows: &[&Showing], act: &Callback<Action>) -> Html {
    html! {
        <ol class="showings">{ for shows.iter().enumerate().map(|(at, showing)| one(state, at, showing, act)) }</ol>
    }
}

fn one(state: &State, at: usize, showing: &Showing, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let inner = match showing.steps() {
        None => pair(state, at, showing, act),
        Some(steps) => run(state, (at, steps), showing, act),
    };
    html! {
        <li data-showing="" data-testid="showing">
            <h2>{ (text.showing)(at + 1) }</h2>
            { inner }
        </li>
    }
}

/// Before and after, and what changed on demand.
fn pair(state: &State, at: usize, showing: &Showing, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let is_pointed = state.pointed.contains(&at);
    let (pre, post) = showing.states();
    let [from, to] = if is_pointed { changed(showing) } else { Default::default() };
    let id = format!("change-{}", at + 1);
    html! {
        <>
            <div class="both">
                { picture(state, pre, from, text.before) }
                { picture(state, post, to, text.after) }
            </div>
            <button type="button" class="quiet" data-testid={id} aria-pressed={is_pointed.to_string()}
                onclick={act.reform(move |_| Action::Point(at))}>
                { if is_pointed { text.hide_change } else { text.show_change } }
            </button>
            // For those who do not see the picture alone: words here would become everybody's words.
            <p class="changed unseen" aria-live="polite">
                if is_pointed { { text.grammar.change(pre, post) } }
            </p>
        </>
    }
}

/// A run: where the robot is on its way, and what has it go on.
fn run(
    state: &State,
    (at, steps): (usize, usize),
    showing: &Showing,
    act: &Callback<Action>,
) -> Html {
    let text = Text::of(state.language);
    let gone = state.runs.gone.get(&at).copied().unwrap_or(0);
    let is_playing = state.runs.playing == Some(at);
    let (world, (start, _)) = (showing.behind(gone), showing.states());
    let named = |name: &str| format!("{name}-{}", at + 1);
    html! {
        <>
            { picture(state, &world, Vec::new(), (text.step)(gone, steps)) }
            <p class="buttons">
                <button type="button" class="plain" data-testid={named("play")}
                    onclick={act.reform(move |_| Action::Play(at))}>
                    { if is_playing { text.pause } else { text.play } }
                </button>
                <button type="button" class="quiet" data-testid={named("step")} disabled={gone == steps}
                    onclick={act.reform(move |_| Action::Step(at))}>{ text.one_step }</button>
            </p>
            // As above; while it plays there is no time to be told of every step.
            <p class="changed unseen" aria-live="polite">
                if gone > 0 && !is_playing { { text.grammar.change(start, &world) } }
            </p>
        </>
    }
}

fn picture(
    state: &State,
    world: &World,
    highlight: Vec<(i32, i32)>,
    words: impl Into<AttrValue>,
) -> Html {
    let (text, words) = (Text::of(state.language), words.into());
    let theme = state.preferences.theme;
    let options = Options { theme, letters: true, highlight, ..Options::default() };
    let label = format!("{words}: {}", text.grammar.world(world));
    html! {
        <figure>
            <figcaption>{ words }</figcaption>
            <Picture world={world.clone()} {options} {label} />
        </figure>
    }
}

/// A button that does something.
pub(super) fn button(
    id: &'static str,
    class: &'static str,
    words: &str,
    act: &Callback<Action>,
    action: Action,
) -> Html {
    let pressed = act.reform(move |_: yew::MouseEvent| action.clone());
    html! { <button type="button" {class} data-testid={id} onclick={pressed}>{ words }</button> }
}
