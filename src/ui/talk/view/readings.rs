//! The readings of a command: what each says, what tells it from the best, where its goal would be; and what its
//! phrases stand for.
use crate::render::Options;
use crate::ui::page::document::Said;
use crate::ui::page::shared::Shared;
use crate::ui::page::view::picture::Picture;
use crate::ui::page::view::sends::sends;
use crate::ui::talk::action::Action;
use crate::ui::talk::command::link::{self, Link};
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use crate::worker::protocol::{Answer, Reading};
use yew::{Callback, Html, classes, html};

/// So many readings are shown at first, and all that are equally likely.
const FIRST: usize = 4;

/// The readings, best first.
#[inline(never)] // It comes late: www/split.mjs.
pub(super) fn readings(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let said = shared.document.said.as_ref().filter(|_| state.command.live.is_none());
    let Some(Said { world, answer, chosen, .. }) = said else { return Html::default() };
    if answer.readings.is_empty() {
        return Html::default();
    }
    let (link, theme) = (state.command.link, shared.preferences.theme);
    let shown = if state.command.all_readings {
        answer.readings.len()
    } else {
        FIRST.max(chosen + 1).max(tied(answer))
    };
    let best = answer.readings.first().map_or(0.0, |reading| reading.score);
    html! {
        <section class="card" aria-labelledby="readings-title">
            <div class="card-head">
                <h2 id="readings-title">{ text.readings }</h2>
                <span class="tag">{ answer.readings.len() }</span>
            </div>
            <ul class="readings" aria-label={text.readings}>
                { for answer.readings.iter().enumerate().take(shown).map(|(place, reading)| {
                    let options = Options { theme, goal: reading.cells.clone(), ..Options::default() };
                    html! {
                        <li key={reading.form.clone()}>
                            <button type="button" aria-pressed={(place == *chosen).to_string()}
                                class="reading" data-testid="reading"
                                onclick={sends(act, Action::Choose(place))}
                                onmouseenter={sends(act, Action::Preview(Some(place)))}
                                onmouseleave={sends(act, Action::Preview(None))}
                                onfocus={sends(act, Action::Preview(Some(place)))}
                                onblur={sends(act, Action::Preview(None))}>
                                <Picture world={(**world).clone()} {options} label={text.where_it_holds} />
                                <span class="reading-words">
                                    <span data-testid="reading-plain">{ text.phrases.sentence(&reading.claim) }</span>
                                    <span class="dim">{ difference(text, answer, reading, place, best) }</span>
                                </span>
                                <span class="score" data-testid="reading-score">
                                    { format!("{:.2}", reading.score) }
                                </span>
                            </button>
                        </li>
                    }
                }) }
            </ul>
            if shown < answer.readings.len() {
                <p class="buttons">
                    <button type="button" class="quiet" data-testid="more-readings"
                        onclick={sends(act, Action::AllReadings)}>{ text.all_readings }</button>
                </p>
            }
            if let Some(reading) = answer.readings.get(*chosen) {
                { phrases(text, reading, link, act) }
            }
        </section>
    }
}

/// How many readings are equally likely.
fn tied(answer: &Answer) -> usize {
    let best = answer.readings.first().map_or(0.0, |reading| reading.score);
    answer.readings.iter().filter(|reading| reading.score == best).count()
}

/// What tells a reading from the best: how much less it scores, and by which words.
fn difference(text: &Text, answer: &Answer, reading: &Reading, place: usize, best: f64) -> String {
    if place == 0 {
        return text.best_reading.to_owned();
    }
    let words = |reading: &Reading| {
        let leaves = reading.nodes.iter().filter(|node| node.parts.is_empty());
        leaves.map(|n| (n.words, n.category.clone(), n.meaning.clone())).collect::<Vec<_>>()
    };
    let first = answer.readings.first().map(words).unwrap_or_default();
    let other = words(reading).into_iter().filter(|leaf| !first.contains(leaf));
    let mut apart: Vec<&str> = other
        .flat_map(|((start, end), ..)| answer.words.get(start..end).unwrap_or_default())
        .map(|word| &*word.text)
        .collect();
    apart.dedup();
    (text.less_likely)(best - reading.score, &apart)
}

/// What the phrases stand for.
fn phrases(text: &Text, reading: &Reading, link: Option<Link>, act: &Callback<Action>) -> Html {
    html! {
        <>
            <h3>{ text.phrases_title }</h3>
            <ul class="phrases" data-testid="phrases">
                { for reading.phrases.iter().filter_map(|phrase| {
                    let own = link::span(phrase)?;
                    let to = Action::Link(Some(own));
                    let (over, focus) = (to.clone(), to);
                    let names: Vec<String> = phrase.referents.iter().map(|r| text.phrases.referent(r)).collect();
                    Some(html! {
                        <li>
                            <button type="button" data-testid="phrase"
                                class={classes!("phrase", link::covers(link, own).then_some("linked"))}
                                onmouseenter={sends(act, over)}
                                onmouseleave={sends(act, Action::Link(None))}
                                onfocus={sends(act, focus)}
                                onblur={sends(act, Action::Link(None))}>
                                <span>{ text.phrases.noun(&phrase.noun) }</span>
                                <span class="dim">{"→ "}{ text.phrases.list(&names) }</span>
                            </button>
                        </li>
                    })
                }) }
            </ul>
        </>
    }
}
