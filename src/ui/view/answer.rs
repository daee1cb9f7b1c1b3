//! What a command was taken to mean: words, meaning, form, score, derivation, and why nothing came of it.

use crate::ui::why;
use crate::worker::protocol::{Answer, Fate, Reading};
use std::rc::Rc;
use yew::{Html, Properties, component, html};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) answer: Option<Rc<Answer>>,
}

/// The answer to the last command.
#[component]
pub(super) fn AnswerPanel(props: &Props) -> Html {
    let Some(answer) = &props.answer else { return Html::default() };
    let tie = answer.reason.as_deref() == Some("tie");
    let messages = why::explain(answer);
    html! {
        <div class="answer" data-testid="answer">
            if !answer.words.is_empty() {
                <p class="words" aria-label="The words as it reads them">
                    { for answer.words.iter().map(|word| {
                        let unknown = (word.fate == Fate::Unknown).then_some("unknown");
                        html! { <span class={yew::classes!("word", unknown)}>{ &word.text }</span> }
                    }) }
                </p>
            }
            { for messages.iter().map(|m| html! {
                <div class="notice" data-testid="why" data-kind={m.kind}>
                    <p><strong>{ &m.what }</strong></p><p>{ &m.fix }</p>
                </div>
            }) }
            { for answer.readings.iter().enumerate().map(|(i, reading)| {
                let title = match (tie, i) {
                    (false, 0) => "It means".to_owned(),
                    (true, _) => format!("Meaning {}", i + 1),
                    (false, _) => "Less likely".to_owned(),
                };
                show(reading, title, i == 0)
            }) }
        </div>
    }
}

fn show(reading: &Reading, title: String, first: bool) -> Html {
    html! {
        <details class="reading" open={first} data-testid="reading">
            <summary>
                <span class="reading-title">{ title }</span>
                <span class="human" data-testid="reading-human">{ for reading.formula.iter().map(|p| &p.text) }</span>
                <span class="score" data-testid="reading-score" title="Score">
                    { format!("score {:.2}", reading.score) }
                </span>
            </summary>
            <h3>{"Form"}</h3>
            <pre tabindex="0" data-testid="reading-form">{ &reading.form }</pre>
            <h3>{"Derivation"}</h3>
            <pre tabindex="0" data-testid="reading-derivation">{ &reading.derivation }</pre>
        </details>
    }
}
