//! A row that is open: its demonstrations side by side, what was decided of it, and what the model makes of it.

use super::grid::arrow;
use crate::render::{Options, Theme};
use crate::ui::page::view::picture::{Picture, line};
use crate::ui::page::view::sign::{Sign, sign};
use crate::ui::page::way::{rooms, states};
use crate::ui::train::data::action::{Action, Look};
use crate::ui::train::data::sheet::{Open, Sheet};
use crate::ui::train::data::words::Text;
use crate::worker::protocol::{Decision, Reading, RowReading, RunText, Shown};
use yew::{Callback, Html, html};

/// Readings that are shown.
const SHOWN: usize = 8;

/// The row that is open; nothing when none is.
pub(super) fn row(sheet: &Sheet, text: &Text, theme: Theme, act: &Callback<Action>) -> Html {
    let Some(Open { row, pairs, reading }) = &sheet.open else { return Html::default() };
    let line = sheet.table.window.lines.iter().find(|line| line.row == *row);
    html! {
        <section class="card open-row" aria-labelledby="row-title" data-testid="open-row">
            <div class="card-head">
                <h2 id="row-title">{ line.map_or("", |line| line.command.as_str()) }</h2>
                { sign("close-row", text.close, Sign::Close, false, act.reform(|()| Action::Look(Look::Close))) }
            </div>
            if let Some(line) = line {
                <p class="dim figures">
                    { (text.where_from)(&line.id, line.line) }
                    { for [&line.task, &line.worker].into_iter().flatten().map(|word| html! { <>{" · "}{ word }</> }) }
                    if let Decision::Rejected(why) = &line.decision { {" · "}{ text.reason }{": "}{ why.to_string() } }
                    { for line.marks.iter().map(|(rule, why)| html! { <><br />{ (text.rule)(*rule) }{": "}{ why }</> }) }
                </p>
            }
            <div class="pairs" data-testid="pairs">
                if let Some(pairs) = pairs {
                    { for pairs.iter().zip(1..).map(|(shown, n)| show(text, shown, n, theme)) }
                } else {
                    <p class="dim">{ text.reading }</p>
                }
            </div>
            { match reading {
                Some(reading) => readings(text, reading),
                None if sheet.is_audited => html! { <p class="dim">{ text.reading }</p> },
                None => html! { <p class="dim">{ text.not_audited }</p> },
            } }
        </section>
    }
}

/// A demonstration: before and after, and of a run the way, with what was not meant.
fn show(text: &Text, Shown { pair, run }: &Shown, number: usize, theme: Theme) -> Html {
    let before = format!("{} {}", (text.demonstration)(number), text.phrases.robot(&pair.pre));
    let after = format!("{} {}", text.after, text.phrases.robot(&pair.post));
    let options = || Options { theme, ..Options::default() };
    let rooms = |way: &str| rooms(&pair.pre, way, text.phrases);
    html! {
        <span class="pair" data-testid={if run.is_some() { "run" } else { "pair" }}>
            <Picture world={pair.pre.clone()} options={options()} label={before} over={run.as_ref().map(ways).unwrap_or_default()} />
            { arrow() }
            <Picture world={pair.post.clone()} options={options()} label={after} />
            if let Some(run) = run {
                <span class="ways dim">
                    <span data-testid="run-way">{ (text.way)(&rooms(&run.actions), run.actions.len()) }</span>
                    { for run.contrast.iter().map(|way| html! {
                        <span data-testid="run-contrast">{ (text.unlike)(&rooms(way), way.len()) }</span>
                    }) }
                </span>
            }
        </span>
    }
}

/// The way of a run, and those that are not meant.
fn ways(RunText { start, actions, contrast }: &RunText) -> Html {
    html! {
        <>
            { for contrast.iter().map(|way| line("way unlike", &states(start, way))) }
            { line("way", &states(start, actions)) }
        </>
    }
}

fn readings(text: &Text, found: &RowReading) -> Html {
    html! {
        <>
            <h3>{ (text.readings)(found.n_readings) }</h3>
            if let Some(reason) = &found.reason { <p class="dim">{ (text.no_reading)(reason) }</p> }
            <ol class="row-readings" data-testid="row-readings">
                { for found.readings.iter().take(SHOWN).map(|(reading, valid)| one(text, reading, valid)) }
            </ol>
        </>
    }
}

fn one(text: &Text, reading: &Reading, valid: &[bool]) -> Html {
    let formula: String = reading.formula.iter().map(|piece| piece.text.as_str()).collect();
    html! {
        <li>
            <p>{ text.phrases.claim(&reading.claim) }</p>
            <code>{ formula }</code>
            <p class="verdicts figures">
                { format!("{:.2} ", reading.score) }
                { for valid.iter().zip(1..).map(|(valid, n)| html! {
                    <span class={if *valid { "good" } else { "wrong" }} role="img" aria-label={(text.valid_for)(*valid, n)}>
                        { if *valid { "✓" } else { "✗" } }{ n }
                    </span>
                }) }
            </p>
        </li>
    }
}
