//! Another program's trials: which value is what.

use super::controls::button;
use crate::ui::page::view::fields::choice;
use crate::ui::page::view::files::open_file;
use crate::ui::train::study::action::{Action, Saved, Value};
use crate::ui::train::study::state::State;
use crate::ui::train::study::words::Text;
use yew::{Callback, Html, html};

/// The mapping, while there is something to map.
pub(super) fn survey(state: &State, text: &'static Text, act: &Callback<Action>) -> Html {
    let Some((trials, paths, mapping)) = &state.survey else { return Html::default() };
    let names: Vec<String> = std::iter::once(text.none.to_owned()).chain(paths.clone()).collect();
    let choose = |id: String, value: Value, chosen: &str| {
        let place = paths.iter().position(|path| path == chosen).map_or(0, |at| at + 1);
        let paths = paths.clone();
        let told = act.reform(move |at: usize| {
            let path = at.checked_sub(1).and_then(|at| paths.get(at)).cloned().unwrap_or_default();
            Action::Map(value, path)
        });
        choice(id.into(), (text.value)(value).into(), &names, place, told)
    };
    let pairs = (0..=mapping.pairs.len()).map(|at| {
        let pair = mapping.pairs.get(at);
        let (pre, post) = pair.map_or(("", ""), |pair| (&pair.pre, &pair.post));
        html! {
            <>
                { choose(format!("map-pre-{at}"), Value::Pre(at), pre) }
                { choose(format!("map-post-{at}"), Value::Post(at), post) }
            </>
        }
    });
    html! {
        <div class="problems-box" data-testid="survey">
            <h3>{ text.survey_title }</h3>
            <p class="dim">{ (text.survey_help)(*trials as usize) }</p>
            <div class="settings">
                { choose("map-command-value".into(), Value::Command, &mapping.command) }
                { choose("map-worker-value".into(), Value::Worker, mapping.worker.as_deref().unwrap_or("")) }
                { choose("map-task-value".into(), Value::Task, mapping.task.as_deref().unwrap_or("")) }
                { for pairs }
            </div>
            <p class="buttons">
                { button("convert", text.convert, !mapping.is_complete(), act, Action::Convert) }
                { button("save-survey", (text.saved)(Saved::Mapping), false, act, Action::Save(Saved::Mapping)) }
            </p>
            { open_file("survey-file", text.open_mapping, ".json", None, &act.reform(Action::Mapping)) }
        </div>
    }
}
