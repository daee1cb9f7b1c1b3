//! Making a study: what it is to be, drawing it, and the file that comes of it.

use super::controls::{bar, button};
use crate::study::TASKS;
use crate::study::file::{Again, Order};
use crate::study::tasks::names;
use crate::ui::page::view::fields::{choice, line, number, tick};
use crate::ui::page::view::files::open_file;
use crate::ui::train::desk::Desk;
use crate::ui::train::study::action::{Action, Change, Place, Saved, Way};
use crate::ui::train::study::state::{Draft, State};
use crate::ui::train::study::words::Text;
use web_sys::{HtmlTextAreaElement, InputEvent};
use yew::{Callback, Html, TargetCast, html};

/// The form, and the study.
pub(super) fn make(
    state: &State,
    desk: &Desk,
    text: &'static Text,
    act: &Callback<Action>,
) -> Html {
    let Draft {
        name,
        german,
        tasks,
        pairs,
        has_ways,
        checks,
        shown,
        asked,
        seed,
        says,
        order,
        again,
        hosts,
        ends,
        cents,
    } = &state.draft;
    let n = |id: &'static str,
             label: &'static str,
             value: u32,
             most: u32,
             change: fn(u32) -> Change| {
        let told = act.reform(move |n: f64| Action::Draft(change(n as u32)));
        let least = u32::from(matches!(id, "study-pairs" | "study-shown"));
        let bounds = [value, least, most, 1].map(f64::from);
        number(id.into(), label.into(), bounds, false, told)
    };
    let words =
        |id: &'static str, label: &'static str, value: &str, change: fn(String) -> Change| {
            line(id, label, "text", value, act.reform(move |words| Action::Draft(change(words))))
        };
    let way = Way::ALL.into_iter().find(|way| way.ends()[0] == *ends).unwrap_or(Way::File);
    html! {
        <section class="card" aria-labelledby="study-title">
            <h2 id="study-title">{ text.make_title }</h2>
            <p class="dim">{ text.make_help }</p>
            <div class="fields">
                { words("study-name", text.name, name, Change::Name) }
                { tick("study-german".into(), text.german.into(), *german, false,
                    act.reform(|on| Action::Draft(Change::German(on)))) }
            </div>
            <div class="settings">
                { n("study-pairs", text.pairs, *pairs, 20, Change::Pairs) }
                { n("study-shown", text.shown, *shown, 20, Change::Shown) }
                { n("study-asked", text.asked, *asked, 500, Change::Asked) }
                { n("study-seed", text.seed, *seed, u32::MAX, Change::Seed) }
                { n("study-cents", text.cents, *cents, 100_000, Change::Cents) }
            </div>
            <div class="fields">
                { one_of("study-way", text.way, &Way::ALL, way, text.ways, act.reform(Action::Way)) }
                { one_of("study-order", text.order, &Order::ALL, *order, text.orders,
                    act.reform(|order| Action::Draft(Change::Order(order)))) }
                { one_of("study-again", text.again, &Again::ALL, *again, text.agains,
                    act.reform(|again| Action::Draft(Change::Again(again)))) }
            </div>
            { tick("study-ways".into(), text.has_ways.into(), *has_ways, false,
                act.reform(|on| Action::Draft(Change::Ways(on)))) }
            <details>
                <summary>{ text.checks }</summary>
                <p class="dim">{ text.checks_help }</p>
                { self::checks(checks, tasks, text, act) }
            </details>
            <details>
                <summary>{ text.words }</summary>
                <div class="fields">
                    { for Place::ALL.map(|place| {
                        let said = says.get(&place).map_or("", String::as_str);
                        area(place.id(), (text.says)(place), said,
                            act.reform(move |words| Action::Draft(Change::Says(place, words))))
                    }) }
                </div>
            </details>
            <details>
                <summary>{ format!("{}, {}, {}", text.hosts, text.ends, text.tasks) }</summary>
                <div class="fields">
                    { words("study-hosts", text.hosts, hosts, Change::Hosts) }
                    { words("study-ends", text.ends, ends, Change::Ends) }
                    { area("study-tasks", text.tasks, tasks, act.reform(|words| Action::Draft(Change::Tasks(words)))) }
                </div>
            </details>
            <p class="buttons">
                <button type="button" class="primary" data-testid="study-make" disabled={!desk.is_ready()}
                    onclick={act.reform(|_| Action::Make)}>{ text.make }</button>
                { button("study-save", (text.saved)(Saved::Study), state.study.is_none(), act, Action::Save(Saved::Study)) }
            </p>
            { open_file("study-file", text.open_study, ".json", None, &act.reform(Action::Open)) }
            { bar("study-making", text.making, state.making) }
            if state.making.is_some() {
                <p class="buttons">{ button("stop-making", text.stop, false, act, Action::Stop) }</p>
            }
            if let Some(notice) = &state.notice { <p class="notice" role="status" data-testid="study-notice">{ notice }</p> }
            if let Some((study, fingerprint)) = &state.study {
                <p data-testid="study-is">{ (text.study_is)(&study.name, study.items.len(), fingerprint) }</p>
                <p class="dim">{ text.host_it }</p>
                if let Some(link) = &state.link {
                    <p class="buttons">
                        <a href={format!("collect.html?preview{link}")} target="_blank" rel="noopener" data-testid="study-preview">{ text.preview }</a>
                        <a href={format!("collect.html{link}")} target="_blank" rel="noopener" data-testid="study-link">{ text.link }</a>
                    </p>
                }
            }
            if !state.open.is_empty() {
                <details>
                    <summary>{ text.open }</summary>
                    <ul class="problems">{ for state.open.iter().map(|words| html! { <li>{ words }</li> }) }</ul>
                </details>
            }
        </section>
    }
}

