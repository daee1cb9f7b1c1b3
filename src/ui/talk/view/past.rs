//! What was said before, the latest first: a press says it again, another goes on from after it.
use crate::ui::page::shared::Shared;
use crate::ui::page::view::sends::sends;
use crate::ui::talk::action::Action;
use crate::ui::talk::past::state::Outcome;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use yew::{Callback, Html, html};

/// What was said before; nothing as long as nothing was.
pub(super) fn past(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    if state.past.lines.is_empty() { Html::default() } else { lines(state, shared, act) }
}

#[inline(never)] // It comes late: www/split.mjs.
fn lines(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let outcome = |outcome| {
        let [already, asked, unable, lost, told] = text.outcomes;
        match outcome {
            Outcome::Done(steps) => return (text.done_in)(steps),
            Outcome::Already => already,
            Outcome::Asked => asked,
            Outcome::Unable => unable,
            Outcome::Lost => lost,
            Outcome::Told => told,
        }
        .to_owned()
    };
    html! {
        <section class="card past" aria-labelledby="past-title" data-testid="past">
            <h2 id="past-title">{ text.said_before }</h2>
            <ol reversed=true class="lines">
                { for state.past.lines.iter().enumerate().rev().map(|(place, line)| {
                    let command = line.command.clone();
                    html! {
                        <li>
                            <button type="button" class="link" lang="en" data-testid="again" title={text.say_again}
                                onclick={sends(act, Action::AskExample(command.clone()))}>{ &line.command }</button>
                            <span class="dim" data-testid="outcome">{ outcome(line.outcome) }</span>
                            <button type="button" class="link" data-testid="go-on"
                                aria-label={(text.go_on_after)(&line.command)}
                                onclick={sends(act, Action::GoOn(place))}>{ text.go_on }</button>
                        </li>
                    }
                }) }
            </ol>
        </section>
    }
}
