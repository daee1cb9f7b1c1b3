//! Holding rows out: a share by chance, or all of a task or a person.

use super::files::link;
use super::grid::Words;
use crate::ui::page::view::fields::{choice, number};
use crate::ui::train::data::action::{Action, Care};
use crate::worker::protocol::{By, Split};
use yew::{Callback, Html, Properties, component, html, use_state};

#[derive(PartialEq, Properties)]
pub(super) struct Props {
    pub(super) words: Words,
    /// The task and the person that are looked at, if one is.
    pub(super) task: Option<String>,
    pub(super) worker: Option<String>,
    /// The names of the files, where there are several.
    pub(super) files: Vec<String>,
    pub(super) act: Callback<Action>,
}

/// How the corpus is parted.
#[component]
pub(super) fn Parting(props: &Props) -> Html {
    let Props { words: Words(text), task, worker, files, act } = props;
    let (percent, by, seed) = (use_state(|| 20.0), use_state(|| 0), use_state(|| 0.0));
    let care = act.reform(|split| Action::Care(Care::Divide(split)));
    let names: Vec<String> = By::ALL.iter().map(|(_, by)| (text.by)(*by).to_owned()).collect();
    let part = {
        let by = By::ALL.get(*by).map_or(By::Command, |(_, by)| *by);
        let split = Split::Share { by, percent: *percent as u32, seed: *seed as u32 };
        care.reform(move |_| split.clone())
    };
    let named = |workers: bool, name: &Option<String>| {
        let Some(name) = name.clone() else { return Html::default() };
        let words = (text.split_view)(&name);
        let split = Split::Named { workers, names: vec![name] };
        let press = care.reform(move |_| split.clone());
        html! { <button type="button" class="quiet" data-testid="split-view" onclick={press}>{ words }</button> }
    };
    let set = |setter: yew::UseStateHandle<f64>| Callback::from(move |value| setter.set(value));
    html! {
        <section class="card" aria-labelledby="split-title">
            <h2 id="split-title">{ text.split }</h2>
            <p class="dim">{ text.split_help }</p>
            <div class="fields">
                { number("split-percent".into(), text.share.into(), [*percent, 1.0, 99.0, 1.0], false, set(percent.clone())) }
                { choice("split-by".into(), text.together.into(), &names, *by, Callback::from(move |place| by.set(place))) }
                { number("split-seed".into(), text.seed.into(), [*seed, 0.0, 4_294_967_295.0, 1.0], false, set(seed.clone())) }
            </div>
            <p class="buttons">
                <button type="button" class="quiet" data-testid="split-share" onclick={part}>{ text.split_share }</button>
                { named(false, task) }
                { named(true, worker) }
                { for (0..).zip(files).map(|(at, name)| html! {
                    <button type="button" class="quiet" data-testid="hold-out-file"
                        onclick={act.reform(move |_| Action::Care(Care::HoldOut(at)))}>{ (text.split_view)(name) }</button>
                }) }
                { link(text.split_none, "split-none", care.reform(|()| Split::None)) }
            </p>
        </section>
    }
}