/// The tasks that are there to see whether somebody looks, and a place for one more.
fn checks(
    checks: &[(String, String)],
    tasks: &str,
    text: &'static Text,
    act: &Callback<Action>,
) -> Html {
    let tasks = if tasks.trim().is_empty() { TASKS } else { tasks };
    let known: Vec<String> = names(tasks).map(str::to_owned).collect();
    let shown: Vec<String> = std::iter::once(text.none.to_owned()).chain(known.clone()).collect();
    let one = |at: usize| {
        let (task, words) = checks.get(at).map_or(("", ""), |(task, words)| (task, words));
        let place = known.iter().position(|name| name == task).map_or(0, |place| place + 1);
        let known = known.clone();
        let choose = act.reform(move |place: usize| {
            let name = place.checked_sub(1).and_then(|place| known.get(place)).cloned();
            Action::Draft(Change::Check(at, name.unwrap_or_default()))
        });
        let say = act.reform(move |words| Action::Draft(Change::Must(at, words)));
        html! {
            // By its place: what was chosen in one row is none of the next one's.
            <div class="fields" key={at}>
                { choice(format!("check-{at}").into(), text.check.into(), &shown, place, choose) }
                if at < checks.len() { { line(format!("must-{at}"), text.must, "text", words, say) } }
            </div>
        }
    };
    html! { <>{ for (0..=checks.len()).map(one) }</> }
}

/// A choice among values, each with its words.
fn one_of<T: Copy + PartialEq + 'static>(
    id: &'static str,
    label: &'static str,
    all: &'static [T],
    chosen: T,
    named: fn(T) -> &'static str,
    choose: Callback<T>,
) -> Html {
    let names: Vec<String> = all.iter().map(|one| named(*one).to_owned()).collect();
    let place = all.iter().position(|one| *one == chosen).unwrap_or(0);
    // The browser names no place that was not offered.
    let choose = choose.reform(move |at: usize| all.get(at).copied().unwrap_or(chosen));
    choice(id.into(), label.into(), &names, place, choose)
}

/// A text of several lines.
fn area(id: &'static str, label: &'static str, value: &str, change: Callback<String>) -> Html {
    let typed = change.reform(|event: InputEvent| {
        event.target_dyn_into::<HtmlTextAreaElement>().map_or(String::new(), |area| area.value())
    });
    html! {
        <label class="field grow" for={id}>
            <span>{ label }</span>
            <textarea {id} data-testid={id} rows="3" value={value.to_owned()} oninput={typed} spellcheck="false" />
        </label>
    }
}
