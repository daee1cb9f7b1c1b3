//! A question: the readings to choose from side by side, each with where its goal would hold; chosen by a press, by
//! number, or by arrows and Enter.
use crate::render::Options;
use crate::ui::page::shared::Shared;
use crate::ui::page::view::host;
use crate::ui::page::view::picture::Picture;
use crate::ui::page::view::sends::sends;
use crate::ui::talk::action::Action;
use crate::ui::talk::command::ask::question;
use crate::ui::talk::command::state::CHOICES;
use crate::ui::talk::state::State;
use crate::ui::talk::why::help::Help;
use crate::ui::talk::words::Text;
use yew::{Callback, Html, KeyboardEvent, html};

/// The question that waits for an answer, if there is one.
pub(super) fn choices(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let (Some(asks), Some(said)) = (question(state, shared), &shared.document.said) else {
        return Html::default();
    };
    let text = Text::of(shared.language);
    let theme = shared.preferences.theme;
    let press = |at: usize| {
        let (act, asks) = (act.clone(), asks.to_vec());
        Callback::from(move |event: KeyboardEvent| {
            let count = asks.len().min(CHOICES.len());
            let next = match event.key().as_str() {
                "ArrowRight" | "ArrowDown" => (at + 1) % count,
                "ArrowLeft" | "ArrowUp" => (at + count - 1) % count,
                "Home" => 0,
                "End" => count - 1,
                key => {
                    let number = key.parse::<usize>().ok().and_then(|n| n.checked_sub(1));
                    if let Some(&reading) = number.and_then(|number| asks.get(number)) {
                        act.emit(Action::Choose(reading));
                    }
                    return;
                }
            };
            event.prevent_default();
            host::focus(CHOICES[next]);
        })
    };
    html! {
        <section class="question" aria-labelledby="question" data-testid="question">
            <h2 id="question">{ text.which(asks.len()) }</h2>
            <div class="choices">
                { for asks.iter().zip(CHOICES).enumerate().filter_map(|(at, (&place, id))| {
                    let reading = said.answer.readings.get(place)?;
                    let options = Options { theme, goal: reading.cells.clone(), ..Options::default() };
                    Some(html! {
                        <button type="button" {id} class="choice" data-testid="choice" onkeydown={press(at)}
                            aria-keyshortcuts={(at + 1).to_string()}
                            onclick={sends(act, Action::Choose(place))}
                            onmouseenter={sends(act, Action::Preview(Some(place)))}
                            onmouseleave={sends(act, Action::Preview(None))}
                            onfocus={sends(act, Action::Preview(Some(place)))}
                            onblur={sends(act, Action::Preview(None))}>
                            <span class="number" aria-hidden="true">{ at + 1 }</span>
                            <span>{ text.phrases.sentence(&reading.claim) }</span>
                            <Picture world={(*said.world).clone()} {options} label={text.where_it_holds} />
                        </button>
                    })
                }) }
            </div>
            <button type="button" class="quiet" data-testid="none-of-these"
                onclick={sends(act, Action::Help(Help::Teach))}>{ text.none_of_these }</button>
        </section>
    }
}
