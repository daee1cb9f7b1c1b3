//! The study of a reading: its derivation as a proof tree, the form, the reduction of a constituent's meaning step by
//! step, and what its score is made of.
use super::proof::Proof;
use crate::ui::page::shared::Shared;
use crate::ui::page::view::sends::sends;
use crate::ui::talk::action::Action;
use crate::ui::talk::command::link::{Link, covers};
use crate::ui::talk::command::state::Command;
use crate::ui::talk::proof;
use crate::ui::talk::state::State;
use crate::ui::talk::words::Text;
use crate::worker::protocol::{Piece, Study};
use std::rc::Rc;
use yew::{Callback, Html, classes, html};

/// The study's card.
#[inline(never)] // It comes late: www/split.mjs.
pub(super) fn study(state: &State, shared: &Shared, act: &Callback<Action>) -> Html {
    let text = Text::of(shared.language);
    let said = shared.document.said.as_ref().filter(|_| state.command.live.is_none());
    let Some((said, reading)) = said.zip(shared.document.reading()) else { return Html::default() };
    let Command { link, node, steps, studies, .. } = &state.command;
    let study = studies.as_ref().and_then(|all| all.get(said.chosen));
    let words = &said.answer.words;
    let chosen = node.filter(|&node| node < reading.nodes.len());
    let chosen = chosen.or(reading.nodes.len().checked_sub(1));
    let spoken: Rc<[String]> = words.iter().map(|word| word.text.clone()).collect();
    let nodes: Rc<[_]> = reading.nodes.clone().into();
    let (plain, form) = (reading.derivation.clone(), reading.form.clone());
    // Drawn when it is wanted: the page is shown again at every step of a plan.
    let drawing = {
        let (spoken, nodes) = (spoken.clone(), nodes.clone());
        move || proof::svg(&proof::Proof::new(&spoken, &nodes))
    };
    html! {
        <section class="card study" aria-labelledby="study-title" data-testid="study">
            <div class="card-head">
                <h2 id="study-title">{ text.derivation }</h2>
                <div class="buttons">
                    { copy("copy-derivation", text.copy_as_text, move || plain.clone(), act) }
                    { copy("copy-svg", text.copy_as_svg, drawing, act) }
                </div>
            </div>
            <Proof words={spoken} {nodes} linked={*link} chosen={chosen}
                label={text.proof_label} on_link={act.reform(Action::Link)}
                on_choose={act.reform(Action::ChooseNode)} />
            <div class="columns even">
                <div>
                    <h3>{ text.formula }</h3>
                    <p class="formula" data-testid="formula">{ pieces(&reading.formula, *link, act) }</p>
                    { reduction(text, study, chosen, *steps, act) }
                    <h3>{ text.form }</h3>
                    <pre tabindex="0" data-testid="reading-form">{ &reading.form }</pre>
                    <p class="buttons">{ copy("copy-form", text.copy, move || form.clone(), act) }</p>
                </div>
                <div>{ score(text, study) }</div>
            </div>
        </section>
    }
}

fn copy(
    id: &'static str,
    label: &'static str,
    what: impl Fn() -> String + 'static,
    act: &Callback<Action>,
) -> Html {
    let copied = act.reform(move |_: yew::MouseEvent| Action::Copy(what()));
    html! { <button type="button" class="quiet" data-testid={id} onclick={copied}>{ label }</button> }
}

/// A formula, whose parts point at their words.
fn pieces(formula: &[Piece], link: Option<Link>, act: &Callback<Action>) -> Html {
    let piece = |piece: &Piece| match piece.words {
        None => html! { { &piece.text } },
        Some(words) => html! {
            <span class={classes!("piece", covers(link, words).then_some("linked"))} data-testid="piece"
                onmouseenter={sends(act, Action::Link(Some(words)))}
                onmouseleave={sends(act, Action::Link(None))}>{ &piece.text }</span>
        },
    };
    html! { <>{ for formula.iter().map(piece) }</> }
}

/// How a constituent's meaning came about, as far as it is shown.
fn reduction(
    text: &Text,
    study: Option<&Study>,
    chosen: Option<usize>,
    steps: usize,
    act: &Callback<Action>,
) -> Html {
    let lines = study.zip(chosen).and_then(|(study, node)| study.reductions.get(node));
    let Some(lines) = lines else {
        return html! { <p class="dim">{ text.working_out }</p> };
    };
    let last = lines.len().saturating_sub(1);
    let shown = steps.min(last);
    html! {
        <>
            <h3>{ text.reduction }</h3>
            <ol class="reduction" data-testid="reduction" aria-live="polite">
                { for lines.iter().take(shown + 1).map(|line| html! { <li><code>{ line }</code></li> }) }
            </ol>
            if last > 0 {
                <p class="buttons">
                    <button type="button" class="quiet" data-testid="reduce-back" disabled={shown == 0}
                        onclick={sends(act, Action::Reduce(shown.saturating_sub(1)))}>{ text.step_back }</button>
                    <button type="button" class="quiet" data-testid="reduce" disabled={shown == last}
                        onclick={sends(act, Action::Reduce(shown + 1))}>{ text.step_forward }</button>
                    <button type="button" class="quiet" data-testid="reduce-all" disabled={shown == last}
                        onclick={sends(act, Action::Reduce(last))}>{ text.all_steps }</button>
                </p>
            } else {
                <p class="dim">{ text.from_lexicon }</p>
            }
        </>
    }
}

/// What a score is made of.
fn score(text: &Text, study: Option<&Study>) -> Html {
    let Some(Study { explanation, .. }) = study else { return Html::default() };
    let most = explanation.parts.iter().map(|part| part.adds.abs()).fold(1e-9, f64::max);
    html! {
        <>
            <h3>{ text.score }{" "}<span data-testid="study-score">{ format!("{:.2}", explanation.score) }</span></h3>
            <div class="scroll score-table" tabindex="0" role="group" aria-label={text.score}>
                <table class="features" data-testid="features">
                    <thead><tr><th>{ text.feature }</th><th>{ text.times }</th><th>{ text.weight }</th><th>{ text.adds }</th></tr></thead>
                    <tbody>
                        { for explanation.parts.iter().map(|part| html! {
                            <tr>
                                <td><code>{ &part.feature }</code></td><td>{ part.count }</td>
                                <td>{ format!("{:.2}", part.weight) }</td>
                                <td>
                                    <meter min="0" max={most.to_string()} value={part.adds.abs().to_string()}
                                        aria-hidden="true" class={if part.adds < 0.0 { "minus" } else { "plus" }} />
                                    { format!("{:+.2}", part.adds) }
                                </td>
                            </tr>
                        }) }
                    </tbody>
                </table>
            </div>
            <h3>{ text.entries }</h3>
            <ul class="entry-list">
                { for explanation.entries.iter().map(|entry| html! {
                    <li><strong lang="en">{ &entry.words }</strong>{" "}<code>{ &entry.syntax }</code>
                        {" "}<span class="dim">{ if entry.learned { text.learned_entry } else { text.seed_entry } }</span></li>
                }) }
            </ul>
        </>
    }
}
