//! What is being learned: the command at work with its best forms, the entries that it added, the features it moved.

use crate::ui::train::run::state::Run;
use crate::ui::train::run::words::Text;
use crate::worker::protocol::Look;
use yew::{Html, html};

/// What is being learned.
pub(super) fn now(run: &Run, text: &Text) -> Html {
    html! {
        <section class="card now" aria-labelledby="now-title" data-testid="now">
            <h2 id="now-title">{ text.now }</h2>
            { match &run.look {
                Some(look) => seen(look, text),
                None => html! { <p class="dim">{ text.nothing_yet }</p> },
            } }
        </section>
    }
}

fn seen(look: &Look, text: &Text) -> Html {
    html! {
        <>
            <p class="row-command" data-testid="now-command">{ &look.command }</p>
            <h3>{ (text.forms)(look.n_forms) }</h3>
            <ol class="row-readings">
                { for look.forms.iter().map(|form| html! {
                    <li>
                        <code>{ &form.form }</code>
                        <p class="figures">{ format!("{:.2} · ", form.score) }{ (text.valid_in)(form.valid, look.examples) }</p>
                    </li>
                }) }
            </ol>
            if !look.added.is_empty() {
                <h3>{ text.added }</h3>
                <ul class="row-readings">
                    { for look.added.iter().map(|entry| html! {
                        <li><strong>{ &entry.words }</strong>{" "}<code>{ &entry.syntax }{" : "}{ &entry.meaning }</code></li>
                    }) }
                </ul>
            }
            if !look.moved.is_empty() {
                <h3>{ text.moved }</h3>
                <div class="scroll" tabindex="0" role="region" aria-label={text.moved}>
                    <table class="figures">
                        <thead><tr><th scope="col">{ text.feature }</th><th scope="col">{ text.moved_by }</th><th scope="col">{ text.moved_to }</th></tr></thead>
                        <tbody>
                            { for look.moved.iter().map(|moved| html! {
                                <tr><td><code>{ &moved.feature }</code></td><td>{ format!("{:+.3}", moved.by) }</td><td>{ format!("{:.3}", moved.weight) }</td></tr>
                            }) }
                        </tbody>
                    </table>
                </div>
            }
        </>
    }
}
