//! The settings of the next run; the paper's unless a person says otherwise.

use super::press::press;
use crate::ui::page::view::fields::{choice, number, tick};
use crate::ui::train::run::action::{Action, Number, Setting};
use crate::ui::train::run::state::State;
use crate::ui::train::run::words::Text;
use crate::worker::protocol::{FeatureKind, SeedLexicon};
use yew::{Callback, Html, html};

/// The lexicons that can be chosen, in the order of their words.
const LEXICONS: [Option<SeedLexicon>; 3] =
    [None, Some(SeedLexicon::Demonstration), Some(SeedLexicon::Domain)];

/// The settings; those of a run at work stay as they were when it began.
pub(super) fn settings(state: &State, text: &Text, act: &Callback<Action>) -> Html {
    let set = act.reform(Action::Set);
    let numbers = Number::ALL.into_iter().map(|(which, least, most)| {
        let step = if which == Number::Margin { 0.1 } else { 1.0 };
        let id = format!("setting-{which:?}").to_ascii_lowercase();
        let value = [state.number(which), least, most, step];
        let change = set.reform(move |value| Setting::Number(which, value));
        number(id.into(), (text.number)(which).into(), value, false, change)
    });
    let lexicons = text.lexicons.map(str::to_owned);
    let chosen = LEXICONS.iter().position(|one| *one == state.lexicon).unwrap_or(0);
    let choose =
        set.reform(|place: usize| Setting::Lexicon(LEXICONS.get(place).copied().flatten()));
    let kinds = FeatureKind::ALL.into_iter().map(|(name, kind)| {
        let is_out = state.settings.without.contains(&kind);
        let change = set.reform(move |out| Setting::Without(kind, out));
        tick(format!("without-{name}").into(), (text.kind)(kind).into(), is_out, false, change)
    });
    let is_paper = state.is_paper();
    html! {
        <section class="card" aria-labelledby="settings-title">
            <div class="card-head">
                <h2 id="settings-title">{ text.settings }</h2>
                if is_paper {
                    <span class="dim">{ text.are_paper }</span>
                } else {
                    { press("quiet", "paper", text.paper, false, act, Action::Paper) }
                }
            </div>
            <div class="settings">{ for numbers }</div>
            <div class="fields">
                { choice("setting-lexicon".into(), text.lexicon.into(), &lexicons, chosen, choose) }
                { tick("setting-idioms".into(), text.idioms.into(), state.settings.idioms, false, set.reform(Setting::Idioms)) }
            </div>
            <fieldset class="kinds"><legend>{ text.without }</legend>{ for kinds }</fieldset>
        </section>
    }
}
