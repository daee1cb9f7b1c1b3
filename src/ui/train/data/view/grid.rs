//! The rows, of which only those in sight are in the page: what stands above and below them is empty space. All by
//! keyboard, as a grid: one row is the current one.

use crate::render::{Options, Theme};
use crate::ui::page::view::picture::Picture;
use crate::ui::train::data::action::{Action, Look};
use crate::ui::train::data::sheet::Sheet;
use crate::ui::train::data::words::Text;
use crate::worker::protocol::{Decision, Line, Rule, Sort, Status};
use web_sys::{Element, Event, HtmlInputElement, KeyboardEvent, MouseEvent};
use yew::{
    Callback, Html, Properties, TargetCast, classes, component, html, use_effect_with, use_node_ref,
};

/// The height of a row, and of one with pictures, in pixels; the style sheet says the same.
const HEIGHT: [u32; 2] = [40, 72];

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) sheet: Sheet,
    pub(super) words: Words,
    pub(super) theme: Theme,
    pub(super) act: Callback<Action>,
}

/// The words of a language, which there is one table of.
#[derive(Clone, Copy)]
pub(super) struct Words(pub(super) &'static Text);

impl PartialEq for Words {
    fn eq(&self, other: &Words) -> bool {
        std::ptr::eq(self.0, other.0)
    }
}

/// The rows in sight.
#[component]
pub(super) fn Grid(props: &Props) -> Html {
    let Props { sheet, words: Words(text), act, .. } = props;
    let act = act.reform(Action::Look);
    let table = &sheet.table;
    let height = HEIGHT[usize::from(sheet.is_small())];
    let node = use_node_ref();
    let (top, count) = table.sight;
    let in_sight = move |grid: &Element| grid.client_height().max(0) as u32 / height + 1;
    let told = act.clone();
    use_effect_with((top, count, node.clone()), move |(top, count, node)| {
        if let Some(grid) = node.cast::<Element>() {
            let now = grid.scroll_top() as u32 / height;
            if now != *top {
                grid.set_scroll_top((*top * height) as i32);
            }
            // How many there is room for is known once it is drawn; of what is hidden, never.
            if grid.client_height() > 0 && in_sight(&grid) != *count {
                told.emit(Look::Scrolled(*top, in_sight(&grid)));
            }
        }
    });
    let scrolled = {
        let act = act.clone();
        Callback::from(move |event: Event| {
            let Some(grid) = event.target_dyn_into::<Element>() else { return };
            let first = grid.scroll_top().max(0) as u32 / height;
            let seen = in_sight(&grid);
            if (first, seen) != (top, count) {
                act.emit(Look::Scrolled(first, seen));
            }
        })
    };
    let here = table.line(table.current).map(|line| format!("row-{}", line.row));
    let pressed = {
        let (act, page) = (act.clone(), i64::from(count).max(2) - 1);
        Callback::from(move |event: KeyboardEvent| {
            let look = match event.key().as_str() {
                "ArrowDown" => Look::Move(1),
                "ArrowUp" => Look::Move(-1),
                "PageDown" => Look::Move(page),
                "PageUp" => Look::Move(-page),
                "Home" => Look::End(false),
                "End" => Look::End(true),
                "Enter" => Look::OpenHere,
                " " => Look::PickHere,
                "Escape" => Look::Close,
                _ => return,
            };
            // A button of the head has keys of its own.
            let on_head = event.target_dyn_into::<web_sys::HtmlButtonElement>().is_some();
            if !on_head {
                event.prevent_default();
                act.emit(look);
            }
        })
    };
    let drawn = table.drawn();
    let is_said_who = sheet.facets.workers.values.iter().any(|(who, _)| !who.is_empty());
    let nobody = (!is_said_who).then_some("nobody");
    let is_marked = sheet.facets.rules.iter().any(|(_, rows)| *rows > 0);
    let unasked = (!is_marked && sheet.facets.outcomes.is_empty()).then_some("unasked");
    let below = table.total().saturating_sub(drawn.end) * height;
    html! {
        <div ref={node} class={classes!("grid", sheet.is_small().then_some("small"), nobody, unasked)} role="grid" tabindex="0"
            aria-label={text.table} aria-rowcount={(table.total() + 1).to_string()} data-testid="rows"
            aria-activedescendant={here} onscroll={scrolled} onkeydown={pressed}>
            { head(sheet, text, &act) }
            { space(drawn.start * height) }
            { for drawn.map(|place| row(props, place, &act)) }
            { space(below) }
        </div>
    }
}

/// Empty space of so many pixels.
fn space(height: u32) -> Html {
    html! {
        <div role="presentation" class="space"><svg aria-hidden="true" width="1" height={height.to_string()} /></div>
    }
}

fn head(sheet: &Sheet, text: &'static Text, act: &Callback<Look>) -> Html {
    let view = &sheet.table.view;
    let column = |class: &'static str, words: &'static str, sort: Sort| {
        let order = match (view.sort == sort, view.descending) {
            (false, _) => "none",
            (true, false) => "ascending",
            (true, true) => "descending",
        };
        let sign = match order {
            "ascending" => " ↑",
            "descending" => " ↓",
            _ => "",
        };
        html! {
            <span role="columnheader" class={class} aria-sort={order}>
                <button type="button" class="sort" data-testid={format!("sort-{sort:?}").to_ascii_lowercase()}
                    onclick={act.reform(move |_| Look::Sort(sort))}>{ words }<span aria-hidden="true">{ sign }</span></button>
            </span>
        }
    };
    html! {
        <div role="row" class="grid-row grid-head" aria-rowindex="1">
            { column("n", "#", Sort::Row) }
            { column("said", text.command, Sort::Command) }
            { column("wide", text.filter_task, Sort::Task) }
            { column("wide who", text.filter_worker, Sort::Worker) }
            { column("wide n", text.pairs, Sort::Pairs) }
            { column("wide", text.filter_status, Sort::Status) }
            { column("", text.filter_outcome, Sort::Outcome) }
        </div>
    }
}

fn row(props: &Props, place: u32, act: &Callback<Look>) -> Html {
    let Props { sheet, words: Words(text), theme, .. } = props;
    let table = &sheet.table;
    let index = (place + 2).to_string();
    let Some(line) = table.line(place) else {
        return html! {
            <div key={place} role="row" class="grid-row" aria-rowindex={index}><span role="gridcell">{"…"}</span></div>
        };
    };
    let Line { row, command, task, worker, pairs, decision, half, outcome, marks, .. } = line;
    let (row, picked) = (*row, table.picked.contains(row));
    let is_open = sheet.open.as_ref().is_some_and(|open| open.row == row);
    let is_rejected = matches!(decision, Decision::Rejected(_));
    let pick = act.reform(move |event: Event| {
        let input = event.target_dyn_into::<HtmlInputElement>();
        Look::Pick(row, input.is_some_and(|input| input.checked()))
    });
    let class = classes!(
        "grid-row",
        (place == table.current).then_some("current"),
        is_open.then_some("open"),
        is_rejected.then_some("rejected")
    );
    let first = sheet.pairs.get(&row).and_then(|shown| Some(&shown.first()?.pair));
    let picture = |world: &crate::domain::State| {
        let options = Options { theme: *theme, ..Options::default() };
        html! { <Picture world={world.clone()} {options} label="" /> }
    };
    html! {
        <div key={place} id={format!("row-{row}")} role="row" {class} data-testid="row" aria-rowindex={index}
            aria-selected={picked.to_string()} onclick={act.reform(move |_| Look::Open(place))}>
            <span role="gridcell" class="n">
                <input type="checkbox" tabindex="-1" aria-label={(text.pick)(row + 1)} checked={picked} onchange={pick}
                    onclick={|event: MouseEvent| event.stop_propagation()} />
                <span>{ row + 1 }</span>
            </span>
            <span role="gridcell" class="said">
                <span class="clip" title={command.clone()}>{ command }</span>
                if let Some(pair) = first {
                    <span class="pair" aria-hidden="true">{ picture(&pair.pre) }{ arrow() }{ picture(&pair.post) }</span>
                }
            </span>
            <span role="gridcell" class="wide clip">{ task.clone().unwrap_or_default() }</span>
            <span role="gridcell" class="wide clip who">{ worker.clone().unwrap_or_default() }</span>
            <span role="gridcell" class="wide n">{ pairs }</span>
            <span role="gridcell" class="wide clip">
                { (text.status)(Status::of(decision)) }
                if *half != Default::default() { {" · "}{ (text.half)(*half) } }
            </span>
            // That it does not validate is what the outcome says.
            <span role="gridcell" class="clip">
                if let Some(outcome) = outcome { <span class={format!("outcome {outcome:?}").to_ascii_lowercase()}>{ (text.outcome)(*outcome) }</span> }
                { for marks.iter().filter(|(rule, _)| *rule != Rule::Invalid).map(|(rule, why)| html! { <span class="mark" title={why.clone()}>{ (text.rule)(*rule) }</span> }) }
            </span>
        </div>
    }
}

/// From before to after.
pub(super) fn arrow() -> Html {
    html! { <svg class="arrow" viewBox="0 0 24 24" aria-hidden="true"><path d="M4 12h14m-6-6 6 6-6 6" /></svg> }
}
