//! The room as the robot is seen in it, and the command: what is typed, how it was understood, and its plan.

use crate::domain::State as World;
use crate::render::{Options, Pose, Scene};
use crate::ui::page::view::sends::sends;
use crate::ui::page::view::sketch;
use crate::ui::robot::action::Action;
use crate::ui::robot::place::corner;
use crate::ui::robot::state::{Said, State};
use crate::ui::robot::think::is_asking;
use crate::ui::robot::words::Text;
use crate::worker::protocol::{Answer, Fate, Refers};
use std::f64::consts::FRAC_PI_2;
use web_sys::{HtmlInputElement, InputEvent, SubmitEvent};
use yew::{Callback, Html, TargetCast, html};

/// The room and the command.
pub(super) fn room(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let typed = act.reform(|event: InputEvent| {
        let field = event.target_dyn_into::<HtmlInputElement>();
        Action::Typed(field.map(|field| field.value()).unwrap_or_default())
    });
    let sent = act.reform(|event: SubmitEvent| {
        event.prevent_default();
        Action::Ask
    });
    let can_ask = state.model == Some(Ok(())) && !state.command.trim().is_empty();
    html! {
        <section class="card room" aria-label={text.room}>
            { picture(state) }
            <form class="say" onsubmit={sent}>
                <label for="command">{ text.command }</label>
                <input id="command" data-testid="command" lang="en" autocomplete="off" placeholder={text.command_hint}
                    value={state.command.clone()} oninput={typed} />
                <button type="submit" class="primary" data-testid="ask" disabled={!can_ask}>{ text.go }</button>
            </form>
            <div class="answer" data-testid="answer" aria-live="polite">{ answer(state, act) }</div>
        </section>
    }
}

/// The picture: the world as it is believed to be, the robot where it is seen.
fn picture(state: &State) -> Html {
    let text = Text::of(state.language);
    let driver = &state.pilot.driver;
    let shown: &World = &driver.world;
    let mut pose = Pose::of(shown);
    if let Some(place) = driver.place() {
        pose.robot = [place.x as f32, place.y as f32];
        // Pictures count from the north.
        pose.turn = (place.heading - FRAC_PI_2) as f32;
    }
    let route = state.plan().map(|plan| &plan.states[..]).unwrap_or_default();
    let highlight = match corner(state) {
        Some(cell) => vec![cell],
        None => route.iter().map(|state| (state.agent.x, state.agent.y)).collect(),
    };
    let options =
        Options { theme: state.preferences.theme, letters: true, highlight, ..Options::default() };
    let scene = Scene::posed(shown, &pose, &options);
    html! {
        <svg class="picture" role="img" data-testid="picture" aria-label={text.grammar.world(shown)}
            viewBox={sketch::view_box(&scene.extent)} data-x={format!("{:.2}", pose.robot[0])}
            data-y={format!("{:.2}", pose.robot[1])} data-turn={format!("{:.2}", pose.turn)}>
            { sketch::quads(&scene) }
        </svg>
    }
}

fn answer(state: &State, act: &Callback<Action>) -> Html {
    let text = Text::of(state.language);
    let waits = |words: &str| html! { <p class="dim">{ words }</p> };
    match &state.model {
        Some(Err(why)) => return html! { <p class="notice bad">{ (text.no_model)(why) }</p> },
        None if !state.command.is_empty() => return waits(text.loading),
        _ if is_asking(state) => return waits(text.thinking),
        _ => {}
    }
    let Some(said) = &state.said else { return Html::default() };
    let Said { answer, chosen, plan } = said;
    let sentence = |place: usize| {
        answer.readings.get(place).map(|reading| text.grammar.sentence(&reading.claim))
    };
    let Some(chosen) = *chosen else {
        return html! {
            <>
                { for trouble(text, answer).into_iter().map(|words| html! { <p class="notice" data-testid="why">{ words }</p> }) }
                if !answer.readings.is_empty() {
                    <p>{ text.which_meant }</p>
                    <p class="buttons">
                        { for (0..answer.readings.len().min(4)).map(|place| html! {
                            <button type="button" data-testid="reading" onclick={sends(act, Action::Choose(place))}>
                                { sentence(place) }</button>
                        }) }
                    </p>
                }
            </>
        };
    };
    let (done, of) = state.pilot.driver.route().map_or((0, 0), |route| route.progress());
    html! {
        <>
            <p><span class="dim">{ text.meant }{ " " }</span><strong data-testid="meant">{ sentence(chosen) }</strong></p>
            { match plan {
                Some(plan) if plan.reached && plan.actions.is_empty() => html! { <p class="notice">{ text.done_already }</p> },
                Some(plan) if plan.reached => html! {
                    <p data-testid="plan" data-steps={plan.actions.len().to_string()}>{ (text.plan)(done, of) }</p>
                },
                Some(plan) => {
                    let failing = answer.readings.get(chosen).into_iter().flat_map(|reading| &reading.phrases);
                    let failing = failing.filter(|phrase| !matches!(phrase.refers, Refers::One | Refers::Inner));
                    html! {
                        <>
                            { for failing.map(|phrase| html! { <p class="notice">{ text.grammar.failure(phrase) }</p> }) }
                            { match &plan.instead {
                                Some(instead) => {
                                    let demands = instead.demands.iter().map(|one| text.grammar.claim(one));
                                    let demands = text.grammar.list(&demands.collect::<Vec<_>>());
                                    let is_blocked = plan.reason.as_deref() == Some("unreachable");
                                    html! {
                                        <p class="notice" data-testid="demands">
                                            { (text.demands)(&demands) }{" "}
                                            <button type="button" data-testid="instead" onclick={sends(act, Action::Instead)}>
                                                { if is_blocked { text.without } else { text.once } }</button>
                                        </p>
                                    }
                                }
                                None => html! { <p class="notice" data-testid="no-way">{ text.no_way }</p> },
                            } }
                        </>
                    }
                }
                None => Html::default(),
            } }
        </>
    }
}

/// Why nothing is simply done.
fn trouble(text: &Text, answer: &Answer) -> Vec<String> {
    let of = |fate| {
        let words = answer.words.iter().filter(move |word| word.fate == fate);
        words.map(|word| &*word.text).collect::<Vec<_>>()
    };
    let (unknown, out) = (of(Fate::Unknown), of(Fate::Skipped));
    let mut all = Vec::new();
    if !unknown.is_empty() {
        all.push((text.unknown)(&unknown));
    }
    if !out.is_empty() {
        all.push((text.left_out)(&out));
    }
    if answer.readings.is_empty() {
        all.push(text.nothing.to_owned());
    }
    all
}
