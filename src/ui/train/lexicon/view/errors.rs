//! Where the model errs: commands, words, features, and what wrong answers did instead.

use super::rows::rows;
use super::table::table;
use crate::ui::train::lexicon::action::Action;
use crate::ui::train::lexicon::state::State;
use crate::ui::train::lexicon::words::Text;
use crate::worker::protocol::{Confused, Errors};
use yew::{Callback, Html, html};

/// Lines of a table that are shown.
const SHOWN: usize = 40;

/// Where it errs; `confused` is of what is held out.
pub(super) fn errors(
    state: &State,
    confused: &[Confused],
    text: &Text,
    act: &Callback<Action>,
) -> Html {
    html! {
        <section class="card" aria-labelledby="errors-title" data-testid="errors">
            <h2 id="errors-title">{ text.errors }</h2>
            { match &state.errors {
                Some(errors) if errors.commands.is_empty() && errors.unknown.is_empty() => html! {
                    <p class="dim">{ text.errs_nowhere }</p>
                },
                Some(errors) => tables(errors, text, act),
                None => html! { <p class="dim">{ text.no_errors }</p> },
            } }
            { table(text.confusion, &[text.task, text.does, text.count], confused.iter().take(SHOWN).map(|one| {
                let name = |name: &Option<String>| name.clone().unwrap_or_else(|| text.nothing.to_owned());
                html! { <tr><td>{ name(&one.task) }</td><td>{ name(&one.does) }</td><td>{ one.count }</td></tr> }
            }).collect()) }
        </section>
    }
}

fn tables(errors: &Errors, text: &Text, act: &Callback<Action>) -> Html {
    let commands = errors.commands.iter().take(SHOWN).map(|one| {
        html! {
            <tr>
                <td>{ &one.command }</td><td>{ rows(&one.rows, text, act) }</td><td>{ one.right }</td>
                <td><code>{ one.form.clone().unwrap_or_default() }</code></td>
            </tr>
        }
    });
    let unknown = errors.unknown.iter().take(SHOWN).map(|(word, of)| {
        html! { <tr><td>{ word }</td><td>{ rows(of, text, act) }</td></tr> }
    });
    let deciders = errors.deciders.iter().take(SHOWN).map(|one| {
        html! { <tr><td><code>{ &one.feature }</code></td><td>{ format!("{:.2}", one.by) }</td><td>{ rows(&one.rows, text, act) }</td></tr> }
    });
    html! {
        <>
            { table(text.worst, &[text.command, text.uses, text.right, text.best_form], commands.collect()) }
            { table(text.unknown, &[text.words, text.uses], unknown.collect()) }
            { table(text.deciders, &[text.feature, text.by, text.uses], deciders.collect()) }
        </>
    }
}
